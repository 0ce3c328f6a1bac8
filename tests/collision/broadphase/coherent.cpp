// SPDX-License-Identifier: BSL-1.0
// Coherent: the pairs of two loops whatever its boxes do from call to call, in one order; and when it keeps pairs.

#include "tests/collision/broadphase/scenes.hpp"

#include <ansatz/collision/broadphase/box_table.hpp>
#include <ansatz/collision/broadphase/coherent.hpp>
#include <ansatz/collision/broadphase/kept_pairs.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <limits>

using namespace ansatz;
using broadphase_tests::Pairs;
using broadphase_tests::Random;

namespace {

/// What a bound broadphase tells, in its order.
template <class Bound, class S> Pairs told_by(Bound& bound, const Boxes<S>& boxes) {
    Pairs told;
    bound.find(boxes, [&](std::size_t i, std::size_t j) { told.emplace_back(i, j); });
    return told;
}

/// Balls that drift in a box of this side and turn round at its walls; as many as make a few pairs each.
template <class S> class Drift {
public:
    using Scalar = typename S::Scalar;
    struct Ball {
        std::array<double, 3> at{}, step{};
        double radius = 0.5;
    };
    double scale = 1; ///< m, by which all is multiplied
    double speed = 0; ///< m a step, at most on each axis
    double side = 6;  ///< m
    Random random;
    std::vector<Ball> balls;
    std::size_t active = 0;

    Drift(std::uint64_t seed, std::size_t n, double most) : speed(most), random(seed) {
        while (balls.size() < n) balls.push_back(ball());
        active = n;
    }
    double step_on_axis() { return random.uniform(-speed, speed); }
    Ball ball() {
        Ball b;
        for (auto& x : b.at) x = random.uniform(0, side);
        for (auto& v : b.step) v = step_on_axis();
        return b;
    }
    void speed_up(double most) {
        speed = most;
        for (Ball& b : balls)
            for (auto& v : b.step) v = step_on_axis();
    }
    void step() {
        for (std::size_t i = 0; i < active; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                Ball& b = balls[i];
                b.at[k] += b.step[k];
                if (b.at[k] < 0) b.step[k] = std::abs(b.step[k]);
                if (b.at[k] > side) b.step[k] = -std::abs(b.step[k]);
            }
    }
    Boxes<S> boxes() const {
        Boxes<S> all;
        for (const Ball& b : balls) {
            Vector<Scalar, S::dimension> low, high;
            for (int k = 0; k < S::dimension; ++k) {
                low[k] = Scalar(scale * (b.at[std::size_t(k)] - b.radius));
                high[k] = Scalar(scale * (b.at[std::size_t(k)] + b.radius));
            }
            all.push_back(S::Position::from_value(low), S::Position::from_value(high));
        }
        all.set_active(active);
        return all;
    }
};

/// A broadphase that makes use of what it may do where a box is not finite: it finds nothing.
struct Particular {
    using role = roles::Broadphase;
    int number = 0; ///< a parameter
    template <class S> class In {
    public:
        explicit In(const Particular& policy) { last_bound = policy.number; }
        template <class F> void find(const Boxes<S>& boxes, F&& found) {
            for (std::size_t i = 0; i < boxes.size(); ++i)
                for (int k = 0; k < S::dimension; ++k)
                    if (!std::isfinite(boxes.lower(k)[i]) || !std::isfinite(boxes.upper(k)[i])) return;
            for (const auto& [i, j] : broadphase_tests::oracle(boxes)) found(i, j);
        }
    };
    static inline int last_bound = 0; ///< the parameter of the one that was bound last
};

/// How often each way of Coherent was gone.
struct Seen {
    std::size_t kept = 0, rebuilds = 0, amended = 0, given_up = 0, pairs = 0;
};

/// Something happens to a scene, now and then.
template <class S> void surprise(Drift<S>& scene) {
    auto& random = scene.random;
    auto any = [&]() -> auto& { return scene.balls[random.below(scene.balls.size())]; };
    switch (random.below(12)) {
    case 0: scene.speed_up(0); break;
    case 1: scene.speed_up(0.002); break;
    case 2:
    case 3: scene.speed_up(0.03); break;
    case 4: scene.speed_up(1); break;
    case 5: any() = scene.ball(); break; // it is elsewhere at once
    case 6:
        any().step = {2, 1, 0.5}; // a bullet
        break;
    case 7: any().radius = 0.5 * std::pow(10.0, random.uniform(-2, 1)); break;
    case 8: std::swap(any(), any()); break; // an index is another body's
    case 9: scene.balls.push_back(scene.ball()), scene.active = scene.balls.size(); break;
    case 10: scene.active = random.below(scene.balls.size() + 1); break;
    default:
        scene.balls.resize(std::max<std::size_t>(scene.balls.size() * 3 / 4, 40)), scene.active = scene.balls.size();
    }
}

/// One bound policy through all of it, beside two loops, the inner broadphase and a copy of itself.
template <class S, class Inner> void anything(const Inner& inner, std::uint64_t seed, double scale, Seen& seen) {
    Drift<S> scene(seed, 120, 0.02);
    scene.scale = scale;
    if (S::dimension == 2) scene.side = 16;
    typename Coherent<Inner>::template In<S> bound(Coherent<Inner>{inner});
    typename Inner::template In<S> plain(inner);
    for (int call = 0; call < 600; ++call) {
        if (call % 25 == 24) surprise(scene);
        scene.step();
        const Boxes<S> boxes = scene.boxes();
        const Pairs right = broadphase_tests::oracle(boxes), told = told_by(bound, boxes);
        seen.kept += bound.keeps(), seen.pairs += right.size();
        if (told != right)
            FAIL("call " << call << " of seed " << seed << ", scale " << scale << ": " << told.size()
                         << " pairs instead of " << right.size() << ", or in another order");
        Pairs same = told_by(plain, boxes);
        std::sort(same.begin(), same.end());
        REQUIRE(same == told);
        if (call % 40 == 0) { // what it kept does not show in the order
            typename Coherent<Inner>::template In<S> fresh(Coherent<Inner>{inner});
            REQUIRE(told_by(fresh, boxes) == told);
            const auto copy = bound;
            bound = copy;
        }
    }
    seen.rebuilds += bound.rebuilds(), seen.amended += bound.amended(), seen.given_up += bound.given_up();
}

} // namespace

TEST_CASE("Coherent tells what two loops tell, in order of indices, whatever the boxes do", "[broadphase][coherent]") {
    Seen seen;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        anything<Space<double, 3>>(UniformGrid<>{}, seed, 1, seen);
        anything<Space<float, 3>>(UniformGrid<>{}, seed + 10, 1, seen);
        anything<Space<double, 2>>(UniformGrid<>{}, seed + 20, 1, seen);
        anything<Space<float, 2>>(Octree<>{}, seed + 30, 1, seen);
    }
    anything<Space<double, 3>>(SortAndSweep{}, 50, 1, seen);
    anything<Space<double, 3>>(BinarySplit<>{}, 51, 1, seen);
    anything<Space<double, 3>>(Octree<SortAndSweep>{}, 52, 1, seen);
    anything<Space<double, 3>>(BoundingBoxes{}, 53, 1, seen);
    // Each way was gone, or the test would say less than it seems to.
    CHECK(seen.kept > 3000);
    CHECK(seen.rebuilds > 100);
    CHECK(seen.amended > 500);
    CHECK(seen.given_up > 30);
    CHECK(seen.pairs > 100000);
}

TEST_CASE("Coherent: tiny and huge boxes", "[broadphase][coherent][hard]") {
    Seen seen;
    for (const double scale : {1e-300, 1e-20, 1e20, 1e290, 1e307}) {
        anything<Space<double, 3>>(UniformGrid<>{}, 7, scale, seen);
        anything<Space<double, 2>>(Octree<>{}, 8, scale, seen);
    }
    for (const double scale : {1e-36, 1e-10, 1e10, 1e37}) anything<Space<float, 3>>(UniformGrid<>{}, 9, scale, seen);
    CHECK(seen.kept > 2000);
    CHECK(seen.amended > 100);
    // Boxes that reach from one end of the numbers to the other.
    constexpr double most = std::numeric_limits<double>::max();
    Boxes<Space<>> boxes;
    for (int i = 0; i < 30; ++i) boxes.push_back(metres(-most, i, -most), metres(most, i + 1.5, most));
    boxes.set_active(30);
    Coherent<Particular>::In<Space<>> bound(Coherent<Particular>{});
    for (int call = 0; call < 8; ++call) CHECK(told_by(bound, boxes) == broadphase_tests::oracle(boxes));
    CHECK(bound.keeps());
}

TEST_CASE("Coherent keeps what moves slowly, and makes fat boxes that last", "[broadphase][coherent]") {
    // 0.3 of a width of 1 m, at 0.01 m a call: thirty calls.
    Drift<Space<>> scene(3, 60, 0);
    for (auto& b : scene.balls) b.step = {0.01, -0.005, 0};
    scene.side = 1e9; // no walls
    for (auto& b : scene.balls) b.at[1] += 1e6;
    Coherent<>::In<Space<>> bound(Coherent<>{});
    std::vector<std::size_t> rebuilds;
    for (int call = 0; call < 100; ++call) {
        (void)told_by(bound, scene.boxes());
        rebuilds.push_back(bound.rebuilds());
        CHECK(bound.keeps() == (call >= 2)); // it watches from the second call that is like the one before
        scene.step();
    }
    // Every fat box holds for thirty calls and for a skin of 0.05 m, which at 0.005 m and 0.01 m a call is a few more.
    CHECK(rebuilds[2] == 1);
    CHECK(rebuilds[2 + 30] == 1);
    CHECK(rebuilds[2 + 36] == 2);
    CHECK(bound.rebuilds() == 3);
    CHECK(bound.given_up() == 0);
}

TEST_CASE("G3: Coherent keeps boxes that share a face, an edge or a corner", "[broadphase][coherent][hard]") {
    Drift<Space<>> scene(3, 125, 0);
    for (std::size_t i = 0; i < 125; ++i)
        scene.balls[i].at = {double(i % 5), double(i / 5 % 5), double(i / 25)}, scene.balls[i].step = {0.0625, 0, 0};
    scene.side = 1e9;
    Coherent<>::In<Space<>> bound(Coherent<>{});
    for (int call = 0; call < 6; ++call, scene.step()) CHECK(told_by(bound, scene.boxes()).size() == (2197 - 125) / 2);
    CHECK(bound.keeps());
}

TEST_CASE("Coherent: one that turns, and one that jumps, costs no rebuild", "[broadphase][coherent]") {
    Drift<Space<>> scene(4, 150, 0.001);
    Coherent<>::In<Space<>> bound(Coherent<>{});
    for (int call = 0; call < 40; ++call) {
        scene.step();
        if (call > 4) scene.balls[std::size_t(call)] = scene.ball();
        REQUIRE(told_by(bound, scene.boxes()) == broadphase_tests::oracle(scene.boxes()));
    }
    CHECK(bound.rebuilds() == 1);
    CHECK(bound.amended() >= 35);
    CHECK(bound.keeps());
}

TEST_CASE("Coherent gives up where it does not pay, and comes back", "[broadphase][coherent]") {
    Drift<Space<>> scene(5, 150, 1);
    Coherent<>::In<Space<>> bound(Coherent<>{});
    auto run = [&](int calls) {
        for (int call = 0; call < calls; ++call) {
            scene.step();
            (void)told_by(bound, scene.boxes());
        }
    };
    run(200);
    CHECK(!bound.keeps());
    CHECK(bound.rebuilds() == 0); // it saw that boxes would not last, and made none
    CHECK(bound.given_up() == 4); // at the calls 3, 21, 55 and 121
    scene.speed_up(0.002);
    run(55); // the pause that it is in ends before
    CHECK(bound.keeps());
    run(200);
    CHECK(bound.keeps());
    scene.speed_up(1); // its pauses are short again
    run(3);
    CHECK(!bound.keeps());
    scene.speed_up(0.002);
    run(20);
    CHECK(bound.keeps());
}

TEST_CASE("Coherent gives up where most turn all the time, which it cannot see before", "[broadphase][coherent]") {
    Drift<Space<>> scene(6, 150, 0.07);
    Coherent<>::In<Space<>> bound(Coherent<>{});
    std::size_t kept = 0;
    for (int call = 0; call < 1000; ++call) {
        if (call % 2) scene.speed_up(0.07);
        scene.step();
        REQUIRE(told_by(bound, scene.boxes()) == broadphase_tests::oracle(scene.boxes()));
        kept += bound.keeps();
    }
    CHECK(bound.rebuilds() > 0);
    CHECK(bound.given_up() > 2);
    CHECK(kept < 200);
}

TEST_CASE("Coherent: boxes whose number changes in every call are handed on", "[broadphase][coherent]") {
    Drift<Space<>> scene(7, 40, 0.001);
    Coherent<>::In<Space<>> bound(Coherent<>{});
    for (int call = 0; call < 60; ++call) {
        scene.balls.push_back(scene.ball());
        if (call < 30) scene.active = scene.balls.size(); // and then only that of bodies that rest
        scene.step();
        REQUIRE(told_by(bound, scene.boxes()) == broadphase_tests::oracle(scene.boxes()));
        CHECK(!bound.keeps());
    }
    CHECK(bound.rebuilds() == 0);
    for (const std::size_t n : {0u, 1u, 2u, 2u, 2u, 2u, 0u, 2u}) { // none, one, and two
        scene.balls.resize(n);
        scene.active = n;
        CHECK(told_by(bound, scene.boxes()) == broadphase_tests::oracle(scene.boxes()));
    }
}

TEST_CASE("G9: Coherent meets a box that is none, and goes on", "[broadphase][coherent][hard]") {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const double bad : {infinite, -infinite, std::numeric_limits<double>::quiet_NaN()})
        for (const std::size_t many : {1u, 100u}) {
            Drift<Space<>> scene(8, 100, 0.002);
            Coherent<>::In<Space<>> bound(Coherent<>{});
            for (int call = 0; call < 120; ++call) {
                scene.step();
                auto boxes = scene.boxes();
                const bool good = call % 30 != 20;
                if (!good)
                    for (std::size_t i = 0; i < many; ++i)
                        boxes.set(i * 31 % 100, metres(0, bad, 0), metres(1, bad, 1));
                const Pairs told = told_by(bound, boxes);
                if (good) REQUIRE(told == broadphase_tests::oracle(boxes));
                for (const auto& [i, j] : told) REQUIRE((i < j && j < boxes.size()));
                CHECK(std::adjacent_find(told.begin(), told.end()) == told.end());
                if (call == 19) REQUIRE(bound.keeps());
            }
        }
}

TEST_CASE("G9: Coherent keeps no pairs of a call that had a box which is none", "[broadphase][coherent][hard]") {
    Drift<Space<>> scene(9, 60, 0);
    scene.side = 1e9;
    for (auto& b : scene.balls) b.step = {0.05, 0.05, 0.05}; // all leave their fat boxes at once
    Coherent<Particular>::In<Space<>> bound(Coherent<Particular>{});
    for (int call = 0; call < 60; ++call) {
        scene.step();
        (void)told_by(bound, scene.boxes());
        auto copy = bound; // which meets it in the next call
        auto next = scene;
        next.step();
        auto spoilt = next.boxes();
        auto low = spoilt.lower_corner(5); // all else is as it would be
        low[1] = std::numeric_limits<double>::quiet_NaN();
        spoilt.set(5, Space<>::Position::from_value(low), Space<>::Position::from_value(spoilt.upper_corner(5)));
        (void)told_by(copy, spoilt);
        for (int later = 0; later < 3; ++later) {
            next.step();
            REQUIRE(told_by(copy, next.boxes()) == broadphase_tests::oracle(next.boxes()));
        }
    }
    CHECK(bound.rebuilds() > 3);
}

TEST_CASE("Coherent passes on what its broadphase says of itself", "[broadphase][coherent]") {
    const auto boxes = broadphase_tests::boxes_of<Space<>>(broadphase_tests::seeded_scene(4));
    using ansatz::test::refusal;
    CHECK(refusal([&] { find_pairs(Coherent{UniformGrid{-1.0 * metre}}, boxes); }) ==
          "UniformGrid: cell is -1 m; it must be finite and not negative");
    CHECK(refusal([&] {
              find_pairs(Coherent{Octree<>{0, 3, {}}}, boxes);
          }) == "Octree: threshold is 0; a cell holds at least 1 body");
    CHECK(find_pairs(Coherent{SortAndSweep{}}, boxes) == broadphase_tests::oracle(boxes));
    Coherent coherent{UniformGrid{2.0 * metre}};
    double cell = 0;
    decltype(coherent)::parameters(coherent, [&](std::string_view name, const auto& value) {
        CHECK(name == "cell");
        cell = value.value();
    });
    CHECK(cell == 2);
    const Coherent<Particular>::In<Space<>> bound(Coherent{Particular{7}});
    CHECK(Particular::last_bound == 7);
    STATIC_REQUIRE(BroadphaseIn<Coherent<>, Space<>>);
    STATIC_REQUIRE(!InsideIn<Coherent<>, Space<>>);
}
