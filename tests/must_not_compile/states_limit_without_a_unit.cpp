// expect: a guard compares a value with a limit of another unit, or without one
// SPDX-License-Identifier: BSL-1.0
// A distance compared with a bare number.

#include <ansatz/states.hpp>

using namespace ansatz;
using namespace ansatz::states;

struct Npc {
    Quantity<unit::Length> distance = 5.0 * metre;
};
struct GuardNpc {
    using Context = Npc;
#ifdef ANSATZ_MISTAKE
    static constexpr auto machine = states::machine(
        state("patrol", transition(when(value("distance", &Npc::distance) < 5.0), to("chase"))), state("chase"));
#else
    static constexpr auto machine =
        states::machine(state("patrol", transition(when(value("distance", &Npc::distance) < 5.0 * metre), to("chase"))),
                        state("chase"));
#endif
};

int main() {
    Npc npc;
    Machine<GuardNpc, Switch> machine;
    machine.start(npc);
    machine.update(npc);
}
