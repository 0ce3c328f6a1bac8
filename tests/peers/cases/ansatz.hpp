// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Ansatz in `peers cases`: one composition for all rows with contacts, one for springs and orbits, and the verbs that
/// the rows ask for. Two files fill them in, for double and for float, so that no compilation becomes too long.

#include "tests/peers/cases/engine.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <limits>
#include <type_traits>

namespace peers {

/// A law of its own, for orbits: a = -mu r / |r|^3.
struct Sun {
    using role = ansatz::roles::Force;
    using reads = ansatz::Columns<ansatz::Position>;
    double mu = 0; ///< m^3/s^2; zero is no sun
    template <class S> struct In {
        using Scalar = typename S::Scalar;
        Scalar mu;
        explicit In(const Sun& sun) : mu(Scalar(sun.mu)) {}
        typename S::Acceleration acceleration(const typename S::Position& x, const auto&) const {
            const auto r = x.value();
            const Scalar d = r.norm();
            if (!(mu > 0)) return S::Acceleration::from_value(Scalar(0) * r);
            return S::Acceleration::from_value(-mu / (d * d * d) * r);
        }
    };
};

/// Rows, as each scene fills them in.
template <class W> class OurEngine : public Engine {
public:
    using S = typename W::S;
    static constexpr bool collides = requires(const W& w) { w.contacts(); };
    static constexpr bool rubs = W::composition::template stores<ansatz::Friction>;

    OurEngine(const Scene& scene, W world) : scene_(scene), world_(std::move(world)) {}

    int add(const Ball& ball) override {
        using namespace ansatz;
        const auto at = position(Vector(ball.x) * metre);
        const auto going = velocity(Vector(ball.v) * metre_per_second);
        if constexpr (rubs)
            return keep(world_.add(Sphere{ball.radius * metre}, at, going, mass(ball.mass * kilogram),
                                   restitution(ball.bounce), friction(ball.friction)));
        else if constexpr (collides)
            return keep(world_.add(Sphere{ball.radius * metre}, at, going, mass(ball.mass * kilogram)));
        else return keep(world_.add(at, going, mass(ball.mass * kilogram)));
    }
    int plane(const Vector& normal, double offset, double bounce, double rough) override {
        using namespace ansatz;
        if constexpr (rubs)
            return keep(world_.add(Plane{normal, offset * metre}, fixed, restitution(bounce), friction(rough)));
        else if constexpr (collides) return keep(world_.add(Plane{normal, offset * metre}, fixed));
        else throw Cannot("this composition has no contacts");
    }
    int box(const Vector& x, const Vector& half, double bounce, double rough) override {
        using namespace ansatz;
        if constexpr (rubs)
            return keep(world_.add(Box{metres(half[0], half[1], half[2])}, position(Vector(x) * metre), fixed,
                                   restitution(bounce), friction(rough)));
        else throw Cannot("this composition has no such boxes");
    }
    int platform(const Vector& x, const Vector& half) override {
        using namespace ansatz;
        if constexpr (collides)
            return keep(world_.add(Box{metres(half[0], half[1], half[2])}, position(Vector(x) * metre), moving));
        else throw Cannot("this composition has no contacts");
    }
    void add(const SpringOf& s) override {
        using namespace ansatz;
        if constexpr (!collides) {
            const auto k = s.stiffness * newton_per_metre;
            const auto c = s.damping * newton_second_per_metre;
            if (s.b < 0) world_.add(Spring{metres(s.at[0], s.at[1], s.at[2]), at(s.a), k, c, s.rest * metre});
            else world_.add(Spring{at(s.a), at(s.b), k, c, s.rest * metre});
        } else throw Cannot("this composition has no springs");
    }
    void remove(int i) override { world_.remove(at(i)); }
    void step() override { world_.step(scene_.dt * ansatz::second); }

    Vector x(int i) const override { return world_.position(at(i)).value().template cast<double>(); }
    Vector v(int i) const override { return world_.velocity(at(i)).value().template cast<double>(); }
    bool asleep(int i) const override { return world_.motion(at(i)) == ansatz::Motion::resting; }
    void put(int i, const Vector& x) override { world_.set_position(at(i), Vector(x) * ansatz::metre); }
    void send(int i, const Vector& v) override { world_.set_velocity(at(i), Vector(v) * ansatz::metre_per_second); }
    void push(int i, const Vector& force) override {
        world_.apply_force(at(i), ansatz::newtons(force[0], force[1], force[2]));
    }
    void set_gravity(const Vector& g) override {
        world_.set(ansatz::Gravity{ansatz::metres_per_second_squared(g[0], g[1], g[2])});
    }

private:
    ansatz::Handle at(int i) const { return bodies_[std::size_t(i)]; }
    int keep(ansatz::Handle body) {
        bodies_.push_back(body);
        return int(bodies_.size()) - 1;
    }
    Scene scene_;
    W world_;
    std::vector<ansatz::Handle> bodies_;
};
template <class W> std::unique_ptr<Engine> our_engine(const Scene& scene, W world) {
    return std::make_unique<OurEngine<W>>(scene, std::move(world));
}

/// The one composition for contacts: docs/collision.md, "what is supported". Eight substeps at 120/s hold 300 : 1.
template <class Space_, class Narrow, class Integrator = ansatz::SemiImplicitEuler>
std::unique_ptr<Engine> our_contacts(const Scene& scene, const Narrow& narrowphase, const Integrator& integrator = {}) {
    using namespace ansatz;
    const Vector& g = scene.gravity;
    SoftSubsteps<Friction> response;
    response.parts = 8;
    response.frequency = 120.0 * hertz;
    response.push_out = 1.5 * scene.size * metre_per_second;
    response.threshold = scene.bounces_above * metre_per_second;
    Rest rest;
    if (scene.slow > 0) {
        rest.threshold = scene.slow * metre_per_second;
        rest.time = (scene.sleeps ? scene.slow_for : 1e30) * second; // nobody sleeps
    }
    rest.pull = 1e-3 * scene.size * metre_per_second_squared;
    return our_engine(scene, World{Space_{}, integrator, Gravity{metres_per_second_squared(g[0], g[1], g[2])},
                                   AppliedForces{}, UniformGrid{}, narrowphase, response, rest});
}
/// Contacts that are springs: Penalty, in implicit steps.
template <class Space_> std::unique_ptr<Engine> our_soft_contacts(const Scene& scene) {
    using namespace ansatz;
    const Vector& g = scene.gravity;
    return our_engine(scene,
                      World{Space_{}, ImplicitEuler{}, Gravity{metres_per_second_squared(g[0], g[1], g[2])},
                            AppliedForces{}, UniformGrid{}, Narrowphase<Sphere, Plane, Box>{},
                            Penalty{scene.soft * newton_per_metre, scene.soft_damping * newton_second_per_metre}});
}
/// Springs, orbits and drag: velocity Verlet where the step resolves them, and else implicit Euler (docs/springs.md).
template <class Space_, class Integrator>
std::unique_ptr<Engine> our_flights(const Scene& scene, const Integrator& integrator) {
    using namespace ansatz;
    const Vector& g = scene.gravity;
    const Gravity gravity{metres_per_second_squared(g[0], g[1], g[2])};
    if constexpr (std::same_as<Integrator, ImplicitEuler>)
        return our_engine(scene, World{Space_{}, integrator, gravity, Springs{}, AppliedForces{}});
    else
        return our_engine(scene, World{Space_{}, integrator, gravity, Springs{}, AppliedForces{},
                                       Drag{scene.drag / second}, Sun{scene.pull_of_sun}});
}
template <class Space_> std::unique_ptr<Engine> ours(const Scene& scene) {
    using namespace ansatz;
    if (scene.springs && !scene.resolved) return our_flights<Space_>(scene, ImplicitEuler{});
    if (scene.springs) return our_flights<Space_>(scene, VelocityVerlet{});
    using Shapes = Narrowphase<Sphere, Plane, Box>;
    if (scene.soft > 0) return our_soft_contacts<Space_>(scene);
    if (scene.detection == Scene::Detection::continuous) return our_contacts<Space_>(scene, Swept<Shapes>{});
    if (scene.far) return our_contacts<Space_>(scene, Shapes{}, Compensated<SemiImplicitEuler>{});
    return our_contacts<Space_>(scene, Shapes{});
}

template <class S> Pairs our_pairs(const std::vector<BoxOf>& told) {
    using namespace ansatz;
    UniformGrid<> policy;
    typename UniformGrid<>::template In<S> grid(policy);
    Boxes<S> boxes;
    boxes.resize(told.size());
    boxes.set_active(told.size());
    for (std::size_t i = 0; i < told.size(); ++i) {
        const Vector &low = told[i].low, &high = told[i].high;
        boxes.set(i, S::convert(metres(low[0], low[1], low[2])), S::convert(metres(high[0], high[1], high[2])));
    }
    Pairs pairs;
    grid.find(boxes,
              [&](std::size_t a, std::size_t b) { pairs.emplace_back(int(std::min(a, b)), int(std::max(a, b))); });
    return pairs;
}

/// The same words for both scalars.
template <class Scalar> Contestant our_contestant() {
    using S = ansatz::Space<Scalar, 3>;
    const std::string scalar = std::is_same_v<Scalar, float> ? "float" : "double";
    return {.name = "Ansatz " + scalar,
            .version = ANSATZ_PEERS_VERSION,
            .scalar = scalar,
            .epsilon = double(std::numeric_limits<Scalar>::epsilon()),
            .settings = {"contacts: SemiImplicitEuler, UniformGrid, Narrowphase<Sphere, Plane, Box>, "
                         "SoftSubsteps<Friction> with 8 substeps at 120/s, Rest",
                         "Swept where a row asks for continuous detection, Compensated where it is far from the origin",
                         "springs, orbits and drag: VelocityVerlet where the step resolves them, else ImplicitEuler"},
            .make = ours<S>,
            .pairs = our_pairs<S>};
}

} // namespace peers
