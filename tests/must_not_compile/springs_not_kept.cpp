// expect: none of this world's policies keeps such elements; add the one that does, as a Spring needs Springs{}
// SPDX-License-Identifier: BSL-1.0
// A spring in a world that has none.

#include <ansatz/springs/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Keep<InverseMass>{}};
#else
    World world{SemiImplicitEuler{}, Springs{}};
#endif
    const auto ball = world.add(mass(2.0 * kilogram));
    world.add(Spring{ball, metres(0, 1, 0), 100.0 * newton_per_metre});
}
