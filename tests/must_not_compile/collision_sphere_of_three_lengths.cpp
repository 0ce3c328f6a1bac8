// expect: a vector where one number belongs; give a single one with its unit, e.g. 0.5 * metre instead of metres(0.5, 0.5, 0.5)
// at most: 1 errors
// SPDX-License-Identifier: BSL-1.0
// A sphere has one radius.

#include <ansatz/collision/sphere.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    [[maybe_unused]] const Sphere sphere{metres(1, 1, 1)};
#else
    [[maybe_unused]] const Sphere sphere{1.0 * metre};
#endif
}
