// expect: a StepLimit refuses or divides; write StepLimit<Refuse>{} or StepLimit<Divide>{}
// SPDX-License-Identifier: BSL-1.0
// Who adds a StepLimit says what it is to do.

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Springs<>{}, StepLimit{}};
#else
    World world{SemiImplicitEuler{}, Springs<>{}, StepLimit<Refuse>{}};
#endif
    world.step(0.01 * second);
}
