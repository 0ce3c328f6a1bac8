// SPDX-License-Identifier: BSL-1.0
// Bullet: its discrete world with the settings that its manual and its headers recommend.

#include "tests/peers/cases/engine.hpp"

#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using peers::Ball;
using peers::Scene;
using peers::Vector;

constexpr int passes = 50; // 10 by default; the manual asks for more where masses differ or much is stacked

btVector3 to(const Vector& x) { return {btScalar(x[0]), btScalar(x[1]), btScalar(x[2])}; }
Vector from(const btVector3& x) { return {double(x.x()), double(x.y()), double(x.z())}; }

/// Materials meet as in Ansatz and Box2D: the larger restitution, the geometric mean of friction.
btScalar bounce_of(const btCollisionObject* a, const btCollisionObject* b) {
    return std::max(a->getRestitution(), b->getRestitution());
}
btScalar friction_of(const btCollisionObject* a, const btCollisionObject* b) {
    return std::sqrt(a->getFriction() * b->getFriction());
}

class Bullet : public peers::Engine {
public:
    explicit Bullet(const Scene& scene) : scene_(scene) {
        gCalculateCombinedRestitutionCallback = bounce_of;
        gCalculateCombinedFrictionCallback = friction_of;
        gContactBreakingThreshold = btScalar(0.02 * scene.size);
        if (scene.slow > 0) gDeactivationTime = btScalar(scene.slow_for); // 2 s by itself
        btContactSolverInfo& solver = world_.getSolverInfo();
        solver.m_numIterations = passes;
        solver.m_splitImpulse = 1;
        solver.m_splitImpulsePenetrationThreshold = btScalar(-0.04 * scene.size);
        solver.m_restitutionVelocityThreshold = btScalar(scene.bounces_above);
        world_.getDispatchInfo().m_useContinuous = true;
        world_.setGravity(to(scene.gravity));
    }
    ~Bullet() override {
        for (auto& joint : joints_) world_.removeConstraint(joint.get());
        for (auto& body : bodies_)
            if (body) world_.removeRigidBody(body.get());
    }
    int add(const Ball& ball) override {
        shapes_.push_back(std::make_unique<btSphereShape>(btScalar(ball.radius)));
        const int i = add_body(ball.mass, ball.x, ball.bounce, ball.friction);
        btRigidBody& body = *bodies_.back();
        body.setLinearVelocity(to(ball.v));
        body.setAngularFactor(0);
        if (scene_.detection == Scene::Detection::continuous) {
            body.setCcdMotionThreshold(btScalar(ball.radius));
            body.setCcdSweptSphereRadius(btScalar(0.9 * ball.radius));
        }
        if (scene_.drag > 0) body.setDamping(btScalar(1 - std::exp(-scene_.drag)), 0); // what is lost in a second
        return i;
    }
    int plane(const Vector& normal, double offset, double bounce, double friction) override {
        shapes_.push_back(std::make_unique<btStaticPlaneShape>(to(normal), btScalar(offset)));
        const int i = add_body(0, Vector::Zero(), bounce, friction);
        if (scene_.soft > 0)
            bodies_.back()->setContactStiffnessAndDamping(btScalar(scene_.soft), btScalar(scene_.soft_damping));
        return i;
    }
    int box(const Vector& x, const Vector& half, double bounce, double friction) override {
        shapes_.push_back(std::make_unique<btBoxShape>(to(half)));
        return add_body(0, x, bounce, friction);
    }
    int platform(const Vector& x, const Vector& half) override {
        const int i = box(x, half, 0, 0);
        auto& body = *bodies_.back();
        body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        body.setActivationState(DISABLE_DEACTIVATION); // the manual: of kinematic bodies
        states_.push_back(std::make_unique<btDefaultMotionState>(body.getWorldTransform()));
        body.setMotionState(states_.back().get());
        platforms_.push_back({i, Vector::Zero()});
        return i;
    }
    void add(const peers::SpringOf& s) override {
        btRigidBody& a = body(s.a);
        const Vector end = s.b < 0 ? s.at : x(s.b), way = x(s.a) - end;
        int axis = 0;
        way.cwiseAbs().maxCoeff(&axis);
        const btTransform here = btTransform::getIdentity();
        std::unique_ptr<btGeneric6DofSpring2Constraint> joint;
        btTransform there = here;
        if (s.b < 0) {
            points_.push_back(std::make_unique<btRigidBody>(0, nullptr, nullptr));
            there.setOrigin(to(s.at));
            joint = std::make_unique<btGeneric6DofSpring2Constraint>(*points_.back(), a, there, here);
        } else joint = std::make_unique<btGeneric6DofSpring2Constraint>(body(s.b), a, here, here);
        for (int k = 0; k < 6; ++k) joint->setLimit(k, 1, -1); // free
        joint->enableSpring(axis, true);
        joint->setStiffness(axis, btScalar(s.stiffness));
        joint->setDamping(axis, btScalar(s.damping));
        joint->setEquilibriumPoint(axis, btScalar(way[axis] < 0 ? -s.rest : s.rest));
        world_.addConstraint(joint.get(), true);
        joints_.push_back(std::move(joint));
    }
    void remove(int i) override {
        world_.removeRigidBody(&body(i));
        bodies_[std::size_t(i)].reset();
    }
    void step() override {
        for (const auto& [i, velocity] : platforms_) {
            btTransform now;
            body(i).getMotionState()->getWorldTransform(now);
            now.setOrigin(now.getOrigin() + to(velocity * scene_.dt));
            body(i).getMotionState()->setWorldTransform(now);
        }
        if (scene_.pull_of_sun > 0)
            for (auto& each : bodies_) {
                const Vector r = from(each->getWorldTransform().getOrigin());
                each->applyCentralForce(to(-scene_.pull_of_sun / each->getInvMass() / std::pow(r.norm(), 3) * r));
            }
        world_.stepSimulation(btScalar(scene_.dt), 0);
    }
    Vector x(int i) const override { return from(body(i).getWorldTransform().getOrigin()); }
    Vector v(int i) const override { return from(body(i).getLinearVelocity()); }
    bool asleep(int i) const override { return !body(i).isActive(); }
    void put(int i, const Vector& x) override {
        btTransform there = btTransform::getIdentity();
        there.setOrigin(to(x));
        body(i).setWorldTransform(there);
    }
    void send(int i, const Vector& v) override {
        for (auto& [platform, velocity] : platforms_)
            if (platform == i) velocity = v;
        if (!body(i).isStaticOrKinematicObject()) body(i).setLinearVelocity(to(v));
    }
    void push(int i, const Vector& force) override {
        body(i).activate();
        body(i).applyCentralForce(to(force));
    }
    void set_gravity(const Vector& g) override { world_.setGravity(to(g)); }

private:
    btRigidBody& body(int i) const { return *bodies_[std::size_t(i)]; }
    int add_body(double mass, const Vector& x, double bounce, double friction) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shapes_.back()->calculateLocalInertia(btScalar(mass), inertia);
        btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), nullptr, shapes_.back().get(), inertia);
        info.m_startWorldTransform.setOrigin(to(x));
        info.m_restitution = btScalar(bounce);
        info.m_friction = btScalar(friction);
        if (scene_.slow > 0) // 0.8 m/s by itself
            info.m_linearSleepingThreshold = info.m_angularSleepingThreshold = btScalar(scene_.slow);
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        if (!scene_.sleeps) bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
        if (scene_.springs) world_.addRigidBody(bodies_.back().get(), 1, 0); // meets nobody
        else world_.addRigidBody(bodies_.back().get());
        return int(bodies_.size()) - 1;
    }
    Scene scene_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btDefaultMotionState>> states_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_, points_;
    std::vector<std::pair<int, Vector>> platforms_;
    std::vector<std::unique_ptr<btGeneric6DofSpring2Constraint>> joints_;
};

peers::Pairs pairs_of(const std::vector<peers::BoxOf>& boxes) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase tree;
    std::vector<int> numbers(boxes.size());
    std::vector<btBroadphaseProxy*> proxies;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        numbers[i] = int(i);
        proxies.push_back(tree.createProxy(to(boxes[i].low), to(boxes[i].high), 0, &numbers[i],
                                           btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter,
                                           &dispatcher));
    }
    tree.calculateOverlappingPairs(&dispatcher);
    peers::Pairs pairs;
    auto& found = tree.getOverlappingPairCache()->getOverlappingPairArray();
    for (int k = 0; k < found.size(); ++k) {
        const int a = *static_cast<int*>(found[k].m_pProxy0->m_clientObject),
                  b = *static_cast<int*>(found[k].m_pProxy1->m_clientObject);
        pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
    for (auto* proxy : proxies) tree.destroyProxy(proxy, &dispatcher);
    return pairs;
}

} // namespace

peers::Contestant peers::bullet() {
    const int version = btGetVersion();
    return {.name = "Bullet",
            .version = std::to_string(version / 100) + "." + std::to_string(version % 100),
            .scalar = sizeof(btScalar) == 4 ? "float" : "double",
            .epsilon = double(std::numeric_limits<btScalar>::epsilon()),
            .settings = {"btDiscreteDynamicsWorld, sequential impulses, warm start, split impulse",
                         std::to_string(passes) + " iterations, of which 10 are the default",
                         "continuous detection where a row asks for it: motion threshold r, swept sphere of 0.9 r",
                         "springs: btGeneric6DofSpring2Constraint, with its limits of stiffness and damping",
                         "broadphase btDbvtBroadphase"},
            .does_more = {"bodies that turn, with their inertia", "convex hulls, capsules, meshes and height fields",
                          "hinges, sliders, motors, cones and gears", "articulated bodies (Featherstone)",
                          "vehicles and characters", "solvers to choose from, Dantzig and Lemke among them"},
            .make = [](const Scene& scene) { return std::make_unique<Bullet>(scene); },
            .pairs = pairs_of};
}
