// expect: one number where a vector belongs; give each of its components, e.g. metres(0.5, 0.5, 0.5) instead of 0.5 * metre
// at most: 1 errors
// SPDX-License-Identifier: BSL-1.0
// A box has a half width on each axis.

#include <ansatz/collision/box.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    [[maybe_unused]] const Box box{1.0 * metre};
#else
    [[maybe_unused]] const Box box{metres(1, 1, 1)};
#endif
}
