// SPDX-License-Identifier: BSL-1.0
// What hangs on springs falls asleep when it has come to hang still, all of it together, and wakes together: R10 to R13
// of springs.

#include "tests/springs/support.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>
#include <ansatz/motion/forces_at_rest.hpp>

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

using namespace spring_tests;

namespace {

constexpr double dt = 1.0 / 60;

/// A chain of five links in air that slows it, on a hook of its own.
template <class World_> struct Chain {
    World_ world;
    Handle hook;
    std::vector<Handle> links;
    std::vector<ElementHandle<Spring>> springs;
    int fell_asleep = 0; ///< steps
    Chain(const World_& empty, bool moves, int n = 5) : world(empty) {
        using S = typename World_::S;
        hook = moves ? world.add(shapeless, at<S>(0), moving) : world.add(shapeless, at<S>(0), fixed);
        auto above = hook;
        for (int i = 1; i <= n; ++i) {
            links.push_back(world.add(shapeless, at<S>(0.2 * i, -0.3 * i), mass(0.5 * kilogram)));
            springs.push_back(world.add(Spring{above, links.back(), 300.0 * N_per_m, 2.0 * N_s_per_m, 0.3 * metre}));
            above = links.back();
        }
        while (world.count(Motion::awake) > 0 && fell_asleep < 6000) {
            world.step(dt * second);
            ++fell_asleep;
        }
    }
    auto asleep() const { return world.count(Motion::resting); }
};

template <class... P> void check_chains(P... policies) {
    const World empty{policies..., Gravity{}, AppliedForces{}, Drag{1.0 / second}, Rest{}, Springs{}};
    for (const bool moves : {false, true}) {
        const Chain chain(empty, moves);
        INFO("on a hook that is " << (moves ? "moving" : "fixed") << "; after " << chain.fell_asleep << " steps");
        REQUIRE(chain.asleep() == 5);
        // Where it hangs is where it would hang for ever: below each other, each spring as long as its load makes it.
        for (int i = 0; i < 5; ++i) {
            const auto above =
                i == 0 ? chain.world.position(chain.hook) : chain.world.position(chain.links[std::size_t(i) - 1]);
            const double stretched = double(norm(chain.world.position(chain.links[std::size_t(i)]) - above).value());
            CHECK(std::abs(stretched - (0.3 + (5 - i) * 0.5 * 9.81 / 300)) <= 1e-4);
        }
        // No body falls asleep before the others, and nothing moves any more.
        auto still = chain.world;
        const auto where = still.position(chain.links.back());
        run(still, 600, dt);
        CHECK(still.count(Motion::resting) == 5);
        CHECK(still.position(chain.links.back()) == where);
        auto wakes_by = [&](const char* what, auto&& act) {
            INFO("wakes by " << what);
            auto world = chain.world;
            act(world);
            world.step(dt * second);
            CHECK(world.count(Motion::awake) == 5);
        };
        using S = typename decltype(still)::S;
        wakes_by("a hook that is put elsewhere", [&](auto& w) { w.set_position(chain.hook, point(w, 0.01)); });
        wakes_by("a hook that is put a micrometre aside", [&](auto& w) { w.set_position(chain.hook, point(w, 1e-6)); });
        if (moves)
            wakes_by("a hook that moves slowly",
                     [&](auto& w) { w.set_velocity(chain.hook, vector_in<S, unit::Velocity>(1e-3, 0)); });
        wakes_by("a hook that is gone", [&](auto& w) { w.remove(chain.hook); });
        wakes_by("a spring that is gone", [&](auto& w) { w.remove(chain.springs[2]); });
        wakes_by("a spring that is another", [&](auto& w) {
            w.set(chain.springs[4],
                  Spring{chain.links[3], chain.links[4], 301.0 * N_per_m, 2.0 * N_s_per_m, 0.3 * metre});
        });
        wakes_by("a spring that is new", [&](auto& w) {
            w.add(Spring{chain.links[0], chain.links[4], 1.0 * N_per_m});
        });
        wakes_by("gravity", [&](auto& w) { w.set(Gravity{metres_per_second_squared(0, -9.8, 0)}); });
        wakes_by("a link that is gone",
                 [&](auto& w) { w.remove(chain.links[4]), w.add(shapeless, at<S>(50), mass(1.0 * kilogram)); });
        wakes_by("a push", [&](auto& w) { w.set_velocity(chain.links[4], vector_in<S, unit::Velocity>(0.01, 0)); });
    }
}

} // namespace

TEST_CASE("R12 a chain that hangs in air falls asleep, all of it together, and wakes together",
          "[springs][rest][R12]") {
    SECTION("alone") { check_chains(SemiImplicitEuler{}); }
    SECTION("of float, in a plane, with history") { check_chains(Space<float, 2>{}, Verlet{}); }
    SECTION("advanced as one system") { check_chains(ImplicitEuler{}); }
    SECTION("where bodies collide") {
        check_chains(SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, SoftSubsteps<>{});
    }
}

TEST_CASE("R9 what swings or hangs on what moves does not fall asleep in its swing", "[springs][rest][R9]") {
    // A pendulum that swings 4 cm to each side at up to 0.04 m/s: always slower than the threshold, and at its lowest
    // point nothing pulls it. Two metres long, it swings at 2.2 1/s.
    World world{VelocityVerlet{}, Gravity{}, Rest{0.1 * metre_per_second}, Springs{}};
    const auto ball = world.add(position(metres(0.04, -2, 0)), mass(1.0 * kilogram));
    world.add(Spring{
        .first = ball, .second = metres(0, 0, 0), .stiffness = 1e4 * N_per_m, .rest_length = (2 - 9.81e-4) * metre});
    bool slept = false;
    for (int i = 0; i < 6000; ++i) {
        world.step(dt / 4 * second);
        slept = slept || world.motion(ball) != Motion::awake;
    }
    CHECK_FALSE(slept);
}

TEST_CASE("R13 what hangs on a hook that creeps goes with it, and never stops on the way", "[springs][rest][R13]") {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{1.0 / second}, Rest{}, Springs{}};
    Chain chain(world, true, 2);
    REQUIRE(chain.asleep() == 2);
    auto& w = chain.world;
    const double before = double(w.position(chain.links[1]).value()[1]);
    w.set_velocity(chain.hook, metres_per_second(0, 0.045, 0)); // nine tenths of the threshold of Rest
    bool slept = false;
    for (int i = 0; i < 3600; ++i) {
        w.step(dt * second);
        slept = slept || w.count(Motion::resting) > 0;
    }
    CHECK_FALSE(slept);
    CHECK(std::abs(double(w.position(chain.links[1]).value()[1]) - before - 2.7) <= 0.027);
}

namespace {
/// A damped force towards the origin that names no element: bodies it couples are of no island.
struct Honey {
    using role = roles::Force;
    using reads = Columns<Position, Velocity>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Honey&) {}
        void couple(auto& view, const auto&) const {
            view.for_each([&](std::size_t slot) {
                const auto x = view.template get<Position>(slot).value();
                const auto v = view.template get<Velocity>(slot).value();
                view.add_force(slot, S::Force::from_value(typename S::Scalar(-4) * x - typename S::Scalar(100) * v));
            });
        }
    };
};

/// A body that creeps on a damper, 0.04 1/s of its way each second, goes as far beside Rest as without, and falls
/// asleep where next to nothing pulls at it.
template <class... P> void creeps(double hz, P... policies) {
    const auto start = [](auto world) {
        using S = typename decltype(world)::S;
        Handle body;
        if constexpr (decltype(world)::composition::collides) {
            world.add(Plane::ground(), fixed);
            body = world.add(Sphere{0.5 * metre}, at<S>(1, 0.5), mass(1.0 * kilogram));
        } else body = world.add(at<S>(1), mass(1.0 * kilogram));
        const double y = decltype(world)::composition::collides ? 0.5 : 0;
        if constexpr ((std::is_same_v<P, Springs<>> || ...))
            world.add(Spring{.first = body,
                             .second = point(world, 0, y),
                             .stiffness = 4.0 * N_per_m,
                             .damping = 100.0 * N_s_per_m,
                             .rest_length = 0.0 * metre});
        return std::pair(world, body);
    };
    auto [world, body] = start(World{policies..., Rest{}});
    auto [awake, same] = start(World{policies...});
    run(world, int(60 * hz), 1 / hz);
    run(awake, int(60 * hz), 1 / hz);
    CHECK(world.motion(body) == Motion::awake);
    CHECK(world.position(body) == awake.position(same));
    while (world.motion(body) == Motion::awake && world.tick() < std::uint64_t(400 * hz)) world.step(1 / hz * second);
    REQUIRE(world.motion(body) == Motion::resting);
    const double left = std::abs(double(world.position(body).value()[0]));
    // Where contacts carry it, a hundredth of its weight may remain.
    CHECK(4 * left <= (decltype(world)::composition::collides ? 0.0981 : 1e-3) * (1 + 1e-6));
    CHECK(world.velocity(body).value().norm() == 0);
    run(world, 600, 1 / hz);
    CHECK(world.motion(body) == Motion::resting);
}
} // namespace

TEST_CASE("R13 what creeps on a damper does not fall asleep before it is there", "[springs][rest][R13]") {
    creeps(60, SemiImplicitEuler{}, Springs{});
    creeps(240, VelocityVerlet{}, Springs{});
    creeps(240, Verlet{}, Springs{});
    creeps(240, RungeKutta4{}, Springs{});
    creeps(60, ImplicitEuler{}, Springs{});
    creeps(240, Space<float, 2>{}, SemiImplicitEuler{}, Springs{});
    creeps(240, SemiImplicitEuler{}, Honey{});
    creeps(240, VelocityVerlet{}, Honey{});
    creeps(60, SemiImplicitEuler{}, Gravity{}, Springs{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{},
           SoftSubsteps<>{});
}
