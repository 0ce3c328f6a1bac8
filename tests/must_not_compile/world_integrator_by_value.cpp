// expect: because it takes it by value
// SPDX-License-Identifier: BSL-1.0
// A world that would stand still in silence.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Mine {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    static void advance(Stage<0>, auto x, auto v, const auto& a, const auto& dt) {
        v += a * dt;
        x += v * dt;
    }
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
