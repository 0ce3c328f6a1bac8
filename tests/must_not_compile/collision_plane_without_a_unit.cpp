// expect: a bare number where a quantity belongs; multiply it with its unit
// SPDX-License-Identifier: BSL-1.0
// How far a plane lies from its body is a length.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(Plane{Eigen::Vector3d(0, 1, 0), -2.0}, fixed);
#else
    world.add(Plane{Eigen::Vector3d(0, 1, 0), -2.0 * metre}, fixed);
#endif
}
