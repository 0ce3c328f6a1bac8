// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Energy and momentum of a world, as queries with units (notes 1.4).
///
/// Use them to watch a simulation: what should be conserved and is not names the mistake. They visit every body when
/// they are called and cost nothing otherwise. Bodies of infinite mass (fixed, moving) are left out: they are not part
/// of the system but what acts on it from outside. They need the masses: a world whose policies do not gets
/// `Keep<InverseMass>`.

#include <ansatz/world/world.hpp>

namespace ansatz {

namespace detail {

/// Calls `f(handle, mass)` for each body with a finite mass.
template <class World_, class F> void for_each_mass(const World_& world, F&& f) {
    world.for_each([&](Handle body) {
        const auto inverse = world.inverse_mass(body);
        if (inverse.value() > 0) f(body, typename World_::Scalar(1) / inverse);
    });
}

/// A world, and not a list of masses: of those, notes 1.4 has functions with the same names (motion/momentum.hpp).
template <class T>
concept HasComposition = requires { typename T::composition; };

template <class P, class S>
concept HasPotential = requires(const Bound<P, S>& law, const typename S::Position& x,
                                const Context<S, reads_clock<P>>& c) { law.potential(x, c); };

} // namespace detail

/// \f$ \tfrac12 m |\mathbf v|^2 \f$ of one body, in J.
/// \throws std::out_of_range for a stale handle
template <class World_> auto kinetic_energy(const World_& world, Handle body) {
    using S = typename World_::S;
    const auto inverse = world.inverse_mass(body);
    if (!(inverse.value() > 0)) return typename S::Energy();
    return typename S::Energy(0.5 * squared_norm(world.velocity(body)) / inverse);
}

/// The sum of the kinetic energies, in J.
template <class World_> auto kinetic_energy(const World_& world) {
    typename World_::S::Energy sum{};
    detail::for_each_mass(world, [&](Handle body, const auto&) { sum += kinetic_energy(world, body); });
    return sum;
}

/// The potential energy of all bodies in all forces that have one, in J. A force without a potential (drag, applied
/// forces) does not count: it takes or gives energy.
template <class World_> auto potential_energy(const World_& world) {
    using S = typename World_::S;
    typename S::Energy sum{};
    detail::for_each_mass(world, [&](Handle body, const auto& m) {
        const auto x = world.position(body);
        auto add = [&]<class P>() {
            if constexpr (detail::HasPotential<P, S>) {
                const auto part = world.laws().template get<P>().potential(
                    x, world.context().template restricted<detail::reads_clock<P>>());
                if constexpr (std::is_convertible_v<decltype(part), typename S::Energy>)
                    sum += part;      // of a force: an energy
                else sum += m * part; // of an acceleration: an energy for each kilogram
            }
        };
        [&]<class... P>(Types<P...>) { (add.template operator()<P>(), ...); }(typename World_::composition::laws{});
    });
    auto add_coupling = [&]<class P>() {
        const auto view = world.template view<P>();
        const detail::Bound<P, S> force(world.template get<P>());
        if constexpr (requires { force.potential_energy(view); }) sum += force.potential_energy(view);
    };
    [&]<class... P>(Types<P...>) {
        (add_coupling.template operator()<P>(), ...);
    }(typename World_::composition::all_couplings{});
    return sum;
}

/// Kinetic and potential energy together, in J.
template <class World_> auto total_energy(const World_& world) {
    return kinetic_energy(world) + potential_energy(world);
}

/// \f$ \sum m \mathbf v \f$, in kg m/s.
template <class World_>
    requires detail::HasComposition<World_>
auto total_momentum(const World_& world) {
    typename World_::S::Momentum sum{};
    detail::for_each_mass(world, [&](Handle body, const auto& m) { sum += m * world.velocity(body); });
    return sum;
}

/// \f$ \sum m\,(\mathbf x - \mathbf x_0) \times \mathbf v \f$ about a point, in kg m^2/s: a vector in three dimensions, a
/// number in two.
template <class World_>
auto total_angular_momentum(const World_& world, const typename World_::Position& about = typename World_::Position()) {
    using Sum = decltype(typename World_::S::Mass() * cross(about, typename World_::Velocity()));
    Sum sum{};
    detail::for_each_mass(world, [&](Handle body, const auto& m) {
        sum += m * cross(world.position(body) - about, world.velocity(body));
    });
    return sum;
}

/// The centre of mass, in m; the origin if there is no mass.
template <class World_> auto centre_of_mass(const World_& world) {
    typename World_::S::Mass all{};
    auto sum = typename World_::S::Mass() * typename World_::Position();
    detail::for_each_mass(world, [&](Handle body, const auto& m) {
        all += m;
        sum += m * world.position(body);
    });
    if (!(all.value() > 0)) return typename World_::Position();
    return typename World_::Position(sum / all);
}

} // namespace ansatz
