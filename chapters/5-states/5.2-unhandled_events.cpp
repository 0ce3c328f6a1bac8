// SPDX-License-Identifier: BSL-1.0
// 5.2 Issues: an event that nobody handles is ignored, counted, logged or refused, and the machine says which

// The notes list three issues; each has a program below. A fourth comes first, because it hides the others: an event
// arrives in a state that has no transition for it. Nothing happens, which is what the author wanted, or what he
// forgot; a machine that only ignores cannot tell. So what happens to unhandled events is a policy of the machine, and
// it costs nothing where it is not asked for.

#include "claims.hpp"
#include "graphviz.hpp"
#include "say.hpp"

#include <ansatz/states.hpp>

#include <iostream>
#include <stdexcept>
#include <string>

using namespace ansatz;
using namespace ansatz::states;

namespace {

//! [door]
/// A door with a lock. Its author forgot what happens when somebody locks it while it stands open.
struct Hall {
    int creaks = 0;
};
struct Door {
    using Context = Hall;
    static constexpr auto machine = states::machine(
        state("closed", transition(on("push"), then([](Hall& h) { ++h.creaks; }), to("open")),
              transition(on("lock"), to("locked"))),
        state("open", transition(on("pull"), to("closed"))), state("locked", transition(on("unlock"), to("closed"))));
};
//! [door]

/// What a day does to a door; the fourth and the sixth event have nobody who handles them.
constexpr std::string_view day[] = {"push", "pull", "push", "lock", "pull", "pull", "lock", "unlock"};

} // namespace

int main() {
    workbook::Claims claim;
    Hall hall;

    //! [count]
    Machine<Door, Switch> silent;
    Machine<Door, Switch, CountUnhandled> counting;
    silent.start(hall), counting.start(hall);
    int answered = 0;
    for (const auto event : day) {
        if (silent.handle(hall, event)) ++answered; // handle also says whether anybody did
        counting.handle(hall, event);
    }
    //! [count]
    std::cout << answered << " of " << std::size(day) << " events were handled, "
              << counting.get<CountUnhandled>().count << " were not\n";
    claim("ignored and counted come to the same door",
          silent.active() == counting.active() && answered == 6 && counting.get<CountUnhandled>().count == 2);
    claim("whoever ignores pays nothing", sizeof(silent) < sizeof(counting));

    //! [log]
    Machine<Door, Switch, LogUnhandled<8>> logging;
    logging.start(hall);
    for (const auto event : day) logging.handle(hall, event);
    const auto& log = logging.get<LogUnhandled<8>>();
    for (std::size_t i = 0; i < log.size(); ++i)
        std::cout << "  nobody handled \"" << logging.name(log[i].event) << "\" in \"" << logging.name(log[i].state)
                  << "\"\n";
    //! [log]
    claim("the log names the event and the state",
          log.size() == 2 && logging.name(log[0].event) == "lock" && logging.name(log[0].state) == "open");

    //! [refuse]
    Machine<Door, Switch, RefuseUnhandled> strict;
    strict.start(hall);
    strict.handle(hall, "push");
    std::string sentence;
    try {
        strict.handle(hall, "lock");
    } catch (const std::invalid_argument& error) {
        sentence = error.what();
    }
    //! [refuse]
    workbook::say() << sentence << '\n';
    claim("a strict machine refuses, and is where it was",
          strict.is_in("open") && sentence.find("lock") != std::string::npos);
    workbook::draw_graph("5.2", to_dot(outline_of<Door>(), strict.active_names()));
    return claim.result();
}
