// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on one vertex of a solver (notes 4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <Eigen/Core>

#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using Vec = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

struct Star {
    const char* name;
    exercise::Body body;
    exercise::Place x;
    std::vector<exercise::Spring> springs;
    double h;

    double inertia() const { return body.mass.value() / (h * h); }
    double energy(const Vec& at) const {
        double sum = 0.5 * inertia() * (at - body.flown.value()).squaredNorm();
        for (const exercise::Spring& s : springs) {
            const double c = (at - s.neighbour.value()).norm() - s.rest_length.value();
            sum += 0.5 * s.stiffness.value() * c * c;
        }
        return sum;
    }
    /// How the energy changes along each axis, by differences.
    Vec differences(const Vec& at) const {
        Vec all;
        for (int k = 0; k < 3; ++k)
            all[k] = (energy(at + 1e-5 * Vec::Unit(k)) - energy(at - 1e-5 * Vec::Unit(k))) / 2e-5;
        return all;
    }
    Vec slope(const Vec& at) const {
        Vec sum = inertia() * (at - body.flown.value());
        for (const exercise::Spring& s : springs) {
            const Vec from = at - s.neighbour.value();
            sum += s.stiffness.value() * (1 - s.rest_length.value() / from.norm()) * from;
        }
        return sum;
    }
};
const std::vector<Star>& stretched() {
    static const std::vector<Star> all = {{"a body on one stretched spring",
                                           {0.2 * kilogram, metres(0.9, 0.3, -0.2)},
                                           metres(1.0, 0.4, -0.1),
                                           {{metres(-0.2, 0.1, 0.3), 0.5 * metre, 80.0 * newton_per_metre}},
                                           0.05},
                                          {"a body between three stretched springs",
                                           {1.5 * kilogram, metres(0.3, 0.2, 0.6)},
                                           metres(0.1, 0.5, 0.4),
                                           {{metres(1.1, 0.2, 0.3), 0.4 * metre, 300.0 * newton_per_metre},
                                            {metres(-0.9, 0.7, -0.2), 0.7 * metre, 150.0 * newton_per_metre},
                                            {metres(0.2, -0.8, 0.9), 0.9 * metre, 700.0 * newton_per_metre}},
                                           0.1}};
    return all;
}
const std::vector<Star>& pressed() {
    static const std::vector<Star> all = {{"a body on one pressed spring",
                                           {0.05 * kilogram, metres(0.2, 0.1, 0.1)},
                                           metres(0.15, 0.05, 0.1),
                                           {{metres(0, -0.1, 0.2), 0.9 * metre, 400.0 * newton_per_metre}},
                                           0.1},
                                          {"a body between a stretched and a pressed spring",
                                           {0.3 * kilogram, metres(0.1, 0.2, -0.1)},
                                           metres(0.2, 0.1, 0.1),
                                           {{metres(0.9, 0.3, -0.4), 0.5 * metre, 90.0 * newton_per_metre},
                                            {metres(0, 0.4, 0.3), 0.8 * metre, 250.0 * newton_per_metre}},
                                           0.05}};
    return all;
}
std::vector<Star> all_stars() {
    auto all = stretched();
    all.insert(all.end(), pressed().begin(), pressed().end());
    return all;
}
std::string said(const Star& s) {
    std::ostringstream text;
    text << s.name << ", " << s.body.mass << ", a step of " << s.h << " s";
    return text.str();
}
VectorQuantity<unit::Force, 3> in_newtons(const Vec& v) { return VectorQuantity<unit::Force, 3>::from_value(v); }
auto yours(const Star& s, int iterations) { return exercise::solve(s.body, s.springs, s.h * second, iterations); }

} // namespace

TEST_CASE("the slope is how the energy changes", "[task-1][slope]") {
    for (const Star& s : all_stars())
        expect_near(said(s) + ": the gradient", exercise::slope(s.body, s.x, s.springs, s.h * second),
                    in_newtons(s.differences(s.x.value())), 1e-6 * newton,
                    "The energy grows where the body goes away from where it would have flown, and away from a "
                    "neighbour whose spring is too long.");
}

TEST_CASE("where it flew to and no spring pulls, it is level", "[task-1][level]") {
    for (Star s : all_stars()) {
        s.x = s.body.flown;
        for (exercise::Spring& spring : s.springs) spring.rest_length = norm(s.x - spring.neighbour);
        expect_near(said(s) + ", at rest: the gradient", exercise::slope(s.body, s.x, s.springs, s.h * second),
                    newtons(0, 0, 0), 1e-12 * newton, "Neither inertia nor a spring wants it elsewhere.");
    }
}

TEST_CASE("stretched, it is the second derivative", "[task-2][second-derivative]") {
    for (const Star& s : stretched()) {
        const Matrix mine = exercise::curvature(s.body, s.x, s.springs, s.h * second);
        for (int k = 0; k < 3; ++k) {
            const Vec right =
                (s.slope(s.x.value() + 1e-4 * Vec::Unit(k)) - s.slope(s.x.value() - 1e-4 * Vec::Unit(k))) / 2e-4;
            std::ostringstream text;
            text << said(s) << ": column " << k << " of the matrix, in N/m, as a vector";
            expect_near(
                text.str(), in_newtons(mine.col(k)), in_newtons(right), 2e-4 * newton,
                "Inertia in all directions, k along each spring, and across it what turns its pull: k times the "
                "stretch over the length.");
        }
    }
}

TEST_CASE("pressed, nothing is taken off across the spring", "[task-2][pressed]") {
    for (const Star& s : pressed()) {
        const Matrix mine = exercise::curvature(s.body, s.x, s.springs, s.h * second);
        const exercise::Place axis = s.x - s.springs.back().neighbour;
        const exercise::Place other = s.springs.size() > 1 ? s.x - s.springs.front().neighbour : metres(0.3, 0.5, 0.8);
        // Across both springs: of a stretched one what it turns, of a pressed one nothing.
        const Vec across = Vec(cross(axis, other).value()).normalized();
        double right = s.inertia();
        if (s.springs.size() > 1) {
            const auto& long_one = s.springs.front();
            const double length = norm(s.x - long_one.neighbour).value();
            right += long_one.stiffness.value() * (length - long_one.rest_length.value()) / length;
        }
        expect_near(said(s) + ": the curvature across, in N/m", across.dot(mine * across) * newton_per_metre,
                    right * newton_per_metre, 1e-9 * newton_per_metre,
                    "A pressed spring pushes its end to the side, all the more the farther it is there: a negative "
                    "curvature. It is left out, and the matrix keeps its inverse.");
    }
}

TEST_CASE("pressed or not, along a spring it is as stiff as it is", "[task-2][along]") {
    for (Star s : all_stars()) {
        s.springs.resize(1);
        const Matrix mine = exercise::curvature(s.body, s.x, s.springs, s.h * second);
        const Vec axis = (s.x - s.springs[0].neighbour).value().normalized();
        expect_near(said(s) + ", the first spring alone: the curvature along it, in N/m",
                    axis.dot(mine * axis) * newton_per_metre,
                    (s.inertia() + s.springs[0].stiffness.value()) * newton_per_metre, 1e-9 * newton_per_metre,
                    "That of its inertia, and k.");
    }
}

TEST_CASE("along one spring, one step is implicit Euler", "[task-3][implicit-euler]") {
    for (Star s : stretched()) {
        s.springs.resize(1);
        const exercise::Spring& spring = s.springs[0];
        const Vec from = s.body.flown.value() - spring.neighbour.value();
        const double k = spring.stiffness.value(), stretch = from.norm() - spring.rest_length.value();
        // m (x - flown) / h^2 = -k (stretch as it is at x): along a line.
        const Vec right = s.body.flown.value() - k * stretch / (s.inertia() + k) * from.normalized();
        expect_near(said(s) + ", the first spring alone: where it is after one step of Newton", yours(s, 1),
                    exercise::Place::from_value(right), 1e-12 * metre,
                    "Along the spring the energy is a parabola, and Newton's method finds the bottom of one at once.");
    }
}

TEST_CASE("in the end nothing pulls any more", "[task-3][bottom]") {
    for (const Star& s : all_stars())
        expect_near(said(s) + ": the gradient where it is after 300 steps of Newton",
                    in_newtons(s.slope(yours(s, 300).value())), newtons(0, 0, 0), 1e-6 * newton,
                    "The body belongs where inertia and springs are in balance.");
}

TEST_CASE("each step goes down", "[task-3][down]") {
    for (const Star& s : all_stars()) {
        double before = s.energy(s.body.flown.value());
        for (int n = 1; n <= 6; ++n) {
            const double now = s.energy(yours(s, n).value());
            std::ostringstream text;
            text << said(s) << "\n    yours  " << now * joule << " after step " << n << ", " << before * joule
                 << " before it\nThe first step begins where the body would have flown, and each goes down.";
            expect(std::isfinite(now) && now <= before + 1e-9, text.str());
            before = now;
        }
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    for (const Star& s : all_stars()) {
        const Vec slope = task == 1 ? Vec(exercise::slope(s.body, s.x, s.springs, s.h * second).value()) : Vec(0, 0, 0);
        if (task == 1) numbers.insert(numbers.end(), {slope[0], slope[1], slope[2]});
        if (task == 2) {
            const Matrix mine = exercise::curvature(s.body, s.x, s.springs, s.h * second);
            for (int k = 0; k < 9; ++k) numbers.push_back(mine(k / 3, k % 3));
        }
        if (task == 3)
            for (const int n : {1, 2, 5})
                for (int k = 0; k < 3; ++k) numbers.push_back(yours(s, n).value()[k]);
    }
    return numbers;
}
