// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace ansatz;

namespace exercise {

using Corners = std::array<std::uint32_t, 3>; ///< of a triangle, vertices by number

struct Vertex {
    VectorQuantity<unit::Length, 3> place;
    VectorQuantity<unit::Velocity, 3> velocity;
    Quantity<unit::Mass> mass;
};
struct Sheet {
    std::vector<Vertex> vertices;
    std::vector<Corners> triangles; ///< those that are whole
};
/// A spring along an edge.
struct Edge {
    std::uint32_t first, second; ///< vertices by number
};
using Fan = std::vector<std::size_t>; ///< triangles by number

/// Which corner of a triangle a vertex is; 3 where it is none.
inline std::size_t corner_of(const Corners& triangle, std::uint32_t vertex) {
    return std::size_t(std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
}
inline Quantity<unit::Area> area(const Sheet& sheet, std::size_t triangle) {
    const auto& [a, b, c] = sheet.triangles[triangle];
    const auto& from = sheet.vertices[a].place;
    return 0.5 * norm(cross(sheet.vertices[b].place - from, sheet.vertices[c].place - from));
}

/// 4.9: the triangles around a vertex, in fans.
inline std::vector<Fan> fans(const std::vector<Corners>& triangles, std::uint32_t vertex) {
    return todo(1);
}

/// 4.9: gives each fan around a vertex but the first a vertex of its own.
/// \return the numbers of the new ones
inline std::vector<std::uint32_t> split(Sheet& sheet, std::uint32_t vertex) {
    return todo(2);
}

/// 4.9: lets springs go with the triangles.
/// \param before the triangles when the springs were joined, \param now the same behind all splits
inline void hand_on(std::vector<Edge>& springs, const std::vector<Corners>& before, const std::vector<Corners>& now) {
    todo(3);
}

} // namespace exercise
