#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A warm step of a world with springs allocates nothing: not with explicit integrators, not when springs break or bodies
# fall asleep, and not with implicit Euler and conjugate gradients, whose pattern, vectors and preconditioner are kept.
# Eigen takes its memory from malloc, past operator new, so that one program of its own is built in which both tell.
#
# usage: allocation.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

cat > allocation.cpp << 'END'
#define EIGEN_RUNTIME_NO_MALLOC
#include <cstdio>
#include <cstdlib>
#define eigen_assert(ok) ((ok) ? (void)0 : (std::puts("Eigen allocated: " #ok), std::exit(1)))
#include <ansatz/springs.hpp>
#include <ansatz/motion/integrators/odeint.hpp>
#include <ansatz/world.hpp>

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include <new>

static bool forbidden = false;
void* operator new(std::size_t size) {
    if (forbidden) std::puts("operator new was called"), std::exit(1);
    if (void* p = std::malloc(size)) return p;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    if (forbidden) std::puts("operator new was called"), std::exit(1);
    return std::aligned_alloc(std::size_t(alignment), (size + std::size_t(alignment) - 1) / std::size_t(alignment) * std::size_t(alignment));
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

using namespace ansatz;

template <class Integrator, class... More> void hang(const char* name, More... more) {
    World world{Integrator{}, Gravity{}, Springs<Breaking>{}, Ropes{}, Rest{0.5 * metre_per_second, 0.05 * second}, more...};
    world.template reserve<Spring>(40);
    SpringEnd above = metres(0, 0, 0);
    for (int i = 1; i <= 20; ++i) {
        const auto body = world.add(position(metres(0.02 * i, -0.1 * i, 0)), mass(0.1 * kilogram));
        world.add(Spring{above, body, 500.0 * newton_per_metre, 0.5 * newton_second_per_metre, 0.1 * metre}, breaks_at(i == 12 ? 9.0 * newton : 1e3 * newton));
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
    hang<SemiImplicitEuler>("SemiImplicitEuler");
    hang<Verlet>("Verlet");
    hang<VelocityVerlet>("VelocityVerlet");
    hang<RungeKutta4>("RungeKutta4");
    hang<Odeint<boost::numeric::odeint::runge_kutta4<std::array<double, 6>>>>("Odeint<runge_kutta4>");
    hang<ImplicitEuler>("ImplicitEuler");
    hang<SemiImplicitEuler>("SemiImplicitEuler in divided steps", StepLimit<Divide>{.part = 0.02});
}
END
# -Wno-mismatched-new-delete: g++ sees free() where it has inlined the delete above and not the new
warnings=()
"${CXX:-g++}" -Wno-mismatched-new-delete -E -x c++ /dev/null > /dev/null 2>&1 && warnings=(-Wno-mismatched-new-delete -Wno-unknown-warning-option)
eigen=$(pkg-config --cflags eigen3 2> /dev/null || echo -I/usr/include/eigen3)
# shellcheck disable=SC2086
"${CXX:-g++}" -std=c++20 -O1 "${warnings[@]}" -I"$project/include" $eigen allocation.cpp -o allocation
./allocation
