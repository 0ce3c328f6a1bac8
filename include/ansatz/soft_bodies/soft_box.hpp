// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `add_soft_box`: a box as a lattice of bodies and springs, in its inside as on its surface (notes 4).
///
/// Use it for jelly, beams, rubber, whatever is filled and keeps its shape. The lattice costs more than a skin and
/// does not fall in. For a sheet take cloth.hpp, for a ball soft_ball.hpp.
///
/// | springs    | where                                                          |
/// |------------|----------------------------------------------------------------|
/// | structural | along the lattice's lines                                      |
/// | shear      | all diagonals: two of each face, and four through each cell    |
/// | bend       | along the lattice's lines, from each body to the next but one  |

#include <ansatz/soft_bodies/cloth.hpp>

namespace ansatz {

/// A soft box, as it is given to `add_soft_box`.
struct SoftBox {
    VectorParameter<unit::Length> centre = {};      ///< m
    VectorParameter<unit::Length> size = {};        ///< its sides along the axes, m, greater than zero
    std::array<std::uint32_t, 3> cells = {1, 1, 1}; ///< along x, y and z, at least 1 each
    Parameter<unit::Density> density = 0.0 * kilogram_per_cubic_metre; ///< kg/m^3, finite, greater than zero
    SpringConstants structural = {};                                   ///< along its lines
    SpringConstants shear = {};                                        ///< along its diagonals
    SpringConstants bend = {};                                         ///< along its lines, over one body
    std::vector<std::uint32_t> pins = {};                              ///< bodies that become fixed ones
    std::vector<std::uint32_t> dragged = {};                           ///< bodies that become `moving` ones
    VectorParameter<unit::Velocity> velocity = {};                     ///< m/s, of those that are not held

    /// The number of the body at (i, j, k) of the lattice: i + (nx + 1) (j + (ny + 1) k).
    std::uint32_t at(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
        return i + (cells[0] + 1) * (j + (cells[1] + 1) * k);
    }
};

/// The parts of a soft box in its world.
struct SoftBoxParts {
    std::vector<Handle> bodies;           ///< by `SoftBox::at`: x fastest, z slowest
    std::vector<SpringHandle> structural; ///< along x by body, then along y, then along z
    std::vector<SpringHandle> shear; ///< the faces' by normal (z, x, y) and body, then those through the cells by body
    std::vector<SpringHandle> bend;  ///< as structural
};

namespace detail {

/// The springs of a lattice from each body to the one that lies this many further, if there is one.
inline void link_lattice(SoftPlan& plan, const SoftBox& box, const std::array<int, 3>& by,
                         const SpringConstants& constants) {
    const std::array<int, 3> n{int(box.cells[0]), int(box.cells[1]), int(box.cells[2])};
    auto inside = [&](int at, int axis) { return at >= 0 && at <= n[std::size_t(axis)]; };
    for (int k = 0; k <= n[2]; ++k)
        for (int j = 0; j <= n[1]; ++j)
            for (int i = 0; i <= n[0]; ++i)
                if (inside(i + by[0], 0) && inside(j + by[1], 1) && inside(k + by[2], 2))
                    plan.link(box.at(std::uint32_t(i), std::uint32_t(j), std::uint32_t(k)),
                              box.at(std::uint32_t(i + by[0]), std::uint32_t(j + by[1]), std::uint32_t(k + by[2])),
                              constants);
}

/// The bodies of a box: a cell gives an eighth of its mass to each of its corners.
inline void add_lattice(SoftPlan& plan, const SoftBox& box) {
    require_finite(plan.where, "centre", box.centre);
    require_positive(plan.where, "density", box.density);
    std::size_t bodies = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string_view letter = std::string_view("xyz").substr(axis, 1);
        require_positive(plan.where, joined({"size along ", letter}), component(box.size, int(axis)));
        if (box.cells[axis] < 1 || box.cells[axis] > 1000)
            refuse_value(plan.where, joined({"the number of cells along ", letter}), std::to_string(box.cells[axis]),
                         "it is at least 1, and 1000 at most");
        bodies *= box.cells[axis] + 1;
    }
    const auto& [nx, ny, nz] = box.cells;
    const Quantity<unit::Mass> of_cell =
        box.density * (component(box.size, 0) * component(box.size, 1) * component(box.size, 2) /
                       (double(nx) * double(ny) * double(nz)));
    plan.bodies.reserve(bodies);
    for (std::uint32_t k = 0; k <= nz; ++k)
        for (std::uint32_t j = 0; j <= ny; ++j)
            for (std::uint32_t i = 0; i <= nx; ++i) {
                const Vector<double, 3> part(double(i) / nx - 0.5, double(j) / ny - 0.5, double(k) / nz - 0.5);
                double share = 1;
                for (const bool border : {i == 0 || i == nx, j == 0 || j == ny, k == 0 || k == nz})
                    if (border) share /= 2;
                plan.bodies.push_back({.place = box.centre + VectorQuantity<unit::Length>::from_value(
                                                                 part.cwiseProduct(box.size.value())),
                                       .mass = share * of_cell});
            }
}

} // namespace detail

/// Adds a soft box: a body for each point of its lattice, then the springs, kind by kind.
/// \param world of three dimensions, with Springs among its policies
/// \param box   what is built
/// \param each  what each body is given beside its place, its velocity and its mass, e.g. `Sphere{0.02 * metre}`
/// \return the handles of all parts
/// \throws std::invalid_argument with name, index, value and unit; the world is then as it was
template <class... P, class... Property>
SoftBoxParts add_soft_box(World<P...>& world, const SoftBox& box, const Property&... each) {
    static_assert(World<P...>::S::dimension == 3, "Ansatz: a soft box is built in three dimensions; in a world of two "
                                                  "take add_cloth with a grid in the plane");
    SoftPlan plan{.where = "add_soft_box", .vertex = "body", .velocity = box.velocity, .bodies = {}, .links = {}};
    plan.check("structural", box.structural);
    plan.check("shear", box.shear);
    plan.check("bend", box.bend);
    detail::add_lattice(plan, box);
    plan.hold("pins", box.pins, Motion::fixed);
    plan.hold("dragged", box.dragged, Motion::moving);
    using Steps = std::array<int, 3>;
    for (const Steps& by : {Steps{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) detail::link_lattice(plan, box, by, box.structural);
    const std::size_t structural = plan.links.size();
    for (const Steps& by : {Steps{1, 1, 0}, {-1, 1, 0}, {0, 1, 1}, {0, -1, 1}, {1, 0, 1}, {-1, 0, 1}})
        detail::link_lattice(plan, box, by, box.shear);
    for (const Steps& by : {Steps{1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {-1, -1, 1}})
        detail::link_lattice(plan, box, by, box.shear);
    const std::size_t shear = plan.links.size() - structural;
    for (const Steps& by : {Steps{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}) detail::link_lattice(plan, box, by, box.bend);
    plan.template check<Spring>(world);
    SoftBoxParts parts;
    std::vector<SpringHandle> springs;
    plan.template build<Spring>(world, parts.bodies, springs, each...);
    std::span<const SpringHandle> all = springs;
    parts.structural = detail::take_front(all, structural);
    parts.shear = detail::take_front(all, shear);
    parts.bend = detail::take_front(all, all.size());
    return parts;
}

} // namespace ansatz
