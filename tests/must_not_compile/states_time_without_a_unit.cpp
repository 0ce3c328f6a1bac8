// expect: after takes a time; write e.g. after(2.0 * second)
// SPDX-License-Identifier: BSL-1.0
// A dwell time as a bare number.

#include <ansatz/states.hpp>

using namespace ansatz;
using namespace ansatz::states;

struct Npc {
    Quantity<unit::Length> distance = 5.0 * metre;
};
struct GuardNpc {
    using Context = Npc;
#ifdef ANSATZ_MISTAKE
    static constexpr auto machine =
        states::machine(state("patrol", transition(when(after(2.0)), to("chase"))), state("chase"));
#else
    static constexpr auto machine =
        states::machine(state("patrol", transition(when(after(2.0 * second)), to("chase"))), state("chase"));
#endif
};

int main() {
    Npc npc;
    Machine<GuardNpc, Switch> machine;
    machine.start(npc);
    machine.update(npc, 0.5 * second);
}
