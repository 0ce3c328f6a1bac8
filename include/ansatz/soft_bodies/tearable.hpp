// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `TearableTriangle`: a triangle of a sheet that may be torn, as it is given to `World::add`, and the table in which
/// `Tearing` keeps them (soft_bodies/tearing.hpp). `add_cloth` adds one for each of a sheet's triangles, in a world
/// that tears. By itself such a triangle does nothing: springs, hinges and sails stand on the same bodies.

#include <ansatz/soft_bodies/constraint_force.hpp>
#include <ansatz/world/cache.hpp>
#include <ansatz/world/element_table.hpp>

#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ansatz {

/// A triangle of a sheet that may be torn: what `World::add` takes of a world with `Tearing`.
struct TearableTriangle {
    using element = TearableTriangle;   ///< marks it as one that World::add takes
    std::array<Handle, 3> corners = {}; ///< its bodies
};

/// A vertex that split.
struct SplitVertex {
    Handle from; ///< the body that it was, and still is on one side
    Handle to;   ///< the new one on another
};

/// What is kept of a triangle.
template <class S> struct TearableRow {
    std::array<BodyId, 3> corners;                  ///< its bodies
    typename S::template ScalarOf<unit::Area> area; ///< as it was added, m^2: its share of the mass
    bool torn = false;                              ///< whether it is

    /// Names what it consists of.
    static void fields(auto& self, auto&& field) {
        field("corners", self.corners);
        field("area", self.area);
        field("torn", self.torn);
    }
    /// Of a description.
    /// \throws std::invalid_argument where two corners are one, and where the triangle has no area
    static TearableRow from(const auto& asked, const TearableTriangle& triangle) {
        using std::sqrt;
        TearableRow row{};
        for (std::size_t i = 0; i < 3; ++i) row.corners[i] = asked.body(triangle.corners[i]);
        detail::check_corners(asked.where, row.corners);
        const auto x = [&](std::size_t i) { return asked.position(triangle.corners[i]).value(); };
        const Vector<typename S::Scalar, S::dimension> u = x(1) - x(0), v = x(2) - x(0);
        // Lagrange's identity: of any dimension.
        const auto squared = u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v);
        row.area = decltype(row.area)::from_value(squared > 0 ? sqrt(squared) / 2 : 0);
        require_positive(asked.where, "the area of the triangle", row.area);
        return row;
    }
    /// What it was made of.
    TearableTriangle describe(const auto& handle_of) const {
        return {{handle_of(corners[0]), handle_of(corners[1]), handle_of(corners[2])}};
    }
    /// Holds it against what a step relies on, whatever made it: a file, too.
    void check() const {
        detail::check_corners("a tearable triangle", corners);
        require_positive("a tearable triangle", "area", area);
    }
    /// Whether it has a corner.
    bool has(std::uint32_t body) const { return corner_of(body) < 3; }
    /// Which corner a body is; 3 where it is none.
    std::size_t corner_of(std::uint32_t body) const {
        return corners[0].id == body ? 0 : corners[1].id == body ? 1 : corners[2].id == body ? 2 : 3;
    }
};

namespace detail {
/// One corner of a triangle.
struct TriangleCorner {
    std::uint32_t body;     // by its id
    std::uint32_t triangle; // by its id
    friend auto operator<=>(const TriangleCorner&, const TriangleCorner&) = default;
};
/// Room for a tear.
template <class S> struct TearScratch {
    std::vector<TriangleCorner> corners;     // sorted by body, then by triangle
    std::vector<TearableRow<S>> before;      // the triangles before vertices split, by id
    std::vector<std::uint32_t> around, fans; // the triangles around a vertex, and to which fan each belongs
};
} // namespace detail

/// The triangles of a world.
/// \tparam Splits whether vertices split
template <class S, bool Splits> class TearTable : public ElementTable<S, TearableTriangle, TearableRow<S>> {
    using Base = ElementTable<S, TearableTriangle, TearableRow<S>>;

public:
    std::uint64_t split = 0;                 ///< bodies that vertices have become
    std::uint64_t waiting = 0;               ///< sides for which there was no room
    std::vector<SplitVertex> split_vertices; ///< in the last step

    detail::Cache<detail::TearScratch<S>> scratch; ///< no part of the value

    /// What is kept beside the triangles.
    static void fields(auto& self, auto&& field) {
        field("split", self.split);
        field("waiting", self.waiting);
    }
    /// Adds everything to a hash.
    void add_to(StateHash& hash) const {
        Base::add_to(hash);
        detail::hash_fields<true>(hash, *this);
    }
    /// Forgets what split in the step before.
    void begin_step() { split_vertices.clear(); }
    /// Room for all that may be torn in a step.
    void reserve_notes_of_step() {
        auto& room = scratch.value;
        room.corners.reserve(3 * this->ids());
        room.before.reserve(this->ids());
        room.around.reserve(this->ids());
        room.fans.reserve(this->ids());
    }
    /// How many bodies may come in a step; makes room to tell of them.
    std::size_t bodies_to_come(const auto& tearing)
        requires Splits
    {
        const auto room = std::size_t(tearing.room), made = std::size_t(split);
        const std::size_t left = room > made ? room - made : 0;
        split_vertices.reserve(left);
        return left;
    }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const TearTable& other) {
        Base::make_room_for(other);
        split_vertices.reserve(other.split_vertices.size());
    }
    /// A triangle exerts no force: no body hangs on it.
    static bool is_slack(std::uint32_t, const auto&) { return true; }
};

} // namespace ansatz
