// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `add_rope`: a chain of bodies between two points, joined by ropes (notes 4).
///
/// Use it for ropes, reins, bridges of one line. Its links are of the kind `Rope`, which never push, so that it folds
/// up when its ends come together; the world has Ropes among its policies, and `Ropes<Breaking>` where it may break.
/// Nothing of it remains but bodies and ropes. Not for what resists bending: there is nothing in it that does.
///
/// N links of stiffness k in a row are as stiff as one of k/N.

#include <ansatz/soft_bodies/plan.hpp>

namespace ansatz {

/// A rope of several bodies, as it is given to `add_rope`.
struct SoftRope {
    VectorParameter<unit::Length> from = {}; ///< where body 0 is, m
    VectorParameter<unit::Length> to = {};   ///< where the last is, m; it is as long as that is far
    std::size_t bodies = 2;                  ///< how many, both ends included: at least 2
    Parameter<unit::LineDensity> mass_per_length = 0.0 * kilogram_per_metre; ///< kg/m, finite, greater than zero
    SpringConstants links = {};                                              ///< of each link, N/m and N s/m
    std::vector<std::uint32_t> pins = {};                                    ///< bodies that become fixed ones
    std::vector<std::uint32_t> dragged = {};                                 ///< bodies that become `moving` ones
    VectorParameter<unit::Velocity> velocity = {};                           ///< m/s, of those that are not held
};

/// The parts of a rope in its world.
struct SoftRopeParts {
    std::vector<Handle> bodies;    ///< from its first end to its last
    std::vector<RopeHandle> links; ///< link i joins bodies i and i + 1
};

/// Adds a rope: its bodies, then its links. A link's mass is shared by its ends, so that the first and the last body
/// have half of the others' mass.
/// \param world with Ropes among its policies
/// \param rope  what is built; in a world of two dimensions every z is 0
/// \param each  what each body is given beside its place, its velocity and its mass, e.g. `Sphere{0.02 * metre}`
/// \return the handles of all parts
/// \throws std::invalid_argument with name, index, value and unit; the world is then as it was
template <class... P, class... Property>
SoftRopeParts add_rope(World<P...>& world, const SoftRope& rope, const Property&... each) {
    SoftPlan plan{.where = "add_rope", .vertex = "body", .velocity = rope.velocity, .bodies = {}, .links = {}};
    plan.check("links'", rope.links);
    require_finite("add_rope", "from", rope.from);
    require_finite("add_rope", "to", rope.to);
    require_positive("add_rope", "mass per length", rope.mass_per_length);
    const Quantity<unit::Length> length = norm(rope.to - rope.from);
    if (!is_finite(length) || !(length.value() > 0))
        refuse_value("add_rope", "the distance of from and to", length, "it is finite and greater than zero");
    if (rope.bodies < 2 || rope.bodies > 0x7fffffff)
        refuse_value("add_rope", "bodies", std::to_string(rope.bodies), "a rope has at least 2, and 2^31 - 1 at most");
    const double links = double(rope.bodies - 1);
    const Quantity<unit::Mass> of_link = rope.mass_per_length * length / links;
    plan.bodies.reserve(rope.bodies);
    for (std::size_t i = 0; i < rope.bodies; ++i) {
        const double part = double(i) / links;
        const bool is_end = i == 0 || i + 1 == rope.bodies;
        // Weighted, and not from + part (to - from), so that both ends are where they were put to the last bit.
        plan.bodies.push_back(
            {.place = (1 - part) * rope.from + part * rope.to, .mass = is_end ? 0.5 * of_link : of_link});
    }
    plan.hold("pins", rope.pins, Motion::fixed);
    plan.hold("dragged", rope.dragged, Motion::moving);
    for (std::uint32_t i = 0; i + 1 < rope.bodies; ++i) plan.link(i, i + 1, rope.links);
    plan.template check<Rope>(world);
    SoftRopeParts parts;
    plan.template build<Rope>(world, parts.bodies, parts.links, each...);
    return parts;
}

} // namespace ansatz
