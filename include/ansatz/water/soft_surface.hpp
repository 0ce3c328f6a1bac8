// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `add_soft_surface`: the surface of water as a soft body (notes 7.4), a net of the bodies and springs of chapters 3
/// and 4 that is held at its level, on which things sink, float or bounce.
///
/// Use it where few things meet a surface that shall give way, swing and throw back: a puddle, slime, a trampoline of
/// water. In the world there are bodies and springs afterwards, which are advanced, saved and removed like all others,
/// by any integrator. What lies on it is told with `SurfaceContacts` (surface_contacts.hpp). Not for a sea: a column
/// of WaterColumns costs a twentieth of a body with its springs, and not where water flows, since a net only gives way.
///
/// Over each column of a grid there is a body. A spring holds it at its level with what the water weighs, springs to
/// its neighbours are drawn, and the border hangs on a frame:
///
/// \f[ m = \sigma A, \qquad k_{level} = \rho g A, \qquad k_x = T\,\frac{\Delta z}{\Delta x}, \qquad k_z = T\,\frac{\Delta x}{\Delta z},
///     \qquad c_{level} = \gamma m \f]
///
/// | symbol | meaning                                                                  | unit   |
/// |--------|--------------------------------------------------------------------------|--------|
/// | A      | footprint of a column, its widths are dx and dz                          | m^2    |
/// | rho, g | `density`, and the downward part of the world's gravity as it is built   | kg/m^3, m/s^2 |
/// | sigma  | `mass_per_area`: the water that moves along                              | kg/m^2 |
/// | T      | `tension`: waves that are short run at sqrt(T / sigma)                   | N/m    |
/// | gamma  | `damping`                                                                | 1/s    |
///
/// So what presses the surface down by a volume V is carried with \f$ \rho g V \f$, as Archimedes says. All springs have the rest
/// length 0, which makes the net linear: its modes swing with \f$ \sigma \omega^2 = \rho g + T \kappa^2 \f$, of
/// \f$ \kappa^2 = \frac4{\Delta x^2} \sin^2 \frac{p \pi}{2 (n_x + 1)} + \frac4{\Delta z^2} \sin^2 \frac{q \pi}{2 (n_z + 1)} \f$.
/// Each spring at the level ends above it by sigma / rho, so that the net's own weight rests where it is built.

#include <ansatz/motion/gravity.hpp>
#include <ansatz/soft_bodies/plan.hpp>
#include <ansatz/water/column_grid.hpp>

#include <concepts>
#include <vector>

namespace ansatz {

/// A surface of bodies and springs, as it is given to `add_soft_surface`.
struct SoftSurface {
    ColumnGrid grid;                                                            ///< columns that are all alike
    Parameter<unit::Length> level = 0.0 * metre;                                ///< of the surface at rest, m
    Parameter<unit::AreaDensity> mass_per_area = 0.0 * kilogram / square_metre; ///< sigma, kg/m^2, finite, positive
    Parameter<unit::Density> density = 1000 * kilogram_per_cubic_metre;         ///< rho, kg/m^3, finite, positive
    Parameter<unit::Stiffness> tension = 0.0 * newton_per_metre;                ///< T, N/m, finite, not negative
    Parameter<unit::Frequency> damping = 0.0 * hertz;                           ///< gamma, 1/s, finite, not negative
};

/// The parts of a soft surface in its world.
struct SoftSurfaceParts {
    ColumnGrid grid;                   ///< over whose columns its bodies are
    std::vector<Handle> bodies;        ///< by column
    std::vector<SpringHandle> level;   ///< by column: what holds it up
    std::vector<SpringHandle> tension; ///< to the neighbours and to the frame; none without a tension
};

namespace detail {

/// The springs of a soft surface.
class SurfaceNet {
public:
    template <class S>
    SurfaceNet(std::type_identity<S>, const SoftSurface& surface, double gravity)
        : grid_(surface.grid), flat_(S::dimension == 2), level_(surface.level.value()) {
        const double dx = grid_.x().width(0), dz = grid_.z().width(0), area = dx * dz;
        mass_ = surface.mass_per_area.value() * area * kilogram;
        lift_ = surface.mass_per_area.value() / surface.density.value();
        held_ = {surface.density.value() * gravity * area * newton_per_metre,
                 surface.damping.value() * mass_.value() * newton_second_per_metre};
        along_x_ = surface.tension.value() * dz / dx * newton_per_metre;
        along_z_ = surface.tension.value() * dx / dz * newton_per_metre;
        S::convert("stiffness", held_.stiffness);
        S::convert("damping", held_.damping);
        S::convert("tension", along_x_);
        S::convert("tension", along_z_);
    }
    const SpringConstants& held() const { return held_; }
    /// Where column (i, j) has its body, and for those beyond the border where the frame is, m.
    VectorQuantity<unit::Length> place(int i, int j, double above = 0) const {
        const auto &x = grid_.x(), &z = grid_.z();
        return metres(x.centre(0) + i * x.width(0), level_ + above, flat_ ? 0 : z.centre(0) + j * z.width(0));
    }
    void bodies(SoftPlan& plan) const {
        each([&](int i, int j) { plan.bodies.push_back({.place = place(i, j), .mass = mass_}); });
    }
    template <class W> void springs(W& world, SoftSurfaceParts& parts) const {
        const int nx = int(grid_.columns_x()), nz = int(grid_.columns_z());
        const auto none = 0.0 * metre;
        each([&](int i, int j) {
            const auto body = parts.bodies[grid_.index(std::size_t(i), std::size_t(j))];
            parts.level.push_back(world.add(Spring{body, place(i, j, lift_), held_.stiffness, held_.damping, none}));
            auto tie = [&](int i2, int j2, const Parameter<unit::Stiffness>& k) {
                const bool inside = i2 >= 0 && i2 < nx && j2 >= 0 && j2 < nz;
                if (inside && i2 + j2 < i + j) return; // the other one has tied it
                const SpringEnd end = inside ? SpringEnd(parts.bodies[grid_.index(std::size_t(i2), std::size_t(j2))])
                                             : SpringEnd(place(i2, j2));
                parts.tension.push_back(world.add(Spring{body, end, k, 0.0 * newton_second_per_metre, none}));
            };
            if (!(along_x_.value() > 0)) return;
            for (const int to : {-1, 1}) tie(i + to, j, along_x_);
            for (const int to : {-1, 1})
                if (nz > 1) tie(i, j + to, along_z_);
        });
    }

private:
    template <class F> void each(F&& f) const {
        for (int j = 0; j < int(grid_.columns_z()); ++j)
            for (int i = 0; i < int(grid_.columns_x()); ++i) f(i, j);
    }
    const ColumnGrid& grid_;
    bool flat_;
    double level_, lift_ = 0;
    Quantity<unit::Mass> mass_;
    SpringConstants held_;
    Parameter<unit::Stiffness> along_x_, along_z_;
};

} // namespace detail

/// Adds a soft surface: a body for each column, then the springs.
/// \param world   with Gravity, which pulls downwards, and Springs among its policies
/// \param surface what is built; in a world of two dimensions its grid is a channel, and every z is 0
/// \param each    what each body is given beside its place and its mass: a shape in a world of collisions
/// \return the handles of all parts
/// \throws std::invalid_argument with name, value and unit; the world is then as it was
template <class... P, class... Property>
SoftSurfaceParts add_soft_surface(World<P...>& world, const SoftSurface& surface, const Property&... each) {
    constexpr bool weighs = (std::same_as<P, Gravity> || ...);
    static_assert(weighs, "Ansatz: a soft surface is held up by the weight of water, which is that of the world: "
                          "add_soft_surface needs a world with Gravity{}");
    SoftSurfaceParts parts{surface.grid, {}, {}, {}};
    if constexpr (weighs) {
        using S = typename World<P...>::S;
        const char* const where = "add_soft_surface";
        require_finite(where, "level", surface.level);
        require_positive(where, "mass per area", surface.mass_per_area);
        require_positive(where, "density", surface.density);
        require_not_negative(where, "tension", surface.tension);
        require_not_negative(where, "damping", surface.damping);
        if (!surface.grid.uniform())
            refuse_value(where, "grid", "of unequal columns", "the columns of a soft surface are all alike");
        if (S::dimension == 2 && surface.grid.columns_z() != 1)
            refuse_value(where, "the number of columns along z", std::to_string(surface.grid.columns_z()),
                         "in a world of two dimensions the surface is a channel: 1");
        const double down = 0 - static_cast<double>(S::convert(world.template get<Gravity>().acceleration).value()[1]);
        if (!(down > 0))
            refuse_value(where, "the downward part of Gravity", down * metre_per_second_squared,
                         "it must be greater than zero: nothing else holds the surface at its level");
        const detail::SurfaceNet net(std::type_identity<S>{}, surface, down);
        SoftPlan plan{.where = where, .vertex = "column", .velocity = {}, .bodies = {}, .links = {}};
        net.bodies(plan);
        plan.template check<Spring>(world);
        using Keeper = typename detail::KeeperOf<Spring, P...>::type;
        if constexpr (!std::is_void_v<Keeper>) {
            if (!Keeper::damped && net.held().damping.value() != 0)
                refuse_value(where, "damping", surface.damping, "the springs of this world are Undamped");
            std::vector<SpringHandle> nothing_else;
            plan.template build<Spring>(world, parts.bodies, nothing_else, each...);
            net.springs(world, parts);
        }
    }
    return parts;
}

} // namespace ansatz
