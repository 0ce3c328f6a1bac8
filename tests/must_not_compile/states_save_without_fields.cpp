// expect: a machine cannot be saved whose guard or state class holds something of which it is not known
// SPDX-License-Identifier: BSL-1.0
// A state class with data that does not say what it consists of.

#include <ansatz/states/save.hpp>

#include <iostream>

struct Npc {};
struct Patrol {
    int corner = 0;
    void update(Npc&) { ++corner; }
#ifndef ANSATZ_MISTAKE
    static void fields(auto& self, auto&& field) { field("corner", self.corner); }
#endif
};
struct Guard {
    using Context = Npc;
    static constexpr auto machine =
        ansatz::states::machine(ansatz::states::state("patrol", ansatz::states::behaves<Patrol>()));
};

int main() {
    Npc npc;
    ansatz::Machine<Guard> machine;
    machine.start(npc);
    save(machine, std::cout);
}
