// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Foam`: how much of each column of a surface is covered by foam, a number from 0 to 1.
///
/// Use it to draw white water where waves are steep: behind a hull, along a bore, where something fell in. It is a
/// value beside a Surface, one step behind each of its steps: `foam.step(surface, dt)`, or
/// `foam.step(world.water(pool).surface(), dt)`. It changes nothing of the water. Not for spray, and not for a height
/// of foam.
///
/// \f[ \dot f + \mathbf u \cdot \nabla f = a\,(1 - f) - b f, \qquad a = \frac{\max(0,\; s - s_0)}{s_0\,T_{grow}}, \qquad b = \frac1{T_{fade}} \f]
///
/// | symbol         | meaning                                                                 | unit |
/// |----------------|-------------------------------------------------------------------------|------|
/// | f              | the fraction of the column that foam covers                             | 1    |
/// | s              | slope of the level, by its central differences                          | 1    |
/// | s_0            | `steep`: no foam is made below it                                       | 1    |
/// | T_grow, T_fade | in which water twice as steep is covered, and foam is gone, but for 1/e | s    |
/// | u              | the water's flow along the surface, where its policy has one            | m/s  |
///
/// Growing and fading are solved exactly for the slope of the step, so that foam does not depend on the frame rate; it
/// goes with the flow by tracing back along it, which no step is too long for. A column without water has no foam.

#include <ansatz/water/surface.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace ansatz {

/// What foam needs to know.
struct FoamLaw {
    double steep = 0.3;                            ///< s_0, finite, positive
    Parameter<unit::Time> grows_in = 0.3 * second; ///< T_grow, s, finite, positive
    Parameter<unit::Time> fades_in = 2.0 * second; ///< T_fade, s, finite, positive
};

/// Foam on the columns of a grid.
/// \tparam Scalar that of the surface
template <class Scalar> class Foam {
public:
    /// None yet.
    /// \param grid of the surface
    /// \throws std::invalid_argument for a law that cannot be
    explicit Foam(const ColumnGrid& grid, const FoamLaw& law = {})
        : grid_(grid), law_(law), part_(grid.size(), Scalar(0)), next_(part_) {
        require_positive("Foam", "steep", Quantity<unit::Dimensionless>::from_value(law.steep));
        require_positive("Foam", "grows_in", law.grows_in);
        require_positive("Foam", "fades_in", law.fades_in);
    }
    const ColumnGrid& grid() const { return grid_; } ///< where its columns stand
    const FoamLaw& law() const { return law_; }      ///< by what it grows and fades
    /// The fractions of all columns, from 0 to 1, x fastest.
    std::span<const Scalar> parts() const { return part_; }
    /// That of column (i, j).
    /// \throws std::out_of_range if there is no such column
    const Scalar& part(std::size_t i, std::size_t j) const { return part_[grid_.known_index("Foam::part", i, j)]; }
    /// Gives every column its fraction, e.g. of a saved foam.
    /// \throws std::invalid_argument unless there is one for each, from 0 to 1; nothing is changed then
    void set_parts(std::span<const Scalar> parts) {
        grid_.require_one_each("Foam::set_parts", "parts", parts.size());
        for (const Scalar& f : parts)
            if (!(f >= Scalar(0) && f <= Scalar(1)))
                refuse_value("Foam::set_parts", "a part", static_cast<double>(f), "it must be from 0 to 1");
        std::copy(parts.begin(), parts.end(), part_.begin());
    }
    /// What the water of now does in a time.
    /// \param surface on the same grid
    /// \param dt      s, finite, not negative
    /// \throws std::invalid_argument for another grid or time
    template <class Policy> void step(const Surface<Policy, Scalar>& surface, Quantity<unit::Time> dt) {
        require_not_negative("Foam::step", "dt", dt);
        if (!(surface.grid() == grid_))
            refuse_value("Foam::step", "the grid of the surface", "another one", "it is that of the foam");
        const double b = rate(1, law_.fades_in.value());
        for (std::size_t j = 0; j < grid_.columns_z(); ++j)
            for (std::size_t i = 0; i < grid_.columns_x(); ++i) {
                const std::size_t n = grid_.index(i, j);
                if (dry(surface, n)) {
                    next_[n] = Scalar(0);
                    continue;
                }
                const double over = slope(surface, i, j) - law_.steep;
                const double a = over > 0 ? rate(over, law_.steep * law_.grows_in.value()) : 0.0;
                const double steady = a / (a + b), keeps = std::exp(-(a + b) * dt.value());
                const double came = carried(surface, i, j, dt);
                const double f = steady + (came - steady) * keeps;
                next_[n] = Scalar(f < 0 ? 0.0 : f > 1 ? 1.0 : f);
            }
        part_.swap(next_);
    }
    /// The same grid, law and fractions.
    friend bool operator==(const Foam& a, const Foam& b) {
        return a.grid_ == b.grid_ && a.part_ == b.part_ && a.law_.steep == b.law_.steep &&
               a.law_.grows_in == b.law_.grows_in && a.law_.fades_in == b.law_.fades_in;
    }

private:
    /// What happens in a second, held to 1e300 where the quotient overflows.
    static double rate(double what, double in) { return std::min(what / in, 1e300); }
    template <class Surface_> static bool dry(const Surface_& surface, std::size_t n) {
        if constexpr (requires { surface.state().bed; }) return !(surface.state().height[n] > Scalar(0));
        else return false;
    }
    template <class Surface_> static double level(const Surface_& surface, std::size_t n) {
        const auto& state = surface.state();
        if constexpr (requires { state.bed; }) return static_cast<double>(state.bed[n] + state.height[n]);
        else return static_cast<double>(state.height[n]);
    }
    /// |grad eta| by central differences; to a column without water there is no slope.
    template <class Surface_> double slope(const Surface_& surface, std::size_t i, std::size_t j) const {
        auto along = [&](const detail::ColumnAxis& axis, std::size_t k, std::size_t stride) {
            const std::size_t n = grid_.index(i, j);
            const std::size_t before = k > 0 && !dry(surface, n - stride) ? 1 : 0;
            const std::size_t after = k + 1 < axis.count() && !dry(surface, n + stride) ? 1 : 0;
            if (before + after == 0) return 0.0;
            return (level(surface, n + after * stride) - level(surface, n - before * stride)) /
                   (axis.centre(k + after) - axis.centre(k - before));
        };
        return std::hypot(along(grid_.x(), i, 1), along(grid_.z(), j, grid_.columns_x()));
    }
    /// The foam of where the water of a column was before.
    template <class Surface_>
    double carried(const Surface_& surface, std::size_t i, std::size_t j, Quantity<unit::Time> dt) const {
        if constexpr (requires { surface.velocity(i, j); }) {
            const auto u = surface.velocity(i, j).value();
            if (u[0] == Scalar(0) && u[1] == Scalar(0)) return static_cast<double>(part_[grid_.index(i, j)]);
            auto back = [&](const detail::ColumnAxis& axis, std::size_t k, const Scalar& speed) {
                const double from = axis.centre(k) - static_cast<double>(speed) * dt.value();
                return axis.between(std::clamp(from, axis.begin(), axis.end()));
            };
            const auto x = back(grid_.x(), i, u[0]), z = back(grid_.z(), j, u[1]);
            auto row = [&](std::size_t k) {
                const double low = static_cast<double>(part_[grid_.index(x.low, k)]),
                             high = static_cast<double>(part_[grid_.index(x.high, k)]);
                return low + (high - low) * x.part;
            };
            return row(z.low) + (row(z.high) - row(z.low)) * z.part;
        } else return static_cast<double>(part_[grid_.index(i, j)]);
    }
    ColumnGrid grid_;
    FoamLaw law_;
    std::vector<Scalar> part_, next_;
};
/// Of a surface, in its scalar.
template <class Policy, class Scalar>
Foam<Scalar> foam_on(const Surface<Policy, Scalar>& surface, const FoamLaw& law = {}) {
    return Foam<Scalar>(surface.grid(), law);
}

} // namespace ansatz
