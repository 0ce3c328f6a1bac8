// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A height map as an image (`write_pgm`) and as a mesh (`write_obj`), for other programs (notes 7.1, 7.4).
///
/// Use the image where heights are wanted back, in an editor of terrain, and the mesh to see a surface; for a finer
/// one, write `map.tessellated(4)`. Both are streams of bytes: open files with std::ios::binary. They are not for the
/// frame of a game, which hands `heights()` to the graphics card.
///
/// PGM: https://netpbm.sourceforge.net/doc/pgm.html ("P5", 65535 grey values, the larger byte first). OBJ: Wavefront's
/// Advanced Visualizer manual, appendix B.

#include <ansatz/water/height_map.hpp>

#include <cmath>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>

namespace ansatz {

/// Writes a map as a grey image of 16 bits: `low` is black, `high` is white, what lies outside is cut to them. The
/// first row of the image is the row of the largest z, so that z points up on the page and x to the right.
/// \param low  m, finite
/// \param high m, finite and larger
/// \throws std::invalid_argument for other values, before a byte is written
template <class Scalar>
void write_pgm(std::ostream& out, const HeightMap<Scalar>& map, Quantity<unit::Length> low,
               Quantity<unit::Length> high) {
    require_finite("write_pgm", "low", low);
    require_finite("write_pgm", "high", high);
    if (!(high > low)) refuse_value("write_pgm", "high", high, "white is higher than black, low = " + describe(low));
    std::string bytes = "P5\n" + std::to_string(map.points_x()) + ' ' + std::to_string(map.points_z()) + "\n65535\n";
    for (std::size_t row = map.points_z(); row-- > 0;)
        for (std::size_t i = 0; i < map.points_x(); ++i) {
            const double part = (0.5 * static_cast<double>(map(i, row).value()) - 0.5 * low.value()) /
                                (0.5 * high.value() - 0.5 * low.value()); // halves: the whole may overflow
            const auto grey = static_cast<unsigned>(std::lround(65535 * std::clamp(part, 0.0, 1.0)));
            bytes += static_cast<char>(static_cast<unsigned char>(grey >> 8U));
            bytes += static_cast<char>(static_cast<unsigned char>(grey & 255U));
        }
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}
/// The same from the map's lowest point to its highest. A level map is black.
template <class Scalar> void write_pgm(std::ostream& out, const HeightMap<Scalar>& map) {
    const auto low = static_cast<double>(map.range().first.value()) * metre,
               high = static_cast<double>(map.range().second.value()) * metre;
    constexpr double beyond = std::numeric_limits<double>::infinity();
    write_pgm(out, map, low, high > low ? high : std::nextafter(low.value(), beyond) * metre);
}

/// Writes a map as a mesh: a vertex with its normal for each point, two triangles for each cell, anticlockwise seen
/// from above. The normal of a point is that of the cells around it, averaged, so that the mesh is shaded smoothly.
template <class Scalar> void write_obj(std::ostream& out, const HeightMap<Scalar>& map) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(std::numeric_limits<double>::max_digits10);
    const std::size_t nx = map.points_x(), nz = map.points_z();
    for (std::size_t j = 0; j < nz; ++j)
        for (std::size_t i = 0; i < nx; ++i)
            text << "v " << map.x(i).value() << ' ' << map(i, j).value() << ' ' << map.z(j).value() << '\n';
    const Scalar dx(map.dx().value()), dz(map.dz().value());
    text.precision(6);
    for (std::size_t j = 0; j < nz; ++j)
        for (std::size_t i = 0; i < nx; ++i) {
            // Central differences, one-sided on the border: the mean of the slopes of the cells around the point.
            const std::size_t west = i > 0 ? i - 1 : 0, east = std::min(i + 1, nx - 1), south = j > 0 ? j - 1 : 0,
                              north = std::min(j + 1, nz - 1);
            const Scalar by_x = (map(east, j).value() - map(west, j).value()) / (Scalar(double(east - west)) * dx),
                         by_z = (map(i, north).value() - map(i, south).value()) / (Scalar(double(north - south)) * dz);
            Vector<Scalar, 3> normal(-by_x, Scalar(1), -by_z);
            normal.normalize();
            text << "vn " << normal[0] << ' ' << normal[1] << ' ' << normal[2] << '\n';
        }
    auto corner = [&](std::size_t i, std::size_t j) { // counted from 1, vertex and normal alike
        const std::string number = std::to_string(j * nx + i + 1);
        return number + "//" + number;
    };
    for (std::size_t j = 0; j + 1 < nz; ++j)
        for (std::size_t i = 0; i + 1 < nx; ++i)
            text << "f " << corner(i, j) << ' ' << corner(i, j + 1) << ' ' << corner(i + 1, j + 1) << "\nf "
                 << corner(i, j) << ' ' << corner(i + 1, j + 1) << ' ' << corner(i + 1, j) << '\n';
    out << text.str();
}

} // namespace ansatz
