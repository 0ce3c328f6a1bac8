// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `box_mesh` and `ball_mesh`: closed surfaces of triangles, which face outwards.
///
/// Use them for what is filled with something: the skin of a soft ball, a balloon under pressure, a body that wind
/// blows on. For a sheet take `TriangleMesh::grid`.

#include <ansatz/soft_bodies/triangle_mesh.hpp>

#include <map>

namespace ansatz {

/// The surface of a box along the axes. Its vertices are those of a lattice of (nx + 1) (ny + 1) (nz + 1) points that
/// lie on the surface, in the lattice's order: x fastest, z slowest. With n sides of 1 along each it is the octet of
/// corners, and its volume is the box's exactly.
/// \param size   its three sides, m, each finite and greater than zero
/// \param nx, ny, nz how many cells along each side, at least 1
/// \param centre where its middle is, m
/// \throws std::invalid_argument
inline TriangleMesh box_mesh(const TriangleMesh::Point& size, std::size_t nx = 1, std::size_t ny = 1,
                             std::size_t nz = 1,
                             const TriangleMesh::Point& centre = TriangleMesh::Point::from_value({0, 0, 0})) {
    using Index = TriangleMesh::Index;
    const std::array<std::size_t, 3> n{nx, ny, nz};
    for (std::size_t k = 0; k < 3; ++k) {
        require_positive("box_mesh", detail::joined({"size along ", std::string_view("xyz").substr(k, 1)}),
                         component(size, int(k)));
        if (n[k] < 1 || n[k] > 10000)
            refuse_value("box_mesh",
                         detail::joined({"the number of cells along ", std::string_view("xyz").substr(k, 1)}),
                         std::to_string(n[k]), "it is at least 1, and 10000 at most");
    }
    std::map<std::array<std::size_t, 3>, Index> index; // of the lattice's points on the surface
    std::vector<TriangleMesh::Point> vertices;
    auto on_surface = [&](std::size_t i, std::size_t j, std::size_t k) {
        return i == 0 || i == nx || j == 0 || j == ny || k == 0 || k == nz;
    };
    for (std::size_t k = 0; k <= nz; ++k)
        for (std::size_t j = 0; j <= ny; ++j)
            for (std::size_t i = 0; i <= nx; ++i) {
                if (!on_surface(i, j, k)) continue;
                index[{i, j, k}] = Index(vertices.size());
                const Vector<double, 3> part(double(i) / double(nx) - 0.5, double(j) / double(ny) - 0.5,
                                             double(k) / double(nz) - 0.5);
                vertices.push_back(centre + TriangleMesh::Point::from_value(part.cwiseProduct(size.value())));
            }
    std::vector<TriangleMesh::Triangle> triangles;
    // Both sides across each axis; (axis, u, v) are right-handed, so that u x v points along the axis.
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool far : {false, true}) {
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (std::size_t j = 0; j < n[v]; ++j)
                for (std::size_t i = 0; i < n[u]; ++i) {
                    auto corner = [&](std::size_t by_u, std::size_t by_v) {
                        std::array<std::size_t, 3> at{};
                        at[axis] = far ? n[axis] : 0;
                        at[u] = i + by_u;
                        at[v] = j + by_v;
                        return index.at(at);
                    };
                    const Index a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
                    triangles.push_back(far ? TriangleMesh::Triangle{a, b, c} : TriangleMesh::Triangle{a, c, b});
                    triangles.push_back(far ? TriangleMesh::Triangle{a, c, d} : TriangleMesh::Triangle{a, d, c});
                }
        }
    return {std::move(vertices), std::move(triangles)};
}

/// A ball: an octahedron, each of its triangles divided into four `divisions` times, the new vertices put onto the
/// sphere. It has 2 + 4^(divisions + 1) vertices and 8 4^divisions triangles, and with each vertex the opposite one.
/// Without a division it is the octahedron itself, of volume 4/3 r^3.
/// \param radius    m, finite and greater than zero; of the sphere on which all vertices lie
/// \param divisions 0 to 8
/// \param centre    m
/// \throws std::invalid_argument
inline TriangleMesh ball_mesh(const Quantity<unit::Length>& radius, int divisions = 3,
                              const TriangleMesh::Point& centre = TriangleMesh::Point::from_value({0, 0, 0})) {
    using Index = TriangleMesh::Index;
    require_positive("ball_mesh", "radius", radius);
    if (divisions < 0 || divisions > 8)
        refuse_value("ball_mesh", "divisions", std::to_string(divisions), "0 to 8 of them are made");
    std::vector<Vector<double, 3>> units{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<TriangleMesh::Triangle> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int d = 0; d < divisions; ++d) {
        std::map<TriangleMesh::Edge, Index> middles;
        auto middle = [&](Index a, Index b) {
            const auto [at, is_new] =
                middles.try_emplace(a < b ? TriangleMesh::Edge{a, b} : TriangleMesh::Edge{b, a}, Index(units.size()));
            if (is_new) units.push_back((units[a] + units[b]).normalized());
            return at->second;
        };
        std::vector<TriangleMesh::Triangle> finer;
        finer.reserve(4 * triangles.size());
        for (const auto& [a, b, c] : triangles) {
            const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const TriangleMesh::Triangle& t :
                 {TriangleMesh::Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
                finer.push_back(t);
        }
        triangles = std::move(finer);
    }
    std::vector<TriangleMesh::Point> vertices;
    vertices.reserve(units.size());
    for (const auto& direction : units)
        vertices.push_back(centre + TriangleMesh::Point::from_value(radius.value() * direction));
    return {std::move(vertices), std::move(triangles)};
}

} // namespace ansatz
