// SPDX-License-Identifier: BSL-1.0
// 4.1 At rest: a sheet as built has no tension in any spring, and left alone it stays bit for bit

// "A piece of cloth at rest will have no tension in all springs (i.e. all springs at their rest length)." A rest length
// is not typed in: it is the distance of the two bodies as they were put, computed in the numbers in which the force
// will be. Then the difference is nothing, and not merely small. Typed in with a few digits it is a sheet that shivers.
// (A part of section 4, which the notes do not divide.)

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/soft_bodies.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {

/// The largest pull or push of a spring.
template <class World_> Quantity<unit::Force> largest_tension(const World_& world) {
    Quantity<unit::Force> largest{};
    for (const SpringHandle spring : world.template elements<Spring>().handles()) {
        const Spring it = world.get(spring);
        const auto length = norm(world.position(it.second.body()) - world.position(it.first.body()));
        largest = std::max(largest, Quantity<unit::Force>(abs(it.stiffness * (length - *it.rest_length))));
    }
    return largest;
}

} // namespace

int main() {
    workbook::Claims claim;

    //! [sheet]
    World world{SemiImplicitEuler{}, Springs{}};
    const ClothParts parts =
        add_cloth(world, {.mesh = TriangleMesh::grid(20, 20, metres(1, 0.1, 0.3), metres(0.2, 0.9, -1)), // askew
                          .mass_per_area = 0.15 * kilogram / square_metre,
                          .structural = {50.0 * newton_per_metre, 0.01 * newton_second_per_metre},
                          .shear = {25.0 * newton_per_metre, 0.01 * newton_second_per_metre},
                          .bend = {1.0 * newton_per_metre}});
    //! [sheet]
    const auto as_built = world;
    std::cout << world.elements<Spring>().size() << " springs; the largest tension as built is "
              << largest_tension(world) << '\n';
    claim("no spring has any tension", largest_tension(world).value() == 0);
    //! [left alone]
    while (world.time() < 10.0 * second) world.step(1.0 / 600 * second);
    bool stays = true;
    for (const Handle body : parts.bodies) stays = stays && world.position(body) == as_built.position(body);
    //! [left alone]
    claim("after ten seconds every body is where it was, bit for bit", stays);

    // The same sheet with rest lengths of four digits, as one reads them off a drawing.
    //! [rounded]
    World rounded = as_built;
    for (const SpringHandle spring : rounded.elements<Spring>().handles()) {
        Spring it = rounded.get(spring);
        it.rest_length = std::round(it.rest_length->value() * 1e4) * 1e-4 * metre;
        rounded.set(spring, it);
    }
    //! [rounded]
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Force>> tensions, exact;
    while (rounded.time() < 2.0 * second) {
        if (rounded.tick() % 6 == 0) {
            times.push_back(rounded.time());
            tensions.push_back(largest_tension(rounded));
            exact.push_back(0.0 * newton);
        }
        rounded.step(1.0 / 600 * second);
    }
    Quantity<unit::Length> farthest{};
    for (const Handle body : parts.bodies)
        farthest = std::max(farthest, norm(rounded.position(body) - as_built.position(body)));
    workbook::say() << "With rest lengths of a tenth of a millimetre it begins with a tension of " << tensions.front()
                    << " and has moved by up to " << farthest << " after two seconds\n";
    claim("rest lengths that are typed in are no rest", tensions.front().value() > 0 && farthest.value() > 0);

    workbook::Plot plot("4.1", "A sheet at rest, and one whose rest lengths were rounded to 0.1 mm");
    plot.x("time").y("largest tension").line("rounded", times, tensions).line("as built", times, exact).write();
    return claim.result();
}
