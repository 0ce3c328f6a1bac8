// SPDX-License-Identifier: BSL-1.0
// The order of a step: by phases, then by names; drivers own what stands between; and the frame has what its modules
// bring and nothing else.

#include <ansatz/collision.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/hooks.hpp>
#include <ansatz/world/inside.hpp>
#include <ansatz/world/modules.hpp>
#include <ansatz/world/schedule.hpp>
#include <ansatz/world/types.hpp>

#include <catch2/catch.hpp>

#include <sstream>
#include <string>
#include <vector>

using namespace ansatz;

namespace {

// Systems that write down their names.
struct Notes {
    std::vector<std::string> all;
};
template <int Tenths, char Name> struct Plain {
    static constexpr Phase phase{Tenths / 10.0};
    static constexpr char letters[] = {Name, 0};
    static constexpr std::string_view name = letters;
    static void run(auto& step) { step.all.push_back(letters); }
};
template <int Tenths, int Until, int Times> struct Repeats {
    static constexpr Phase phase{Tenths / 10.0}, until{Until / 10.0};
    static constexpr std::string_view name = "driver";
    static void run(auto& step, const auto& inside) {
        step.all.push_back("(");
        for (int i = 0; i < Times; ++i) inside(step);
        step.all.push_back(")");
    }
};
template <class... Y> std::string order_of() {
    using Schedule = detail::InOrder<Types<Y...>>;
    Notes notes;
    detail::run_systems<Schedule, 0, Schedule::size>(notes);
    std::string all;
    for (const auto& one : notes.all) all += one;
    return all;
}
template <class World_> std::string printed(const World_& world) {
    std::ostringstream out;
    print_schedule(world, out);
    return out.str();
}

template <class W>
concept TellsContacts = requires(const W& world) { world.contacts(); };
template <class W>
concept TakesForces = requires(W& world) { world.apply_force(Handle{}, newtons(0, 0, 0)); };

using Free = World<SemiImplicitEuler, Gravity>;
using Pushed = World<SemiImplicitEuler, Gravity, AppliedForces>;
using Colliding = World<SemiImplicitEuler, Gravity, AllPairs, Narrowphase<Sphere, Plane>, Impulse<>>;

} // namespace

TEST_CASE("A step runs by phases, then by names, in whatever order its systems are listed", "[schedule]") {
    using A = Plain<10, 'a'>;
    using B = Plain<10, 'b'>;
    using C = Plain<5, 'c'>;
    using D = Plain<20, 'd'>;
    CHECK(order_of<A, B, C, D>() == "cabd");
    CHECK(order_of<D, C, B, A>() == "cabd");
    CHECK(order_of<B, D, A, C>() == "cabd");
    CHECK(order_of<>().empty());
    STATIC_REQUIRE_FALSE(detail::InOrder<Types<A, B, C>>::ambiguous);
    STATIC_REQUIRE(detail::InOrder<Types<A, Plain<10, 'a'>, C>>::ambiguous);
    STATIC_REQUIRE(between(phases::forces, phases::integration) > phases::forces);
    STATIC_REQUIRE(between(phases::forces, phases::integration) < phases::integration);
    STATIC_REQUIRE(phases::positions < phases::contacts);
    STATIC_REQUIRE(phases::contacts < phases::fields);
}

TEST_CASE("A driver owns what stands between its phase and another, one within the other", "[schedule]") {
    using A = Plain<10, 'a'>;
    using B = Plain<20, 'b'>;
    using C = Plain<30, 'c'>;
    CHECK(order_of<A, B, C, Repeats<15, 30, 3>>() == "a(bbb)c");
    CHECK(order_of<A, B, C, Repeats<5, 30, 2>>() == "(abab)c");
    CHECK(order_of<A, B, C, Repeats<5, 40, 2>, Repeats<15, 25, 2>>() == "(a(bb)ca(bb)c)");
    CHECK(order_of<A, B, Repeats<15, 30, 0>>() == "a()");
    CHECK(order_of<A, Repeats<15, 18, 2>, B>() == "a()b"); // there is nothing to repeat
}

TEST_CASE("The schedule of a world can be read", "[schedule]") {
    CHECK(printed(Free{SemiImplicitEuler{}, Gravity{}}) == "forces and integration\nclock\n");
    CHECK(printed(World{SemiImplicitEuler{}, Gravity{}, Rest{}, AllPairs{}, Narrowphase<Sphere, Plane>{},
                        SoftSubsteps<Friction>{}}) == "wake: neighbours of bodies that woke\n"
                                                      "substeps\n"
                                                      "    forces and integration\n"
                                                      "contacts\n"
                                                      "clock\n"
                                                      "rest\n");
    CHECK(printed(World{Verlet{}, Springs<Breaking>{}, Swept<Narrowphase<Sphere>>{}, AllPairs{}, Impulse{}}) ==
          "places before the step\n"
          "forces and integration\n"
          "contacts\n"
          "clock\n"
          "breaking\n"
          "forces for rest, queries and the next step\n");
}

TEST_CASE("A world has the members that its policies bring, and no others", "[schedule]") {
    STATIC_REQUIRE(TellsContacts<Colliding>);
    STATIC_REQUIRE_FALSE(TellsContacts<Free>);
    STATIC_REQUIRE(TakesForces<Pushed>);
    STATIC_REQUIRE_FALSE(TakesForces<Free>);
    STATIC_REQUIRE(std::same_as<Free::composition::modules, Types<modules::Motion>>);
    STATIC_REQUIRE(std::same_as<Colliding::composition::modules, Types<modules::Collision, modules::Motion>>);
    // What stands on another module brings it along, even if no policy of that one is there.
    STATIC_REQUIRE(std::same_as<detail::modules_of<AllPairs>, Types<modules::Collision, modules::Motion>>);
    STATIC_REQUIRE(std::same_as<detail::modules_of<>, Types<>>);
}

TEST_CASE("Lists of types", "[schedule]") {
    STATIC_REQUIRE(std::same_as<detail::distinct<int, void, char, int>, Types<int, char>>);
    STATIC_REQUIRE(std::same_as<detail::joined_types<Types<int>, Types<>, Types<char, int>>, Types<int, char, int>>);
    STATIC_REQUIRE(std::same_as<detail::joined_types<>, Types<>>);
    STATIC_REQUIRE(detail::stands_in<int, Types<char, int>>);
    STATIC_REQUIRE_FALSE(detail::stands_in<int, Types<>>);
    STATIC_REQUIRE(std::same_as<detail::FirstIn<Types<char, int>>::type, char>);
    STATIC_REQUIRE(std::same_as<detail::FirstIn<Types<>>::type, void>);
}
