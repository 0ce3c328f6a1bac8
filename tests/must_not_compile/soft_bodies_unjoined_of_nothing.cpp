// expect: Unjoined names the springs that it reads; write e.g. Unjoined<Springs<>>{}
// SPDX-License-Identifier: BSL-1.0
// A filter that reads springs says which.

#include <ansatz/soft_bodies/unjoined.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    const Unjoined<> filter{};
#else
    const Unjoined<Springs<>> filter{};
#endif
    return sizeof filter > 0 ? 0 : 1;
}
