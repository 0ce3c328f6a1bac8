// expect: a soft ball is built in three dimensions
// SPDX-License-Identifier: BSL-1.0
// A ball in a world of two dimensions.

#include <ansatz/soft_bodies/soft_ball.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Springs{}, Space<double, 2>{}};
#else
    World world{SemiImplicitEuler{}, Springs{}, Space<double, 3>{}};
#endif
    add_soft_ball(world, SoftBall{.radius = 1.0 * metre, .density = 10.0 * kilogram_per_cubic_metre});
}
