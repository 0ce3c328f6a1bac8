// SPDX-License-Identifier: BSL-1.0
// 4.12 Damping that amplifies: too much of it tears a sheet apart, and stable_step says so beforehand

// "Simulating soft bodies using springs can lead to amplification of movement within the system if damping factors are
// not properly tuned." It is so in two ways. Without damping nothing ever comes to rest. With too much of it an
// explicit step overshoots: it takes more velocity out of a spring than there is, so that the next step finds more of
// it the other way. Three sheets are alike but for their damping, and are stepped alike. (A part of section 4, which
// the notes do not divide.)

#include "claims.hpp"
#include "film.hpp"

#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {

constexpr std::size_t side = 9;
const auto step = 1.0 / 240 * second;

/// A sheet of a square metre that lies level and hangs from two corners.
auto hung(Quantity<unit::Damping> c) {
    //! [hung]
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}};
    const ClothParts sheet =
        add_cloth(world, {.mesh = TriangleMesh::grid(side, side, metres(1, 0, 0), metres(0, 0, -1)),
                          .mass_per_area = 0.2 * kilogram / square_metre,
                          .structural = {30.0 * newton_per_metre, c},
                          .shear = {10.0 * newton_per_metre, c},
                          .pins = {0, side - 1}});
    //! [hung]
    return std::pair(std::move(world), sheet);
}
/// How fast the fastest of its springs becomes longer or shorter, m/s: what their damping acts on.
template <class World_> double shivering(const World_& world, const ClothParts& sheet) {
    double most = 0;
    for (const SpringHandle spring : sheet.structural) {
        const Spring it = world.get(spring);
        const auto along = world.position(it.second.body()) - world.position(it.first.body());
        const auto apart = world.velocity(it.second.body()) - world.velocity(it.first.body());
        most = std::max(most, std::abs((dot(along, apart) / norm(along)).value()));
    }
    return most;
}
template <class World_>
auto places(const World_& world, const ClothParts& sheet, const VectorQuantity<unit::Length>& aside) {
    std::vector<VectorQuantity<unit::Length>> all;
    for (const Handle body : sheet.bodies) all.push_back(world.position(body) + aside);
    return all;
}

} // namespace

int main() {
    workbook::Claims claim;
    const std::array dampings{0.0, 0.02, 0.12}; // N s/m
    std::vector<double> after;                  // m/s
    std::vector<Quantity<unit::Time>> limits;
    std::cout << "Each step is " << step << "\n   c in N s/m   stable_step   fastest spring after 10 s\n";
    for (const double c : dampings) {
        auto [world, sheet] = hung(c * newton_second_per_metre);
        //! [ask]
        limits.push_back(stable_step(world)); // asked before the first step
        //! [ask]
        for (int n = 0; n < 2400 && shivering(world, sheet) < 1e3; ++n) world.step(step);
        after.push_back(shivering(world, sheet));
        std::cout << std::fixed << std::setprecision(2) << std::setw(13) << c << std::setw(11)
                  << 1e3 * limits.back().value() << " ms     ";
        if (after.back() < 1e3) std::cout << after.back() << " m/s\n";
        else std::cout << "it has exploded\n";
    }
    claim("without damping its springs still swing after ten seconds", after[0] > 0.5);
    claim("with some they swing less than a tenth of that, though the sheet still swings as a whole",
          after[1] < 0.1 * after[0]);
    claim("with six times as much it explodes", !(after[2] < 1e3));
    claim("stable_step says which of them, beforehand", limits[0] > step && limits[1] > step && limits[2] < step);

    // The same damping, with the step that it wants.
    auto [calm, calm_sheet] = hung(dampings[2] * newton_second_per_metre);
    while (calm.time() < 10.0 * second) calm.step(limits[2]);
    std::cout << "With the most damping and the step that stable_step says: " << shivering(calm, calm_sheet)
              << " m/s\n";
    claim("with that step the same damping calms", shivering(calm, calm_sheet) < after[1]);

    workbook::Film film(
        "4.12", "Damping of 0.02 N s/m (left), and of 0.12 N s/m (right)",
        "Two level sheets are let go. The left one falls and swings. The right one shivers in zigzags and is crumpled; "
        "after more of them it flies apart.",
        {.middle = metres(0.5, -0.45, -0.3),
         .width = 3.9 * metre,
         .height = 2.0 * metre,
         .turn = degrees(-20),
         .above = degrees(20)});
    film.may_leave().still(9);
    auto [tuned, tuned_sheet] = hung(dampings[1] * newton_second_per_metre);
    auto [wild, wild_sheet] = hung(dampings[2] * newton_second_per_metre);
    for (int n = 0; n <= 28 * 6; ++n) {
        if (n % 6 == 0)
            film.frame(double(n) * step)
                .sheet(places(tuned, tuned_sheet, metres(-0.75, 0, -0.27)), side, workbook::paints::cloth)
                .sheet(places(wild, wild_sheet, metres(0.75, 0, 0.27)), side, workbook::paints::cloth);
        tuned.step(step);
        if (shivering(wild, wild_sheet) < 70) wild.step(step);
    }
    film.write();
    return claim.result();
}
