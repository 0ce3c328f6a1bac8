// SPDX-License-Identifier: BSL-1.0
// 4 Soft bodies: a sheet, a rope, a ball and a box are bodies and springs, and nothing else

// "Soft bodies (such as cloth) are modelled as a collection of rigid bodies bound by virtual springs." That is all
// there is to it: what builds one counts vertices and edges, and leaves behind a world in which nobody could tell who
// built it. The same bodies and springs, added by hand, move alike to the last bit.

#include "claims.hpp"
#include "say.hpp"

#include <ansatz/soft_bodies.hpp>
#include <ansatz/world.hpp>

#include <iostream>
#include <string_view>

using namespace ansatz;

int main() {
    workbook::Claims claim;

    //! [build]
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Ropes{}};
    const Cloth flag{.mesh = TriangleMesh::grid(13, 9, metres(1.2, 0, 0), metres(0, 0.8, 0)),
                     .mass_per_area = 0.15 * kilogram / square_metre,
                     .structural = {20.0 * newton_per_metre, 0.01 * newton_second_per_metre},
                     .shear = {10.0 * newton_per_metre, 0.01 * newton_second_per_metre},
                     .bend = {0.5 * newton_per_metre},
                     .pins = {0, 8 * 13}}; // the two corners of its left side
    const ClothParts cloth = add_cloth(world, flag);
    //! [build]
    //! [others]
    const SoftRopeParts rope = add_rope(world, {.from = metres(0, 3, 0),
                                                .to = metres(2, 3, 0),
                                                .bodies = 21,
                                                .mass_per_length = 0.07 * kilogram_per_metre,
                                                .links = {500.0 * newton_per_metre, 0.1 * newton_second_per_metre},
                                                .pins = {0, 20}});
    const SoftBallParts ball = add_soft_ball(world, {.centre = metres(4, 1, 0),
                                                     .radius = 0.3 * metre,
                                                     .density = 50.0 * kilogram_per_cubic_metre,
                                                     .structural = {100.0 * newton_per_metre},
                                                     .spokes = {100.0 * newton_per_metre}});
    const SoftBoxParts box = add_soft_box(world, {.centre = metres(6, 1, 0),
                                                  .size = metres(0.4, 0.4, 0.8),
                                                  .cells = {2, 2, 4},
                                                  .density = 50.0 * kilogram_per_cubic_metre,
                                                  .structural = {100.0 * newton_per_metre},
                                                  .shear = {50.0 * newton_per_metre}});
    //! [others]
    const auto count = [](std::string_view what, std::size_t bodies, std::size_t springs) {
        std::cout << what << ": " << bodies << " bodies, " << springs << " springs\n";
    };
    const std::size_t of_cloth = cloth.structural.size() + cloth.shear.size() + cloth.bend.size();
    const std::size_t of_ball = ball.structural.size() + ball.bend.size() + ball.spokes.size();
    const std::size_t of_box = box.structural.size() + box.shear.size() + box.bend.size();
    count("A flag of 13 x 9 vertices", cloth.bodies.size(), of_cloth);
    count("A rope", rope.bodies.size(), rope.links.size());
    count("A ball", ball.bodies.size(), of_ball);
    count("A box of 2 x 2 x 4 cells", box.bodies.size(), of_box);
    count("The world", world.size(), world.elements<Spring>().size() + world.elements<Rope>().size());
    claim("nothing is in the world but their bodies and their springs",
          world.size() == cloth.bodies.size() + rope.bodies.size() + ball.bodies.size() + box.bodies.size() &&
              world.elements<Spring>().size() == of_cloth + of_ball + of_box &&
              world.elements<Rope>().size() == rope.links.size());

    // The flag once more, by hand.
    //! [by hand]
    World built{SemiImplicitEuler{}, Gravity{}, Springs{}}, by_hand = built;
    const ClothParts parts = add_cloth(built, flag);
    std::vector<Handle> bodies; // in two worlds that gave out the same handles
    for (const Handle body : parts.bodies)
        bodies.push_back(built.motion(body) == Motion::fixed
                             ? by_hand.add(position(built.position(body)), fixed)
                             : by_hand.add(position(built.position(body)), mass(built.mass(body))));
    for (const SpringHandle spring : built.elements<Spring>().handles()) by_hand.add(built.get(spring));
    for (int i = 0; i < 500; ++i) {
        built.step(1.0 / 500 * second);
        by_hand.step(1.0 / 500 * second);
    }
    //! [by hand]
    workbook::say() << "After a second the flag's free corner is at " << built.position(parts.bodies[12])
                    << ", that of the flag made by hand at " << by_hand.position(bodies[12]) << '\n';
    bool alike = true;
    for (std::size_t v = 0; v < bodies.size(); ++v)
        alike = alike && built.position(parts.bodies[v]) == by_hand.position(bodies[v]) &&
                built.velocity(parts.bodies[v]) == by_hand.velocity(bodies[v]);
    claim("the same bodies and springs, added by hand, are bit for bit in the same places", alike);
    claim("and nothing has gone wrong in either", built.status().ok() && by_hand.status().ok());
    return claim.result();
}
