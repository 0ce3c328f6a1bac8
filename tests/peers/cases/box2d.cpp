// SPDX-License-Identifier: BSL-1.0
// Box2D, in two dimensions: circles for spheres, 8 and 3 iterations as its manual suggests.

#include "tests/peers/cases/engine.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace {

using peers::Ball;
using peers::Scene;
using peers::Vector;

constexpr int of_velocity = 8, of_position = 3; // iterations
constexpr double wide = 100, thick = 10;        // m, half of the box that stands for a plane

b2Vec2 to(const Vector& x) { return {float(x[0]), float(x[1])}; }
Vector from(const b2Vec2& x) { return {double(x.x), double(x.y), 0}; }

class Box2d : public peers::Engine {
public:
    explicit Box2d(const Scene& scene) : scene_(scene), world_(to(scene.gravity)) {
        if (scene.soft > 0) throw peers::Cannot("its contacts are hard");
        world_.SetAllowSleeping(scene.sleeps);
        world_.SetContinuousPhysics(scene.detection != Scene::Detection::discrete);
    }
    int add(const Ball& ball) override {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position = to(ball.x);
        def.linearVelocity = to(ball.v);
        def.fixedRotation = true;
        def.bullet = scene_.detection == Scene::Detection::continuous;
        def.linearDamping = float(scene_.drag);
        b2CircleShape shape;
        shape.m_radius = float(ball.radius);
        const int i = add_body(def, shape, ball.bounce, ball.friction);
        const b2MassData mass{float(ball.mass), {0, 0}, float(ball.mass * ball.radius * ball.radius)};
        bodies_.back()->SetMassData(&mass);
        return i;
    }
    int plane(const Vector& normal, double offset, double bounce, double friction) override {
        b2BodyDef def;
        def.position = to(normal * (offset - thick));
        def.angle = float(std::atan2(normal[1], normal[0]) - std::acos(-1.0) / 2);
        if (std::abs(normal[1]) == 1 && normal[0] == 0) def.angle = 0; // no rounding of an angle where none is needed
        b2PolygonShape shape;
        shape.SetAsBox(float(wide), float(thick));
        return add_body(def, shape, bounce, friction);
    }
    int box(const Vector& x, const Vector& half, double bounce, double friction) override {
        b2BodyDef def;
        def.position = to(x);
        b2PolygonShape shape;
        shape.SetAsBox(float(half[0]), float(half[1]));
        return add_body(def, shape, bounce, friction);
    }
    int platform(const Vector& x, const Vector& half) override {
        b2BodyDef def;
        def.type = b2_kinematicBody;
        def.position = to(x);
        b2PolygonShape shape;
        shape.SetAsBox(float(half[0]), float(half[1]));
        return add_body(def, shape, 0, 0);
    }
    void add(const peers::SpringOf& s) override {
        b2DistanceJointDef def;
        def.bodyA = &body(s.a);
        if (s.b < 0) {
            b2BodyDef point;
            point.position = to(s.at);
            def.bodyB = world_.CreateBody(&point);
        } else def.bodyB = &body(s.b);
        def.length = float(s.rest);
        def.stiffness = float(s.stiffness);
        def.damping = float(s.damping);
        world_.CreateJoint(&def);
    }
    void remove(int i) override { world_.DestroyBody(&body(i)); }
    void step() override {
        if (scene_.pull_of_sun > 0)
            for (b2Body* each : bodies_) {
                const Vector r = from(each->GetPosition());
                const double pull = -scene_.pull_of_sun * double(each->GetMass()) / std::pow(r.norm(), 3);
                each->ApplyForceToCenter(to(pull * r), true);
            }
        world_.Step(float(scene_.dt), of_velocity, of_position);
    }
    Vector x(int i) const override { return from(body(i).GetPosition()); }
    Vector v(int i) const override { return from(body(i).GetLinearVelocity()); }
    bool asleep(int i) const override { return !body(i).IsAwake(); }
    void put(int i, const Vector& x) override { body(i).SetTransform(to(x), 0); }
    void send(int i, const Vector& v) override { body(i).SetLinearVelocity(to(v)); }
    void push(int i, const Vector& force) override { body(i).ApplyForceToCenter(to(force), true); }
    void set_gravity(const Vector& g) override { world_.SetGravity(to(g)); }

private:
    b2Body& body(int i) const { return *bodies_[std::size_t(i)]; }
    int add_body(const b2BodyDef& def, const b2Shape& shape, double bounce, double friction) {
        b2Body* body = world_.CreateBody(&def);
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.density = 1;
        fixture.restitution = float(bounce);
        // Its own threshold is 1 m/s; a lower one makes contacts tremble.
        if (!(scene_.bounces_above > 0)) fixture.restitutionThreshold = 0;
        fixture.friction = float(friction);
        if (scene_.springs) fixture.filter.maskBits = 0; // meets nobody
        body->CreateFixture(&fixture);
        bodies_.push_back(body);
        return int(bodies_.size()) - 1;
    }
    Scene scene_;
    b2World world_;
    std::vector<b2Body*> bodies_;
};

/// Its broadphase fattens boxes by 10 cm, so that it tells more pairs than touch.
peers::Pairs pairs_of(const std::vector<peers::BoxOf>& boxes) {
    struct Told {
        peers::Pairs pairs;
        void AddPair(void* a, void* b) {
            const int i = int(reinterpret_cast<std::intptr_t>(a)), j = int(reinterpret_cast<std::intptr_t>(b));
            pairs.emplace_back(std::min(i, j), std::max(i, j));
        }
    } told;
    b2BroadPhase tree;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const b2AABB box{to(boxes[i].low), to(boxes[i].high)};
        tree.CreateProxy(box, reinterpret_cast<void*>(std::intptr_t(i)));
    }
    tree.UpdatePairs(&told);
    return told.pairs;
}

} // namespace

peers::Contestant peers::box2d() {
    return {
        .name = "Box2D",
        .version = std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) + "." +
                   std::to_string(b2_version.revision),
        .scalar = "float",
        .epsilon = double(std::numeric_limits<float>::epsilon()),
        .flat = true,
        .slop = double(b2_linearSlop),
        .settings = {"two dimensions: circles for spheres, a box of 200 m by 20 m for a plane",
                     std::to_string(of_velocity) + " iterations of velocity, " + std::to_string(of_position) +
                         " of position",
                     "bullets where a row asks for continuous detection, none where it asks for discrete",
                     "its sleep (0.01 m/s, 0.5 s), its slop (5 mm) and its speed limit (2 m a step) are compiled in",
                     "springs: b2DistanceJoint with stiffness and damping",
                     "broadphase b2BroadPhase, its boxes fattened by 0.1 m"},
        .does_more = {"bodies that turn, with their inertia", "convex polygons, edges and chains",
                      "continuous detection of bodies that turn", "hinges, sliders, wheels, gears, pulleys, motors"},
        .make = [](const Scene& scene) { return std::make_unique<Box2d>(scene); },
        .pairs = pairs_of};
}
