// SPDX-License-Identifier: BSL-1.0
// Every parameter of every policy is held to the world's scalar at the door: a world of floats takes none that would be
// infinite in it, or that its policy would not accept as a float, and says which one it was.

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/held_parameters.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <string>
#include <string_view>

using namespace ansatz;
using Catch::Matchers::ContainsSubstring;

namespace {

using Flat = Space<float, 2>;

/// Makes one parameter, the n-th, another; counts them.
template <class P> int change(P& policy, int n, double to, std::string& what) {
    int count = 0;
    P::parameters(policy, [&](std::string_view name, auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_integral_v<Value>) return;
        else {
            if (count++ != n) return;
            what = std::string(name);
            if constexpr (std::is_floating_point_v<Value>) value = to;
            else if constexpr (detail::vector_valued<detail::stripped<Value>>) {
                auto v = value.value();
                v[0] = to;
                value = detail::stripped<Value>::from_value(v);
            } else value = detail::stripped<Value>::from_value(to);
        }
    });
    return count;
}
template <class P> void is_held(P policy) {
    std::string what;
    detail::check_in<Flat>(policy); // as it is, it is right
    const int count = change(policy, -1, 0, what);
    for (int n = 0; n < count; ++n)
        for (const double huge : {1e39, -1e39, 3.5e38, 1e308}) {
            P other = policy;
            change(other, n, huge, what);
            CAPTURE(P::name, what, huge);
            const auto sentence = test::refusal([&] { detail::check_in<Flat>(other); });
            CHECK_THAT(sentence, ContainsSubstring(std::string(P::name)) && ContainsSubstring(what));
        }
}

} // namespace

TEST_CASE("no parameter of any policy or shape is one that a float cannot hold", "[world][door][V5]") {
    is_held(Gravity{});
    is_held(Drag{});
    is_held(QuadraticDrag{});
    is_held(FrameDrag{});
    is_held(Attraction{});
    is_held(Rest{});
    is_held(StopBelow{});
    is_held(UniformGrid<>{});
    is_held(Impulse<>{});
    is_held(Penalty{});
    is_held(Projection{});
    is_held(SoftSubsteps<>{});
    is_held(Sphere{0.5 * metre});
    is_held(Box{metres(0.5, 0.5)});
    // What becomes zero is held to what its policy accepts.
    SoftSubsteps<> soft;
    soft.frequency = 1e-60 * hertz;
    CHECK_THAT(test::refusal([&] { detail::check_in<Flat>(soft); }), ContainsSubstring("SoftSubsteps: frequency"));
    CHECK(test::refusal([&] { detail::check_in<Space<>>(soft); }) == "nothing");
    CHECK(test::refusal([&] { detail::check_in<Flat>(Drag{1e-60 / second}); }) == "nothing"); // no drag
}

TEST_CASE("a world of floats refuses what it cannot hold when it is made, set and added to", "[world][door][V5]") {
    auto made = [](auto grid, auto impulse) {
        World world{Flat{}, SemiImplicitEuler{}, grid, Narrowphase<Sphere>{}, impulse, Springs<Breaking>{}};
        return world;
    };
    CHECK_THAT(test::refusal([&] { made(UniformGrid{1e39 * metre}, Impulse{}); }),
               ContainsSubstring("UniformGrid: cell is 1e+39 m; "));
    CHECK_THAT(test::refusal([&] { made(UniformGrid{}, Impulse<>{1e39 * metre_per_second}); }),
               ContainsSubstring("Impulse: threshold is 1e+39 m/s; "));
    auto world = made(UniformGrid{}, Impulse{});
    const auto ball = world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram));
    const auto before = world.hash();
    CHECK_THAT(test::refusal([&] { world.set(Impulse<>{1e39 * metre_per_second}); }),
               ContainsSubstring("Impulse: threshold is 1e+39 m/s; "));
    CHECK_THAT(test::refusal([&] { world.set(UniformGrid{1e39 * metre}); }),
               ContainsSubstring("UniformGrid: cell is 1e+39 m; "));
    CHECK_THAT(test::refusal([&] { world.add(Sphere{1e39 * metre}, mass(1.0 * kilogram)); }),
               ContainsSubstring("Sphere: radius is 1e+39 m; "));
    // Greater than zero and finite: it is the float that cannot hold it, or the inverse.
    const std::string not_held =
        " kg; a mass is finite and greater than 0 kg in the world's scalar, and its inverse is a number (a body that "
        "nothing moves is added as `fixed`, without a mass)";
    for (const double m : {1e-300, 1e-39, 1e39}) {
        CHECK(test::refusal([&] { world.add(Sphere{0.5 * metre}, mass(m * kilogram)); }) ==
              "World::add: mass is " + describe(m) + not_held);
        CHECK(test::refusal([&] { world.set_mass(ball, m * kilogram); }) ==
              "World::set_mass: mass is " + describe(m) + not_held);
    }
    auto refused = [&](const Spring& spring, const auto&... more) {
        return test::refusal([&] { world.add(spring, more...); });
    };
    const Spring right{ball, metres(1, 0), 1.0 * newton_per_metre, 1.0 * newton_second_per_metre, 1.0 * metre};
    auto wrong = right;
    wrong.stiffness = 1e39 * newton_per_metre;
    CHECK_THAT(refused(wrong), ContainsSubstring("stiffness is 1e+39 N/m; "));
    wrong = right, wrong.damping = 1e39 * newton_second_per_metre;
    CHECK_THAT(refused(wrong), ContainsSubstring("damping is 1e+39 "));
    wrong = right, wrong.rest_length = 1e39 * metre;
    CHECK_THAT(refused(wrong), ContainsSubstring("rest length is 1e+39 m; "));
    CHECK_THAT(refused(Spring{ball, metres(1e39, 0), 1.0 * newton_per_metre}),
               ContainsSubstring("anchor is (1e+39, 0"));
    CHECK_THAT(refused(right, breaks_at(1e39 * newton)), ContainsSubstring("1e+39 N; "));
    CHECK(world.hash() == before);
    world.step(1.0 / 60 * second);
    CHECK(world.status().ok());
}
