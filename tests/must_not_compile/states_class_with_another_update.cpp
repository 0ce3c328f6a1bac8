// expect: the update of this state's class would never be called
// SPDX-License-Identifier: BSL-1.0
// A state's class whose update wants the time as a number: nobody would call it.

#include <ansatz/states.hpp>

using namespace ansatz;
using namespace ansatz::states;

struct Npc {
    double steps = 0;
};
struct Walk {
#ifdef ANSATZ_MISTAKE
    void update(Npc& npc, double dt) { npc.steps += dt; }
#else
    void update(Npc& npc, Quantity<unit::Time> dt) { npc.steps += dt.value(); }
#endif
};
struct GuardNpc {
    using Context = Npc;
    static constexpr auto machine = states::machine(state("patrol", behaves<Walk>("Walk")));
};

int main() {
    Npc npc;
    Machine<GuardNpc, Switch> machine;
    machine.start(npc);
    machine.update(npc, 0.5 * second);
}
