// SPDX-License-Identifier: BSL-1.0
// Bullet's soft body as a sheet of its own links, in a soft world without anything to touch; float.

#include "tests/peers/soft_bodies/sheet.hpp"
#include "tests/peers/versions.hpp"

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

static const peers::Version version("Bullet",
                                    std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100));

namespace {

class BulletSheet : public peers::SheetOf {
public:
    BulletSheet(const peers::Sheet& sheet, int passes) {
        world_.setGravity(btVector3(0, -btScalar(peers::Sheet::gravity), 0));
        auto& info = world_.getWorldInfo();
        info.m_gravity = world_.getGravity();
        info.air_density = info.water_density = 0;
        std::vector<btVector3> places;
        for (const auto& x : sheet.places) places.emplace_back(btScalar(x[0]), btScalar(x[1]), btScalar(x[2]));
        body_ = new btSoftBody(&info, int(places.size()), places.data(), nullptr);
        for (std::size_t i = 0; i < sheet.size(); ++i) body_->setMass(int(i), btScalar(sheet.masses[i]));
        body_->m_materials[0]->m_kLST = 1; // as stiff as its passes make it
        for (const auto& l : sheet.links) body_->appendLink(int(l.a), int(l.b), body_->m_materials[0]);
        body_->m_cfg.piterations = passes;
        body_->m_cfg.kDP = 0;
        body_->m_cfg.collisions = 0;
        world_.addSoftBody(body_);
    }
    ~BulletSheet() override {
        world_.removeSoftBody(body_);
        delete body_;
    }
    void step() override { world_.stepSimulation(btScalar(peers::Sheet::dt), 0); }
    std::array<double, 3> at(std::size_t i) const override {
        const btVector3& x = body_->m_nodes[int(i)].m_x;
        return {double(x.x()), double(x.y()), double(x.z())};
    }

private:
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btSoftRigidDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    btSoftBody* body_;
};

} // namespace

std::unique_ptr<peers::SheetOf> peers::bullet_sheet(const Sheet& sheet, int passes) {
    return std::make_unique<BulletSheet>(sheet, passes);
}
