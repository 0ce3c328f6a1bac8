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
    // task 1: return todo(1);
    std::vector<Fan> all;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (corner_of(triangles[t], vertex) == 3) continue;
        Fan joined{t};
        std::vector<Fan> others;
        for (const Fan& fan : all) {
            bool hangs = false;
            for (const std::size_t u : fan)
                for (const std::uint32_t corner : triangles[t])
                    hangs = hangs || (corner != vertex && corner_of(triangles[u], corner) < 3);
            if (hangs) joined.insert(joined.end(), fan.begin(), fan.end());
            else others.push_back(fan);
        }
        std::sort(joined.begin(), joined.end());
        others.push_back(joined);
        all = others;
    }
    std::sort(all.begin(), all.end());
    return all;
    // end of task 1
}

/// 4.9: gives each fan around a vertex but the first a vertex of its own.
/// \return the numbers of the new ones
inline std::vector<std::uint32_t> split(Sheet& sheet, std::uint32_t vertex) {
    // task 2: return todo(2);
    const auto all = fans(sheet.triangles, vertex);
    std::vector<Quantity<unit::Area>> areas(all.size(), 0.0 * square_metre);
    auto total = 0.0 * square_metre;
    for (std::size_t f = 0; f < all.size(); ++f)
        for (const std::size_t t : all[f]) {
            areas[f] += area(sheet, t);
            total += area(sheet, t);
        }
    std::vector<std::uint32_t> added;
    const auto mass = sheet.vertices[vertex].mass;
    for (std::size_t f = 1; f < all.size(); ++f) {
        Vertex part = sheet.vertices[vertex];
        part.mass = mass * (areas[f] / total);
        sheet.vertices[vertex].mass -= part.mass;
        const auto number = std::uint32_t(sheet.vertices.size());
        for (const std::size_t t : all[f]) sheet.triangles[t][corner_of(sheet.triangles[t], vertex)] = number;
        sheet.vertices.push_back(part);
        added.push_back(number);
    }
    return added;
    // end of task 2
}

/// 4.9: lets springs go with the triangles.
/// \param before the triangles when the springs were joined, \param now the same behind all splits
inline void hand_on(std::vector<Edge>& springs, const std::vector<Corners>& before, const std::vector<Corners>& now) {
    // task 3: todo(3);
    for (auto& [first, second] : springs)
        for (std::size_t t = 0; t < before.size(); ++t) {
            const auto i = corner_of(before[t], first), j = corner_of(before[t], second);
            if (i == 3 || j == 3) continue;
            first = now[t][i];
            second = now[t][j];
            break;
        }
    // end of task 3
}

} // namespace exercise
