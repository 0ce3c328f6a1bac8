// expect: query: an option that means nothing here; it is with_sensors, or something that the world's filter reads
// SPDX-License-Identifier: BSL-1.0
// A ray of some layer, in a world without layers.

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    const Ray ray{metres(0, 0, 0), Eigen::Vector3d(1, 0, 0)};
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, AllPairs{}, Narrowphase<Sphere>{}, Impulse<>{}};
#else
    World world{SemiImplicitEuler{}, AllPairs{}, Layers{}, Narrowphase<Sphere>{}, Impulse<>{}};
#endif
    world.query().closest(ray, member_of(2));
}
