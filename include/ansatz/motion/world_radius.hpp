// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `WorldRadius`: declares the slowest motion that must be right, and with it how large the world is; `status()` tells
/// which bodies are outside.
///
/// Use it in float worlds that bodies may leave, and while you build one: far from the origin motion stops without a
/// sound. It only checks when `status()` is called, so that a step costs what it did. It mends nothing: for that take
/// Compensated, double, or keep the origin near. Beside an integrator that keeps no velocity (Verlet) a call of
/// `status()` does not compile, by a sentence: there is no such radius.

#include <ansatz/motion/resolved_radius.hpp>
#include <ansatz/world/bodies.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace ansatz {

/// An observer: within the radius of `resolved_radius` a body of at least `speed` moves by its way but for `share`.
struct WorldRadius {
    using role = roles::Observer;
    using reads = Columns<Position>;

    /// The slowest that must move rightly, m/s, finite and greater than zero; what is slower may stand still
    Parameter<unit::Velocity> speed = 0.05 * metre_per_second;
    /// Of its way, at least 2e-6, which a float holds everywhere, and less than 1
    double share = 0.01;

    static constexpr std::string_view name = "WorldRadius";
    static void parameters(auto& self, auto&& visit) {
        visit("speed", self.speed);
        visit("share", self.share);
    }
    void check() const {
        require_positive("WorldRadius", "speed", speed);
        if (!(share >= 2e-6) || !(share < 1))
            refuse_value("WorldRadius", "share", share, "it is at least 2e-6 and less than 1");
    }

    /// The bodies outside.
    struct Outside {
        Quantity<unit::Length> radius{}; ///< m
        std::size_t count = 0;           ///< how many are there; bodies that are `fixed` move nowhere and do not count
        Handle first{};                  ///< the one with the smallest id
    };
    /// The bodies outside.
    /// \param dt s, greater than zero: the step of the integrator
    template <class World_> Outside outside(const World_& world, const Quantity<unit::Time>& dt) const {
        using S = typename World_::S;
        Outside found{resolved_radius<S, typename World_::Integrator>(speed, dt, share)};
        world.for_each([&](Handle body) {
            if (world.motion(body) == Motion::fixed || !(farthest(world, body) >= found.radius)) return;
            if (found.count++ == 0) found.first = body;
        });
        return found;
    }

    /// What it has to say in `status()`.
    template <class World_> std::string report(const World_& world, const Quantity<unit::Time>& dt) const {
        const Outside found = outside(world, dt);
        if (found.count == 0) return {};
        constexpr bool compensated = detail::contains<PositionRemainder, writes_of<typename World_::Integrator>>;
        return detail::joined(
            {describe(found.count), found.count == 1 ? " body" : " bodies",
             " outside of the world's radius, the first is body ", describe(std::size_t(found.first.id)),
             ": a coordinate of ", describe(farthest(world, found.first)), ", and at ",
             describe(Quantity<unit::Velocity>(speed)), " in steps of ", describe(dt), " this scalar moves within ",
             describe(100 * share), " % of the way up to ", describe(found.radius),
             "; keep the origin nearer, or take ", compensated ? "" : "Compensated or ", "a scalar of more digits"});
    }

private:
    /// Its largest coordinate: the places of a position are those of the component.
    template <class World_> static Quantity<unit::Length> farthest(const World_& world, Handle body) {
        const auto x = world.position(body);
        double most = 0;
        for (int k = 0; k < World_::S::dimension; ++k)
            if (const double one = std::abs(double(x.value()[k])); one > most) most = one;
        return most * metre;
    }
};

} // namespace ansatz
