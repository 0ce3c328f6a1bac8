// SPDX-License-Identifier: BSL-1.0
// WorldRadius: status() tells which bodies are outside of the radius within which motion is resolved (hard case V7).

#include <ansatz/collision.hpp>
#include <ansatz/motion/integrators/compensated.hpp>
#include <ansatz/motion/world_radius.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world/save.hpp>

#include "tests/motion/support.hpp"
#include "tests/refusal.hpp"

#include <sstream>

using namespace motion_tests;

namespace {
using S = Space<float, 2>;
constexpr double dt = 1.0 / 256; // s

template <class I, class... P> auto world_of(const P&... more) {
    World world{S{}, I{}, WorldRadius{.speed = 0.05 * metre_per_second}, more...};
    world.add(at<S>(1), going<S>(0.05));
    return world;
}
/// As a policy of a user's: any of them may say something.
struct Crowd {
    using role = roles::Observer;
    std::string report(const auto& world, const Quantity<unit::Time>&) const {
        return world.size() > 2 ? "a crowd" : "";
    }
};
} // namespace

TEST_CASE("V7: outside of the radius a status says which, where, and what would be right", "[motion][far]") {
    auto world = world_of<SemiImplicitEuler>();
    const auto inside = world.add(at<S>(0, 31.9)), outside = world.add(at<S>(-32, 0)),
               farther = world.add(at<S>(0, 4096), going<S>(0.05));
    world.add(at<S>(1e9), fixed); // it moves nowhere
    CHECK(world.status().ok());   // no step has been taken, so that its length is unknown
    const auto before = world.hash();
    CHECK(world.status().ok());
    CHECK(world.hash() == before);
    world.step(dt * second);
    const auto status = world.status();
    CHECK(!status.ok());
    CHECK(status.said ==
          "2 bodies outside of the world's radius, the first is body " + std::to_string(outside.id) +
              ": a coordinate of 32 m, and at 0.05 m/s in steps of 0.00390625 s this scalar moves within "
              "1 % of the way up to 32 m; keep the origin nearer, or take Compensated or a scalar of "
              "more digits");
    CHECK(describe(status) == status.said);
    const auto found = world.get<WorldRadius>().outside(world, dt * second);
    CHECK(found.radius == resolved_radius<S>(0.05 * metre_per_second, dt * second));
    CHECK(found.count == 2);
    CHECK(found.first == outside);

    world.remove(farther);
    CHECK_THAT(world.status().said, Catch::StartsWith("1 body outside"));
    world.set_position(outside, metres(0, -31.9));
    CHECK(world.status().ok());
    CHECK(world.contains(inside));
    world.set(WorldRadius{.speed = 0.02 * metre_per_second}); // now 16 m
    CHECK(world.get<WorldRadius>().outside(world, dt * second).count == 2);
}
TEST_CASE("V7: what it says is what happens: within the radius a way is right, and far outside there is none",
          "[motion][far]") {
    for (const double away : {1.0, 31.0, 512.0, 4096.0, 1e5}) {
        auto world = World{S{}, VelocityVerlet{}, WorldRadius{.speed = 0.05 * metre_per_second}};
        const auto body = world.add(at<S>(away), going<S>(0.05));
        run(world, 20 * 256, dt);
        const double way = double(world.position(body).value()[0]) - away;
        CHECK((std::abs(way - 1) <= 0.01) == world.status().ok());
    }
}
TEST_CASE("V7: the radius of a compensated float has room for 1e7 m", "[motion][far]") {
    auto world = world_of<Compensated<SemiImplicitEuler>>();
    world.add(at<S>(1e7), going<S>(0.05));
    world.step(dt * second);
    CHECK(world.status().ok());
    world.add(at<S>(1e9), going<S>(0.05));
    CHECK_THAT(world.status().said, Catch::Contains("up to 5.36871e+08 m") || Catch::Contains("up to 536870912 m"));
    CHECK_THAT(world.status().said, !Catch::Contains("take Compensated"));
}
TEST_CASE("V7: where a response divides the step, the radius is that of a part", "[motion][far]") {
    World world{S{},
                SemiImplicitEuler{},
                WorldRadius{.speed = 0.05 * metre_per_second},
                SortAndSweep{},
                Narrowphase<Sphere, Plane>{},
                SoftSubsteps<>{.parts = 4}};
    const auto ball = world.add(Sphere{0.1 * metre}, at<S>(8), going<S>(0.05), mass(1.0 * kilogram));
    world.step(dt * second);
    CHECK_THAT(world.status().said, Catch::Contains("in steps of 0.0009765625 s") && Catch::Contains("up to 8 m"));
    world.set_position(ball, metres(7.5, 0));
    CHECK(world.status().ok());
}
TEST_CASE("V7: it is set, checked and saved as every policy, and costs no byte", "[motion][far]") {
    using With = decltype(world_of<SemiImplicitEuler>());
    using Without = World<S, SemiImplicitEuler>;
    STATIC_REQUIRE(With::bytes_per_body == Without::bytes_per_body);
    STATIC_REQUIRE(ObserverIn<WorldRadius, S>);
    auto world = world_of<SemiImplicitEuler>(), loaded = world;
    world.set(WorldRadius{.speed = 2.0 * metre_per_second, .share = 0.1});
    std::stringstream file;
    save(world, file);
    load(loaded, file);
    CHECK(loaded.get<WorldRadius>().speed.value() == 2);
    CHECK(loaded.get<WorldRadius>().share == 0.1);
    const auto set = [&](double speed, double share) {
        return test::refusal([&] { world.set(WorldRadius{.speed = speed * metre_per_second, .share = share}); });
    };
    CHECK(set(0, 0.1) == "WorldRadius: speed is 0 m/s; it must be finite and greater than zero");
    CHECK(set(1, 1e-6) == "WorldRadius: share is 1e-06; it is at least 2e-6 and less than 1");
    CHECK(set(1, 1) == "WorldRadius: share is 1; it is at least 2e-6 and less than 1");
}
TEST_CASE("V7: a policy of a user's says something in the status, beside others", "[motion][far]") {
    auto world = world_of<SemiImplicitEuler>(Crowd{});
    world.step(dt * second);
    CHECK(world.status().ok());
    world.add(at<S>(2));
    world.add(at<S>(3));
    CHECK(describe(world.status()) == "a crowd");
    world.add(at<S>(4096));
    CHECK_THAT(world.status().said, Catch::StartsWith("1 body outside") && Catch::EndsWith("digits; a crowd"));
}
