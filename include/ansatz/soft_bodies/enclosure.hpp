// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Enclosure`: a closed surface of bodies with something in it, as it is given to a world with `Pressure`; and
/// `Filling`, the law of what is in it.
///
/// A filling is a gas, or something that resists a change of its volume, or both:
///
/// \f[ p(V) = p_0 \frac{V_0}{V} - p_a + K \Bigl(1 - \frac{V}{V_0}\Bigr) - \eta \frac{\dot V}{V_0} \f]
///
/// | symbol | meaning                                                          | unit |
/// |--------|------------------------------------------------------------------|------|
/// | p      | by how much more the inside presses on the surface than the outside | Pa   |
/// | V, V_0 | the volume, and that of the filling as it was filled in           | m^3  |
/// | p_0    | `inside`: the pressure of a gas at V_0; p V stays the same        | Pa   |
/// | p_a    | `outside`: the pressure around it                                 | Pa   |
/// | K      | `stiffness`, the bulk modulus                                     | Pa   |
/// | eta    | `damping`, a viscosity of the volume                              | Pa s |
///
/// A gas that is pressed to less than a hundredth of V_0, or turned inside out, presses on along the tangent at that
/// point: it stays finite, and finds its way out again.

#include <ansatz/soft_bodies/triangle_mesh.hpp>
#include <ansatz/world/element_table.hpp>
#include <ansatz/world/space.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ansatz {

/// What is in a closed surface: a gas, something that resists a change of its volume, or both.
struct Filling {
    Parameter<unit::Pressure> inside = 0.0 * pascal;          ///< of a gas at the volume as filled, Pa, not negative
    Parameter<unit::Pressure> outside = 0.0 * pascal;         ///< around it, Pa, not negative
    Parameter<unit::Pressure> stiffness = 0.0 * pascal;       ///< bulk modulus, Pa, not negative
    Parameter<unit::Viscosity> damping = 0.0 * pascal_second; ///< of the volume, Pa s, not negative

    /// \throws std::invalid_argument for what is not finite or negative, and where neither a gas nor a stiffness is in it
    void check(std::string_view where) const {
        require_not_negative(where, "inside", inside);
        require_not_negative(where, "outside", outside);
        require_not_negative(where, "stiffness", stiffness);
        require_not_negative(where, "damping", damping);
        if (inside.value() == 0 && stiffness.value() == 0)
            refuse_value(where, "inside", inside,
                         "a filling is a gas or is stiff: give it a pressure inside, a stiffness, or both");
    }
};

/// A closed surface between bodies, and its filling: what `World::add` takes of a world with `Pressure`.
struct Enclosure {
    using element = Enclosure;                     ///< marks it as one that World::add takes
    std::vector<Handle> bodies;                    ///< by vertex
    std::vector<TriangleMesh::Triangle> triangles; ///< their vertices, anticlockwise as seen from outside
    Filling filling;                               ///< the law of its pressure
    std::optional<Parameter<unit::Volume>> volume; ///< V_0, m^3, greater than zero; without it the one that it has

    /// Of the bodies that were built of a closed mesh, vertex by vertex: those of `add_cloth`, `add_soft_ball`.
    static Enclosure of(std::span<const Handle> bodies, const TriangleMesh& mesh, const Filling& filling) {
        const auto used = bodies.first(std::min(bodies.size(), mesh.vertices().size()));
        return {{used.begin(), used.end()}, {mesh.triangles().begin(), mesh.triangles().end()}, filling, {}};
    }
};

namespace detail {

/// The law of a filling in numbers of SI.
template <class Scalar> struct FillingLaw {
    Scalar inside, outside, stiffness, volume;

    /// Below this the law goes on along its tangent, m^3.
    Scalar least() const { return volume / 100; }
    /// Of the gas and the stiffness at a volume, Pa.
    Scalar excess(Scalar v) const {
        const Scalar at = std::max(v, least()), gas = inside * (volume / at);
        return gas + gas / at * (at - v) - outside + stiffness * (1 - v / volume);
    }
    /// -dp/dV, Pa/m^3; never negative.
    Scalar slope(Scalar v) const {
        const Scalar at = std::max(v, least());
        return inside * (volume / at) / at + stiffness / volume;
    }
    /// J, zero at V_0.
    Scalar energy(Scalar v) const {
        using std::log;
        const Scalar at = std::max(v, least()), more = at - v, gas = inside * (volume / at);
        return gas * more + gas / at * more * more / 2 - inside * volume * log(at / volume) + outside * (v - volume) +
               stiffness / volume * (v - volume) * (v - volume) / 2;
    }
};

/// Refuses what is no closed surface that faces outwards; `count` vertices are there.
inline void check_closed(std::string_view where, std::span<const std::uint32_t> corners, std::size_t count) {
    const auto named = [&](std::size_t t) { return joined({"triangle ", std::to_string(t)}); };
    const auto edge = [](std::uint32_t a, std::uint32_t b) {
        return joined({"{", std::to_string(a), ", ", std::to_string(b), "}"});
    };
    if (corners.size() < 12 || corners.size() % 3 != 0)
        refuse_value(where, "the number of triangles", std::to_string(corners.size() / 3),
                     "a closed surface has at least 4");
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
    std::vector<bool> used(count);
    for (std::size_t t = 0; 3 * t < corners.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = corners[3 * t + k], b = corners[3 * t + (k + 1) % 3];
            if (a >= count)
                refuse_value(where, named(t), joined({"of vertex ", std::to_string(a)}),
                             joined({"there are ", std::to_string(count), " of them, from 0"}));
            if (a == b) refuse_value(where, named(t), joined({"of ", edge(a, b)}), "its vertices are three different");
            used[a] = true;
            sides.emplace_back(a, b);
        }
    std::sort(sides.begin(), sides.end());
    const auto twice = std::adjacent_find(sides.begin(), sides.end());
    if (twice != sides.end())
        refuse_value(where, joined({"the side ", edge(twice->first, twice->second)}), "there twice",
                     "each edge of a closed surface is a side of two triangles, of which one runs along it one way and "
                     "one the other");
    for (const auto& [a, b] : sides)
        if (!std::binary_search(sides.begin(), sides.end(), std::pair(b, a)))
            refuse_value(where, joined({"the edge ", edge(a, b)}), "a side of one triangle",
                         "the surface is open there; only a closed one encloses a volume");
    const auto lone = std::find(used.begin(), used.end(), false);
    if (lone != used.end())
        refuse_value(where, joined({"vertex ", std::to_string(lone - used.begin())}), "in no triangle",
                     "each belongs to the surface");
}

} // namespace detail

/// What is kept of an enclosure.
template <class S> struct EnclosureRow {
    using Scalar = typename S::Scalar;
    std::vector<BodyId> bodies;                                ///< by vertex
    std::vector<std::uint32_t> corners;                        ///< of its triangles, by vertex, three each
    typename S::template ScalarOf<unit::Pressure> inside{};    ///< Pa
    typename S::template ScalarOf<unit::Pressure> outside{};   ///< Pa
    typename S::template ScalarOf<unit::Pressure> stiffness{}; ///< Pa
    typename S::template ScalarOf<unit::Viscosity> damping{};  ///< Pa s
    typename S::template ScalarOf<unit::Volume> volume{};      ///< V_0, m^3

    /// Names what it consists of.
    static void fields(auto& self, auto&& field) {
        field("bodies", self.bodies);
        field("corners", self.corners);
        field("inside", self.inside);
        field("outside", self.outside);
        field("stiffness", self.stiffness);
        field("damping", self.damping);
        field("volume", self.volume);
    }
    /// Of a description.
    /// \throws std::invalid_argument for a surface that is not closed, faces inwards or has a triangle without an area
    static EnclosureRow from(const auto& asked, const Enclosure& e) {
        EnclosureRow row;
        e.filling.check(asked.where);
        std::vector<TriangleMesh::Point> places;
        for (const Handle& h : e.bodies) {
            row.bodies.push_back(asked.body(h));
            Vector<double, 3> x = Vector<double, 3>::Zero();
            for (int k = 0; k < S::dimension; ++k) x[k] = static_cast<double>(asked.position(h).value()[k]);
            places.push_back(TriangleMesh::Point::from_value(x));
        }
        row.check_bodies(asked.where);
        const TriangleMesh mesh(std::move(places), e.triangles); // its sentences say what is no surface
        for (const auto& t : e.triangles) row.corners.insert(row.corners.end(), t.begin(), t.end());
        detail::check_closed(asked.where, row.corners, row.bodies.size());
        const auto has = mesh.volume();
        if (!(has.value() > 0))
            refuse_value(asked.where, "the enclosed volume", has,
                         "it is greater than zero: the triangles run anticlockwise as seen from outside");
        if (e.volume) require_positive(asked.where, "volume", *e.volume);
        row.inside = S::convert("inside", e.filling.inside);
        row.outside = S::convert("outside", e.filling.outside);
        row.stiffness = S::convert("stiffness", e.filling.stiffness);
        row.damping = S::convert("damping", e.filling.damping);
        row.volume = e.volume ? S::convert("volume", *e.volume) : S::convert("volume", has);
        return row;
    }
    /// What it was made of.
    Enclosure describe(const auto& handle_of) const {
        Enclosure e;
        for (const BodyId& body : bodies) e.bodies.push_back(handle_of(body));
        for (std::size_t t = 0; t < corners.size(); t += 3)
            e.triangles.push_back({corners[t], corners[t + 1], corners[t + 2]});
        e.filling = {scalar_cast<double>(inside), scalar_cast<double>(outside), scalar_cast<double>(stiffness),
                     scalar_cast<double>(damping)};
        e.volume = scalar_cast<double>(volume);
        return e;
    }
    /// Holds it against what a step relies on, whatever made it: a file, too.
    void check() const {
        const std::string_view where = "an enclosure";
        require_not_negative(where, "inside", inside);
        require_not_negative(where, "outside", outside);
        require_not_negative(where, "stiffness", stiffness);
        require_not_negative(where, "damping", damping);
        require_positive(where, "volume", volume);
        if (!(law().slope(volume.value()) > Scalar(0)))
            refuse_value(where, "stiffness", stiffness, "a filling is a gas or is stiff");
        if (!is_finite(law().slope(Scalar(0))) || !is_finite(damping / volume))
            refuse_value(
                where, "volume", volume,
                "the filling resists a change of it by more than the world's scalar can hold: give it more, or "
                "less pressure, stiffness and damping");
        if (!is_finite(law().excess(volume.value()) / law().slope(volume.value())))
            refuse_value(where, "inside", inside,
                         "so thin a gas balances what is outside at a volume that the world's scalar cannot hold");
        check_bodies(where);
        detail::check_closed(where, corners, bodies.size());
    }
    /// The law of its pressure.
    detail::FillingLaw<Scalar> law() const {
        return {inside.value(), outside.value(), stiffness.value(), volume.value()};
    }
    /// Calls `f(a, b, c, twice the area vector)` for each triangle, by vertex; m^2.
    /// \param at where a vertex is, m
    template <class At, class F> [[gnu::always_inline]] void each_triangle(const At& at, F&& f) const {
        for (std::size_t t = 0; t < corners.size(); t += 3) {
            const auto a = corners[t], b = corners[t + 1], c = corners[t + 2];
            const Vector<Scalar, 3> from = at(a), u = at(b) - from, v = at(c) - from;
            f(a, b, c, Vector<Scalar, 3>(u.cross(v)));
        }
    }
    /// The volume, m^3, from the places of the vertices alone: far from the origin no digit is lost.
    template <class At> Scalar volume_at(const At& at) const {
        const Vector<Scalar, 3> from = at(0);
        Scalar sum(0);
        each_triangle(at, [&](std::uint32_t a, std::uint32_t, std::uint32_t, const Vector<Scalar, 3>& twice) {
            sum += (at(a) - from).dot(twice);
        });
        return sum / 6;
    }
    /// The gradients of the volume by `into.size()` vertices from `first` on, m^2.
    template <class At> void gradients(const At& at, std::size_t first, std::span<Vector<Scalar, 3>> into) const {
        for (auto& one : into) one.setZero();
        each_triangle(at, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vector<Scalar, 3>& twice) {
            for (const std::size_t vertex : {a, b, c})
                if (vertex - first < into.size()) into[vertex - first] += twice / 6;
        });
    }

private:
    void check_bodies(std::string_view where) const {
        std::vector<std::uint32_t> ids;
        ids.reserve(bodies.size());
        for (const BodyId& body : bodies) ids.push_back(body.id);
        std::sort(ids.begin(), ids.end());
        const auto twice = std::adjacent_find(ids.begin(), ids.end());
        if (twice != ids.end())
            refuse_value(where, detail::joined({"the number of vertices of body ", std::to_string(*twice)}), "2",
                         "each vertex is a body of its own");
        if (!ids.empty() && BodyId{ids.back()} == BodyId())
            refuse_value(where, "one of its vertices", "nobody", "each vertex is a body");
    }
};

} // namespace ansatz
