// expect: suvat::displacement takes a length in one dimension
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// A time for a displacement.

#include <ansatz/motion/suvat.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    suvat::displacement(5.0 * second);
#else
    suvat::displacement(5.0 * metre);
#endif
}
