// SPDX-License-Identifier: BSL-1.0
// ODE with its quick step (twenty passes) and its hash space, as its manual recommends for many bodies.

#include "tests/peers/collision/pile.hpp"
#include "tests/peers/versions.hpp"

#include <ode/ode.h>

static const peers::Version version("ODE", dODE_VERSION);

namespace {

class OdePile : public peers::PileOf {
public:
    explicit OdePile(const peers::Pile& pile) {
        using peers::Pile;
        dWorldSetGravity(world_, 0, -dReal(Pile::gravity), 0);
        const dReal half = dReal(pile.half_side);
        dCreatePlane(space_, 0, 1, 0, 0);
        dCreatePlane(space_, 1, 0, 0, -half);
        dCreatePlane(space_, -1, 0, 0, -half);
        dCreatePlane(space_, 0, 0, 1, -half);
        dCreatePlane(space_, 0, 0, -1, -half);
        dHashSpaceSetLevels(space_, 0, 1); // cells as large as the spheres
        dMass mass;
        dMassSetSphereTotal(&mass, dReal(Pile::mass), dReal(Pile::radius));
        for (const auto& x : pile.start) {
            const dBodyID body = dBodyCreate(world_);
            dBodySetMass(body, &mass);
            dBodySetPosition(body, dReal(x[0]), dReal(x[1]), dReal(x[2]));
            dGeomSetBody(dCreateSphere(space_, dReal(Pile::radius)), body);
            bodies_.push_back(body);
        }
    }
    ~OdePile() override {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }
    OdePile(const OdePile&) = delete;
    OdePile& operator=(const OdePile&) = delete;
    void step() override {
        dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) { static_cast<OdePile*>(self)->touch(a, b); });
        dWorldQuickStep(world_, dReal(peers::Pile::dt));
        dJointGroupEmpty(contacts_);
    }
    std::array<double, 3> at(std::size_t i) const override {
        const dReal* x = dBodyGetPosition(bodies_[i]);
        return {double(x[0]), double(x[1]), double(x[2])};
    }

private:
    /// ODE's library is prepared once.
    struct Ready {
        Ready() { dInitODE2(0); }
        ~Ready() { dCloseODE(); }
    };
    void touch(dGeomID a, dGeomID b) {
        dContact contact{};
        if (dCollide(a, b, 1, &contact.geom, sizeof(dContact)) == 0) return;
        contact.surface.mode = 0;
        contact.surface.mu = 0;
        dJointAttach(dJointCreateContact(world_, contacts_, &contact), dGeomGetBody(a), dGeomGetBody(b));
    }
    static inline const Ready ready_{};
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    dJointGroupID contacts_ = dJointGroupCreate(0);
    std::vector<dBodyID> bodies_;
};

} // namespace

std::unique_ptr<peers::PileOf> peers::ode_pile(const Pile& pile) { return std::make_unique<OdePile>(pile); }
