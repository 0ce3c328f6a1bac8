// SPDX-License-Identifier: BSL-1.0
// Sheets among things to touch: each body is given what it needs beside its place, and a bad one changes nothing.

#include <ansatz/collision.hpp>
#include <ansatz/soft_bodies.hpp>

#include "tests/soft_bodies/support.hpp"

using namespace soft_tests;

TEST_CASE("the bodies of a sheet are particles with a shape, or shapeless, and fall onto the ground as such",
          "[soft_bodies]") {
    World world{SemiImplicitEuler{},          Gravity{}, Springs{},   AllPairs{},
                Narrowphase<Sphere, Plane>{}, Impulse{}, Projection{}};
    world.add(Plane::ground(), fixed);
    Cloth cloth = woven(3, 3);
    cloth.mesh = TriangleMesh::grid(3, 3, metres(0.2, 0, 0), metres(0, 0, 0.2), metres(0, 0.1, 0));
    const auto before = world.hash();
    CHECK_THAT(refusal([&] { add_cloth(world, cloth, Sphere{-0.02 * metre}); }),
               Catch::Matchers::ContainsSubstring("-0.02 m"));
    CHECK(world.hash() == before);
    const ClothParts falling = add_cloth(world, cloth, Sphere{0.02 * metre}, restitution(0.0));
    cloth.mesh = cloth.mesh.moved(metres(5, 0, 0));
    const ClothParts ghost = add_cloth(world, cloth, shapeless);
    run(world, 300, 0.002);
    CHECK(world.status().ok());
    for (const Handle body : falling.bodies) CHECK(world.position(body).value()[1] == Approx(0.02).margin(0.002));
    for (const Handle body : ghost.bodies) CHECK(world.position(body).value()[1] < -1);
}
