// expect: unknown role: a policy's role is one of ansatz::roles
// SPDX-License-Identifier: BSL-1.0
// A role that no world knows.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Music {
    using role = struct Loudspeaker;
};
#else
struct Music {
    using role = roles::Observer;
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Music{}};
    world.step(0.1 * second);
}
