// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the largest stable step (notes 1.6.3 and 3).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <limits>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using Time = Quantity<unit::Time>;

/// A mass on a damped spring.
struct OnSpring {
    Quantity<unit::Mass> m;
    Quantity<unit::Stiffness> k;
    Quantity<unit::Damping> c;

    Time largest_step() const { return exercise::largest_step(m, k, c); }
};
OnSpring on_spring(double m, double k, double c) {
    return {m * kilogram, k * newton_per_metre, c * newton_second_per_metre};
}
std::string said(const OnSpring& s) {
    std::ostringstream text;
    text << "the largest step for " << s.m << " on a spring of " << s.k << " with a damping of " << s.c;
    return text.str();
}

/// Light and heavy, soft and stiff, with damping below the critical one, near it, and far above it.
const std::vector<OnSpring>& damped() {
    static const std::vector<OnSpring> all = {
        on_spring(0.5, 200, 3),   on_spring(3, 200, 40), on_spring(2, 8, 11),
        on_spring(0.2, 1000, 90), on_spring(7, 30, 200),
    };
    return all;
}
const std::vector<OnSpring>& undamped() {
    static const std::vector<OnSpring> all = {on_spring(0.5, 200, 0), on_spring(3, 200, 0), on_spring(7, 30, 0)};
    return all;
}
/// Dampers with no spring beside them, or hardly any.
const std::vector<OnSpring>& dampers() {
    static const std::vector<OnSpring> all = {on_spring(2, 0, 5), on_spring(0.3, 0, 40), on_spring(2, 1e-8, 5),
                                              on_spring(0.3, 1e-10, 400)};
    return all;
}

/// How far a body comes that is let go at 1 m, within 100 000 steps. Beyond the limit by a thousandth, each step
/// multiplies one state by about -1.001 or more, which is e^100; below it the states run on ellipses, or fade.
Quantity<unit::Length> reach(const OnSpring& s, Time h) {
    auto x = 1.0 * metre, farthest = x;
    auto v = 1.0 * metre_per_second;
    for (int i = 0; i < 100000 && farthest < 1e20 * metre; ++i) {
        ansatz::SemiImplicitEuler::advance(Stage<0>{}, x, v, -(s.k * x + s.c * v) / s.m, h);
        farthest = max(farthest, abs(x));
    }
    return farthest;
}
/// Whether `limit` lies where a body on this spring begins to explode; says on which side of that it is.
void expect_limit(const OnSpring& s) {
    const Time limit = s.largest_step();
    std::ostringstream text;
    text << said(s) << "\n    yours  " << limit;
    expect(is_finite(limit) && limit > 0.0 * second, text.str() + "\nA step is a positive time.");
    expect(reach(s, 0.999 * limit) < 1e6 * metre,
           text.str() + ", and with a step of 0.999 of it the body comes beyond 1e6 m: it is too long.\n"
                        "The motion explodes as soon as a step turns a state round and makes it larger.");
    expect(reach(s, 1.001 * limit) > 1e6 * metre,
           text.str() + ", but with a step of 1.001 of it the body still stays where it is: it is too short.\n"
                        "Put x' = -x and v' = -v into both lines of the method.");
}

const auto infinite = std::numeric_limits<double>::infinity() * second;

/// A frame and a limit: the frame from nothing to a hundred times as long, also a whole number of times.
struct Frame {
    Time frame, limit;
    int parts() const { return exercise::parts_of(frame, limit); }
};
const std::vector<Frame>& frames() {
    static const std::vector<Frame> all = [] {
        std::vector<Frame> frames;
        for (const double times : {0.0, 0.1, 0.4, 1.0, 1.1, 1.5, 2.0, 2.9, 8.0, 8.25, 8.75, 100.0})
            for (const double limit : {0.25, 0.0078125}) // so that a whole number of times it is exact
                frames.push_back({times * limit * second, limit * second});
        frames.push_back({1.0 / 60 * second, infinite});
        return frames;
    }();
    return all;
}
std::string said(const Frame& f) {
    std::ostringstream text;
    text << "a frame of " << f.frame << " in substeps of " << f.limit << " at most";
    return text.str();
}

} // namespace

TEST_CASE("with damping: below the largest step it stays, above it explodes", "[task-1][damped]") {
    for (const auto& s : damped()) expect_limit(s);
}

TEST_CASE("without damping: below the largest step it stays, above it explodes", "[task-1][undamped]") {
    for (const auto& s : undamped()) expect_limit(s);
}

TEST_CASE("a damper alone has a largest step too", "[task-1][damper]") {
    for (const auto& s : dampers())
        expect_near(said(s), s.largest_step(), 2.0 * s.m / s.c, 1e-6 * s.m / s.c,
                    "Without a spring v' = v (1 - h c / m), which turns a velocity round at h = 2 m / c. A formula "
                    "that takes\ntwo large numbers from each other, or divides by k, has no digit left here: write the "
                    "root the other way up.");
}

TEST_CASE("damping makes the largest step shorter", "[task-1][shorter]") {
    for (const auto& s : damped()) {
        const auto free = OnSpring{s.m, s.k, 0.0 * newton_second_per_metre}.largest_step();
        std::ostringstream text;
        text << said(s) << "\n    yours  " << s.largest_step() << ", and " << free << " without the damping"
             << "\nThe one with damping must be the shorter: a damper that uses the old velocity pushes too far.";
        expect(s.largest_step() < free, text.str());
    }
}

TEST_CASE("ten times the mass, the stiffness and the damping move in the same way", "[task-1][ten-times]") {
    for (const auto& s : damped()) {
        const OnSpring tenfold{10.0 * s.m, 10.0 * s.k, 10.0 * s.c};
        expect_agree(said(s) + ", and with ten times of all three", "yours, as it is", s.largest_step(),
                     "yours, tenfold", tenfold.largest_step(), 1e-9 * abs(s.largest_step()),
                     "Ten such bodies side by side move as one of them does: only k / m and c / m count.");
    }
}

TEST_CASE("no substep is longer than the limit", "[task-2][short-enough]") {
    for (const auto& f : frames()) {
        const int parts = f.parts();
        std::ostringstream text;
        text << said(f) << "\n    yours  " << parts << " substeps";
        expect(parts >= 1, text.str() + "\nA frame has one substep at least.");
        text << " of " << f.frame / double(parts) << " each\nThat is too long. A spring explodes at one per cent "
             << "beyond its limit: a fraction of a substep counts as a whole one.";
        expect(f.frame / double(parts) <= f.limit, text.str());
    }
}

TEST_CASE("and there are no more substeps than that takes", "[task-2][no-more]") {
    for (const auto& f : frames()) {
        const int parts = f.parts();
        std::ostringstream text;
        text << said(f) << "\n    yours  " << parts << " substeps\nOne less would do, of "
             << f.frame / double(parts - 1) << " each. Every substep costs a whole step.";
        expect(parts <= 1 || f.frame / double(parts - 1) > f.limit, text.str());
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 2)
        for (const auto& f : frames()) numbers.push_back(f.parts());
    else
        for (const auto& all : {damped(), undamped(), dampers()})
            for (const auto& s : all) numbers.push_back(s.largest_step().value());
    return numbers;
}
