// SPDX-License-Identifier: BSL-1.0
// 5.3.1 Machines that last: saved, loaded, begun anywhere, asked for how long, and asked where they are

// A game is saved, and a guard who was about to give up the search for a thief must still be about to give it up when
// it is loaded. What a machine is consists of more than its state: the time in it, what histories, guards and state
// classes remember. All of it goes into a file under its name, with the description's mark: a file for a machine that
// was changed since is refused and not guessed at. The last part asks between parallel states: In('x') is the condition
// that the machine is in x. (A part of section 5.3, beyond the notes.)

#include "claims.hpp"
#include "graphviz.hpp"
#include "say.hpp"

#include <ansatz/states.hpp>
#include <ansatz/states/save.hpp>
#include <ansatz/states/scxml.hpp>

#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

using namespace ansatz;
using namespace ansatz::states;

namespace {

struct Npc {
    int found = 0;
};

//! [class]
/// The rooms that the guard has looked into: data of the state `search`.
struct Search {
    int rooms = 0;
    void enter(Npc&) { rooms = 0; }
    void update(Npc&) { ++rooms; }
    static void fields(auto& self, auto&& field) { field("rooms", self.rooms); }
};
//! [class]
struct Guard {
    using Context = Npc;
    static constexpr auto machine =
        states::machine(state("watch", transition(on("noise"), to("search"))),
                        state("search", behaves<Search>(), transition(when(after(5.0 * second)), to("watch"))));
};
/// The same guard, a year later: he is more patient.
struct PatientGuard {
    using Context = Npc;
    static constexpr auto machine =
        states::machine(state("watch", transition(on("noise"), to("search"))),
                        state("search", behaves<Search>(), transition(when(after(9.0 * second)), to("watch"))));
};

//! [scxml]
constexpr const char* ship = R"xml(<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0">
  <parallel id="ship">
    <state id="lock">
      <state id="shut"><transition event="open" cond="In('docked')" target="ajar"/></state>
      <state id="ajar"><transition event="close" target="shut"/></state>
    </state>
    <state id="place">
      <state id="flying"><transition event="dock" target="docked"/></state>
      <state id="docked"><transition event="leave" cond="!In('ajar')" target="flying"/></state>
    </state>
  </parallel>
</scxml>)xml";
//! [scxml]

} // namespace

int main() {
    workbook::Claims claim;
    Npc npc;
    Machine<Guard> guard;
    guard.start(npc);
    guard.handle(npc, "noise");
    for (int i = 0; i < 12; ++i) guard.update(npc, 0.25 * second);

    //! [save]
    std::stringstream file;
    save(guard, file); // or save(guard, "guard.json")
    Machine<Guard> later;
    load(later, file);
    std::cout << later.active_name() << " for " << later.time_in("search").value() << " s, "
              << later.own<Search>(later.state("search")).rooms << " rooms\n";
    //! [save]
    claim("he is where he was, for as long, and has looked into as many rooms",
          later.is_in("search") && later.time_in("search") == 3.0 * second &&
              later.own<Search>(later.state("search")).rooms == 12);
    int updates = 0;
    for (; later.is_in("search"); ++updates) later.update(npc, 0.25 * second);
    std::cout << "After " << updates << " more updates he gives up\n";
    claim("he gives up 2 s later, not 5 s", updates == 8);

    //! [changed]
    Machine<PatientGuard> changed;
    file.clear(), file.seekg(0);
    try {
        load(changed, file, "guard.json");
    } catch (const std::invalid_argument& e) {
        workbook::say() << e.what() << '\n';
        claim("a guard who was changed is not loaded into", !changed.started());
    }
    //! [changed]

    //! [begin]
    Machine<Guard> asleep;
    asleep.start(npc, "search"); // for a test, a checkpoint
    //! [begin]
    claim("a machine begins where it is told to", asleep.active_name() == "search");

    Machine<InFile<Npc>, Interpreted> lock{parse_scxml<Npc>(ship, "ship.scxml", Bindings<Npc>{})};
    lock.start(npc);
    for (const char* order : {"open", "dock", "open", "leave", "close", "leave"})
        std::cout << order << ": " << (lock.handle(npc, order) ? "done" : "refused") << '\n';
    claim("in the end it flies, and its lock is shut", lock.is_in("flying") && lock.is_in("shut"));
    workbook::draw_graph("5.3.1", to_dot(lock.outline(), lock.active_names()));
    return claim.result();
}
