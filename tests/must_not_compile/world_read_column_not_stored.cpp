// expect: this world does not store that column
// SPDX-License-Identifier: BSL-1.0
// A column that nobody needs.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Heat {
    using Unit = unit::Energy;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "heat";
};

int main() {
    World world{SemiImplicitEuler{}};
    auto ball = world.add();
#ifdef ANSATZ_MISTAKE
    (void)world.read<Heat>(ball);
#else
    (void)world.position(ball);
#endif
}
