// SPDX-License-Identifier: BSL-1.0
// Bullet's discrete world, as its first example sets it up: ten sequential impulses a step, warm started; float.

#include "tests/peers/collision/pile.hpp"

#include <btBulletDynamicsCommon.h>

namespace {

class BulletPile : public peers::PileOf {
public:
    explicit BulletPile(const peers::Pile& pile) {
        using peers::Pile;
        world_.setGravity(btVector3(0, -btScalar(Pile::gravity), 0));
        const btScalar half = btScalar(pile.half_side);
        add_plane({0, 1, 0}, 0);
        add_plane({1, 0, 0}, -half);
        add_plane({-1, 0, 0}, -half);
        add_plane({0, 0, 1}, -half);
        add_plane({0, 0, -1}, -half);
        btVector3 inertia;
        sphere_.calculateLocalInertia(btScalar(Pile::mass), inertia);
        for (const auto& x : pile.start) {
            btRigidBody::btRigidBodyConstructionInfo info(btScalar(Pile::mass), nullptr, &sphere_, inertia);
            info.m_startWorldTransform.setOrigin(btVector3(btScalar(x[0]), btScalar(x[1]), btScalar(x[2])));
            add(info);
            spheres_.push_back(bodies_.back().get());
        }
    }
    ~BulletPile() override {
        for (auto& body : bodies_) world_.removeRigidBody(body.get());
    }
    void step() override { world_.stepSimulation(btScalar(peers::Pile::dt), 0); }
    std::array<double, 3> at(std::size_t i) const override {
        const btVector3& x = spheres_[i]->getWorldTransform().getOrigin();
        return {double(x.x()), double(x.y()), double(x.z())};
    }

private:
    void add(btRigidBody::btRigidBodyConstructionInfo& info) {
        info.m_friction = info.m_restitution = 0;
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        bodies_.back()->setActivationState(DISABLE_DEACTIVATION); // nobody sleeps, here and in the others
        world_.addRigidBody(bodies_.back().get());
    }
    void add_plane(const btVector3& normal, btScalar constant) {
        planes_.push_back(std::make_unique<btStaticPlaneShape>(normal, constant));
        btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, planes_.back().get());
        add(info);
    }
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    btSphereShape sphere_{btScalar(peers::Pile::radius)};
    std::vector<std::unique_ptr<btStaticPlaneShape>> planes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<btRigidBody*> spheres_;
};

} // namespace

std::unique_ptr<peers::PileOf> peers::bullet_pile(const Pile& pile) { return std::make_unique<BulletPile>(pile); }
