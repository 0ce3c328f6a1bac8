// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on damping along the axis (notes 3).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Damped;
using exercise::End;
using exercise::Force;
using Velocity3 = VectorQuantity<unit::Velocity, 3>;

/// A spring and its two ends, in the middle of a motion.
struct Case {
    End first, second;
    Damped spring;

    auto to() const { return second.position - first.position; }
    auto forces() const { return exercise::forces(first, second, spring); }
};
const auto no_stiffness = 0.0 * newton_per_metre;

/// Ends at 0.5 m, 3 m and 7 m from each other: stretched and pressed, both moving, along the axis and across it.
const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {{metres(1, 2, 3), metres_per_second(0.5, -1, 2)},
         {metres(1.3, 2.4, 3), metres_per_second(2, 1, -0.5)},
         {0.2 * metre, 80.0 * newton_per_metre, 3.0 * newton_second_per_metre}},
        {{metres(-2, 0, 1), metres_per_second(1, 3, 0)},
         {metres(0, 1, 3), metres_per_second(-4, 2, 1)},
         {4.0 * metre, 15.0 * newton_per_metre, 0.7 * newton_second_per_metre}},
        {{metres(6, 3, -1), metres_per_second(0, 0, 2)},
         {metres(0, 0, 1), metres_per_second(-3, 1, 2)},
         {5.0 * metre, 200.0 * newton_per_metre, 40.0 * newton_second_per_metre}},
    };
    return all;
}
Case in_one_place(double speed) {
    Case c = cases()[1];
    c.second.position = c.first.position;
    c.second.velocity = c.first.velocity + metres_per_second(speed, 0, 0);
    return c;
}
/// The same, seen from a train.
Case moved(Case c) {
    for (End* end : {&c.first, &c.second}) end->velocity += metres_per_second(-3, 10, 2);
    return c;
}
/// The same with a second end that moves across the axis, as the first end sees it, and in no other way.
Case across(Case c) {
    const auto axis = c.to() / norm(c.to());
    const Velocity3 along = dot(metres_per_second(1, -2, 4), axis) * axis;
    c.second.velocity = c.first.velocity + (metres_per_second(1, -2, 4) - along);
    return c;
}

std::string said(const End& end) {
    std::ostringstream text;
    text << "at " << end.position << " with " << end.velocity;
    return text.str();
}
std::string said(const Case& c) { return "one end " + said(c.first) + ", the other " + said(c.second); }
std::string with_spring(const Case& c) {
    std::ostringstream text;
    text << "a spring of " << c.spring.stiffness << ", " << c.spring.damping << ", rest length " << c.spring.rest_length
         << ",\n"
         << said(c);
    return text.str();
}

/// What the length is when both ends have gone on for a time t.
auto length_after(const Case& c, Quantity<unit::Time> t) {
    return norm(c.to() + (c.second.velocity - c.first.velocity) * t);
}
/// By how much the length grows in a time, forwards and backwards; it differs from the speed by the square of h.
auto measured_lengthening(const Case& c) {
    const auto h = 1e-6 * second;
    return (length_after(c, h) - length_after(c, -h)) / (2.0 * h);
}

} // namespace

TEST_CASE("it is how fast the distance grows", "[task-1][distance]") {
    // h^2 L''' / 6 is below 1e-10 m/s, and the rounding of the two lengths, 1e-15 m, over 2 h is some 1e-9 m/s.
    for (const auto& c : cases())
        expect_near(said(c) + ":\nhow fast the distance between them grows", exercise::lengthening(c.first, c.second),
                    measured_lengthening(c), 1e-7 * metre_per_second,
                    "It is the part of the relative velocity that is along the axis. The axis has the length 1, and "
                    "points from the first end to the second.");
}

TEST_CASE("what moves across the axis does not lengthen it", "[task-1][circle]") {
    for (const auto& given : cases()) {
        const Case c = across(given);
        expect_near(said(c) + ":\nhow fast the distance grows when the second end goes round the first",
                    exercise::lengthening(c.first, c.second), 0.0 * metre_per_second, 1e-12 * metre_per_second,
                    "On a circle round the first end the distance stays as it is, however fast the second is.");
    }
}

TEST_CASE("seen from a train, the spring lengthens as fast", "[task-1][train]") {
    for (const auto& c : cases()) {
        const Case train = moved(c);
        expect_agree(said(c) + ":\nhow fast the distance grows", "yours, as it is",
                     exercise::lengthening(c.first, c.second), "yours, with (-3, 10, 2) m/s added to both velocities",
                     exercise::lengthening(train.first, train.second), 1e-12 * metre_per_second,
                     "Only the difference of the two velocities counts.");
    }
}

TEST_CASE("ends in one place do not separate along any axis", "[task-1][no-axis]") {
    for (const double speed : {0.0, 2.0}) {
        const Case c = in_one_place(speed);
        expect_near(said(c) + ":\nhow fast the distance grows", exercise::lengthening(c.first, c.second),
                    0.0 * metre_per_second, 0.0 * metre_per_second,
                    "Ends in one place have no axis, and a division by their distance is no number. The answer asked "
                    "for is zero.");
    }
}

TEST_CASE("without a motion the spring pulls or pushes along its axis", "[task-2][still]") {
    for (Case c : cases()) {
        c.first.velocity = c.second.velocity = metres_per_second(0, 0, 0);
        const Force right = c.spring.stiffness * (norm(c.to()) - c.spring.rest_length) * (c.to() / norm(c.to()));
        expect_near(with_spring(c) + ":\nthe force on the first end", c.forces().first, right, 1e-12 * norm(right),
                    "It is k times the length beyond the rest length, towards the second end. The axis that carries it "
                    "has the length 1, at every distance.");
    }
}

TEST_CASE("what one end feels, the other feels with the opposite sign", "[task-2][opposite]") {
    for (const auto& c : cases()) {
        const auto [on_first, on_second] = c.forces();
        expect_agree(with_spring(c) + ":\nthe two forces", "yours on the second end", on_second,
                     "yours on the first, with the opposite sign", Force(-on_first), 1e-12 * norm(on_first),
                     "A spring has no momentum to give away (notes 1.3).");
    }
}

TEST_CASE("a damper takes c v^2 of energy in each second, and no more", "[task-2][power]") {
    for (Case c : cases()) {
        c.spring.stiffness = no_stiffness;
        const auto [on_first, on_second] = c.forces();
        const auto speed = measured_lengthening(c);
        const auto right = -c.spring.damping * speed * speed;
        expect_near(with_spring(c) + ":\nthe power of its forces, in W",
                    dot(on_first, c.first.velocity) + dot(on_second, c.second.velocity), right, 1e-6 * abs(right),
                    "v is the speed at which the spring becomes longer. The damper pulls when it does and pushes when "
                    "it becomes shorter, so that its power is -c v^2, never more than zero.");
    }
}

TEST_CASE("what moves across the axis is not damped", "[task-2][pendulum]") {
    for (const auto& given : cases()) {
        Case c = across(given);
        c.spring.rest_length = norm(c.to());
        expect_near(with_spring(c) + ":\nthe force on the first end when the second goes round it", c.forces().first,
                    newtons(0, 0, 0), 1e-11 * newton,
                    "The spring is at its rest length and stays there, so that nothing acts. If the whole velocity "
                    "were damped, no pendulum would swing for long.");
    }
}

TEST_CASE("seen from a train, the spring pulls the same", "[task-2][train-forces]") {
    for (const auto& c : cases())
        expect_agree(with_spring(c) + ":\nthe force on the first end", "yours, as it is", c.forces().first,
                     "yours, with (-3, 10, 2) m/s added to both velocities", moved(c).forces().first, 1e-11 * newton,
                     "A damper between two bodies knows nothing of how both move together; a drag would.");
}

TEST_CASE("ends in one place feel nothing", "[task-2][nothing]") {
    for (const double speed : {0.0, 2.0}) {
        const Case c = in_one_place(speed);
        const auto [on_first, on_second] = c.forces();
        expect_near(with_spring(c) + ":\nthe sizes of both forces together", norm(on_first) + norm(on_second),
                    0.0 * newton, 0.0 * newton,
                    "There is no axis along which to push. One force that is no number, and the whole world is gone a "
                    "step later.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    auto add = [&](const Case& c) {
        if (task == 1) {
            numbers.push_back(exercise::lengthening(c.first, c.second).value());
            return;
        }
        const auto [on_first, on_second] = c.forces();
        for (const Force& force : {on_first, on_second})
            numbers.insert(numbers.end(), {x(force).value(), y(force).value(), z(force).value()});
    };
    for (const auto& c : cases()) add(c);
    add(in_one_place(2));
    return numbers;
}
