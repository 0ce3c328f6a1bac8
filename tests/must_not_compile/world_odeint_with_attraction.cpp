// expect: this integrator advances one body by itself, but a force of this world couples bodies
// SPDX-License-Identifier: BSL-1.0
// A stepper of one body where bodies pull at each other.

#include <ansatz/motion/integrators/odeint.hpp>
#include <ansatz/world.hpp>

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{Odeint<boost::numeric::odeint::runge_kutta4<std::array<double, 6>>>{}, Attraction{}};
#else
    World world{RungeKutta4{}, Attraction{}};
#endif
    world.add(mass(2.0 * kilogram));
    world.step(0.1 * second);
}
