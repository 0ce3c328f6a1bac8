// SPDX-License-Identifier: BSL-1.0
// Warm worlds with springs that break and bodies that fall asleep, by every integrator. The script of this name says
// what it shows.
#define EIGEN_RUNTIME_NO_MALLOC
#include <cstdio>
#include <cstdlib>
#define eigen_assert(ok) ((ok) ? (void)0 : (std::puts("Eigen allocated: " #ok), std::exit(1)))
#include <ansatz/motion/integrators/matrix_free.hpp>
#include <ansatz/motion/integrators/odeint.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "tests/operator_new.hpp"

/// While this holds, an allocation ends the program.
static bool forbidden = false;
static bool allowed(std::size_t) noexcept {
    if (forbidden) std::puts("operator new was called"), std::exit(1);
    return true;
}

using namespace ansatz;

template <class Integrator, class... More> void hang(const char* name, More... more) {
    World world{Integrator{}, Gravity{}, Springs<Breaking>{}, Ropes{}, Rest{0.5 * metre_per_second, 0.05 * second},
                more...};
    world.template reserve<Spring>(40);
    SpringEnd above = metres(0, 0, 0);
    for (int i = 1; i <= 20; ++i) {
        const auto body = world.add(position(metres(0.02 * i, -0.1 * i, 0)), mass(0.1 * kilogram));
        world.add(Spring{above, body, 500.0 * newton_per_metre, 0.5 * newton_second_per_metre, 0.1 * metre},
                  breaks_at(i == 12 ? 9.0 * newton : 1e3 * newton));
        above = body;
    }
    // A body that falls asleep and is woken by its rope.
    const auto sleeper = world.add(position(metres(5, 0, 0)), mass(1.0 * kilogram));
    world.add(Spring{sleeper, metres(5, 0, 0), 0.0 * newton_per_metre});
    const auto handles = world.handles();
    for (int i = 0; i < 3; ++i) world.step(0.001 * second);
    forbidden = true;
    Eigen::internal::set_is_malloc_allowed(false);
    std::size_t broken = 0;
    for (int i = 0; i < 1500; ++i) {
        world.step(0.001 * second);
        broken += world.template elements<Spring>().broken().size();
    }
    Eigen::internal::set_is_malloc_allowed(true);
    forbidden = false;
    std::printf("%s: %zu broke, nothing allocated\n", name, broken);
    if (broken == 0) std::puts("nothing broke: the case has lost its point"), std::exit(1);
}

int main() {
    test::before_allocation = allowed;
    hang<SemiImplicitEuler>("SemiImplicitEuler");
    hang<Verlet>("Verlet");
    hang<VelocityVerlet>("VelocityVerlet");
    hang<RungeKutta4>("RungeKutta4");
    hang<Odeint<boost::numeric::odeint::runge_kutta4<std::array<double, 6>>>>("Odeint<runge_kutta4>");
    hang<ImplicitEuler>("ImplicitEuler");
    hang<ImplicitEulerBy<MatrixFree>>("ImplicitEulerBy<MatrixFree>");
    hang<SemiImplicitEuler>("SemiImplicitEuler in divided steps", StepLimit<Divide>{.part = 0.02});
    hang<SemiImplicitEuler>("SemiImplicitEuler in measured steps", StepLimit<Divide>{.part = 0.02, .measured = 5});
}
