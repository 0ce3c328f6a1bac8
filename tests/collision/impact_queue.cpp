// SPDX-License-Identifier: BSL-1.0
// Bodies that travel along straight lines, without a world: which bodies meet, when, and in which order (notes 2.1.2).

#include "tests/collision/support.hpp"
#include "tests/dice.hpp"

#include <ansatz/collision/impact_queue.hpp>
#include <ansatz/collision/narrowphase/swept.hpp>

using namespace collision_tests;

namespace {
/// Balls of 1 m radius that travel, each with its number as its id.
template <class S> struct Balls {
    using Queue = ImpactQueue<S, Narrowphase<Sphere>>;
    using Traveller = typename Queue::Traveller;
    using Raw = Vector<typename S::Scalar, S::dimension>;
    typename Queue::Shapes shapes;
    Queue queue;
    std::vector<Traveller> all;

    void add(const Raw& from, const Raw& way, bool stops = true, bool sensor = false) {
        const auto id = std::uint32_t(all.size());
        const Sphere ball{1.0 * metre};
        shapes.make_room(id);
        shapes.set(id, ball, typename Sphere::template In<S>(ball));
        all.push_back({id, id, stops, false, sensor, S::Position::from_value(from), S::Position::from_value(way)});
    }
    /// All pairs of a fast one with any other.
    void run(bool by_force = false) {
        queue.clear();
        for (const auto& t : all) queue.add(shapes, t);
        if (!queue.add_slow(shapes)) return;
        for (std::uint32_t i = 0; i < queue.travellers.size(); ++i)
            for (std::uint32_t j = 0; j < queue.boxes.active(); ++j)
                if (j < i && queue.boxes.touch(i, j))
                    queue.travellers[i].id < queue.travellers[j].id ? queue.add_pair(i, j) : queue.add_pair(j, i);
        queue.follow(shapes, false, by_force);
    }
    const Traveller& of(std::uint32_t id) const {
        return *std::find_if(queue.travellers.begin(), queue.travellers.end(), [&](auto& t) { return t.id == id; });
    }
    Raw end(std::uint32_t id) const {
        const auto& t = of(id);
        return (t.at + (typename S::Scalar(1) - t.since) * t.rate).value();
    }
};
template <class S> typename Balls<S>::Raw along(double x, double y = 0) {
    auto v = Balls<S>::Raw::Zero().eval();
    v[0] = typename S::Scalar(x), v[1] = typename S::Scalar(y);
    return v;
}
} // namespace

TEMPLATE_TEST_CASE("two that travel towards each other stop where they touch, at their time", "[collision]",
                   (Space<double, 3>), (Space<float, 2>)) {
    using S = TestType;
    Balls<S> balls;
    balls.add(along<S>(-7), along<S>(8)); // 10 m apart, 2 m of them balls: they touch after 8 m of the 16
    balls.add(along<S>(3), along<S>(-8));
    balls.run();
    REQUIRE(balls.queue.impacts.size() == 1);
    const auto& impact = balls.queue.impacts[0];
    const double close = std::is_same_v<typename S::Scalar, float> ? 1e-5 : 1e-14;
    CHECK((impact.a == 0 && impact.b == 1));
    CHECK(std::abs(impact.first.normal[0] + 1) <= close);
    CHECK(std::abs(impact.first.arm.value()[0] + 2) <= 10 * close); // they meet at -2 m
    for (const std::uint32_t id : {0u, 1u}) {
        CHECK(std::abs(balls.of(id).lost - 0.5) <= close);
        CHECK(std::abs(balls.end(id)[0] - (id == 0 ? -3 : -1)) <= 10 * close);
    }
    // Where only forces part them they go on until they are in each other, by a sixteenth of a radius.
    balls.run(true);
    CHECK(std::abs(balls.end(1)[0] - balls.end(0)[0] - (2 - 1.0 / 16)) <= 10 * close);
}

TEST_CASE("a fast one takes the nearest of many, whatever their order, and what is behind it is not touched",
          "[collision]") {
    using S = Space<>;
    test::Dice dice(7);
    int met = 0, several = 0;
    for (int scene = 0; scene < 400; ++scene) {
        Balls<S> balls;
        const double way = dice.number(20, 60);
        balls.add(along<S>(0), along<S>(way));
        double nearest = 2; // of the step
        std::uint32_t whom = 0;
        int in_the_way = 0;
        for (std::uint32_t id = 1; id <= 12; ++id) {
            const double x = dice.number(3, 53), y = dice.number(-4, 4);
            balls.add(along<S>(x, y), along<S>(0), false);
            if (std::abs(y) >= 2) continue;
            const double time = (x - std::sqrt(4 - y * y)) / way; // of two circles of radius 1
            in_the_way += time < 1;
            if (time < nearest) nearest = time, whom = id;
        }
        balls.run();
        INFO("scene " << scene);
        // Those that it would only graze, a sixteenth of a radius deep, are left to the discrete functions.
        const double y = whom > 0 ? balls.all[whom].at.value()[1] : 0;
        if (nearest >= 1 || std::abs(y) > 1.9) continue;
        REQUIRE(!balls.queue.impacts.empty());
        REQUIRE(balls.queue.impacts[0].b == whom);
        REQUIRE(std::abs(1 - balls.of(0).lost - nearest) <= 1e-12);
        REQUIRE(std::abs(balls.end(0)[0] - nearest * way) <= 1e-12 * way);
        ++met;
        several += in_the_way > 1;
    }
    CHECK(met > 100);
    CHECK(several > 50);
}

TEST_CASE("a row that is run into stops at the first, and sensors stop no body", "[collision]") {
    using S = Space<>;
    Balls<S> balls;
    balls.add(along<S>(-10), along<S>(12));
    balls.add(along<S>(-5), along<S>(0), true, true); // notices
    balls.add(along<S>(0), along<S>(0));
    balls.add(along<S>(3), along<S>(0));
    balls.run();
    REQUIRE(balls.queue.impacts.size() == 2); // in the order of time
    CHECK((balls.queue.impacts[0].b == 1 && balls.queue.impacts[1].b == 2));
    CHECK(balls.of(1).lost == 0);
    CHECK(std::abs(balls.end(0)[0] + 2) <= 1e-14);
    CHECK(balls.end(2)[0] == 0); // the response moves it, not this
    CHECK(balls.end(3)[0] == 3);
    // No body is fast: nothing to search for.
    Balls<S> slow;
    slow.add(along<S>(0), along<S>(0.2));
    slow.add(along<S>(2.1), along<S>(-0.2));
    slow.run();
    CHECK(slow.queue.travellers.empty());
    CHECK(slow.queue.impacts.empty());
}
