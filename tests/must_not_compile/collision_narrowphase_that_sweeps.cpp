// expect: a narrowphase that says `sweeps`, which is `continuous` now; write `static constexpr bool continuous = true;`
// SPDX-License-Identifier: BSL-1.0
// An old name that nobody reads any more would lose the continuous detection in silence.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct OfMine : Narrowphase<Sphere> {
#ifdef ANSATZ_MISTAKE
    static constexpr bool sweeps = false;
#else
    static constexpr bool continuous = false;
#endif
};

int main() {
    World world{SemiImplicitEuler{}, SortAndSweep{}, OfMine{}, Impulse<>{}};
    world.step(0.01 * second);
}
