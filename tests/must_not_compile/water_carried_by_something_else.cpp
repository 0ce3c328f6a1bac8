// expect: a policy by which water carries bodies keeps what Buoyancy keeps, and couples bodies; derive it from Buoyancy
// SPDX-License-Identifier: BSL-1.0
// Water that carries bodies by a policy that keeps none.

#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Mine {
    using role = roles::Buoyancy;
    static constexpr std::string_view name = "Mine";
};
#else
struct Mine : Buoyancy {
    static constexpr std::string_view name = "Mine";
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<Pipes>{}, Mine{}};
    world.step(0.01 * second);
}
