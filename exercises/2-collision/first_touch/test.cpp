// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the first touch within a step (notes 2.1.2).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <cstdint>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Ball;

struct Wall {
    double radius, thickness, dt; // m, m, s
};
const std::vector<Wall> walls{{0.1, 0.1, 1.0 / 60}, {0.25, 0.05, 0.02}, {0.05, 0.4, 0.01}};

/// Of many balls at this speed, the share of those that end on the side that they came from. Each begins its last step
/// before the wall a little nearer to it. Nobody is asked for a formula: they are moved and tested.
double saved_at(const Wall& w, double speed) {
    const double touches = -w.radius - w.thickness / 2, step = speed * w.dt;
    int saved = 0;
    constexpr int balls = 500;
    for (int i = 1; i <= balls; ++i) {
        const double x = touches + i * step / balls; // of the centre, after that step; the wall's middle is at 0
        saved += x < 0;                              // beyond it the nearest way out is on the far side
    }
    return double(saved) / balls;
}
std::string said(const Wall& w, double speed) {
    std::ostringstream text;
    text << "a ball of radius " << w.radius << " m, a wall " << w.thickness << " m thick, steps of " << w.dt
         << " s; at your " << speed << " m/s a step is " << speed * w.dt << " m long";
    return text.str();
}
double yours(const Wall& w) {
    return exercise::safe_speed(w.radius * metre, w.thickness * metre, w.dt * second).value();
}

/// Two balls, seen from the second one: in plain numbers, for they are tested at many moments.
struct Seen {
    double x, y, z, by_x, by_y, by_z, reach;
    Seen(const Ball& a, const Ball& b) {
        const auto q = (a.centre - b.centre).value(), m = (a.motion - b.motion).value();
        x = q[0], y = q[1], z = q[2], by_x = m[0], by_y = m[1], by_z = m[2];
        reach = a.radius.value() + b.radius.value();
    }
    /// By how much the surfaces are apart at a moment of the step.
    double gap(double share) const { return std::hypot(x + share * by_x, y + share * by_y, z + share * by_z) - reach; }
    /// The least gap between two moments, tested at many of them.
    double least_gap(double from, double to) const {
        double least = gap(to);
        for (int i = 0; i < 200; ++i) least = std::min(least, gap(from + i * (to - from) / 200));
        return least;
    }
};
/// When two first touch, searched for moment by moment and then between two of them.
double looked_for(const Ball& a, const Ball& b) {
    const Seen seen(a, b);
    double before = 0, after = 1;
    for (int i = 1; i <= 1000; ++i)
        if (seen.gap(i / 1000.0) < 0) {
            after = i / 1000.0, before = (i - 1) / 1000.0;
            break;
        }
    for (int i = 0; i < 50; ++i) (seen.gap((before + after) / 2) < 0 ? after : before) = (before + after) / 2;
    return after;
}
using Pairs = std::vector<std::pair<Ball, Ball>>;
/// Pairs of balls that fly about; `is` says which are wanted.
template <class Is> Pairs pairs(Is&& is) {
    std::uint32_t random = 7;
    auto number = [&](double from, double to) {
        random = random * 1664525u + 1013904223u;
        return from + (to - from) * (random >> 8) / double(1 << 24);
    };
    auto ball = [&] {
        auto vector = [&](double to) {
            const double x = number(-to, to), y = number(-to, to), z = number(-to, to);
            return metres(x, y, z);
        };
        const auto centre = vector(2.5), motion = vector(5.0);
        return Ball{centre, motion, number(0.3, 1.1) * metre};
    };
    Pairs found;
    for (int i = 0; i < 5000 && found.size() < 12; ++i) {
        const auto a = ball(), b = ball();
        if (is(Seen(a, b))) found.push_back({a, b});
    }
    return found;
}
constexpr double clear_of_it = 0.02; // m: nothing is decided by less
Pairs end_in_each_other() {
    return pairs([](const Seen& s) { return s.gap(0) > clear_of_it && s.gap(1) < -clear_of_it; });
}
Pairs fly_through() {
    return pairs([](const Seen& s) {
        return s.gap(0) > clear_of_it && s.gap(1) > clear_of_it && s.least_gap(0, 1) < -clear_of_it;
    });
}
Pairs pass_beside() {
    return pairs([](const Seen& s) {
        const double nearest = s.least_gap(0, 1);
        return nearest > clear_of_it && nearest < 1.5 && s.gap(0) > nearest + 0.1 && s.gap(1) > nearest + 0.1;
    });
}
Pairs not_yet() {
    return pairs([](const Seen& s) {
        return s.gap(0) > clear_of_it && s.least_gap(0, 1) > clear_of_it && s.least_gap(1, 4) < -clear_of_it;
    });
}
Pairs part() {
    return pairs([](const Seen& s) { return s.gap(0) > clear_of_it && s.least_gap(-4, 0) < -clear_of_it; });
}
Pairs part_inside() {
    return pairs([](const Seen& s) { return s.gap(0) < -clear_of_it && s.gap(1e-3) > s.gap(0); });
}
Pairs deeper() {
    return pairs([](const Seen& s) { return s.gap(0) < -clear_of_it && s.gap(1e-3) < s.gap(0); });
}

std::string said(const Ball& a, const Ball& b) {
    std::ostringstream text;
    text.precision(4);
    for (const auto& [name, ball] : {std::pair{"the first", a}, {"the second", b}})
        text << name << ": " << ball.radius << ", from " << ball.centre << " by " << ball.motion << '\n';
    return text.str();
}
void expect_share(const Pairs& all, auto&& right, const std::string& why) {
    for (const auto& [a, b] : all) {
        const auto share = exercise::first_touch(a, b);
        expect(share.has_value(), said(a, b) + "Yours finds no touch.\n" + why);
        expect_near(said(a, b) + "the share of the step until they touch", *share, right(a, b), 1e-9, why);
    }
}
void expect_nothing(const Pairs& all, const std::string& why) {
    for (const auto& [a, b] : all) {
        const auto share = exercise::first_touch(a, b);
        std::ostringstream text;
        text << said(a, b) << "yours says that they touch";
        if (share) text << " at " << *share << " of the step";
        text << ".\n" << why;
        expect(!share.has_value(), text.str());
    }
}
/// Pairs, and the share at which they touch.
template <class Check> void each_touch(Check&& check) {
    for (const Pairs& all : {end_in_each_other(), fly_through()})
        for (const auto& [a, b] : all) check(a, b, looked_for(a, b));
}

} // namespace

TEST_CASE("no ball comes out behind the wall", "[task-1][right-side]") {
    for (const Wall& w : walls) {
        std::ostringstream text;
        text << said(w, yours(w)) << ".\nOf 100 balls at 1 % less " << 100 - 100 * saved_at(w, 0.99 * yours(w))
             << " end on the wrong side; right is none.\nA ball that is first seen beyond the middle of the wall has "
                "its nearest way out on the far side.";
        expect(saved_at(w, 0.99 * yours(w)) == 1, text.str());
    }
}

TEST_CASE("and no speed is forbidden that is safe", "[task-1][no-slower]") {
    for (const Wall& w : walls)
        expect(saved_at(w, 1.01 * yours(w)) < 1,
               said(w, yours(w)) + ".\nAt 1 % more all balls are still pushed out on the right side, so that it is not "
                                   "the fastest that is safe.\nThe ball intersects the wall as soon as its surface "
                                   "does, and is safe until its centre is in the middle.");
}

TEST_CASE("two that end in each other touch before that", "[task-2][before-the-end]") {
    expect_share(end_in_each_other(), looked_for,
                 "They touch when the distance of the centres has first come down to the sum of the radii. What is "
                 "right was found moment by moment.");
}

TEST_CASE("two that fly through each other within the step touch", "[task-2][through]") {
    expect_share(fly_through(), looked_for,
                 "They intersect neither at the beginning nor at the end, but in between. What is right was looked "
                 "for, moment by moment.");
}

TEST_CASE("two that pass beside each other do not", "[task-2][beside]") {
    expect_nothing(pass_beside(), "Where they are nearest, the centres are farther apart than the sum of the radii.");
}

TEST_CASE("what the step does not reach is not touched in it", "[task-2][not-yet]") {
    expect_nothing(not_yet(), "If they went on, they would touch; but the share would be more than 1, after the step.");
}

TEST_CASE("two that separate do not touch", "[task-2][part]") {
    expect_nothing(part(), "The line meets the other ball, but behind them: in the past.");
    expect_nothing(part_inside(), "They intersect and leave each other: whoever stops them here keeps them there.");
    const Ball one{metres(0, 0, 0), metres(3, 1, 2), 0.5 * metre},
        beside{metres(0, 2, 0), metres(3, 1, 2), 0.5 * metre};
    expect_nothing({{one, beside}}, "They go side by side: seen from the one, the other does not move.");
}

TEST_CASE("two that intersect and come nearer touch at once", "[task-2][at-once]") {
    expect_share(
        deeper(), [](const Ball&, const Ball&) { return 0.0; },
        "Nothing of the step may go by before a response hears of them.");
}

TEST_CASE("a shot from far away is as exact as one from near", "[task-2][far]") {
    for (const double distance : {1e4, 1e6, 1e7}) {
        // It passes the centre at 0.6 m, and the radii are 1 m together: they touch 0.8 m before it is nearest.
        const Ball shot{metres(-distance, 0.6, 0), metres(2 * distance, 0, 0), 0.25 * metre};
        const Ball target{metres(0, 0, 0), metres(0, 0, 0), 0.75 * metre};
        const auto share = exercise::first_touch(shot, target);
        const std::string why =
            "It passes the centre of the other at 0.6 m, and the radii are 1 m together: they touch "
            "0.8 m before it is there.\nThe difference of two squares of large numbers has few "
            "digits that are right. The square of how near they come is a small number.";
        expect(share.has_value(), said(shot, target) + "Yours finds no touch.\n" + why);
        expect_near(said(shot, target) + "where the first is when they touch, along its way",
                    (*share * 2 - 1) * distance * metre, -0.8 * metre, 1e-6 * metre, why);
    }
}

TEST_CASE("the normal is of that moment, from the second to the first", "[task-3][normal]") {
    each_touch([](const Ball& a, const Ball& b, double share) {
        const Vector<double, 3> right =
            ((a.centre.value() + share * a.motion.value()) - (b.centre.value() + share * b.motion.value()))
                .normalized();
        const Vector<double, 3> normal = exercise::contact_then(a, b, share).normal;
        std::ostringstream text;
        text << said(a, b) << "touch at " << share << " of the step: the normal\n    yours  (" << normal.transpose()
             << ")\n    right  (" << right.transpose()
             << ")\nIt has the length 1 and leads from the centre of the second to that of the first, where they are "
                "then.";
        expect((normal - right).norm() <= 1e-6, text.str());
    });
}

TEST_CASE("the point is on the first ball", "[task-3][on-the-first]") {
    each_touch([](const Ball& a, const Ball& b, double share) {
        const auto point = exercise::contact_then(a, b, share).point;
        const VectorQuantity<unit::Length, 3> from_it = point - (a.centre + share * a.motion);
        expect_near(said(a, b) + "the distance of the point from the centre of the first, when they touch",
                    norm(from_it), a.radius, 1e-6 * metre,
                    "The point is on the surface of both balls, so that it is a "
                    "radius away from where the centre is then.");
    });
}

TEST_CASE("and on the second", "[task-3][on-the-second]") {
    each_touch([](const Ball& a, const Ball& b, double share) {
        const auto point = exercise::contact_then(a, b, share).point;
        const VectorQuantity<unit::Length, 3> from_it = point - (b.centre + share * b.motion);
        expect_near(said(a, b) + "the distance of the point from the centre of the second, when they touch",
                    norm(from_it), b.radius, 1e-6 * metre,
                    "The point is on the surface of both balls, so that it is a "
                    "radius away from where the centre is then.");
    });
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const Wall& w : walls) numbers.push_back(yours(w));
    if (task == 2) {
        auto add = [&](const Ball& a, const Ball& b) {
            const auto share = exercise::first_touch(a, b);
            numbers.push_back(share ? *share : -7);
        };
        for (const Pairs& all :
             {end_in_each_other(), fly_through(), pass_beside(), not_yet(), part(), part_inside(), deeper()})
            for (int i = 0; i < 5; ++i) add(all[std::size_t(i)].first, all[std::size_t(i)].second);
        // So far away that of R^2 - h^2 nothing is left beside the square of the distance, which is a power of two.
        const double distance = std::exp2(30);
        const auto share = exercise::first_touch({metres(-distance, 0.6, 0), metres(2 * distance, 0, 0), 0.25 * metre},
                                                 {metres(0, 0, 0), metres(0, 0, 0), 0.75 * metre});
        numbers.push_back(share ? (*share * 2 - 1) * distance : -7);
    }
    if (task == 3)
        for (const Pairs& all : {end_in_each_other(), fly_through()})
            for (int i = 0; i < 5; ++i) {
                const auto& [a, b] = all[std::size_t(i)];
                const auto contact = exercise::contact_then(a, b, looked_for(a, b));
                for (int k = 0; k < 3; ++k)
                    numbers.push_back(contact.point.value()[k]), numbers.push_back(contact.normal[k]);
            }
    return numbers;
}
