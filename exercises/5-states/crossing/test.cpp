// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on missed transitions (notes 5.2).

#include "tools/exercises/expect.hpp"

#include <cmath>
#include <limits>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

void expect_crossed(double before, double now, double limit, bool right, const std::string& why) {
    const bool yours = exercise::crossed(before * metre, now * metre, limit * metre);
    std::ostringstream text;
    text << "from " << before << " m to " << now << " m, with a limit of " << limit << " m\n    yours  "
         << (yours ? "crossed" : "not crossed") << "\n    right  " << (right ? "crossed" : "not crossed") << '\n'
         << why;
    expect(yours == right, text.str());
}

/// How many crossings of 5 m a guard sees in these values.
int crossings(const std::vector<double>& places) {
    exercise::CrossingGuard guard(5.0 * metre);
    int n = 0;
    for (const double place : places) n += guard.update(place * metre);
    return n;
}
void expect_crossings(const std::string& what, const std::vector<double>& places, int right, const std::string& why) {
    const int yours = crossings(places);
    expect(yours == right, what + "\n    yours  " + std::to_string(yours) + " crossings\n    right  " +
                               std::to_string(right) + "\n" + why);
}

} // namespace

TEST_CASE("a step over the limit crosses it, in both directions", "[task-1][over]") {
    for (const double limit : {5.0, 0.0, -2.0}) {
        expect_crossed(limit - 0.1, limit + 0.2, limit, true,
                       "It was on one side and is on the other now. It never was *at* the limit.");
        expect_crossed(limit + 30, limit - 1, limit, true,
                       "It was on one side and is on the other now. It never was *at* the limit.");
    }
}

TEST_CASE("a step on one side does not", "[task-1][beside]") {
    expect_crossed(4.0, 4.9999, 5, false, "It was below and is below.");
    expect_crossed(5.1, 5.0001, 5, false, "It was above and is above. How near it came does not matter.");
    expect_crossed(4.95, 4.95, 5, false, "It did not move.");
    expect_crossed(4.9, 3.0, 5, false, "It was below and is below. A long step away from the limit crosses nothing.");
    expect_crossed(5.1, 9.0, 5, false, "It was above and is above. A long step away from the limit crosses nothing.");
}

TEST_CASE("a step that ends on the limit crosses it, one that begins there does not", "[task-1][on-it]") {
    expect_crossed(4.8, 5.0, 5, true, "It was beside the limit and is on it.");
    expect_crossed(5.2, 5.0, 5, true, "It was beside the limit and is on it.");
    expect_crossed(5.0, 5.3, 5, false,
                   "It stood on the limit already: the step before has crossed it, and it shall count once.");
    expect_crossed(5.0, 4.7, 5, false,
                   "It stood on the limit already: the step before has crossed it, and it shall count once.");
    expect_crossed(5.0, 5.0, 5, false, "It stood there already.");
}

TEST_CASE("a guard counts each way through once, wherever the steps end", "[task-2][once]") {
    for (const double step : {0.25, 0.3, 0.7, 1.0, 2.5, 4.0}) {
        std::vector<double> there;
        for (double x = 0; x < 10; x += step) there.push_back(x);
        std::ostringstream text;
        text << "from 0 m to 10 m in steps of " << step << " m";
        expect_crossings(text.str(), there, 1, "5 m lies on this way once.");
    }
    expect_crossings("there and back and there", {4, 6, 7, 3, 8}, 3, "Each way through counts.");
    expect_crossings("to the limit, on and back", {4, 5, 6, 4}, 2,
                     "The step from 4 m to 5 m is the first crossing, the one from 6 m to 4 m the second.");
    expect_crossings("to the limit and back", {4, 5, 4}, 1,
                     "It came to the limit, which counts, and left it, which does not.");
}

TEST_CASE("the first value has crossed nothing", "[task-2][first]") {
    expect_crossings("7 m and 8 m", {7, 8}, 0,
                     "Both are above. A previous value of 0 m that nobody has given is no previous value.");
    expect_crossings("7 m and 3 m", {7, 3}, 1, "One step, one crossing.");
    expect_crossings("5 m and 6 m", {5, 6}, 0, "It begins on the limit, and leaving it does not count.");
    expect_crossings("5 m, 6 m and 4 m", {5, 6, 4}, 1,
                     "The step from 5 m to 6 m only leaves the limit; that from 6 m to 4 m goes through it.");
}

TEST_CASE("a gap in the values does not hide a crossing", "[task-2][gap]") {
    expect_crossings("4 m, not a number, 6 m", {4, gap, 6}, 1,
                     "Nothing is known of the gap, but it was below before it and is above behind it.");
    expect_crossings("not a number, 6 m, 7 m", {gap, 6, 7}, 0, "The first good value is the first value.");
    expect_crossings("4 m, not a number twice, 4 m", {4, gap, gap, 4}, 0, "It is where it was.");
    expect_crossings("6 m, not a number, 7 m", {6, gap, 7}, 0,
                     "It was above before the gap and is above behind it. A gap is no place on the other side.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1) {
        for (const double before : {4.0, 4.9, 5.0, 5.1, 6.0})
            for (const double now : {4.0, 4.95, 5.0, 5.05, 6.0})
                numbers.push_back(exercise::crossed(before * metre, now * metre, 5.0 * metre));
    } else {
        for (const auto& places : std::vector<std::vector<double>>{{4, 6, 5, 5, 6, 4},
                                                                   {7, 8, 3},
                                                                   {4, gap, 6, gap, 6, 5, gap, 4},
                                                                   {gap, 6, 7},
                                                                   {3, 5, 3},
                                                                   {5, 6, 4},
                                                                   {6, gap, 7}})
            numbers.push_back(crossings(places));
    }
    return numbers;
}
