// expect: Pools of something that moves no surface, or does not say what it consists of
// SPDX-License-Identifier: BSL-1.0
// Pools of waves that no column has.

#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Mine {
    static constexpr std::string_view name = "Mine";
};
#else
using Mine = Pipes;
#endif

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<Mine>{}};
    world.step(0.01 * second);
}
