// expect: two columns of this world have the same name
// SPDX-License-Identifier: BSL-1.0
// A column is saved under its name, so two of one name would overwrite each other.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Heat {
    using Unit = unit::Energy;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "heat";
};
struct Fuel {
    using Unit = unit::Energy;
    static constexpr Shape shape = Shape::scalar;
#ifdef ANSATZ_MISTAKE
    static constexpr std::string_view name = "heat";
#else
    static constexpr std::string_view name = "fuel";
#endif
};

int main() {
    World world{SemiImplicitEuler{}, Keep<Heat, Fuel>{}};
    world.step(0.1 * second);
}
