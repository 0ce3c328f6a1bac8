// expect: an integrator with a wrong signature
// SPDX-License-Identifier: BSL-1.0
// Without a velocity it must say what velocity means.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Mine {
    using role = roles::Integrator;
    using writes = Columns<Position, PreviousPosition>;
    static constexpr int stages = 1;
    static void advance(Stage<0>, auto& x, auto& before, const auto& a, const auto& dt) {
        const auto next = x + (x - before) + a * (dt * dt);
        before = x;
        x = next;
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
