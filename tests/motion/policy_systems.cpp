// SPDX-License-Identifier: BSL-1.0
// Systems of policies: rows, tables and drivers do at their phase what they say, whatever the integrator keeps.

#include <ansatz/motion/policy_systems.hpp>
#include <ansatz/world.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace ansatz;

namespace {

/// Divides a step into equal substeps, and keeps when each began and how long it was.
template <int Parts> struct Divides {
    using role = roles::System;
    static constexpr std::string_view name = "Divides";
    template <class S> struct State {
        std::vector<double> lengths;
        static void fields(auto& self, auto&& field) { field("lengths", self.lengths); }
    };
    template <class S> struct Drive {
        static constexpr Phase phase = phases::substeps, until = phases::end;
        static constexpr std::string_view name = "divides: drive";
        explicit Drive(const Divides&) {}
        void run(auto& view, const auto& dt, auto& part) const {
            const typename S::Time h = dt / typename S::Scalar(Parts);
            for (int i = 0; i < Parts; ++i) {
                view.state().lengths.push_back(double(h.value()));
                i + 1 < Parts ? part(h) : part.last(h);
            }
        }
    };
    template <class S> using systems = Types<Drive<S>>;
};
/// A force that depends on time, so that wrong times of substeps are seen: a = t in the first direction.
struct Ramp {
    using role = roles::Force;
    using reads = Columns<Clock>;
    template <class S> struct In {
        explicit In(const Ramp&) {}
        typename S::Acceleration acceleration(const auto& context) const {
            auto a = S::template zero_vector<unit::Acceleration>().value();
            a[0] = typename S::Scalar(context.time().value());
            return S::Acceleration::from_value(a);
        }
    };
};
/// A table system that gives every awake body a push along x at the end of each step.
struct Pushes {
    using role = roles::System;
    template <class S> struct Push {
        static constexpr Phase phase = phases::fields;
        static constexpr std::string_view name = "pushes";
        using writes = Columns<Velocity>;
        explicit Push(const Pushes&) {}
        void run(auto& view, const auto& context) const {
            for (std::size_t slot = view.begin(Motion::awake); slot < view.end(Motion::awake); ++slot) {
                auto v = view.template get<Velocity>(slot).value();
                v[0] += 3 * context.dt().value();
                view.template set<Velocity>(slot, S::Velocity::from_value(v));
            }
        }
    };
    template <class S> using systems = Types<Push<S>>;
};
/// A row system that slows, exactly like the effect Drag with this factor would at its place.
struct Brakes {
    using role = roles::System;
    template <class S> struct Slow {
        static constexpr Phase phase = phases::fields;
        static constexpr std::string_view name = "brakes";
        using writes = Columns<Velocity>;
        explicit Slow(const Brakes&) {}
        void apply(auto& v, const auto&) const { v *= typename S::Scalar(0.5); }
    };
    template <class S> using systems = Types<Slow<S>>;
};

} // namespace

TEMPLATE_TEST_CASE("A driver takes the step in substeps: as many short steps, to the bit", "[systems]", ExplicitEuler,
                   SemiImplicitEuler, Verlet, VelocityVerlet, RungeKutta4) {
    World whole{TestType{}, Ramp{}, Gravity{}};
    World divided{TestType{}, Ramp{}, Gravity{}, Divides<4>{}};
    const auto a = whole.add(velocity(metres_per_second(1, 2, 3)));
    const auto b = divided.add(velocity(metres_per_second(1, 2, 3)));
    for (int i = 0; i < 64; ++i) whole.step(1.0 / 64 * second); // binary: the clock makes no rounding
    for (int i = 0; i < 16; ++i) divided.step(1.0 / 16 * second);
    CHECK(divided.position(b) == whole.position(a));
    CHECK(divided.tick() == 16);
    CHECK(divided.time() == whole.time());
}
TEMPLATE_TEST_CASE("A force from outside acts through all substeps of a step and then is gone", "[systems]",
                   SemiImplicitEuler, Verlet, VelocityVerlet, RungeKutta4) {
    World world{TestType{}, AppliedForces{}, Divides<5>{}};
    const auto body = world.add(mass(2.0 * kilogram));
    world.apply_force(body, newtons(10, 0, 0));
    for (int i = 0; i < 3; ++i) world.step(0.5 * second);
    CHECK(world.velocity(body).value()[0] == Approx(10 * 0.5 / 2)); // J = F dt = m dv
}
TEMPLATE_TEST_CASE("A table system changes velocities through the integrator", "[systems]", ExplicitEuler,
                   SemiImplicitEuler, Verlet, VelocityVerlet, RungeKutta4) {
    World world{TestType{}, Pushes{}};
    const auto body = world.add(velocity(metres_per_second(0, 1, 0)));
    for (int i = 0; i < 100; ++i) world.step(0.01 * second);
    CHECK(world.velocity(body).value()[0] == Approx(3).epsilon(1e-9));
    CHECK(world.velocity(body).value()[1] == Approx(1).epsilon(1e-9));
    CHECK(world.position(body).value()[1] == Approx(1).epsilon(1e-9));
    CHECK(world.position(body).value()[0] == Approx(1.5).epsilon(0.02)); // a push is late by up to a step
}
TEMPLATE_TEST_CASE("A row system is an effect at a phase of its own", "[systems]", ExplicitEuler, SemiImplicitEuler,
                   Verlet, VelocityVerlet, RungeKutta4) {
    World world{TestType{}, Brakes{}};
    const auto body = world.add(velocity(metres_per_second(8, 0, 0)));
    double expected = 0;
    for (int i = 0; i < 3; ++i) {
        world.step(1.0 * second);
        expected += 8 * std::pow(0.5, i);
    }
    CHECK(world.velocity(body).value()[0] == Approx(1));
    CHECK(world.position(body).value()[0] == Approx(expected));
}
TEST_CASE("A world without a system is the same to the bit as one whose system touches nothing", "[systems]") {
    World plain{SemiImplicitEuler{}, Gravity{}};
    World watched{SemiImplicitEuler{}, Gravity{}, Divides<1>{}};
    const auto a = plain.add(), b = watched.add();
    for (int i = 0; i < 10; ++i) {
        plain.step(0.01 * second);
        watched.step(0.01 * second);
    }
    CHECK(plain.position(a) == watched.position(b));
    CHECK(decltype(plain)::bytes_per_body == decltype(watched)::bytes_per_body);
}
