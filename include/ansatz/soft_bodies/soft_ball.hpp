// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `add_soft_ball`: a ball of bodies on a sphere, one in its middle, and springs between them (notes 4).
///
/// Use it for what bounces, bulges and comes back. The skin is `ball_mesh` with springs along its edges and across
/// them, and a spoke runs from each of its vertices to the middle. The spokes hold the shape; what presses a vertex
/// beyond the middle turns the ball inside out there, so that they should be stiff enough for the loads to come. Or it
/// has a `filling` that holds the skin up from inside, in a world with `Pressure`: a balloon, a football. A ball with a
/// filling whose spokes do nothing has neither spokes nor a middle. For a box take soft_box.hpp, for a skin without
/// filling `add_cloth` of a closed mesh.

#include <ansatz/soft_bodies/closed_meshes.hpp>
#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/soft_bodies/enclosure.hpp>

namespace ansatz {

/// A soft ball, as it is given to `add_soft_ball`.
struct SoftBall {
    VectorParameter<unit::Length> centre = {};                         ///< m
    Parameter<unit::Length> radius = 0.0 * metre;                      ///< m, finite, greater than zero
    Parameter<unit::Density> density = 0.0 * kilogram_per_cubic_metre; ///< kg/m^3, finite, greater than zero
    int divisions = 2;               ///< of the octahedron, see ball_mesh: 2 makes 66 vertices and 3 makes 258
    SpringConstants structural = {}; ///< along the skin
    SpringConstants bend = {};       ///< across each edge of the skin, between the two opposite vertices
    SpringConstants spokes = {};     ///< from the vertices to the middle
    VectorParameter<unit::Velocity> velocity = {}; ///< m/s
    std::optional<Filling> filling = {};           ///< what is in the skin, in a world with Pressure

    /// Whether a body is built in its middle.
    bool has_middle() const { return spokes.act() || !filling; }
};

/// The parts of a soft ball in its world.
struct SoftBallParts {
    std::vector<Handle> bodies; ///< by vertex of `ball_mesh(radius, divisions, centre)`, and behind them the middle
    std::vector<SpringHandle> structural; ///< by the mesh's `edges()`
    std::vector<SpringHandle> bend;       ///< by the mesh's `inner_edges()`
    std::vector<SpringHandle> spokes;     ///< by vertex
    ElementHandle<Enclosure> enclosure;   ///< of the filling, if it has one
};

namespace detail {
/// The bodies of a ball with their masses.
inline void add_ball(SoftPlan& plan, const SoftBall& ball, const TriangleMesh& mesh) {
    for (const auto& x : mesh.vertices()) plan.bodies.push_back({.place = x, .mass = {}});
    const auto middle = std::uint32_t(plan.bodies.size());
    if (ball.has_middle()) plan.bodies.push_back({.place = ball.centre, .mass = {}});
    for (const auto& [a, b, c] : mesh.triangles()) {
        const Quantity<unit::Volume> volume =
            dot(mesh.vertices()[a] - ball.centre,
                cross(mesh.vertices()[b] - ball.centre, mesh.vertices()[c] - ball.centre)) /
            6.0;
        const Quantity<unit::Mass> share = ball.density * volume / (ball.has_middle() ? 4.0 : 3.0);
        for (const auto corner : {a, b, c}) plan.bodies[corner].mass += share;
        if (ball.has_middle()) plan.bodies[middle].mass += share;
    }
}
/// Whether a world keeps enclosures.
template <class... P>
inline constexpr bool keeps_enclosures = !std::is_void_v<typename KeeperOf<Enclosure, P...>::type>;
/// Checks a filling against a world, as a whole.
template <class... P>
void check_filling(std::string_view where, const World<P...>&, const std::optional<Filling>& filling) {
    using S = typename World<P...>::S;
    if (!filling) return;
    filling->check(where);
    if (!keeps_enclosures<P...>)
        refuse_value(where, "the filling", "given", "this world keeps none: add Pressure{} to its policies");
    S::convert("inside", filling->inside);
    S::convert("outside", filling->outside);
    S::convert("stiffness", filling->stiffness);
    S::convert("damping", filling->damping);
}
} // namespace detail

/// Adds a soft ball. Its mass is that of the polyhedron, not of the sphere: each of the tetrahedra between the middle
/// and a triangle gives a quarter of its own to each of its corners, so that the middle has a quarter of all. Where
/// there is no middle, a triangle's corners have a third each.
/// \param world of three dimensions, with Springs among its policies, and Pressure for a ball with a filling
/// \param ball  what is built
/// \param each  what each body is given beside its place, its velocity and its mass, e.g. `Sphere{0.02 * metre}`
/// \return the handles of all parts
/// \throws std::invalid_argument with name, value and unit; the world is then as it was
template <class... P, class... Property>
SoftBallParts add_soft_ball(World<P...>& world, const SoftBall& ball, const Property&... each) {
    static_assert(World<P...>::S::dimension == 3, "Ansatz: a soft ball is built in three dimensions; in a world of two "
                                                  "take add_cloth with a mesh in the plane");
    SoftPlan plan{.where = "add_soft_ball", .velocity = ball.velocity, .bodies = {}, .links = {}};
    plan.check("structural", ball.structural);
    plan.check("bend", ball.bend);
    plan.check("spokes'", ball.spokes);
    require_finite("add_soft_ball", "centre", ball.centre);
    require_positive("add_soft_ball", "radius", ball.radius);
    require_positive("add_soft_ball", "density", ball.density);
    const TriangleMesh mesh = ball_mesh(ball.radius, ball.divisions, ball.centre);
    detail::add_ball(plan, ball, mesh);
    detail::check_filling("add_soft_ball", world, ball.filling);
    detail::link_edges(plan, mesh, ball.structural);
    const std::size_t structural = plan.links.size();
    detail::link_across(plan, mesh, ball.bend);
    const std::size_t bend = plan.links.size() - structural;
    const auto middle = std::uint32_t(mesh.vertices().size());
    for (std::uint32_t v = 0; v < middle; ++v) plan.link(v, middle, ball.spokes);
    plan.template check<Spring>(world);
    if constexpr (detail::keeps_enclosures<P...>)
        if (ball.filling) { // in the scalar of the world its corners may coincide
            using S = typename World<P...>::S;
            const auto bodies = plan.template planned<S>();
            EnclosureRow<S>::from(bodies, Enclosure::of(bodies.handles, mesh, *ball.filling)).check();
        }
    SoftBallParts parts;
    std::vector<SpringHandle> springs;
    plan.template build<Spring>(world, parts.bodies, springs, each...);
    std::span<const SpringHandle> all = springs;
    parts.structural = detail::take_front(all, structural);
    parts.bend = detail::take_front(all, bend);
    parts.spokes = detail::take_front(all, all.size());
    if constexpr (detail::keeps_enclosures<P...>)
        if (ball.filling) parts.enclosure = world.add(Enclosure::of(parts.bodies, mesh, *ball.filling));
    return parts;
}

} // namespace ansatz
