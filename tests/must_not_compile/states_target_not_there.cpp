// expect: a transition goes to a state that the machine does not have
// at most: 3 errors
// SPDX-License-Identifier: BSL-1.0
// A transition to a state that is not there.

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
        states::machine(state("patrol", transition(on("alarm"), to("chse"))), state("chase"));
#else
    static constexpr auto machine =
        states::machine(state("patrol", transition(on("alarm"), to("chase"))), state("chase"));
#endif
};

int main() {
    Npc npc;
    Machine<GuardNpc, Switch> machine;
    machine.start(npc);
}
