// SPDX-License-Identifier: BSL-1.0
// 7.1 Height map: a surface as one height for each point of a fixed grid, with all that lies between made up

// Of a lake one sees the surface, so that a height y for each x and z of a grid is enough: n^2 numbers in the place of
// n^3. Between the points a rule must say what is there. The bilinear one is the cheapest that leaves no gap; its error
// falls with the square of the distance of the points, and tessellation adds triangles, not knowledge.

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/water.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

namespace {
Length dune(Length x, Length z) { return (1.0 + 0.8 * std::sin(1.1 * x.value()) * std::cos(0.7 * z.value())) * metre; }
} // namespace

int main() {
    workbook::Claims claim;

    //! [map]
    const auto map = HeightMap<>::of(9, 9, 1.0 * metre, 1.0 * metre, dune); // 9 x 9 points, 1 m apart
    std::cout << "In the middle of a cell: " << map.height(2.5 * metre, 3.5 * metre) << "; the dune itself is "
              << dune(2.5 * metre, 3.5 * metre) << " high there\n";
    std::cout << "Its normal there: (" << map.normal(2.5 * metre, 3.5 * metre).transpose() << ")\n";
    //! [map]
    claim("the map goes through its points", map.height(3.0 * metre, 4.0 * metre) == dune(3.0 * metre, 4.0 * metre));
    claim("and its normal has length 1", std::abs(map.normal(2.5 * metre, 3.5 * metre).norm() - 1) < 1e-14);

    // How far off it is between them.
    std::vector<double> spacings, errors;
    for (const int cells : {8, 16, 32, 64, 128}) {
        const auto finer = HeightMap<>::of(std::size_t(cells + 1), std::size_t(cells + 1), 8.0 / cells * metre,
                                           8.0 / cells * metre, dune);
        double most = 0;
        for (double x = 0.013; x < 8; x += 0.037)
            for (double z = 0.011; z < 8; z += 0.041)
                most = std::max(most, abs(finer.height(x * metre, z * metre) - dune(x * metre, z * metre)).value());
        std::cout << "  points " << 8.0 / cells << " m apart: at most " << most << " m off\n";
        spacings.push_back(8.0 / cells);
        errors.push_back(most);
    }
    const double order = std::log2(errors[errors.size() - 2] / errors.back());
    std::cout << "Halved, the distance leaves a quarter of it: order " << order << '\n';
    claim("bilinear heights are of second order", std::abs(order - 2) < 0.05);

    //! [tessellated]
    const auto fine = map.tessellated(8);
    std::ostringstream mesh, image;
    write_obj(mesh, fine);
    write_pgm(image, map, 0.0 * metre, 2.0 * metre);
    //! [tessellated]
    workbook::say() << map.points_x() * map.points_z() << " points become " << fine.points_x() * fine.points_z()
                    << " and a mesh of " << 2 * (fine.points_x() - 1) * (fine.points_z() - 1) << " triangles in "
                    << mesh.str().size() / 1024 << " KiB; the image has " << image.str().size() << " bytes\n";
    double apart = 0, off = 0;
    for (double x = 0.013; x < 8; x += 0.037)
        for (double z = 0.011; z < 8; z += 0.041) {
            apart = std::max(apart, abs(fine.height(x * metre, z * metre) - map.height(x * metre, z * metre)).value());
            off = std::max(off, abs(fine.height(x * metre, z * metre) - dune(x * metre, z * metre)).value());
        }
    claim("64 times the triangles are the same surface", apart < 1e-14 && std::abs(off - errors.front()) < 1e-14);

    std::vector<Length> places, drawn, meant, points, heights;
    for (double x = 0; x <= 8; x += 0.02) {
        places.push_back(x * metre);
        drawn.push_back(map.height(x * metre, 0.0 * metre));
        meant.push_back(dune(x * metre, 0.0 * metre));
    }
    for (std::size_t i = 0; i < map.points_x(); ++i) {
        points.push_back(map.x(i));
        heights.push_back(map(i, 0));
    }
    workbook::Plot plot("7.1", "A height map knows its points; the rest is a straight line between them");
    plot.x("x").y("height");
    plot.reference("the dune", places, meant).line("the map", places, drawn).points("its points", points, heights);
    plot.write();
    return claim.result();
}
