// expect: take Machine<..., Interpreted> to add some while it runs
// SPDX-License-Identifier: BSL-1.0
// A transition that is added to a machine whose transitions are compiled.

#include <ansatz/states/interpreted.hpp>
#include <ansatz/states/machine.hpp>

struct Npc {};
struct Guard {
    using Context = Npc;
    static constexpr auto machine =
        ansatz::states::machine(ansatz::states::state("watch"), ansatz::states::state("sleep"));
};

int main() {
    Npc npc;
#ifdef ANSATZ_MISTAKE
    ansatz::Machine<Guard, ansatz::Switch> machine;
#else
    ansatz::Machine<Guard, ansatz::Interpreted> machine;
#endif
    machine.start(npc);
    machine.add(npc, "watch", ansatz::states::transition(ansatz::states::on("bell"), ansatz::states::to("sleep")));
}
