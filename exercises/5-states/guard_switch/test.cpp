// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the hard coded switch (notes 5.1).

#include "tools/exercises/expect.hpp"

using namespace ansatz;
using namespace ansatz::workbook;
using exercise::State;

namespace {

constexpr State all[] = {State::patrol, State::search, State::chase, State::strike};
const char* name(State s) {
    constexpr const char* names[] = {"patrol", "search", "chase", "strike"};
    return int(s) >= 0 && int(s) < 4 ? names[int(s)] : "no state at all";
}
/// Fails unless one update leads where it should.
void expect_next(State now, double distance, double in_state, State right, const std::string& why) {
    const State yours = exercise::next(now, distance * metre, in_state * second);
    std::ostringstream text;
    text << "in " << name(now) << " for " << in_state << " s, with the intruder at " << distance << " m\n    yours  "
         << name(yours) << "\n    right  " << name(right) << '\n'
         << why;
    expect(yours == right, text.str());
}

} // namespace

TEST_CASE("the guard sees at less than 7 m, on patrol and in a search", "[task-1][sees]") {
    for (const State now : {State::patrol, State::search})
        for (const double distance : {0.5, 3.0, 6.99})
            expect_next(now, distance, 0.1, State::chase, "Whoever is nearer than 7 m is seen.");
    for (const State now : {State::patrol, State::search})
        for (const double distance : {7.01, 7.5, 8.5, 30.0})
            expect_next(now, distance, 0.1, now, "Whoever is not nearer than 7 m is not seen.");
    for (const State now : {State::patrol, State::search})
        expect_next(now, 7.0, 0.1, now, "An intruder at 7 m is not nearer than 7 m.");
    expect_next(State::patrol, 20, 10, State::patrol, "A patrol has no time after which it ends.");
}

TEST_CASE("in a chase he strikes at less than 1 m, and loses sight beyond 9 m", "[task-1][chase]") {
    for (const double distance : {0.0, 0.99})
        expect_next(State::chase, distance, 0.1, State::strike, "He is near enough to strike.");
    for (const double distance : {1.01, 6.0, 7.5, 8.99})
        expect_next(State::chase, distance, 0.1, State::chase,
                    "Between 1 m and 9 m the chase goes on. Seen at 7 m, lost at 9 m: with one distance for both, a "
                    "step to and fro would change the state.");
    for (const double distance : {9.01, 30.0})
        expect_next(State::chase, distance, 0.1, State::search, "Beyond 9 m he has lost the intruder.");
    expect_next(State::chase, 1.0, 0.1, State::chase, "At 1 m the intruder is not nearer than 1 m.");
    expect_next(State::chase, 9.0, 0.1, State::chase, "At 9 m the intruder is not farther than 9 m.");
    for (const double t : {2.0, 3.0, 10.0})
        expect_next(State::chase, 6.0, t, State::chase, "However long a chase lasts, only the distance ends it.");
}

TEST_CASE("a search takes three seconds, a blow two", "[task-1][times]") {
    for (const double t : {0.0, 2.0, 2.99})
        expect_next(State::search, 20, t, State::search, "He searches for three seconds.");
    for (const double t : {3.0, 3.01, 10.0})
        expect_next(State::search, 20, t, State::patrol,
                    "After three seconds he goes back. At three seconds they are over.");
    for (const double t : {0.0, 1.0, 1.99})
        expect_next(State::strike, 0.5, t, State::strike, "A blow takes two seconds.");
    for (const double t : {2.0, 2.01, 10.0})
        expect_next(State::strike, 0.5, t, State::chase, "After two seconds the chase goes on.");
    for (const double distance : {1.5, 8.0, 30.0}) {
        expect_next(State::strike, distance, 1.0, State::strike,
                    "A blow takes two seconds, wherever the intruder is by then.");
        expect_next(State::strike, distance, 2.0, State::chase,
                    "A blow leads to the chase, wherever the intruder is: the chase asks for him at its next update.");
    }
}

TEST_CASE("where two conditions hold, the one that was named first decides", "[task-1][order]") {
    for (const double t : {3.0, 5.0})
        expect_next(State::search, 5, t, State::chase,
                    "He is tired of searching, and sees the intruder at the same update. To see comes first.");
}

TEST_CASE("only who is on patrol follows a noise", "[task-2][noise]") {
    for (const State now : all) {
        const State yours = exercise::heard(now), right = now == State::patrol ? State::search : now;
        expect(yours == right,
               std::string("after a noise in ") + name(now) + "\n    yours  " + name(yours) + "\n    right  " +
                   name(right) +
                   "\nThe only state with a transition for a noise is patrol. In the others nothing happens.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    for (const State now : all) {
        if (task == 2) numbers.push_back(int(exercise::heard(now)));
        if (task == 1)
            for (const double distance : {0.5, 1.0, 3.0, 7.0, 7.5, 8.5, 9.0, 9.5})
                for (const double t : {0.1, 2.0, 3.0, 4.0})
                    numbers.push_back(int(exercise::next(now, distance * metre, t * second)));
    }
    return numbers;
}
