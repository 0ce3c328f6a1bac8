// expect: this machine counts time (after, held_for); write machine.update(context, dt)
// SPDX-License-Identifier: BSL-1.0
// An update without its time, of a machine that counts it.

#include <ansatz/states.hpp>

using namespace ansatz;
using namespace ansatz::states;

struct Npc {
    Quantity<unit::Length> distance = 5.0 * metre;
};
struct GuardNpc {
    using Context = Npc;
    static constexpr auto machine =
        states::machine(state("patrol", transition(when(after(2.0 * second)), to("chase"))), state("chase"));
};

int main() {
    Npc npc;
    Machine<GuardNpc, Switch> machine;
    machine.start(npc);
#ifdef ANSATZ_MISTAKE
    machine.update(npc);
#else
    machine.update(npc, 0.5 * second);
#endif
}
