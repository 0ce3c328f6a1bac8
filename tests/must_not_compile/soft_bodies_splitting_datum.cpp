// expect: a policy of this world divides bodies, and a module of it keeps something of each body that cannot be divided
// yet SPDX-License-Identifier: BSL-1.0 Vertices that have shapes do not split yet.

#include <ansatz/collision.hpp>
#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    const Tearing<Splitting> tearing{.room = 10};
#else
    const Tearing<> tearing{};
#endif
    World world{SemiImplicitEuler{}, Springs<Breaking>{},          tearing,
                SortAndSweep{},      Narrowphase<Sphere, Plane>{}, Impulse{}};
    world.step(0.1 * second);
}
