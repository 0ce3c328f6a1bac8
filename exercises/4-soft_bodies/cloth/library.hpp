// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: the plan from which add_cloth builds.
#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/world.hpp>

#include <utility>
#include <vector>

namespace exercise {

struct Sheet {
    int columns, rows;
    ansatz::Quantity<ansatz::unit::Length> width, height;
};
using Springs = std::vector<std::pair<int, int>>;

inline ansatz::TriangleMesh mesh(const Sheet& sheet) {
    return ansatz::TriangleMesh::grid(std::size_t(sheet.columns), std::size_t(sheet.rows),
                                      ansatz::metres(sheet.width.value(), 0, 0),
                                      ansatz::metres(0, sheet.height.value(), 0));
}
inline ansatz::TriangleMesh::GridShape shape(const Sheet& sheet) {
    return {ansatz::TriangleMesh::Index(sheet.columns), ansatz::TriangleMesh::Index(sheet.rows)};
}
inline Springs springs(const ansatz::SoftPlan& plan) {
    Springs all;
    for (const auto& link : plan.links) all.emplace_back(int(link.a), int(link.b));
    return all;
}
inline const ansatz::SpringConstants any{1.0 * ansatz::newton_per_metre};

inline Springs along(const Sheet& sheet, int by) {
    ansatz::SoftPlan plan{};
    ansatz::detail::link_lines(plan, shape(sheet), std::uint32_t(by), any);
    return springs(plan);
}

inline Springs diagonals(const Sheet& sheet) {
    ansatz::SoftPlan plan{};
    ansatz::detail::link_diagonals(plan, shape(sheet), any);
    return springs(plan);
}

inline ansatz::Quantity<ansatz::unit::Length> rest_length(const Sheet& sheet, int a, int b) {
    const auto made = mesh(sheet);
    return ansatz::norm(made.vertices()[std::size_t(b)] - made.vertices()[std::size_t(a)]);
}

inline ansatz::Quantity<ansatz::unit::Mass> mass(const Sheet& sheet, int vertex,
                                                 ansatz::Quantity<ansatz::unit::AreaDensity> mass_per_area) {
    ansatz::SoftPlan plan{};
    ansatz::detail::add_vertices(plan, mesh(sheet), mass_per_area, ansatz::Lumping::by_area);
    return plan.bodies[std::size_t(vertex)].mass;
}

} // namespace exercise
