// expect: this integrator advances one body by itself, but a force of this world couples bodies
// SPDX-License-Identifier: BSL-1.0
// An integrator that solves for one body, where bodies pull at each other.

#include <ansatz/world.hpp>

using namespace ansatz;

struct EachByItself {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static bool solve(auto& x, auto& v, const auto& laws, const auto& dt) {
        v += laws(x, v, 0.0) * dt;
        x += v * dt;
        return true;
    }
};

int main() {
#ifdef ANSATZ_MISTAKE
    World world{EachByItself{}, Attraction{}};
#else
    World world{RungeKutta4{}, Attraction{}};
#endif
    world.add(mass(2.0 * kilogram));
    world.step(0.1 * second);
}
