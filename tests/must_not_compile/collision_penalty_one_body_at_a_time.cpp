// expect: this integrator advances one body by itself, but a force of this world couples bodies
// SPDX-License-Identifier: BSL-1.0
// An integrator that solves for one body, where contacts are forces between bodies.

#include <ansatz/collision.hpp>
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
    World world{EachByItself{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Penalty{}};
#else
    World world{RungeKutta4{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Penalty{}};
#endif
    world.step(0.01 * second);
}
