// expect: no matching function for call to
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// A length is no number of seconds.

#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    return int(in(1.0 * metre, second));
#else
    return int(in(1.0 * metre, metre));
#endif
}
