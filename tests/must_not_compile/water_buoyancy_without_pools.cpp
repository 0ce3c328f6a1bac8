// expect: World has Buoyancy and no water; add pools, e.g. Pools<WaterColumns>{}
// SPDX-License-Identifier: BSL-1.0
// Bodies that shall float, and nothing to float in.

#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Gravity{}, Buoyancy{}};
#else
    World world{SemiImplicitEuler{}, Gravity{}, Buoyancy{}, Pools<WaterColumns>{}};
#endif
    world.step(0.01 * second);
}
