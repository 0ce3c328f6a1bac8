// SPDX-License-Identifier: BSL-1.0
// ODE with the settings that its manual recommends: the exact step for few bodies, the quick step for many.

#include "tests/peers/cases/engine.hpp"

#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <limits>
#include <string>

namespace {

using peers::Ball;
using peers::Scene;
using peers::Vector;

// dWorldStep, which is exact, gives up at contacts one exactly upon the other ("LCP internal error"), and lets the ball
// of R4 fall by a metre. So contacts are given to the quick step, with more passes than its 20 where there are few
// bodies.
constexpr int few = 64, passes = 50, passes_for_few = 500;

/// ODE's library is prepared once.
struct Ready {
    Ready() {
        dInitODE2(0);
        dSetMessageHandler([](int, const char*, va_list) {}); // of its solver, thousands in some rows
    }
    ~Ready() { dCloseODE(); }
};
const Ready ready;

class Ode : public peers::Engine {
public:
    explicit Ode(const Scene& scene) : scene_(scene) {
        if (scene.detection == Scene::Detection::continuous) throw peers::Cannot("it has no continuous detection");
        set_gravity(scene.gravity);
        dWorldSetContactSurfaceLayer(world_, dReal(scene.soft > 0 ? 0 : 0.001 * scene.size));
        dWorldSetContactMaxCorrectingVel(world_, dReal(1.0 * scene.size));
        if (scene.sleeps) {
            dWorldSetAutoDisableFlag(world_, 1);
            if (scene.slow > 0) { // 0.01 m/s for ten steps by itself
                dWorldSetAutoDisableLinearThreshold(world_, dReal(scene.slow));
                dWorldSetAutoDisableAngularThreshold(world_, dReal(scene.slow));
                dWorldSetAutoDisableTime(world_, dReal(scene.slow_for));
            }
        }
        if (scene.drag > 0) // a part of the velocity a step, whatever its length
            dWorldSetLinearDamping(world_, dReal(1 - std::exp(-scene.drag * scene.drag_dt)));
        if (scene.drag > 0) dWorldSetLinearDampingThreshold(world_, 0);
    }
    ~Ode() override {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }
    int add(const Ball& ball) override {
        const dBodyID body = dBodyCreate(world_);
        dMass mass;
        dMassSetSphereTotal(&mass, dReal(ball.mass), dReal(ball.radius));
        for (const int k : {0, 5, 10}) mass.I[k] = dReal(1e9 * ball.mass); // it does not turn
        dBodySetMass(body, &mass);
        dBodySetPosition(body, dReal(ball.x[0]), dReal(ball.x[1]), dReal(ball.x[2]));
        dBodySetLinearVel(body, dReal(ball.v[0]), dReal(ball.v[1]), dReal(ball.v[2]));
        dGeomID geom = nullptr;
        if (!scene_.springs) {
            geom = dCreateSphere(space_, dReal(ball.radius));
            dGeomSetBody(geom, body);
        }
        return keep(geom, body, ball.bounce, ball.friction);
    }
    int plane(const Vector& n, double offset, double bounce, double friction) override {
        return keep(dCreatePlane(space_, dReal(n[0]), dReal(n[1]), dReal(n[2]), dReal(offset)), nullptr, bounce,
                    friction);
    }
    int box(const Vector& x, const Vector& half, double bounce, double friction) override {
        const dGeomID geom = dCreateBox(space_, dReal(2 * half[0]), dReal(2 * half[1]), dReal(2 * half[2]));
        dGeomSetPosition(geom, dReal(x[0]), dReal(x[1]), dReal(x[2]));
        return keep(geom, nullptr, bounce, friction);
    }
    int platform(const Vector& x, const Vector& half) override {
        const int i = box(x, half, 0, 0);
        const dBodyID body = dBodyCreate(world_);
        dBodySetKinematic(body);
        dBodySetPosition(body, dReal(x[0]), dReal(x[1]), dReal(x[2]));
        dBodySetAutoDisableFlag(body, 0);
        dGeomSetBody(at(i).geom, body);
        at(i).body = body;
        return i;
    }
    /// A joint of two points at a distance whose stop gives way: the manual's spring and damper,
    /// ERP = h k / (h k + c), CFM = 1 / (h k + c).
    void add(const peers::SpringOf& s) override {
        const dJointID joint = dJointCreateDBall(world_, nullptr);
        dJointAttach(joint, at(s.a).body, s.b < 0 ? nullptr : at(s.b).body);
        const Vector a = x(s.a), b = s.b < 0 ? s.at : x(s.b);
        dJointSetDBallAnchor1(joint, dReal(a[0]), dReal(a[1]), dReal(a[2]));
        dJointSetDBallAnchor2(joint, dReal(b[0]), dReal(b[1]), dReal(b[2]));
        dJointSetDBallDistance(joint, dReal(s.rest));
        const double both = scene_.dt * s.stiffness + s.damping;
        dJointSetDBallParam(joint, dParamERP, dReal(scene_.dt * s.stiffness / both));
        dJointSetDBallParam(joint, dParamCFM, dReal(1 / both));
    }
    void remove(int i) override {
        if (at(i).geom) dGeomDestroy(at(i).geom);
        if (at(i).body) dBodyDestroy(at(i).body), --bodies_;
        at(i) = {};
    }
    void step() override {
        if (scene_.pull_of_sun > 0)
            for (const Kept& each : all_) {
                const dReal* r = dBodyGetPosition(each.body);
                dMass mass;
                dBodyGetMass(each.body, &mass);
                const double pull = -scene_.pull_of_sun * mass.mass / std::pow(std::hypot(r[0], r[1], r[2]), 3);
                dBodyAddForce(each.body, dReal(pull * r[0]), dReal(pull * r[1]), dReal(pull * r[2]));
            }
        if (!scene_.springs)
            dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) { static_cast<Ode*>(self)->touch(a, b); });
        dWorldSetQuickStepNumIterations(world_, bodies_ <= few ? passes_for_few : passes);
        if (scene_.springs) dWorldStep(world_, dReal(scene_.dt));
        else dWorldQuickStep(world_, dReal(scene_.dt));
        dJointGroupEmpty(contacts_);
    }
    Vector x(int i) const override {
        return from(at(i).body ? dBodyGetPosition(at(i).body) : dGeomGetPosition(at(i).geom));
    }
    Vector v(int i) const override { return from(dBodyGetLinearVel(at(i).body)); }
    bool asleep(int i) const override { return dBodyIsEnabled(at(i).body) == 0; }
    void put(int i, const Vector& x) override { dGeomSetPosition(at(i).geom, dReal(x[0]), dReal(x[1]), dReal(x[2])); }
    void send(int i, const Vector& v) override { dBodySetLinearVel(at(i).body, dReal(v[0]), dReal(v[1]), dReal(v[2])); }
    void push(int i, const Vector& f) override {
        dBodyEnable(at(i).body);
        dBodyAddForce(at(i).body, dReal(f[0]), dReal(f[1]), dReal(f[2]));
    }
    void set_gravity(const Vector& g) override { dWorldSetGravity(world_, dReal(g[0]), dReal(g[1]), dReal(g[2])); }

private:
    struct Kept {
        dGeomID geom = nullptr;
        dBodyID body = nullptr;
        double bounce = 0, friction = 0;
    };
    static Vector from(const dReal* x) { return {double(x[0]), double(x[1]), double(x[2])}; }
    Kept& at(int i) { return all_[std::size_t(i)]; }
    const Kept& at(int i) const { return all_[std::size_t(i)]; }
    int keep(dGeomID geom, dBodyID body, double bounce, double friction) {
        const int i = int(all_.size());
        // The number, as a pointer's worth of data: what ODE keeps for its user.
        if (geom) dGeomSetData(geom, reinterpret_cast<void*>(std::intptr_t(i)));
        if (body) ++bodies_;
        all_.push_back({geom, body, bounce, friction});
        return i;
    }
    void touch(dGeomID a, dGeomID b) {
        const dBodyID one = dGeomGetBody(a), other = dGeomGetBody(b);
        if (!one && !other) return;
        dContact contact{};
        if (dCollide(a, b, 1, &contact.geom, sizeof(dContact)) == 0) return;
        const Kept &first = at(int(reinterpret_cast<std::intptr_t>(dGeomGetData(a)))),
                   &second = at(int(reinterpret_cast<std::intptr_t>(dGeomGetData(b))));
        const double bounce = std::max(first.bounce, second.bounce);
        contact.surface.mode = dContactApprox1;
        if (bounce > 0) {
            contact.surface.mode |= dContactBounce;
            contact.surface.bounce = dReal(bounce);
            contact.surface.bounce_vel = dReal(scene_.bounces_above);
        }
        if (scene_.soft > 0) {
            const double both = scene_.dt * scene_.soft + scene_.soft_damping;
            contact.surface.mode |= dContactSoftERP | dContactSoftCFM;
            contact.surface.soft_erp = dReal(scene_.dt * scene_.soft / both);
            contact.surface.soft_cfm = dReal(1 / both);
        }
        contact.surface.mu = dReal(std::sqrt(first.friction * second.friction));
        dJointAttach(dJointCreateContact(world_, contacts_, &contact), one, other);
    }
    Scene scene_;
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    dJointGroupID contacts_ = dJointGroupCreate(0);
    std::vector<Kept> all_;
    int bodies_ = 0;
};

peers::Pairs pairs_of(const std::vector<peers::BoxOf>& boxes) {
    const dSpaceID space = dHashSpaceCreate(nullptr);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Vector size = boxes[i].high - boxes[i].low, x = 0.5 * (boxes[i].high + boxes[i].low);
        const dGeomID geom = dCreateBox(space, dReal(size[0]), dReal(size[1]), dReal(size[2]));
        dGeomSetPosition(geom, dReal(x[0]), dReal(x[1]), dReal(x[2]));
        dGeomSetData(geom, reinterpret_cast<void*>(std::intptr_t(i)));
    }
    peers::Pairs pairs;
    dSpaceCollide(space, &pairs, [](void* all, dGeomID a, dGeomID b) {
        const int i = int(reinterpret_cast<std::intptr_t>(dGeomGetData(a))),
                  j = int(reinterpret_cast<std::intptr_t>(dGeomGetData(b)));
        static_cast<peers::Pairs*>(all)->emplace_back(std::min(i, j), std::max(i, j));
    });
    dSpaceDestroy(space);
    return pairs;
}

} // namespace

peers::Contestant peers::ode() {
    return {.name = "ODE",
            .version = dODE_VERSION,
            .scalar = sizeof(dReal) == 4 ? "float" : "double",
            .epsilon = double(std::numeric_limits<dReal>::epsilon()),
            .slop = 0.001,
            .settings = {"contacts: dWorldQuickStep with " + std::to_string(passes_for_few) + " iterations for up to " +
                             std::to_string(few) + " bodies and " + std::to_string(passes) +
                             " beyond, since dWorldStep gives up at balls exactly upon each other",
                         "springs: dWorldStep",
                         "ERP 0.2 and CFM as they are, contact surface layer 1 mm, contacts separate at 1 m/s at most",
                         "springs: double-ball joints, ERP = hk / (hk + c), CFM = 1 / (hk + c)",
                         "broadphase dHashSpace"},
            .does_more = {"bodies that turn, with their inertia", "capsules, cylinders, meshes and height fields",
                          "hinges, sliders, universal joints and motors",
                          "a direct solver beside the iterative one (Dantzig)"},
            .make = [](const Scene& scene) { return std::make_unique<Ode>(scene); },
            .pairs = pairs_of};
}
