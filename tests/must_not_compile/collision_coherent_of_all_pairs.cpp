// expect: Coherent of something that is no broadphase of boxes; write e.g. Coherent<UniformGrid<>>
// SPDX-License-Identifier: BSL-1.0
// Pairs are kept of a broadphase that tests no box.

#include <ansatz/collision.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    Coherent<AllPairs> broadphase;
#else
    Coherent<BoundingBoxes> broadphase;
#endif
    static_assert(sizeof(broadphase) > 0);
}
