// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: what its Tearing<Splitting> does in a step that is too short for anything
// else. It checks vertices where something has torn just now: at each a triangle is added that tears.
#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace exercise {

using Corners = std::array<std::uint32_t, 3>;
struct Vertex {
    ansatz::VectorQuantity<ansatz::unit::Length, 3> place;
    ansatz::VectorQuantity<ansatz::unit::Velocity, 3> velocity;
    ansatz::Quantity<ansatz::unit::Mass> mass;
};
struct Sheet {
    std::vector<Vertex> vertices;
    std::vector<Corners> triangles;
};
struct Edge {
    std::uint32_t first, second;
};
using Fan = std::vector<std::size_t>;

inline std::size_t corner_of(const Corners& triangle, std::uint32_t vertex) {
    return std::size_t(std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
}

/// A sheet in a world of its own.
class Torn {
public:
    /// \param edges that something has torn beside
    Torn(const Sheet& sheet, const std::vector<Edge>& springs, const std::vector<Edge>& edges) {
        using namespace ansatz;
        for (const auto& [place, v, m] : sheet.vertices)
            bodies_.push_back(world_.add(position(place), velocity(v), mass(m)));
        for (const auto& [a, b, c] : sheet.triangles)
            triangles_.push_back(world_.add(TearableTriangle{{bodies_[a], bodies_[b], bodies_[c]}}));
        for (const auto& [a, b] : springs)
            springs_.push_back(world_.add(Spring{.first = bodies_[a], .second = bodies_[b]}));
        for (const auto& [a, b] : edges) {
            const auto away = VectorQuantity<unit::Length, 3>::from_value(Eigen::Vector3d(0.3, 0.5, 0.7));
            const auto at = sheet.vertices[a].place + away;
            const auto other = world_.add(position(at), mass(1.0 * kilogram));
            auto third = bodies_[b];
            if (a == b) third = world_.add(position(at + metres(1, 0, 0)), mass(1.0 * kilogram));
            world_.add(TearableTriangle{{bodies_[a], third, other}});
            world_.add(Spring{.first = bodies_[a], .second = other, .rest_length = 0.1 * metre}, breaks_at(0.1));
        }
        world_.step(1e-30 * second);
        for (const auto& one : world_.split_vertices()) bodies_.push_back(one.to);
    }
    Corners corners(std::size_t triangle) const {
        const auto now = world_.get(triangles_[triangle]).corners;
        return {number(now[0]), number(now[1]), number(now[2])};
    }
    Edge spring(std::size_t which) const {
        const auto now = world_.get(springs_[which]);
        return {number(now.first), number(now.second)};
    }
    std::size_t vertices() const { return bodies_.size(); }
    Vertex vertex(std::size_t i) const {
        return {world_.position(bodies_[i]), world_.velocity(bodies_[i]), 1.0 / world_.inverse_mass(bodies_[i])};
    }

private:
    std::uint32_t number(const ansatz::SpringEnd& end) const { return number(end.body()); }
    std::uint32_t number(ansatz::Handle body) const {
        return std::uint32_t(std::find(bodies_.begin(), bodies_.end(), body) - bodies_.begin());
    }
    ansatz::World<ansatz::SemiImplicitEuler, ansatz::Springs<ansatz::Breaking>, ansatz::Tearing<ansatz::Splitting>>
        world_{ansatz::SemiImplicitEuler{}, ansatz::Springs<ansatz::Breaking>{},
               ansatz::Tearing<ansatz::Splitting>{.room = 100}};
    std::vector<ansatz::Handle> bodies_; // by vertex
    std::vector<ansatz::ElementHandle<ansatz::TearableTriangle>> triangles_;
    std::vector<ansatz::SpringHandle> springs_;
};

/// Vertices anywhere, no three of them in a line.
inline std::vector<Vertex> somewhere(std::size_t count) {
    std::vector<Vertex> all;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = double(i);
        all.push_back(
            {ansatz::metres(x, x * x, x * x * x), ansatz::metres_per_second(0, 0, 0), 1.0 * ansatz::kilogram});
    }
    return all;
}
inline std::size_t count_of(const std::vector<Corners>& triangles) {
    std::size_t count = 0;
    for (const auto& t : triangles)
        for (const std::size_t corner : t) count = std::max(count, corner + 1);
    return count;
}

inline std::vector<std::uint32_t> split(Sheet& sheet, std::uint32_t vertex) {
    const Torn torn(sheet, {}, {{vertex, vertex}});
    std::vector<std::uint32_t> added;
    for (std::size_t i = sheet.vertices.size(); i < torn.vertices(); ++i) {
        added.push_back(std::uint32_t(i));
        sheet.vertices.push_back(torn.vertex(i));
    }
    sheet.vertices[vertex] = torn.vertex(vertex);
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) sheet.triangles[t] = torn.corners(t);
    return added;
}

inline std::vector<Fan> fans(const std::vector<Corners>& triangles, std::uint32_t vertex) {
    Sheet sheet{somewhere(std::max<std::size_t>(count_of(triangles), vertex + 1)), triangles};
    const auto added = split(sheet, vertex);
    std::vector<Fan> all(1 + added.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto corner = corner_of(triangles[t], vertex);
        if (corner == 3) continue;
        const auto now = std::find(added.begin(), added.end(), sheet.triangles[t][corner]);
        all[now == added.end() ? 0 : std::size_t(now - added.begin()) + 1].push_back(t);
    }
    std::erase_if(all, [](const Fan& fan) { return fan.empty(); });
    return all;
}

inline void hand_on(std::vector<Edge>& springs, const std::vector<Corners>& before, const std::vector<Corners>& now) {
    auto count = count_of(before);
    for (const auto& [a, b] : springs) count = std::max<std::size_t>({count, a + 1, b + 1});
    std::vector<Edge> torn; // at each vertex that split, and beside each thread
    for (std::size_t t = 0; t < before.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (before[t][k] != now[t][k]) torn.push_back({before[t][k], before[t][k]});
    for (const auto& [a, b] : springs)
        if (std::none_of(before.begin(), before.end(),
                         [&](const Corners& t) { return corner_of(t, a) < 3 && corner_of(t, b) < 3; }))
            torn.push_back({a, b});
    const Torn world({somewhere(count), before}, springs, torn);
    std::vector<std::uint32_t> numbers(world.vertices()); // here, by those of the world
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = std::uint32_t(i);
    for (std::size_t t = 0; t < before.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) numbers[world.corners(t)[k]] = now[t][k];
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const auto [a, b] = world.spring(i);
        springs[i] = {numbers[a], numbers[b]};
    }
}

} // namespace exercise
