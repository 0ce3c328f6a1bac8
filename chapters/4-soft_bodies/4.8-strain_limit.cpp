// SPDX-License-Identifier: BSL-1.0
// 4.8 A limit of strain: threads give way a little and then hold

// Springs go on giving way, so that cloth of springs hangs from its pins like rubber: the two at a corner carry all of
// it. Stiffer springs want shorter steps. A limit asks for none: what is too long behind the step is shortened. Provot
// found in 1995 that this is what makes a sheet of springs look like cloth. Its price is that one pass over the springs
// is not enough. (A part of section 4, which the notes do not divide.)

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/soft_bodies/strain_limit.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {

constexpr std::size_t n = 20;

template <class World_> ClothParts hang(World_& world) {
    return add_cloth(world, {.mesh = TriangleMesh::grid(n, n, metres(1, 0, 0), metres(0, -1, 0)),
                             .mass_per_area = 0.3 * kilogram / square_metre,
                             .structural = {20.0 * newton_per_metre, 0.02 * newton_second_per_metre},
                             .shear = {20.0 * newton_per_metre, 0.02 * newton_second_per_metre},
                             .pins = {0, n - 1}});
}
/// The largest strain while it falls into its pins, and when it hangs there.
template <class World_>
std::pair<double, double> strains(World_& world, Quantity<unit::Time> dt, Quantity<unit::Time> until) {
    double most = 0;
    while (world.time() < until) {
        world.step(dt);
        most = std::max(most, largest_strain(world));
    }
    return {most, largest_strain(world)};
}

} // namespace

int main() {
    workbook::Claims claim;
    //! [limit]
    World springs{SemiImplicitEuler{}, Gravity{}, Springs{}, Drag{2.0 / second}};
    World limited{SemiImplicitEuler{}, Gravity{}, Springs{}, Drag{2.0 / second},
                  StrainLimit{.most = 0.1, .passes = 80}};
    //! [limit]
    const auto cloth = hang(springs), same = hang(limited);
    const auto dt = 1.0 / 500 * second;
    const auto free = strains(springs, dt, 1.5 * second), held = strains(limited, dt, 1.5 * second);
    std::cout << std::fixed << std::setprecision(3);
    workbook::say() << "   springs alone: stretched by " << free.second << " of a spring's length at most, and by "
                    << free.first << " on the way\n"
                    << "   with a limit of 0.1: by " << held.second << ", and by " << held.first << " on the way\n";
    claim("springs alone hang like rubber: the longest is more than half too long", free.second > 0.5);
    claim("with a limit none is more than a tenth too long when the sheet hangs, but for two thousandths",
          held.second < 0.102);
    const auto drops = [](const auto& world, const ClothParts& parts) {
        auto lowest = 0.0 * metre;
        for (const Handle body : parts.bodies) lowest = std::min(lowest, y(world.position(body)));
        return -1.0 * lowest;
    };
    std::cout << "   the lowest body hangs " << drops(springs, cloth) / metre << " m and "
              << drops(limited, same) / metre << " m below the pins\n";
    claim("the limit changes how far the sheet hangs", drops(limited, same) < drops(springs, cloth) - 0.05 * metre);

    // How many passes it needs, at two steps.
    std::cout << "   passes      on the way, at 500 and at 120 steps a second\n";
    const auto into_the_pins = 0.3 * second;
    std::vector<double> passes, fine, coarse;
    bool falls = true;
    for (int each = 5; each <= 80; each *= 2) {
        const World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Drag{2.0 / second},
                          StrainLimit{.most = 0.1, .passes = each}};
        auto quick = world, slow = world;
        hang(quick);
        hang(slow);
        const double at_500 = strains(quick, dt, into_the_pins).first,
                     at_120 = strains(slow, 1.0 / 120 * second, into_the_pins).first;
        std::cout << std::setw(9) << each << std::setw(18) << at_500 << std::setw(18) << at_120 << '\n';
        if (!fine.empty()) falls = falls && at_500 < fine.back() && at_120 < coarse.back();
        passes.push_back(each);
        fine.push_back(at_500);
        coarse.push_back(at_120);
    }
    claim("the more passes, and the shorter the step, the less it is exceeded", falls && fine[3] < coarse[3]);

    workbook::Plot plot("4.8", "A sheet of 20 x 20 falls into its two pins: by how much a limit of 0.1 is exceeded");
    plot.x("passes over all springs").y("largest strain").log_x();
    plot.points("500 steps a second", passes, fine).points("120 steps a second", passes, coarse);
    plot.reference("the limit", passes, [](double) { return 0.1; }).write();
    return claim.result();
}
