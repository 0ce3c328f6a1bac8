// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `add_cloth`: a sheet of bodies and springs, from a grid or from any mesh of triangles (notes 4).
///
/// Use it for flags, curtains, sails, skin. In the world there are bodies and springs afterwards, and nothing else:
/// they are advanced, saved and removed like all others, by any integrator. Not for what is filled (soft_ball.hpp,
/// soft_box.hpp) and not for sheets that must not stretch: springs do.
///
/// | springs    | of a grid                                          | of another mesh        |
/// |------------|----------------------------------------------------|------------------------|
/// | structural | along its lines                                    | along each edge        |
/// | shear      | both diagonals of each cell                        | none: see bend         |
/// | bend       | along its lines, from a vertex to the next but one | across each inner edge |
///
/// Across an inner edge, between the two opposite vertices, a spring holds against shear and against folding alike, so
/// that a mesh gets one there, with the sum of both constants and the stricter of both limits. A kind without stiffness
/// and damping is not built.
///
/// In a world with `Bending` a sheet may have a `rigidity` D, too: a hinge on each inner edge, between triangles of
/// areas A_1 and A_2, with the stiffness \f$ D\,|\mathbf e|^2 / (A_1 + A_2) \f$. So a sheet that is rolled up along its
/// lines, or along the diagonals of its triangles, holds the energy of a plate, \f$ \tfrac12 D \kappa^2 \f$ for each
/// area; across those diagonals a mesh of triangles is stiffer than that.
///
/// In a world with `Springs<Breaking>` the springs of a kind have a limit, `.structural = {..., .breaks =
/// breaks_at(0.3)}`; in one with `Tearing`, too, each triangle is one that tears where a spring along it breaks.
///
/// Pins are fixed bodies. Dragged vertices are `moving` ones, which go where `set_velocity` and `set_position` send
/// them. A spring has its rest length from the places in which the bodies were put, in the scalar of the world: as
/// built no spring has any tension, to the last bit.
///
/// X. Provot, Deformation Constraints in a Mass-Spring Model to Describe Rigid Cloth Behaviour (1995), for the three
/// kinds.

#include <ansatz/soft_bodies/bending.hpp>
#include <ansatz/soft_bodies/plan.hpp>
#include <ansatz/soft_bodies/tearable.hpp>
#include <ansatz/soft_bodies/triangle_mesh.hpp>
#include <ansatz/soft_bodies/wind.hpp>

namespace ansatz {

/// A sheet, as it is given to `add_cloth`.
struct Cloth {
    TriangleMesh mesh;                                                          ///< its vertices and triangles, at rest
    Parameter<unit::AreaDensity> mass_per_area = 0.0 * kilogram / square_metre; ///< kg/m^2, finite, greater than zero
    SpringConstants structural = {};                                            ///< along it
    SpringConstants shear = {};                                                 ///< across its cells
    SpringConstants bend = {};                                                  ///< against folding
    std::vector<std::uint32_t> pins = {};                                       ///< vertices that become fixed bodies
    std::vector<std::uint32_t> dragged = {};               ///< vertices that become `moving` bodies
    VectorParameter<unit::Velocity> velocity = {};         ///< m/s, of those that are not held
    Lumping lumping = Lumping::by_area;                    ///< how the mass is shared out
    Parameter<unit::Energy> rigidity = 0.0 * joule;        ///< D, N m, of a plate: hinges, in a world with Bending
    Parameter<unit::Time> rigidity_damping = 0.0 * second; ///< damping of each hinge by its stiffness, s
    double drag = 0;                                       ///< c_D of each triangle: sails, in a world with Wind
    double lift = 0;                                       ///< c_L of each triangle
};

/// The parts of a sheet in its world.
struct ClothParts {
    std::vector<Handle> bodies;           ///< by vertex
    std::vector<SpringHandle> structural; ///< of a grid those along its first side, row by row, then along its second;
                                          ///< of another mesh by `edges()`
    std::vector<SpringHandle> shear;      ///< of a grid, cell by cell, the two from vertex (0, 0) and (1, 0) of each
    std::vector<SpringHandle> bend;       ///< of a grid as structural; of another mesh by `inner_edges()`
    std::vector<ElementHandle<Hinge>> hinges;              ///< of any mesh by `inner_edges()`
    std::vector<ElementHandle<Sail>> sails;                ///< by `triangles()`
    std::vector<ElementHandle<TearableTriangle>> tearable; ///< by `triangles()`, in a world with Tearing
};

namespace detail {

/// The springs of a grid along its lines, from each vertex to the one `step` further.
inline void link_lines(SoftPlan& plan, const TriangleMesh::GridShape& grid, std::uint32_t step,
                       const SpringConstants& constants) {
    for (std::uint32_t j = 0; j < grid.rows; ++j)
        for (std::uint32_t i = 0; i + step < grid.columns; ++i)
            plan.link(i + grid.columns * j, i + step + grid.columns * j, constants);
    for (std::uint32_t j = 0; j + step < grid.rows; ++j)
        for (std::uint32_t i = 0; i < grid.columns; ++i)
            plan.link(i + grid.columns * j, i + grid.columns * (j + step), constants);
}
/// Both diagonals of its cells.
inline void link_diagonals(SoftPlan& plan, const TriangleMesh::GridShape& grid, const SpringConstants& constants) {
    for (std::uint32_t j = 0; j + 1 < grid.rows; ++j)
        for (std::uint32_t i = 0; i + 1 < grid.columns; ++i) {
            const auto at = i + grid.columns * j;
            plan.link(at, at + grid.columns + 1, constants);
            plan.link(at + 1, at + grid.columns, constants);
        }
}
/// Of any mesh: along its edges.
inline void link_edges(SoftPlan& plan, const TriangleMesh& mesh, const SpringConstants& constants) {
    for (const auto& [a, b] : mesh.edges()) plan.link(a, b, constants);
}
/// Of any mesh: between the vertices opposite to its inner edges.
inline void link_across(SoftPlan& plan, const TriangleMesh& mesh, const SpringConstants& constants) {
    for (const auto& edge : mesh.inner_edges()) plan.link(edge.opposite[0], edge.opposite[1], constants);
}

/// The constants of springs that do the work of two kinds, and break where the first of both would; a kind that does
/// nothing has no say.
inline SpringConstants sum_of(const SpringConstants& one, const SpringConstants& other) {
    SpringConstants sum{one.stiffness + other.stiffness, one.damping + other.damping, {}};
    // What is no number stays, so that it is refused.
    const auto stricter = [](double a, double b) { return a != a || a < b ? a : b; };
    for (const SpringConstants* kind : {&one, &other}) {
        if (!kind->act()) continue;
        sum.breaks.force = stricter(sum.breaks.force.value(), kind->breaks.force.value()) * newton;
        sum.breaks.strain = stricter(sum.breaks.strain, kind->breaks.strain);
    }
    return sum;
}

/// The springs of one kind, taken off the front of all.
template <class Handle_> std::vector<Handle_> take_front(std::span<const Handle_>& all, std::size_t count) {
    const auto some = all.first(std::min(count, all.size()));
    all = all.subspan(some.size());
    return {some.begin(), some.end()};
}

/// Whether a world keeps hinges.
template <class... P> inline constexpr bool keeps_hinges = !std::is_void_v<typename KeeperOf<Hinge, P...>::type>;
/// The hinges of a sheet, without their bodies; none without a rigidity.
template <class S, bool Kept> std::vector<Hinge> hinges_of(std::string_view where, const Cloth& cloth) {
    std::vector<Hinge> hinges;
    require_not_negative(where, "rigidity", cloth.rigidity);
    require_not_negative(where, "rigidity damping", cloth.rigidity_damping);
    if (cloth.rigidity.value() == 0) return hinges;
    if (!Kept)
        refuse_value(where, "rigidity", cloth.rigidity, "this world keeps no hinges: add Bending{} to its policies");
    if (!cloth.mesh.is_oriented())
        refuse_value(where, "rigidity", cloth.rigidity,
                     "the mesh is not oriented, and an angle needs a side: all triangles must face the same one");
    for (const auto& edge : cloth.mesh.inner_edges()) {
        const auto along = cloth.mesh.vertices()[edge.ends[1]] - cloth.mesh.vertices()[edge.ends[0]];
        const Quantity<unit::Energy> k =
            cloth.rigidity *
            (dot(along, along) / (cloth.mesh.area(edge.triangles[0]) + cloth.mesh.area(edge.triangles[1])));
        S::convert("rigidity", k);
        S::convert("rigidity damping", Quantity<unit::AngularMomentum>(cloth.rigidity_damping * k));
        hinges.push_back({.stiffness = k, .damping = cloth.rigidity_damping * k, .rest = {}});
    }
    return hinges;
}
/// Puts the bodies of an edge to its hinge; the first wing is of the triangle in which the edge runs as it is named.
inline void join_hinge(Hinge& hinge, const TriangleMesh& mesh, const TriangleMesh::InnerEdge& edge,
                       std::span<const Handle> bodies) {
    const auto& t = mesh.triangles()[edge.triangles[0]];
    bool runs = false;
    for (std::size_t k = 0; k < 3; ++k) runs = runs || (t[k] == edge.ends[0] && t[(k + 1) % 3] == edge.ends[1]);
    hinge.edge = {bodies[edge.ends[0]], bodies[edge.ends[1]]};
    hinge.wings = {bodies[edge.opposite[runs ? 0 : 1]], bodies[edge.opposite[runs ? 1 : 0]]};
}
/// Refuses hinges that the places of a plan do not allow: in the scalar of the world corners may coincide.
template <class S> void check_hinges(const SoftPlan& plan, const TriangleMesh& mesh, std::vector<Hinge>& hinges) {
    const auto bodies = plan.planned<S>();
    for (std::size_t i = 0; i < hinges.size(); ++i) {
        join_hinge(hinges[i], mesh, mesh.inner_edges()[i], bodies.handles);
        HingeRow<S>::from(bodies, hinges[i]).check();
    }
}

/// Whether a world keeps sails, and whether a sheet has some: it has all of its triangles, or none.
template <class... P> inline constexpr bool keeps_sails = !std::is_void_v<typename KeeperOf<Sail, P...>::type>;
template <class S, bool Kept> bool has_sails(std::string_view where, const Cloth& cloth) {
    SailRow<S>::coefficient(where, "drag", cloth.drag);
    SailRow<S>::coefficient(where, "lift", cloth.lift);
    const bool has = cloth.drag != 0 || cloth.lift != 0;
    if (has && !Kept)
        refuse_value(where, cloth.drag != 0 ? "drag" : "lift", cloth.drag != 0 ? cloth.drag : cloth.lift,
                     "this world has no air: add Wind{} to its policies");
    return has;
}

/// Refuses triangles that may not tear: in the scalar of the world one may have no area.
template <class S> void check_tearable(const SoftPlan& plan, const TriangleMesh& mesh) {
    const auto bodies = plan.planned<S>();
    for (const auto& [a, b, c] : mesh.triangles())
        TearableRow<S>::from(bodies, TearableTriangle{{bodies.handles[a], bodies.handles[b], bodies.handles[c]}});
}

/// The bodies of a surface: where they are, and how heavy.
inline void add_vertices(SoftPlan& plan, const TriangleMesh& mesh, const Quantity<unit::AreaDensity>& mass_per_area,
                         Lumping lumping) {
    require_positive(plan.where, "mass per area", mass_per_area);
    const auto shares = mesh.vertex_areas();
    const auto equal = mesh.area() / double(shares.size());
    plan.bodies.reserve(shares.size());
    for (std::size_t v = 0; v < shares.size(); ++v)
        plan.bodies.push_back(
            {.place = mesh.vertices()[v], .mass = mass_per_area * (lumping == Lumping::equal ? equal : shares[v])});
}

} // namespace detail

/// Adds a sheet: a body for each vertex, then the springs, kind by kind.
/// \param world with Springs among its policies, Bending for a sheet with a rigidity, and Wind for one with a
///              drag or a lift
/// \param cloth what is built; in a world of two dimensions every z is 0
/// \param each  what each body is given beside its place, its velocity and its mass: a shape and its properties in a
///              world of collisions, e.g. `Sphere{0.02 * metre}`
/// \return the handles of all parts
/// \throws std::invalid_argument with name, index, value and unit; the world is then as it was
template <class... P, class... Property>
ClothParts add_cloth(World<P...>& world, const Cloth& cloth, const Property&... each) {
    SoftPlan plan{.where = "add_cloth", .velocity = cloth.velocity, .bodies = {}, .links = {}};
    plan.check("structural", cloth.structural);
    plan.check("shear", cloth.shear);
    plan.check("bend", cloth.bend);
    detail::add_vertices(plan, cloth.mesh, cloth.mass_per_area, cloth.lumping);
    plan.hold("pins", cloth.pins, Motion::fixed);
    plan.hold("dragged", cloth.dragged, Motion::moving);
    std::size_t structural = 0, shear = 0;
    if (const auto grid = cloth.mesh.grid_shape()) {
        detail::link_lines(plan, *grid, 1, cloth.structural);
        structural = plan.links.size();
        detail::link_diagonals(plan, *grid, cloth.shear);
        shear = plan.links.size() - structural;
        detail::link_lines(plan, *grid, 2, cloth.bend);
    } else {
        detail::link_edges(plan, cloth.mesh, cloth.structural);
        structural = plan.links.size();
        const auto across = detail::sum_of(cloth.shear, cloth.bend);
        plan.check("shear and bend", across);
        detail::link_across(plan, cloth.mesh, across);
    }
    constexpr bool kept = detail::keeps_hinges<P...>;
    auto hinges = detail::hinges_of<typename World<P...>::S, kept>(plan.where, cloth);
    constexpr bool in_air = detail::keeps_sails<P...>;
    const bool sails = detail::has_sails<typename World<P...>::S, in_air>(plan.where, cloth);
    constexpr bool tears = !std::is_void_v<typename detail::KeeperOf<TearableTriangle, P...>::type>;
    plan.template check<Spring>(world);
    if constexpr (tears) detail::check_tearable<typename World<P...>::S>(plan, cloth.mesh);
    if constexpr (kept) detail::check_hinges<typename World<P...>::S>(plan, cloth.mesh, hinges);
    ClothParts parts;
    std::vector<SpringHandle> springs;
    plan.template build<Spring>(world, parts.bodies, springs, each...);
    std::span<const SpringHandle> all = springs;
    parts.structural = detail::take_front(all, structural);
    parts.shear = detail::take_front(all, shear);
    parts.bend = detail::take_front(all, all.size());
    if constexpr (kept)
        for (std::size_t i = 0; i < hinges.size(); ++i) {
            detail::join_hinge(hinges[i], cloth.mesh, cloth.mesh.inner_edges()[i], parts.bodies);
            parts.hinges.push_back(world.add(hinges[i]));
        }
    if constexpr (in_air)
        for (const auto& [a, b, c] : cloth.mesh.triangles())
            if (sails)
                parts.sails.push_back(
                    world.add(Sail{{parts.bodies[a], parts.bodies[b], parts.bodies[c]}, cloth.drag, cloth.lift}));
    if constexpr (tears)
        for (const auto& [a, b, c] : cloth.mesh.triangles())
            parts.tearable.push_back(world.add(TearableTriangle{{parts.bodies[a], parts.bodies[b], parts.bodies[c]}}));
    return parts;
}

} // namespace ansatz
