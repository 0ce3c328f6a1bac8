// SPDX-License-Identifier: BSL-1.0
// Your classes as states of the library's machine, beside those of the chapter.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/states.hpp>

using namespace ansatz;
using namespace ansatz::states;
using exercise::Npc;

namespace {

struct Yours {
    using Context = Npc;
    static constexpr auto machine =
        states::machine(state("patrol", behaves<exercise::Patrol>(), transition(on("fire"), to("alarm"))),
                        state("alarm", behaves<exercise::Alarm>(), transition(on("over"), to("patrol"))));
};

/// The same with what the library has: states and times in the place of members.
constexpr auto place = value("place", &Npc::place);
inline void go(Npc& n, Quantity<unit::Time> dt) { n.place = min(10.0 * metre, n.place + 1.0 * metre_per_second * dt); }
inline void come(Npc& n, Quantity<unit::Time> dt) { n.place = max(0.0 * metre, n.place - 1.0 * metre_per_second * dt); }
inline void shout(Npc& n) { ++n.shouts; }
struct Theirs {
    using Context = Npc;
    static constexpr auto machine =
        states::machine(state("patrol", transition(on("fire"), to("alarm")),
                              state("going", each_update(go), transition(when(place >= 10.0 * metre), to("coming"))),
                              state("coming", each_update(come), transition(when(place <= 0.0 * metre), to("going"))),
                              shallow_history("where he was", to("going"))),
                        state("alarm", on_entry(shout), transition(when(after(2.0 * second)), to("alarm")),
                              transition(on("over"), to("where he was"))));
};

template <class Description> void show(const char* who, workbook::Play& table) {
    Npc npc;
    Machine<Description, StatePattern> guard;
    guard.start(npc);
    for (int step = 0; step < 60 * 60; ++step) { // a minute, with an alarm from 25 s to 32 s
        if (step == 25 * 60) guard.handle(npc, "fire");
        if (step == 32 * 60) guard.handle(npc, "over");
        guard.update(npc, 1.0 / 60 * second);
    }
    table.row(who, {npc.place.value(), double(npc.shouts)}, 1, [=]() mutable { guard.update(npc, 1.0 / 60 * second); });
}

} // namespace

int main() {
    workbook::Play table("A guard walks for a minute between 0 m and 10 m, with an alarm of 7 s in it.",
                         {"place at the end, m", "shouts"});
    table.timed("ns an update");
    show<Yours>("yours", table);
    show<Theirs>("library", table);
    return table.print();
}
