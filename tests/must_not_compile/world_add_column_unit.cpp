// expect: the value given to with<C> has not the unit or the shape of column C
// SPDX-License-Identifier: BSL-1.0
// A temperature for a heat.

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
    world.add(with<Heat>(1.0 * kilogram));
#else
    world.add(with<Heat>(1.0 * joule));
#endif
}
