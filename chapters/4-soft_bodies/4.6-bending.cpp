// SPDX-License-Identifier: BSL-1.0
// 4.6 Bending: a hinge between two triangles keeps its angle

// A spring across a fold resists it, but hardly: while the fold is small its length changes with the square of the
// angle, so that a small fold costs next to nothing. What makes paper paper is a hinge, whose energy is that of the
// angle itself. This is a sheet with hinges beside the plate of the textbook, and leaves of growing rigidity. (A part
// of section 4, which the notes do not divide.)

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/motion/energy.hpp>
#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;

namespace {

constexpr double side = 0.05; // m, of a cell
/// A leaf of n x 4 vertices that lies level.
Cloth leaf(std::size_t n) {
    return {.mesh = TriangleMesh::grid(n, 4, metres(side * double(n - 1), 0, 0), metres(0, 0, -3 * side)),
            .mass_per_area = 0.3 * kilogram / square_metre};
}
/// Rolls it up about an axis along its second side, with a radius.
template <class World_> void roll(World_& world, const ClothParts& parts, std::size_t n, double radius) {
    const double fold = 2 * std::asin(side / (2 * radius)); // the lines lie on the circle
    for (std::size_t v = 0; v < parts.bodies.size(); ++v) {
        const double angle = fold * double(v % n);
        world.set_position(parts.bodies[v], metres(radius * std::sin(angle), radius * std::cos(angle) - radius,
                                                   world.position(parts.bodies[v]).value()[2]));
    }
}

} // namespace

int main() {
    workbook::Claims claim;
    const std::size_t n = 21;

    //! [rigid]
    Cloth rigid = leaf(n);
    rigid.rigidity = 0.02 * newton_metre; // D, of a plate
    Cloth sprung = leaf(n);
    sprung.bend = {16.0 * newton_per_metre, {}}; // springs from each vertex to the next but one
    //! [rigid]
    World hinges{SemiImplicitEuler{}, Springs{}, Bending{}};
    World springs = hinges;
    const auto of_hinges = add_cloth(hinges, rigid), of_springs = add_cloth(springs, sprung);
    std::cout << "   rolled up to a radius of   hinges hold    a plate would   springs hold\n" << std::fixed;
    std::vector<double> curvatures, by_hinge, by_spring;
    double off = 0, less = 0;
    for (const double radius : {3.2, 1.6, 0.8, 0.4, 0.2}) {
        roll(hinges, of_hinges, n, radius);
        roll(springs, of_springs, n, radius);
        // 1/2 D / r^2 for each area: of n - 1 columns of cells all but a half at both ends are bent.
        const double area = side * double(n - 2) * 3 * side, plate = 0.5 * 0.02 / (radius * radius) * area;
        const double hinge = potential_energy(hinges) / joule, spring = potential_energy(springs) / joule;
        std::cout << std::setw(22) << std::setprecision(1) << radius << " m" << std::setprecision(7) << std::setw(14)
                  << hinge << " J" << std::setw(15) << plate << " J" << std::setw(13) << spring << " J\n";
        off = std::max(off, std::abs(hinge / plate - 1) * radius * radius);
        if (radius == 3.2) less = spring / hinge;
        curvatures.push_back(1 / radius);
        by_hinge.push_back(hinge);
        by_spring.push_back(spring);
    }
    claim("hinges hold what a plate holds, but for (side/r)^2 / 12", off < side * side / 11);
    claim("what springs hold falls with the fourth power of the curvature, and is lost in gentle folds",
          std::abs(std::log2(by_spring[1] / by_spring[0]) - 4) < 0.1 && less < 0.01);

    // Leaves that are held at one side, as rigid as cloth and as card.
    std::vector<std::vector<Quantity<unit::Length>>> across, height;
    const std::vector<double> rigidities{0.003, 0.1, 1};
    for (const double rigidity : rigidities) {
        Cloth held = leaf(n);
        held.structural = {1000.0 * newton_per_metre, 0.1 * newton_second_per_metre};
        held.shear = {300.0 * newton_per_metre, 0.1 * newton_second_per_metre};
        held.rigidity = rigidity * newton_metre;
        held.rigidity_damping = 0.0005 * second;
        for (std::uint32_t j = 0; j < 4; ++j)
            for (std::uint32_t i = 0; i < 2; ++i) held.pins.push_back(i + std::uint32_t(n) * j); // a clamp
        //! [leaf]
        World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Bending{}, Drag{2.0 / second}};
        const auto parts = add_cloth(world, held);
        const auto dt = 0.8 * stable_step(world);
        //! [leaf]
        while (world.time() < 8.0 * second) world.step(dt);
        across.emplace_back();
        height.emplace_back();
        for (std::size_t i = 0; i < n; ++i) {
            across.back().push_back(x(world.position(parts.bodies[i])));
            height.back().push_back(y(world.position(parts.bodies[i])));
        }
        std::cout << "   a leaf of " << std::setprecision(3) << rigidity << " N m hangs by " << std::setprecision(2)
                  << -height.back().back() / metre << " m at its end\n";
    }
    claim("cloth hangs straight down, card hardly bends",
          -height[0].back() > 0.85 * metre && -height[2].back() < 0.6 * metre && -height[1].back() < -height[0].back());

    workbook::Plot energy("4.6", "A sheet that is rolled up: what its folds hold");
    energy.x("curvature", "1/m").y("energy", "J").log_x().log_y();
    energy.points("hinges", curvatures, by_hinge).points("springs across", curvatures, by_spring);
    energy.reference("a plate", curvatures,
                     [&](double c) { return 0.5 * 0.02 * c * c * side * double(n - 2) * 3 * side; });
    energy.write();
    workbook::Plot leaves("4.6-leaves", "A leaf of 1 m, held at one side");
    leaves.x("across").y("height").equal_axes();
    for (std::size_t i = 0; i < rigidities.size(); ++i) {
        const std::vector<std::string> names{"0.003 N m", "0.1 N m", "1 N m"};
        leaves.line(names[i], across[i], height[i]);
    }
    leaves.write();
    return claim.result();
}
