// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on one constraint (notes 4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::End;
using Length3 = VectorQuantity<unit::Length, 3>;
using Velocity3 = VectorQuantity<unit::Velocity, 3>;
const auto gram_metre = 1e-3 * kilogram * metre;

struct Look {
    double stretch, multiplier, stiffness, weights, h;
    auto k() const { return h * h * stiffness * kilogram; }
    auto change() const {
        return exercise::change(stretch * metre, multiplier * kilogram * metre, stiffness * newton_per_metre,
                                weights / kilogram, h * second);
    }
};
const Look looks[] = {{0.03, -0.0002, 500, 3.7, 0.01}, {-0.05, 0.0001, 40, 0.9, 0.02}, {0.2, -0.003, 8000, 12, 0.004}};
std::string said(const Look& l) {
    std::ostringstream text;
    text << "a spring of " << l.stiffness << " N/m that is " << l.stretch << " m too long, has given " << l.multiplier
         << " N s^2, and has 1/m of " << l.weights << " /kg in sum, a step of " << l.h << " s";
    return text.str();
}

struct Pair {
    Length3 first, second;
    double first_weight, second_weight, rest_length, stiffness, multiplier, h;
};
const Pair pairs[] = {
    {metres(0.3, 1, -2), metres(1.1, 1.4, -1.7), 0.5, 3.0, 0.8, 300, -0.001, 0.02},
    {metres(2, -1, 0.5), metres(1.2, 0.4, 0.1), 2.5, 0.4, 1.9, 900, 0.002, 0.01},
    {metres(0.1, 0.2, 0.3), metres(0.1, -1.2, 0.9), 0.0, 1.7, 1.1, 70, -0.0003, 0.03},
};
std::string said(const Pair& p) {
    std::ostringstream text;
    text << "ends at " << p.first << " and " << p.second << " of " << p.first_weight << " /kg and " << p.second_weight
         << " /kg, a spring of " << p.stiffness << " N/m and " << p.rest_length << " m that has given " << p.multiplier
         << " N s^2, a step of " << p.h << " s";
    return text.str();
}
/// The two ends before and after a correction.
struct Looked {
    End first, second, first_before, second_before;
    exercise::Multiplier multiplier;
    Length3 first_way() const { return first.position - first_before.position; }
    Length3 second_way() const { return second.position - second_before.position; }
};
Looked look_at(const Pair& p) {
    Looked all;
    const Velocity3 v = p.first_weight > 0 ? metres_per_second(1, 2, -3) : metres_per_second(0, 0, 0);
    all.first_before = all.first = {p.first, v, p.first_weight / kilogram};
    all.second_before = all.second = {p.second, metres_per_second(-2, 0.5, 1), p.second_weight / kilogram};
    all.multiplier = exercise::hold(all.first, all.second, {p.rest_length * metre, p.stiffness * newton_per_metre},
                                    p.multiplier * kilogram * metre, p.h * second);
    return all;
}

/// A body on a line below a point that is held.
struct Hanging {
    double length, speed, weight, rest_length, stiffness, dt;
};
const Hanging hanging[] = {{1.2, -0.4, 2.0, 1.0, 30, 0.05}, {0.7, 0.9, 0.3, 0.9, 2000, 0.02}};
std::string said(const Hanging& s, int substeps, int iterations) {
    std::ostringstream text;
    text << 1 / s.weight << " kg on " << s.length << " m of a spring of " << s.rest_length << " m and " << s.stiffness
         << " N/m, falling at " << -s.speed << " m/s, a step of " << s.dt << " s in " << substeps << " with "
         << iterations << " iterations each";
    return text.str();
}
End after(const Hanging& s, double dt, int substeps, int iterations, int steps = 1) {
    End top{metres(3, 5, 1), metres_per_second(0, 0, 0), 0.0 / kilogram},
        body{metres(3, 5 - s.length, 1), metres_per_second(0, s.speed, 0), s.weight / kilogram};
    for (int n = 0; n < steps; ++n)
        exercise::step(top, body, {s.rest_length * metre, s.stiffness * newton_per_metre},
                       metres_per_second_squared(0, -9.81, 0), dt * second, substeps, iterations);
    if (top.position != metres(3, 5, 1)) fail("The end that is held has moved. Its 1/m is zero: nothing moves it.");
    return body;
}

} // namespace

TEST_CASE("the force is the one at the end of the step", "[task-1][end]") {
    for (const Look& l : looks) {
        const auto by = l.change();
        expect_agree(
            said(l), "yours, the multiplier afterwards", l.multiplier * kilogram * metre + by,
            "-h^2 k times the stretch that it leaves", -l.k() * (l.stretch * metre + by * (l.weights / kilogram)),
            1e-12 * gram_metre,
            "The correction moves the ends, so that the stretch changes by the weights times the change; the force "
            "is that of the spring as it is then.");
    }
}

TEST_CASE("a spring that is right stays", "[task-1][settled]") {
    for (Look l : looks) {
        l.multiplier = -l.h * l.h * l.stiffness * l.stretch;
        expect_near(said(l) + ": the change", l.change(), 0.0 * kilogram * metre, 1e-15 * kilogram * metre,
                    "It has given all that it has to give already. A second correction must not give it again.");
    }
}

TEST_CASE("the stiffest spring ends at its rest length", "[task-1][stiff]") {
    for (Look l : looks) {
        l.multiplier = 0;
        l.stiffness = 1e13;
        expect_near(said(l) + ": the stretch that your change leaves",
                    l.stretch * metre + l.change() * (l.weights / kilogram), 0.0 * metre, 1e-6 * metre,
                    "It is never moved farther than to where it has no stretch, however stiff it is.");
    }
}

TEST_CASE("the spring is as long as what it has given says", "[task-2][length]") {
    for (const Pair& p : pairs) {
        const auto now = look_at(p);
        const auto stretch = norm(now.second.position - now.first.position) - p.rest_length * metre;
        expect_near(
            said(p) + ": the multiplier", now.multiplier, -p.h * p.h * p.stiffness * kilogram * stretch,
            1e-11 * gram_metre,
            "After the correction the multiplier is -h^2 k times the stretch that there is now: what it was, and "
            "the change.");
    }
}

TEST_CASE("their centre of mass stays", "[task-2][centre]") {
    for (const Pair& p : pairs) {
        if (!(p.first_weight > 0)) continue;
        const auto now = look_at(p);
        expect_near(said(p) + ": the ways, each times its mass, in sum",
                    now.first_way() / p.first_weight + now.second_way() / p.second_weight, metres(0, 0, 0),
                    1e-12 * metre,
                    "Both ends get the same force, opposite: the light one goes far, the heavy one not.");
    }
}

TEST_CASE("the velocity changes by the way", "[task-2][velocity]") {
    for (const Pair& p : pairs) {
        const auto now = look_at(p);
        const auto h = p.h * second;
        const char* why = "Who is moved by a way in a step has that much more of velocity: the way over h, added to "
                          "what there was.";
        expect_near(said(p) + ": the velocity of the first", now.first.velocity,
                    now.first_before.velocity + now.first_way() / h, 1e-10 * metre_per_second, why);
        expect_near(said(p) + ": the velocity of the second", now.second.velocity,
                    now.second_before.velocity + now.second_way() / h, 1e-10 * metre_per_second, why);
    }
}

TEST_CASE("with one spring it is implicit Euler", "[task-3][implicit-euler]") {
    for (const Hanging& s : hanging)
        for (const int substeps : {1, 4}) {
            const double h = s.dt / substeps;
            double x = -s.length, v = s.speed;
            for (int n = 0; n < substeps; ++n) {
                // m (v' - v) = h (-m g - k (x' + l)), x' = x + h v'
                v = (v - h * 9.81 - h * s.weight * s.stiffness * (x + s.rest_length)) /
                    (1 + h * h * s.weight * s.stiffness);
                x += h * v;
            }
            const End body = after(s, s.dt, substeps, 1);
            expect_near(said(s, substeps, 1) + ": where it is", body.position, metres(3, 5 + x, 1), 1e-12 * metre,
                        "Gravity and velocity first, then the spring, once for each substep.");
            expect_near(said(s, substeps, 1) + ": its velocity", body.velocity, metres_per_second(0, v, 0),
                        1e-10 * metre_per_second, "The way that the spring moves it in a substep, over the substep.");
        }
}

TEST_CASE("a second iteration over one spring finds nothing to do", "[task-3][second-look]") {
    for (const Hanging& s : hanging)
        for (const int substeps : {1, 3})
            expect_agree(
                said(s, substeps, 5) + ", and with one", "yours, with one iteration",
                after(s, s.dt, substeps, 1).position, "yours, with five", after(s, s.dt, substeps, 5).position,
                1e-12 * metre,
                "What the first iteration has given is in the multiplier. Without it each iteration makes the spring "
                "stiffer.");
}

TEST_CASE("substeps are steps", "[task-3][substeps]") {
    for (const Hanging& s : hanging)
        expect_agree(said(s, 6, 1) + ", and as six steps", "yours, in substeps", after(s, s.dt, 6, 1).position,
                     "yours, in six steps", after(s, s.dt / 6, 1, 1, 6).position, 1e-12 * metre,
                     "Each substep is a whole step of dt / 6, and begins with a multiplier of zero.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const Look& l : looks) numbers.push_back(1000 * l.change().value());
    if (task == 2)
        for (const Pair& p : pairs) {
            const auto now = look_at(p);
            numbers.push_back(1000 * now.multiplier.value());
            for (const End* end : {&now.first, &now.second})
                for (int k = 0; k < 3; ++k)
                    numbers.insert(numbers.end(), {end->position.value()[k], end->velocity.value()[k]});
        }
    if (task == 3)
        for (const Hanging& s : hanging)
            for (const int substeps : {1, 3})
                for (const int iterations : {1, 4}) {
                    End top{metres(0.3, 2, 0), metres_per_second(0, 0, 0), 0.0 / kilogram},
                        body{metres(0.3, 2 - s.length, 0), metres_per_second(0.2, s.speed, 0), s.weight / kilogram};
                    exercise::step(top, body, {s.rest_length * metre, s.stiffness * newton_per_metre},
                                   metres_per_second_squared(0, -9.81, 0), s.dt * second, substeps, iterations);
                    for (const End* end : {&top, &body})
                        numbers.insert(numbers.end(), {end->position.value()[0], end->position.value()[1],
                                                       end->velocity.value()[0], end->velocity.value()[1]});
                }
    return numbers;
}
