// SPDX-License-Identifier: BSL-1.0
// Warm worlds in which a sheet tears, by the integrators that solve. The script of this name says what it shows.
#define EIGEN_RUNTIME_NO_MALLOC
#include <cstddef>
static std::size_t in_eigen = 0;
#define eigen_assert(ok) ((ok) ? (void)0 : (void)++in_eigen)
#include <ansatz/motion/integrators/matrix_free.hpp>
#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/world.hpp>

#include "tests/operator_new.hpp"
#include "tests/soft_bodies/letting_go.hpp"

#include <cstdio>
#include <random>

using namespace ansatz;

static std::size_t in_new = 0;
static bool counted(std::size_t) noexcept {
    ++in_new;
    return true;
}

/// \return whether no step allocated, of the world and of a copy that has taken one step
template <class World_> bool tears_in_its_room(const char* name, World_ world) {
    Cloth cloth{.mesh = TriangleMesh::grid(9, 8, metres(1, 0, 0), metres(0, 1, 0)),
                .mass_per_area = 0.2 * (kilogram / square_metre),
                .structural = {50.0 * newton_per_metre, 0.1 * newton_second_per_metre},
                .shear = {20.0 * newton_per_metre, 0.1 * newton_second_per_metre},
                .bend = {5.0 * newton_per_metre, 0.1 * newton_second_per_metre}};
    cloth.pins = {0, 8};
    cloth.rigidity = 0.001 * joule;
    cloth.drag = 1;
    add_cloth(world, cloth);
    for (int i = 0; i < 3; ++i) world.step(0.01 * second);
    auto copy = world;
    copy.step(0.01 * second);
    in_new = in_eigen = 0;
    for (World_* one : {&world, &copy}) {
        std::mt19937 random(8);
        for (int i = 0; i < 60; ++i) {
            soft_tests::let_some_go(*one, random, 2);
            test::before_allocation = counted;
            Eigen::internal::set_is_malloc_allowed(false);
            one->step(0.01 * second);
            Eigen::internal::set_is_malloc_allowed(true);
            test::before_allocation = nullptr;
        }
        std::printf("%s: %zu vertices split, %zu allocations by operator new, %zu by Eigen\n", name,
                    one->tearing().split, in_new, in_eigen);
        if (one->tearing().split < 10) return std::puts("hardly any vertex split: the case has lost its point"), false;
    }
    return in_new + in_eigen == 0;
}

int main() {
    // The count counts.
    test::before_allocation = counted;
    delete new int;
    Eigen::internal::set_is_malloc_allowed(false);
    Eigen::VectorXd(Eigen::VectorXd::Ones(3)).swap(*new Eigen::VectorXd);
    Eigen::internal::set_is_malloc_allowed(true);
    test::before_allocation = nullptr;
    if (in_new == 0 || in_eigen == 0) return std::puts("nothing is counted"), 1;

    const Tearing<Splitting> tearing{.room = 200};
    const Wind wind{metres_per_second(0, 0, 3)};
    return tears_in_its_room("ImplicitEulerBy<MatrixFree>", World{ImplicitEulerBy<MatrixFree>{}, Gravity{},
                                                                  Springs<Breaking>{}, Bending{}, wind, tearing})
               ? 0
               : 1;
}
