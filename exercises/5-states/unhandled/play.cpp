// SPDX-License-Identifier: BSL-1.0
// The door of section 5.2 on a busy day: what nobody handles, by your functions and by a machine of the library.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/states.hpp>

#include <array>
#include <random>
#include <string>

using namespace ansatz;
using namespace ansatz::states;

namespace {

struct Hall {};
struct Door {
    using Context = Hall;
    static constexpr auto machine =
        states::machine(state("shut", transition(on("knock")),
                              state("closed", transition(on("push"), to("open")), transition(on("lock"), to("locked"))),
                              state("locked", transition(on("unlock"), to("closed")))),
                        state("open", transition(on("pull"), to("closed"))));
};
/// The same door by your functions.
enum : int { all, shut, closed, locked, open };
const exercise::Chart door{{-1, all, shut, shut, all},
                           {{shut, "knock", true, -1},
                            {closed, "push", true, open},
                            {closed, "lock", true, locked},
                            {locked, "unlock", true, closed},
                            {open, "pull", true, closed}}};
const std::array<std::string, 5> events{"push", "pull", "lock", "unlock", "knock"};

/// Which event comes when.
std::array<std::size_t, 10000> day() {
    std::array<std::size_t, 10000> numbers{};
    std::mt19937 random(2);
    for (std::size_t& n : numbers) n = random() % events.size();
    return numbers;
}

struct Yours {
    int now = closed;
    exercise::Log log;
    void handle(const std::string& event) {
        if (!exercise::handled(door, now, event)) return exercise::note(log, {now, event});
        for (const auto& t : door.transitions)
            if (t.event == event && t.source == now && t.target >= 0) {
                now = t.target;
                return;
            }
    }
};

} // namespace

int main() {
    workbook::Play table("A door, and 10000 events of a busy day.",
                         {"not handled", "of them kept", "last one, its state", "state in the end"});
    table.timed("ns an event");
    const auto numbers = day();

    Yours yours;
    for (const std::size_t n : numbers) yours.handle(events[n]);
    const auto kept = exercise::last(yours.log);
    table.row("yours",
              {double(yours.log.count), double(kept.size()), kept.empty() ? -1.0 : double(kept.back().state),
               double(yours.now)},
              1, [=, i = 0U]() mutable { yours.handle(events[numbers[i++ % 10000]]); });

    Hall hall;
    Machine<Door, Switch, LogUnhandled<4>> machine;
    machine.start(hall);
    std::array<EventId, 5> ids{};
    for (std::size_t n = 0; n < events.size(); ++n) ids[n] = machine.event(events[n]);
    for (const std::size_t n : numbers) machine.handle(hall, ids[n]);
    const auto& log = machine.get<LogUnhandled<4>>();
    table.row("library",
              {double(log.count), double(log.size()), double(index(log[log.size() - 1].state)),
               double(index(machine.active()))},
              1, [=, i = 0U]() mutable { machine.handle(hall, ids[numbers[i++ % 10000]]); });
    return table.print();
}
