// expect: Ansatz: decay takes a number with a fraction, e.g. decay(1.0); its answer is between 0 and 1
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// As an integer, e to the power of minus 1 would be 0.

#include <ansatz/motion/decay.hpp>

int main() {
#ifdef ANSATZ_MISTAKE
    static_cast<void>(ansatz::decay(1));
#else
    static_cast<void>(ansatz::decay(1.0));
#endif
}
