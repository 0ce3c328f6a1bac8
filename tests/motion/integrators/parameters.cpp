// SPDX-License-Identifier: BSL-1.0
// Parameters of integrators at run time: one of a user's own, in every way that a world runs its stages, and those of
// ImplicitEuler.

#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>

using namespace ansatz;

namespace {

//! [blend]
/// Between explicit Euler (0) and semi-implicit Euler (1): how much of the new velocity moves the body.
struct Blend {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    double share = 1;

    static constexpr std::string_view name = "Blend";
    static void parameters(auto& self, auto&& visit) { visit("share", self.share); }
    void check() const {
        if (!(share >= 0 && share <= 1)) refuse_value("Blend", "share", share, "it is 0 to 1");
    }
    template <class S> struct In {
        typename S::Scalar share;
        explicit In(const Blend& blend) : share(typename S::Scalar(blend.share)) {}
        [[gnu::always_inline]] void advance(Stage<0>, auto& x, auto& v, const auto& a, const auto& dt) const {
            const auto old = v;
            v += a * dt;
            x += (share * v + (typename S::Scalar(1) - share) * old) * dt;
        }
    };
};
//! [blend]
static_assert(StagedIntegratorIn<Blend, Space<>> && StagedIntegratorIn<Blend, Space<float, 2>>);

/// The same, where a stage takes the position by value: nothing would move.
struct Copies : Blend {
    template <class S> struct In {
        explicit In(const Copies&) {}
        void advance(Stage<0>, typename S::Position, auto&, const auto&, const auto&) const {}
    };
};
static_assert(!StagedIntegratorIn<Copies, Space<>>);

template <class Scalar, class I, class... P> auto thrown(const I& integrator, const P&... others) {
    World world{Space<Scalar, 2>{}, integrator, Gravity{}, QuadraticDrag{0.3 * kilogram_per_metre}, others...};
    world.add(position(metres(0, 2)), velocity(metres_per_second(3, 4)), mass(2.0 * kilogram));
    world.add(position(metres(1, 0)), velocity(metres_per_second(1, 0)), moving);
    return world;
}
template <class Scalar, class I> auto hung(const I& integrator) {
    World world{Space<Scalar, 2>{}, integrator, Gravity{}, Springs{}};
    const auto nail = world.add(position(metres(0, 0)), velocity(metres_per_second(0.5, 0)), moving);
    const auto ball = world.add(position(metres(1, 0)), mass(0.5 * kilogram));
    world.add(Spring{nail, ball, 80.0 * newton_per_metre, 0.4 * newton_second_per_metre, 0.9 * metre});
    return world;
}
template <class A, class B> void same_motion(A a, B b) {
    for (int i = 0; i < 100; ++i) {
        a.step(1.0 / 60 * second);
        b.step(1.0 / 60 * second);
    }
    const auto of_a = a.handles();
    const auto of_b = b.handles();
    for (std::size_t i = 0; i < of_a.size(); ++i) {
        CHECK(a.position(of_a[i]) == b.position(of_b[i]));
        CHECK(a.velocity(of_a[i]) == b.velocity(of_b[i]));
    }
}

} // namespace

TEMPLATE_TEST_CASE("An integrator with a parameter is the one that it names, to the bit", "[integrators]", double,
                   float) {
    same_motion(thrown<TestType>(Blend{1}), thrown<TestType>(SemiImplicitEuler{}));
    same_motion(thrown<TestType>(Blend{0}), thrown<TestType>(ExplicitEuler{}));
    same_motion(hung<TestType>(Blend{1}), hung<TestType>(SemiImplicitEuler{}));
    same_motion(hung<TestType>(Blend{0}), hung<TestType>(ExplicitEuler{}));
}
TEST_CASE("It is changed at run time, in this world and no copy of it", "[integrators]") {
    auto world = hung<double>(Blend{0});
    auto before = world;
    world.set(Blend{1});
    CHECK(world.get<Blend>().share == 1);
    CHECK(before.get<Blend>().share == 0);
    same_motion(world, hung<double>(SemiImplicitEuler{}));
    same_motion(before, hung<double>(ExplicitEuler{}));
    CHECK_THROWS_WITH(world.set(Blend{1.5}), Catch::Contains("Blend") && Catch::Contains("share") &&
                                                 Catch::Contains("1.5") && Catch::Contains("0 to 1"));
    CHECK(world.get<Blend>().share == 1);
    CHECK_THROWS_WITH(hung<double>(Blend{-1}), Catch::Contains("share"));
}
TEST_CASE("It is saved and loaded with the world", "[integrators]") {
    auto world = hung<double>(Blend{0.25});
    std::stringstream file;
    save(world, file);
    auto loaded = hung<double>(Blend{1});
    load(loaded, file);
    CHECK(loaded.get<Blend>().share == 0.25);
    same_motion(world, loaded);
}
TEST_CASE("The stable step is that of its parameter", "[integrators]") {
    auto world = hung<double>(Blend{1});
    CHECK(stable_step(world) == stable_step(hung<double>(SemiImplicitEuler{})));
    world.set(Blend{0});
    CHECK(stable_step(world) == stable_step(hung<double>(ExplicitEuler{})));
    // x' = x + dt v + share dt^2 a of an oscillator: det = 1 - (1 - share) q^2 + share q^2 ... at share = 1/2 and
    // without damping the determinant is 1 + q^2 / 2, which grows at every step.
    CHECK(stable_step<Blend>(100.0 / (second * second), 0.0 * hertz, Blend{0.5}).value() == 0);
    CHECK(stable_step<Blend>(100.0 / (second * second), 0.0 * hertz, Blend{1}).value() == Approx(0.2));
}
TEST_CASE("StepLimit follows a change of it", "[integrators]") {
    World world{Blend{1}, Springs{}, StepLimit<Divide>{}};
    const auto nail = world.add(position(metres(0, 0, 0)), fixed);
    const auto ball = world.add(position(metres(1.1, 0, 0)), mass(1.0 * kilogram));
    world.add(Spring{nail, ball, 400.0 * newton_per_metre, 2.0 * newton_second_per_metre, 1.0 * metre});
    world.step(0.05 * second);
    const auto few = world.tick();
    world.set(Blend{0});
    world.step(0.05 * second);
    CHECK(world.tick() - few > few); // explicit Euler holds c/k = 5 ms, semi-implicit nearly 0.1 s
}
TEST_CASE("Newton's iterations of ImplicitEuler are a parameter", "[integrators]") {
    auto world = thrown<double>(ImplicitEuler{});
    world.step(1.0 / 60 * second);
    CHECK(world.status().unsolved == 0);
    world.set(ImplicitEuler{.most_iterations = 1}); // a drag of v^2 takes more
    world.step(1.0 / 60 * second);
    CHECK(world.status().unsolved == 1);
    CHECK_THROWS_WITH(world.set(ImplicitEuler{.most_iterations = 0}),
                      Catch::Contains("most_iterations") && Catch::Contains("0") && Catch::Contains("at least 1"));
    CHECK_THROWS_WITH(world.set(ImplicitEuler{.tolerance = 1}),
                      Catch::Contains("tolerance") && Catch::Contains("less"));
    CHECK_THROWS_WITH(world.set(ImplicitEuler{.tolerance = std::nan("")}), Catch::Contains("tolerance"));
}
TEST_CASE("A larger tolerance leaves more of the equation, and is told in the status where it is not met",
          "[integrators]") {
    auto rope = [](const ImplicitEuler& integrator) {
        World world{Space<double, 2>{}, integrator, Gravity{}, Springs{}};
        auto last = world.add(position(metres(0, 0)), fixed);
        for (int i = 1; i <= 30; ++i) {
            const auto next = world.add(position(metres(0.1 * i, 0)), mass(0.05 * kilogram));
            world.add(Spring{last, next, 500.0 * newton_per_metre, 0.1 * newton_second_per_metre, 0.1 * metre});
            last = next;
        }
        for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
        return std::pair(world.position(last), world.status().unsolved);
    };
    const auto [exact, unsolved] = rope(ImplicitEuler{});
    CHECK(unsolved == 0);
    double last = 0;
    for (const double tolerance : {1e-8, 1e-4, 1e-2}) {
        const auto [rough, left] = rope(ImplicitEuler{.tolerance = tolerance});
        CHECK(left == 0);
        const double off = norm(rough - exact).value();
        CHECK(off > last);      // looser is farther away,
        CHECK(off < tolerance); // and no farther than a small part of the rope's 3 m
        last = off;
    }
    CHECK(rope(ImplicitEuler{.tolerance = 1e-8, .most_iterations = 1}).second > 0);
}
