// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on state classes (notes 5.1).

#include "tools/exercises/expect.hpp"

#include <ansatz/states.hpp>

using namespace ansatz;
using namespace ansatz::states;
using namespace ansatz::workbook;
using exercise::Npc;

namespace {

constexpr auto dt = 0.25 * second; // no step is rounded

/// A machine of the library with the subject's classes in it.
struct GuardNpc {
    using Context = Npc;
    static constexpr auto machine =
        states::machine(state("patrol", behaves<exercise::Patrol>(), transition(on("fire"), to("alarm"))),
                        state("alarm", behaves<exercise::Alarm>(), transition(on("over"), to("patrol"))));
};
using Watchman = Machine<GuardNpc, StatePattern>;

/// Where a patrol is after so many updates of `h`.
Quantity<unit::Length> place_after(int updates, Quantity<unit::Time> h) {
    Npc npc;
    exercise::Patrol patrol;
    for (int i = 0; i < updates; ++i) patrol.update(npc, h);
    return npc.place;
}
/// How often an alarm shouts in so many updates of `h`, its entry included.
int shouts_in(int updates, Quantity<unit::Time> h) {
    Npc npc;
    exercise::Alarm alarm;
    alarm.enter(npc);
    for (int i = 0; i < updates; ++i) alarm.update(npc, h);
    return npc.shouts;
}
void expect_equal(const std::string& what, int yours, int right, const std::string& why) {
    expect(yours == right,
           what + "\n    yours  " + std::to_string(yours) + "\n    right  " + std::to_string(right) + "\n" + why);
}

} // namespace

TEST_CASE("he walks at 1 m/s, to the post and no further", "[task-1][walks]") {
    for (const int updates : {1, 8, 40})
        expect_near("the place after " + std::to_string(updates) + " updates of 0.25 s", place_after(updates, dt),
                    updates * 0.25 * metre, 1e-12 * metre,
                    "At 1 m/s an update of 0.25 s is a way of 0.25 m, and the post is at 10 m.");
    expect_near("the place after 11 updates of 0.9375 s", place_after(11, 0.9375 * second), 10.0 * metre, 1e-12 * metre,
                "Ten steps and two thirds of one: the last is shorter, for he stops at the post.");
}

TEST_CASE("at a post he turns round", "[task-1][turns]") {
    expect_near("the place after 50 updates of 0.25 s", place_after(50, dt), 7.5 * metre, 1e-12 * metre,
                "40 updates to the far post, and 10 back.");
    expect_near("the place after 100 updates of 0.25 s", place_after(100, dt), 5.0 * metre, 1e-12 * metre,
                "There, back, and halfway there again.");
    expect_near("the place after 12 updates of 0.9375 s", place_after(12, 0.9375 * second), 9.0625 * metre,
                1e-12 * metre, "The eleventh ends at the post, and the twelfth is a whole step back.");
    expect_near("the place after 22 updates of 0.9375 s", place_after(22, 0.9375 * second), 0.0 * metre, 1e-12 * metre,
                "Eleven updates there and eleven back, the last one shorter: there is a post at 0 m too.");
}

TEST_CASE("two guards do not share a post", "[task-1][two-guards]") {
    Npc one, two;
    exercise::Patrol first, second_one;
    for (int i = 0; i < 44; ++i) first.update(one, dt);
    for (int i = 0; i < 4; ++i) second_one.update(two, dt);
    expect_near("the place of the second guard after 4 updates, when the first has turned round", two.place,
                1.0 * metre, 1e-12 * metre,
                "Each is on his own way: what a state remembers is a member of its class, one for each guard.");
}

TEST_CASE("after an alarm he goes on to the post that he was going to", "[task-1][goes-on]") {
    Npc npc;
    exercise::Patrol patrol;
    for (int i = 0; i < 60; ++i) patrol.update(npc, dt); // to the post and half of the way back
    const auto copy = patrol;
    exercise::Patrol other = copy; // the snapshot of a machine copies its states
    Npc also = npc;
    other.update(also, dt);
    expect_near("the place of a copy after one update more", also.place, 4.75 * metre, 1e-12 * metre,
                "He was on the way back at 5 m, so he goes to 4.75 m.");
}

TEST_CASE("he shouts when he enters", "[task-2][enters]") {
    Npc npc;
    exercise::Alarm alarm;
    alarm.enter(npc);
    expect_equal("shouts after the first entry", npc.shouts, 1, "The first shout comes with the entry.");
    alarm.enter(npc);
    expect_equal("shouts after the second entry", npc.shouts, 2, "Each entry has its shout.");
}

TEST_CASE("and then every two seconds, at any rate", "[task-2][every-two-seconds]") {
    for (const double h : {0.25, 0.0625, 0.0078125}) {
        const int updates = int(9.0 / h);
        std::ostringstream text;
        text << "shouts in 9 s with updates of " << h << " s";
        expect_equal(text.str(), shouts_in(updates, h * second), 5,
                     "One at 0 s, 2 s, 4 s, 6 s and 8 s. Count time, not updates: the rate of a game is not the same "
                     "everywhere.");
        text.str("");
        text << "shouts in 2 s with updates of " << h << " s";
        expect_equal(text.str(), shouts_in(int(2.0 / h), h * second), 2,
                     "One at 0 s and one at 2 s: with this update the two seconds have passed.");
        text.str("");
        text << "shouts in an update less than 2 s with updates of " << h << " s";
        expect_equal(text.str(), shouts_in(int(2.0 / h) - 1, h * second), 1, "Two seconds have not passed yet.");
        text.str("");
        text << "shouts in 8 s with updates of " << h << " s";
        expect_equal(text.str(), shouts_in(int(8.0 / h), h * second), 5,
                     "One at 0 s, 2 s, 4 s, 6 s and 8 s, each of them with the update that completes the two seconds.");
    }
}

TEST_CASE("a new alarm begins to count anew", "[task-2][anew]") {
    Npc npc;
    Watchman guard;
    guard.start(npc);
    guard.handle(npc, "fire");
    for (int i = 0; i < 7; ++i) guard.update(npc, dt); // 1.75 s
    guard.handle(npc, "over");
    guard.handle(npc, "fire");
    for (int i = 0; i < 7; ++i) guard.update(npc, dt);
    expect_equal("shouts in two alarms of 1.75 s", npc.shouts, 2,
                 "Neither lasted two seconds, so each has the shout of its entry and no more. The data outlives the "
                 "alarm: enter must set it back.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1) {
        for (const int updates : {1, 11, 12, 21, 23, 50, 100})
            numbers.push_back(place_after(updates, 0.9375 * second).value());
        Npc npc;
        exercise::Patrol patrol;
        patrol.update(npc, dt);
        numbers.push_back(npc.place.value());
    } else {
        Npc entering;
        exercise::Alarm entered;
        for (int i = 0; i < 3; ++i) entered.enter(entering), numbers.push_back(entering.shouts);
        for (const double h : {0.25, 0.0625, 0.5})
            for (const int updates : {32, 33}) numbers.push_back(shouts_in(updates, h * second));
        Npc npc;
        exercise::Alarm alarm;
        for (int i = 0; i < 4; ++i) {
            alarm.enter(npc);
            for (int k = 0; k < 7; ++k) alarm.update(npc, dt);
            numbers.push_back(npc.shouts);
        }
    }
    return numbers;
}
