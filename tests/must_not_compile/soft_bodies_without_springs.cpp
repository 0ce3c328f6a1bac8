// expect: a soft body is built of springs, and none of this world's policies keeps them
// SPDX-License-Identifier: BSL-1.0
// Cloth in a world that keeps no springs.

#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Gravity{}, Keep<InverseMass>{}};
#else
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}};
#endif
    add_cloth(world, Cloth{.mesh = TriangleMesh::grid(2, 2, metres(1, 0, 0), metres(0, 1, 0)),
                           .mass_per_area = 0.15 * kilogram / square_metre});
}
