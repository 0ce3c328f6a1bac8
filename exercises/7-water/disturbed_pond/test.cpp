// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a disturbed pond (notes 7.3).

#include "tools/exercises/expect.hpp"

#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;
using exercise::State;

namespace {

constexpr State all[] = {State::calm, State::stirred, State::settling};
const char* name(State s) {
    constexpr const char* names[] = {"calm", "stirred", "settling"};
    return int(s) >= 0 && int(s) < 3 ? names[int(s)] : "no state at all";
}
/// Fails unless one update leads where it should.
void expect_next(State now, bool wades, std::size_t rings, State right, const std::string& why) {
    const State yours = exercise::next(now, wades, rings);
    std::ostringstream text;
    text << name(now) << ", " << (wades ? "somebody wades, " : "nobody wades, ") << rings
         << (rings == 1 ? " ring is left" : " rings are left") << "\n    yours  " << name(yours) << "\n    right  "
         << name(right) << '\n'
         << why;
    expect(yours == right, text.str());
}

int begun(double before, double now, double stride) {
    return exercise::begun(before * second, now * second, stride * second);
}
std::string said(double before, double now, double stride) {
    std::ostringstream text;
    text << "a stride takes " << stride << " s, the update brings the time from " << before << " s to " << now << " s";
    return text.str();
}
void expect_begun(double before, double now, double stride, int right, const std::string& why) {
    const int yours = begun(before, now, stride);
    std::ostringstream text;
    text << said(before, now, stride) << "\n    yours  " << yours << " rings begin\n    right  " << right << '\n'
         << why;
    expect(yours == right, text.str());
}

bool faded(double age, double damping) { return exercise::faded(age * second, damping / second); }
std::string said(double age, double damping) {
    std::ostringstream text;
    text << "a ring " << age << " s old that is damped by " << damping << " 1/s";
    return text.str();
}
const double dampings[] = {0.5, 1.5, 4};

} // namespace

TEST_CASE("who wades stirs the pond, whatever it is", "[task-1][stirs]") {
    for (const State now : all)
        for (const std::size_t rings : {0U, 1U, 7U})
            expect_next(now, true, rings, State::stirred, "Somebody wades: it is stirred, or becomes so.");
}

TEST_CASE("when he is gone it settles, and is not calm yet", "[task-1][settles]") {
    for (const std::size_t rings : {0U, 1U, 7U})
        expect_next(State::stirred, false, rings, State::settling,
                    "Nobody wades any more: the rings are left to fade, and that is a state of its own.");
    for (const std::size_t rings : {1U, 7U})
        expect_next(State::settling, false, rings, State::settling, "As long as a ring is left the pond is not calm.");
}

TEST_CASE("it is calm once the last ring is gone, and stays so", "[task-1][calm]") {
    expect_next(State::settling, false, 0, State::calm, "No ring is left, and nobody wades.");
    for (const std::size_t rings : {0U, 3U})
        expect_next(State::calm, false, rings, State::calm, "Only somebody who wades ends the calm.");
}

TEST_CASE("a ring begins at each stride", "[task-2][strides]") {
    const std::string why = "A ring for each stride that is over by now and was not before.";
    expect_begun(0.5, 0.7, 0.6, 1, why);
    expect_begun(0.7, 1.1, 0.6, 0, why);
    expect_begun(1.1, 1.3, 0.6, 1, why);
    expect_begun(0, 0.59, 0.6, 0, "The first is over one stride after he has entered.");
    expect_begun(3.2, 3.4, 0.4, 0, "The eighth was begun by the update before, the ninth is not over.");
}

TEST_CASE("in a long update several begin", "[task-2][long]") {
    const std::string why = "The update is longer than a stride, and he does not wait for it.";
    expect_begun(0.1, 2.5, 0.6, 4, why);
    expect_begun(0.7, 2.0, 0.4, 4, why);
}

TEST_CASE("what falls on the end of an update belongs to it, and not to the next", "[task-2][ends]") {
    expect_begun(0.25, 0.5, 0.5, 1, "The first stride is over just now.");
    expect_begun(0.5, 0.75, 0.5, 0, "The first stride was over before: its ring was begun.");
    expect_begun(0, 0.25, 0.25, 1, "At 0 s no stride is over: he has just entered.");
}

TEST_CASE("in ten seconds as many begin at every frame rate", "[task-2][rates]") {
    for (const int rate : {1, 8, 32, 256}) {
        int rings = 0;
        for (int n = 0; n < 10 * rate; ++n) rings += begun(double(n) / rate, double(n + 1) / rate, 0.6);
        std::ostringstream text;
        text << "10 s of wading, a stride takes 0.6 s, " << rate << " updates a second\n    yours  " << rings
             << " rings\n    right  16\nHow often it is asked is no matter of his.";
        expect(rings == 16, text.str());
    }
}

TEST_CASE("a ring fades to a thousandth by its damping", "[task-3][thousandth]") {
    for (const double damping : dampings) {
        const double age = std::log(1000) / damping;
        expect(!faded(0.98 * age, damping), said(0.98 * age, damping) + ". More than a thousandth is left of it.");
        expect(faded(1.02 * age, damping), said(1.02 * age, damping) + ". Less than a thousandth is left of it.");
    }
}

TEST_CASE("what has just begun has not faded", "[task-3][young]") {
    for (const double damping : dampings)
        for (const double age : {0.0, 0.3 / damping, 1.1 / damping})
            expect(!faded(age, damping), said(age, damping) + ". It is still seen.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const State now : all)
            for (const bool wades : {false, true})
                for (const std::size_t rings : {0U, 1U, 5U}) numbers.push_back(int(exercise::next(now, wades, rings)));
    if (task == 2)
        for (const double stride : {0.25, 0.6, 0.45})
            for (const double before : {0.0, 0.5, 0.7, 1.1})
                for (const double more : {0.1, 0.25, 0.5, 2.3}) numbers.push_back(begun(before, before + more, stride));
    if (task == 3)
        for (const double damping : dampings)
            for (const double part : {0.3, 0.9, 1.1, 2.0, 4.0, 5.0, 6.5, 6.7, 7.2, 14.0, 40.0})
                numbers.push_back(faded(part / damping, damping));
    return numbers;
}
