// expect: World has more than one solver; keep one, e.g. Xpbd{}
// SPDX-License-Identifier: BSL-1.0
// Two solvers: each would hold what the other has held already.

#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Springs<>{}, Xpbd{}, VertexBlockDescent{}};
#else
    World world{SemiImplicitEuler{}, Springs<>{}, Xpbd{}};
#endif
    world.step(0.1 * second);
}
