// expect: an integrator must advance the position
// SPDX-License-Identifier: BSL-1.0
// An integrator that moves nothing.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Mine {
    using role = roles::Integrator;
    using writes = Columns<Velocity>;
    static constexpr int stages = 1;
    static void advance(Stage<0>, auto& v, const auto& a, const auto& dt) { v += a * dt; }
};
#else
struct Mine {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    static void advance(Stage<0>, auto& x, auto& v, const auto& a, const auto& dt) {
        v += a * dt;
        x += v * dt;
    }
};
#endif

int main() {
    World world{Mine{}, Gravity{}};
    world.add(position(metres(0, 10, 0)));
    world.step(0.1 * second);
}
