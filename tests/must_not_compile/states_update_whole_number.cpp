// expect: a time as a whole number; 1 / 60 is 0 in whole numbers. Write a number with a point, e.g. 1.0 / 60 * second
// SPDX-License-Identifier: BSL-1.0
// 1 / 60 in whole numbers is 0: no time would pass.

#include <ansatz/states.hpp>

using namespace ansatz;

struct Npc {
    int shouts = 0;
};
struct GuardNpc {
    using Context = Npc;
    static constexpr auto machine = states::machine(
        states::state("patrol", states::transition(states::when(states::after(2.0 * second)), states::to("chase"))),
        states::state("chase"));
};

int main() {
    Npc npc;
    Machine<GuardNpc, Switch> machine;
    machine.start(npc);
#ifdef ANSATZ_MISTAKE
    machine.update(npc, 1 / 60 * second);
#else
    machine.update(npc, 1.0 / 60 * second);
#endif
}
