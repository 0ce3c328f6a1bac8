// expect: a property is given twice
// SPDX-License-Identifier: BSL-1.0
// Two heats.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Heat {
    using Unit = unit::Energy;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "heat";
};

int main() {
    World world{SemiImplicitEuler{}, Keep<Heat>{}};
#ifdef ANSATZ_MISTAKE
    world.add(with<Heat>(1.0 * joule), with<Heat>(2.0 * joule));
#else
    world.add(with<Heat>(1.0 * joule));
#endif
}
