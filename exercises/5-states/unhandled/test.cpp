// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on events that nobody handles (notes 5.2).

#include "tools/exercises/expect.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <utility>

using namespace ansatz::workbook;
using exercise::Chart;
using exercise::Unhandled;

namespace {

/// The door of section 5.2, with a state around closed and locked.
enum : int { machine, shut, closed, locked, open };
const char* const names[] = {"the machine", "shut", "closed", "locked", "open"};
const Chart& door() {
    static const Chart chart{{-1, machine, shut, shut, machine},
                             {{closed, "push", true, open},
                              {closed, "lock", false, locked}, // nobody has the key
                              {locked, "unlock", true, closed},
                              {locked, "knock", false, -1}, // only at night
                              {shut, "knock", true, -1},
                              {shut, "oil", false, shut},
                              {open, "pull", true, closed},
                              {open, "knock", true, open},
                              {machine, "paint", true, -1}}};
    return chart;
}
/// What the game sends. Nobody thought of the storm.
const std::vector<std::string> sent{"push", "pull", "lock", "unlock", "knock", "oil", "paint", "storm"};

std::string said(const std::string& event) { return '"' + event + '"'; }
std::string name(int state) {
    return state >= 0 && state < int(std::size(names)) ? names[state] : "no state (" + std::to_string(state) + ")";
}
const std::string& whole_door() {
    static const std::string text = [] {
        std::string all = "A door: closed and locked are in shut; shut and open are in the machine. Transitions:";
        for (const auto& t : door().transitions)
            all += "\n    " + name(t.source) + ", on " + said(t.event) +
                   (t.target < 0 ? ", stays" : ", to " + name(t.target)) +
                   (t.holds ? "" : "   (its guard does not hold now)");
        return all + "\n";
    }();
    return text;
}
void expect_handled(int state, const std::string& event, bool right, const std::string& why) {
    const auto word = [](bool handled) { return handled ? "handled" : "nobody handles it"; };
    const bool yours = exercise::handled(door(), state, event);
    expect(yours == right, whole_door() + said(event) + " comes in " + name(state) + "\n    yours  " + word(yours) +
                               "\n    right  " + word(right) + "\n" + why);
}

/// Random machines of eight states, in which the states of a state stand behind it, as in a description.
Chart drawn(std::mt19937& random, const std::vector<std::string>& events) {
    Chart chart{{-1}, {}};
    for (int s = 1; s < 8; ++s) { // the state before it, or one around that
        int parent = s - 1;
        while (parent > 0 && random() % 2 == 0) parent = chart.parents[std::size_t(parent)];
        chart.parents.push_back(parent);
    }
    for (int i = 0; i < 9; ++i)
        chart.transitions.push_back({int(random() % 8), events[random() % events.size()], random() % 3 != 0,
                                     random() % 3 == 0 ? -1 : 1 + int(random() % 7)});
    return chart;
}
bool has_states(const Chart& chart, int state) {
    return std::find(chart.parents.begin(), chart.parents.end(), state) != chart.parents.end();
}
/// What each state handles, handed down: what its parent handles and what it has itself.
std::vector<std::set<std::string>> handed_down(const Chart& chart, bool ask_guards) {
    std::vector<std::set<std::string>> all(chart.parents.size());
    for (std::size_t s = 0; s < all.size(); ++s) {
        if (chart.parents[s] >= 0) all[s] = all[std::size_t(chart.parents[s])];
        for (const auto& t : chart.transitions)
            if (t.source == int(s) && (t.holds || !ask_guards)) all[s].insert(t.event);
    }
    return all;
}
std::string said(const Chart& chart) {
    std::string text = "parents of the states 0, 1, 2 ...:";
    for (const int p : chart.parents) text += ' ' + std::to_string(p);
    text += "\ntransitions:";
    for (const auto& t : chart.transitions)
        text += "\n    " + std::to_string(t.source) + ", on " + said(t.event) +
                (t.target < 0 ? ", stays" : ", to " + std::to_string(t.target)) +
                (t.holds ? "" : "   (its guard does not hold now)");
    return text + '\n';
}
const std::vector<std::string>& three_events() {
    static const std::vector<std::string> all{"a", "b", "c"};
    return all;
}

using Pairs = std::vector<std::pair<int, std::string>>;
Pairs sorted(const std::vector<Unhandled>& all) {
    Pairs pairs;
    for (const Unhandled& u : all) pairs.push_back({u.state, u.event});
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}
/// Of those in the first list that are not in the second, the first; else the other way round.
template <class Name> std::string difference(const Pairs& yours, const Pairs& right, const Name& name_of) {
    for (const auto& pair : right)
        if (std::count(yours.begin(), yours.end(), pair) == 0)
            return said(pair.second) + " in " + name_of(pair.first) + " is missing in yours";
    for (const auto& pair : yours)
        if (std::count(right.begin(), right.end(), pair) == 0)
            return said(pair.second) + " in " + name_of(pair.first) + " does not belong to it";
    return "one of yours is listed twice";
}
/// Holds what is listed for some of the states and some of the events against what should be.
void expect_never(const std::vector<int>& states, const std::vector<std::string>& events, const Pairs& right,
                  const std::string& why) {
    Pairs yours;
    for (const auto& pair : sorted(exercise::never_handled(door(), events)))
        if (std::count(states.begin(), states.end(), pair.first) > 0) yours.push_back(pair);
    std::string list;
    for (const std::string& event : events) list += ' ' + said(event);
    expect(yours == right, whole_door() + "What the game sends:" + list + "\n    " +
                               difference(yours, right, [](int s) { return name(s); }) + "\n" + why);
}

/// A log after a number of entries: entry i is of state i, and every third is like the one before.
Unhandled entry(int i) { return {i - (i % 3 == 2 ? 1 : 0), i / 3 % 2 == 0 ? "lock" : "push"}; }
std::string said(const std::vector<Unhandled>& all) {
    std::string text;
    for (const Unhandled& u : all)
        text += (text.empty() ? "" : ", ") + said(u.event) + " in state " + std::to_string(u.state);
    return text.empty() ? "nothing" : text;
}
void expect_last(int entries, const std::string& why) {
    exercise::Log log;
    std::vector<Unhandled> noted;
    for (int i = 0; i < entries; ++i) exercise::note(log, entry(i)), noted.push_back(entry(i));
    const std::vector<Unhandled> right(noted.end() - std::min(entries, 4), noted.end());
    const auto yours = exercise::last(log);
    expect(yours == right, "noted, one after the other: " + said(noted) + "\n    yours  " + said(yours) +
                               "\n    right  " + said(right) + "\n" + why);
}

} // namespace

TEST_CASE("a transition of the active state handles its event", "[task-1][own]") {
    expect_handled(closed, "push", true, "Closed has a transition for it.");
    expect_handled(open, "pull", true, "Open has a transition for it.");
}

TEST_CASE("that of another state does not", "[task-1][other]") {
    expect_handled(locked, "push", false, "Closed has a transition for it, but the door is locked.");
    expect_handled(open, "unlock", false, "Locked has a transition for it, and is not active.");
    expect_handled(open, "storm", false, "No transition of the whole machine waits for it.");
}

TEST_CASE("what is around the active state is active too", "[task-1][around]") {
    expect_handled(closed, "knock", true, "Shut is around closed, and has a transition for it.");
    expect_handled(locked, "paint", true, "The machine itself is around everything, and has a transition for it.");
    expect_handled(open, "paint", true, "The machine itself is around everything, and has a transition for it.");
}

TEST_CASE("a transition whose guard does not hold handles nothing", "[task-1][guard]") {
    expect_handled(closed, "lock", false, "The only transition for it has a guard, and that does not hold.");
    expect_handled(closed, "oil", false, "The only transition for it is that of shut, whose guard does not hold.");
}

TEST_CASE("and leaves the event to whoever is around", "[task-1][leaves]") {
    expect_handled(locked, "knock", true,
                   "That of locked has a guard that does not hold. The question goes on to shut, which handles it.");
}

TEST_CASE("where a transition leads does not matter", "[task-1][stays]") {
    expect_handled(open, "knock", true,
                   "It leads to where the machine is. Something is done on the way; it is not forgotten.");
    expect_handled(locked, "paint", true, "It leads nowhere, and still somebody answers.");
}

TEST_CASE("in random machines as well", "[task-1][any-machine]") {
    std::mt19937 random(52);
    for (int i = 0; i < 100; ++i) {
        const Chart chart = drawn(random, three_events());
        const auto right = handed_down(chart, true);
        for (int s = 1; s < 8; ++s)
            for (const std::string& event : three_events()) {
                if (has_states(chart, s)) continue;
                const bool is = right[std::size_t(s)].count(event) > 0;
                expect(exercise::handled(chart, s, event) == is,
                       said(chart) + said(event) + " comes in state " + std::to_string(s) +
                           (is ? ". It is handled, and yours says that it is not.\n"
                               : ". Nobody handles it, and yours says that it is handled.\n") +
                           "What is right was found from the outside inwards: a state handles what its parent "
                           "handles, and what it has a transition for whose guard holds.");
            }
    }
}

TEST_CASE("an event without a transition in a state is found", "[task-2][found]") {
    expect_never({open, closed}, {"push", "pull", "unlock"},
                 {{closed, "pull"}, {closed, "unlock"}, {open, "push"}, {open, "unlock"}},
                 "It is asked for each state anew: that another state handles the event is no help.");
}

TEST_CASE("also one that no transition names", "[task-2][unnamed]") {
    expect_never(
        {closed, locked, open}, {"storm"}, {{closed, "storm"}, {locked, "storm"}, {open, "storm"}},
        "The game sends it, so that it comes: the events are those of the list, not those of the transitions.");
}

TEST_CASE("what a state around handles is handled", "[task-2][inherited]") {
    expect_never({closed, locked, open}, {"knock", "paint"}, {},
                 "Shut handles a knock for both of its states, and the machine handles paint for everybody.");
}

TEST_CASE("a guard may hold one day", "[task-2][one-day]") {
    expect_never({closed, locked}, {"lock", "oil"}, {{locked, "lock"}},
                 "Closed has a transition for \"lock\" and shut one for \"oil\". That their guards do not hold now is "
                 "nothing that the author forgot.");
}

TEST_CASE("only states that can be the innermost are listed", "[task-2][innermost]") {
    expect_never({machine, shut}, sent, {},
                 "Whenever shut is active, closed or locked is, too, and may handle what shut does not.");
}

TEST_CASE("in random machines every hole is found, and no other", "[task-2][every-pair]") {
    std::mt19937 random(25);
    for (int i = 0; i < 100; ++i) {
        const Chart chart = drawn(random, three_events());
        const auto handled = handed_down(chart, false);
        Pairs right;
        for (int s = 0; s < 8; ++s)
            for (const std::string& event : three_events())
                if (!has_states(chart, s) && handled[std::size_t(s)].count(event) == 0) right.push_back({s, event});
        const Pairs yours = sorted(exercise::never_handled(chart, three_events()));
        expect(yours == right,
               said(chart) + "The game sends \"a\", \"b\" and \"c\".\n    " +
                   difference(yours, right, [](int s) { return "state " + std::to_string(s); }) +
                   "\nWhat is right was found from the outside inwards: a state handles what its parent handles, and "
                   "what it has a transition for.");
    }
}

TEST_CASE("what was noted is there, the oldest first", "[task-3][order]") {
    expect_last(0, "Nothing was noted yet, and an empty place of the array is no entry.");
    expect_last(2, "Two were noted, and an empty place of the array is no entry.");
    expect_last(4, "Four were noted, and for four there is room. The same event twice is two entries.");
}

TEST_CASE("a full log forgets the oldest", "[task-3][full]") {
    for (const int entries : {5, 6, 7, 8, 11, 30})
        expect_last(entries, "The last four, the oldest of them first. The fifth lies where the first was, and the "
                             "oldest that is left lies behind it.");
}

TEST_CASE("all are counted", "[task-3][count]") {
    exercise::Log log;
    for (int i = 0; i < 11; ++i) {
        expect(log.count == std::size_t(i), "log.count after " + std::to_string(i) + " entries\n    yours  " +
                                                std::to_string(log.count) + "\n    right  " + std::to_string(i) +
                                                "\nThose that are forgotten have happened, too.");
        exercise::note(log, entry(i));
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    std::mt19937 random(7);
    for (int i = 0; i < 20; ++i) {
        const Chart chart = i == 0 ? door() : drawn(random, three_events());
        const auto& events = i == 0 ? sent : three_events();
        if (task == 1)
            for (int s = 1; s < int(chart.parents.size()); ++s)
                for (const std::string& event : events)
                    if (!has_states(chart, s)) numbers.push_back(exercise::handled(chart, s, event));
        if (task == 2) {
            for (const auto& [state, event] : sorted(exercise::never_handled(chart, events)))
                numbers.push_back(1 + state), numbers.push_back(event.front());
            numbers.push_back(-1);
        }
    }
    if (task == 3) {
        exercise::Log log;
        for (int i = 0; i < 12; ++i) {
            for (const Unhandled& u : exercise::last(log))
                numbers.push_back(1 + u.state), numbers.push_back(u.event == "lock" ? 100 : 200);
            numbers.push_back(1000 + double(log.count));
            exercise::note(log, entry(i));
        }
    }
    return numbers;
}
