// expect: a state of this machine begins in none of the states in it, no_initial()
// SPDX-License-Identifier: BSL-1.0
// A state that is entered without any of the states in it, in a machine that does not allow that.

#include <ansatz/states/machine.hpp>

struct Npc {};
struct Guard {
    using Context = Npc;
    static constexpr auto machine = ansatz::states::machine(
        ansatz::states::state("on duty", ansatz::states::no_initial(), ansatz::states::state("patrol")));
};

int main() {
    Npc npc;
#ifdef ANSATZ_MISTAKE
    ansatz::Machine<Guard, ansatz::Switch> machine;
#else
    ansatz::Machine<Guard, ansatz::Switch, ansatz::AllowChildless> machine;
#endif
    machine.start(npc);
}
