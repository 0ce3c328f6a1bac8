// expect: the enter of this state's class would never be called
// SPDX-License-Identifier: BSL-1.0
// A state's class that keeps its enter to itself, in a machine that is interpreted.

#include <ansatz/states.hpp>

using namespace ansatz;
using namespace ansatz::states;

struct Npc {
    int shouts = 0;
};
class Chase {
#ifndef ANSATZ_MISTAKE
public:
#endif
    void enter(Npc& npc) { ++npc.shouts; }
};

int main() {
    Bindings<Npc> names;
    names.behaviour<Chase>("Chase");
}
