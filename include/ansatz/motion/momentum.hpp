// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `mechanics`: momentum, impulse, kinetic energy, and the head-on collision that conserves the first (notes 1.4).
///
/// Use them for bodies that you hold yourself and for results in closed form: after a collision the momentum of two
/// bodies is what it was, at every restitution; only kinetic energy is lost, and this header says how much. The bodies
/// of a world are asked with energy.hpp; contacts of shapes in space are solved by the responses of chapter 2, which
/// along the normal must agree with this header. Velocities are numbers or vectors, of any scalar.
///
/// | symbol | meaning                                            | unit         |
/// |--------|----------------------------------------------------|--------------|
/// | m      | mass                                               | kg           |
/// | u, v   | velocity before and after                          | m/s          |
/// | p      | momentum                                           | kg m/s = N s |
/// | J      | impulse, the change of a momentum                  | N s          |
/// | e      | restitution, 0 (they stay together) to 1 (elastic) | -            |
/// | mu     | reduced mass, m1 m2 / (m1 + m2)                    | kg           |

#include <ansatz/motion/newton.hpp>

#include <array> // and with it std::begin and std::end
#include <type_traits>
#include <utility>

namespace ansatz::mechanics {

/// A body as this header sees it: how heavy and how fast.
/// \tparam ValueT a scalar for motion along a line, `Vector<Scalar, Dim>` in space
template <class ScalarT, class ValueT = ScalarT> struct PointMass {
    using Scalar = ScalarT;
    using Value = ValueT;                      ///< a number along a line, a vector in space
    Quantity<unit::Mass, ScalarT> mass;        ///< kg, finite and greater than zero
    Quantity<unit::Velocity, ValueT> velocity; ///< m/s
};
/// The scalar and the dimension follow from the arguments.
template <class ScalarT, class ValueT>
PointMass(const Quantity<unit::Mass, ScalarT>&, const Quantity<unit::Velocity, ValueT>&) -> PointMass<ScalarT, ValueT>;

/// \f$ \mathbf p = m \mathbf v \f$, in kg m/s.
/// \param mass     kg, finite and greater than zero
/// \param velocity m/s, a number or a vector
/// \throws std::invalid_argument for another mass
template <class Mass, class Velocity> auto momentum(const Mass& mass, const Velocity& velocity) {
    constexpr bool units = detail::is_scalar_in<unit::Mass, Mass> && detail::is_in<unit::Velocity, Velocity>;
    static_assert(units, "Ansatz: mechanics::momentum takes a mass and a velocity; write e.g. momentum(2.0 * kilogram, "
                         "3.0 * metre_per_second)");
    if constexpr (units) {
        require_positive("mechanics::momentum", "mass", mass);
        return mass * velocity;
    }
}

/// \f$ \mathbf J = \mathbf F\,\Delta t \f$, in N s: by how much a constant force changes a momentum in a time. A
/// third law for impulses follows from that for forces, and with it the conservation of momentum.
template <class Force, class Time> auto impulse(const Force& force, const Time& dt) {
    constexpr bool units = detail::is_in<unit::Force, Force> && detail::is_scalar_in<unit::Time, Time>;
    static_assert(
        units,
        "Ansatz: mechanics::impulse takes a force and a time; write e.g. impulse(newtons(0, 5, 0), 0.1 * second)");
    ansatz::detail::refuse_whole_numbers<Time>();
    if constexpr (units) return force * dt;
}

/// \f$ \tfrac12 m |\mathbf v|^2 \f$, in J.
/// \throws std::invalid_argument unless the mass is finite and greater than zero
template <class Mass, class Velocity> auto kinetic_energy(const Mass& mass, const Velocity& velocity) {
    constexpr bool units = detail::is_scalar_in<unit::Mass, Mass> && detail::is_in<unit::Velocity, Velocity>;
    static_assert(
        units,
        "Ansatz: mechanics::kinetic_energy takes a mass and a velocity; write e.g. kinetic_energy(2.0 * kilogram, "
        "3.0 * metre_per_second)");
    if constexpr (units) {
        require_positive("mechanics::kinetic_energy", "mass", mass);
        if constexpr (ansatz::detail::vector_valued<ansatz::detail::stripped<Velocity>>)
            return 0.5 * mass * squared_norm(velocity);
        else return 0.5 * mass * velocity * velocity;
    }
}

namespace detail {
template <class R> using ElementOf = std::remove_cvref_t<decltype(*std::begin(std::declval<R&>()))>;
}
/// A range of point masses: a vector, an array, a view. (By hand, because `<ranges>` would be a tenth of what a small
/// program takes to compile.)
template <class R>
concept PointMasses = requires(R& bodies, const detail::ElementOf<R>& one) {
    std::begin(bodies) != std::end(bodies);
    one.mass* one.velocity;
};

/// \f$ \sum m \mathbf v \f$ of a list, in kg m/s; zero for an empty one. In a closed system it is constant (notes 1.4).
/// \throws std::invalid_argument for a mass that is not finite and greater than zero
template <PointMasses R> auto total_momentum(R&& bodies) {
    using Body = detail::ElementOf<R>;
    auto sum = decltype(std::declval<const Body&>().mass * std::declval<const Body&>().velocity)();
    for (const auto& body : bodies) sum += momentum(body.mass, body.velocity);
    return sum;
}

/// \f$ \sum m \mathbf v / \sum m \f$: how fast the centre of mass moves. Seen from there the total momentum is zero.
/// \throws std::invalid_argument for an empty list, and for a mass that is not finite and greater than zero
template <PointMasses R> auto centre_of_mass_velocity(const R& bodies) {
    using Body = detail::ElementOf<R>;
    decltype(Body::mass) all{};
    for (const auto& body : bodies) all += body.mass;
    require_positive("mechanics::centre_of_mass_velocity", "the sum of the masses", all);
    return total_momentum(bodies) / all;
}

/// \f$ \mu = m_1 m_2 / (m_1 + m_2) \f$: the one mass that two bodies have for their relative motion; at most the
/// smaller.
/// \throws std::invalid_argument for a mass that is not finite and greater than zero
template <class Scalar>
auto reduced_mass(const Quantity<unit::Mass, Scalar>& first, const Quantity<unit::Mass, Scalar>& second) {
    require_positive("mechanics::reduced_mass", "mass", first);
    require_positive("mechanics::reduced_mass", "mass", second);
    // The smaller over a number between 1 and 2: nothing overflows, whatever the ratio of the masses.
    const auto smaller = min(first, second), larger = max(first, second);
    return Quantity<unit::Mass, Scalar>(smaller / (Scalar(1) + Scalar(smaller / larger)));
}

namespace detail {
template <class Scalar, class Value>
void require_collision(const PointMass<Scalar, Value>& first, const PointMass<Scalar, Value>& second,
                       Scalar restitution) {
    require_positive("mechanics::collide", "mass", first.mass);
    require_positive("mechanics::collide", "mass", second.mass);
    require_finite("mechanics::collide", "velocity", first.velocity);
    require_finite("mechanics::collide", "velocity", second.velocity);
    if (!(restitution >= Scalar(0) && restitution <= Scalar(1)))
        refuse_value("mechanics::collide", "restitution",
                     Quantity<unit::Dimensionless, Scalar>::from_value(restitution),
                     "it is from 0 (the bodies stay together) to 1 (no energy is lost)");
}
} // namespace detail

/// The two bodies after they met head-on, so that their relative velocity is along the line between them:
///
/// \f[ \mathbf v_1 = \mathbf u_1 - (1 + e) \frac{\mu}{m_1} (\mathbf u_1 - \mathbf u_2), \qquad
///     \mathbf v_2 = \mathbf u_2 + (1 + e) \frac{\mu}{m_2} (\mathbf u_1 - \mathbf u_2) \f]
///
/// One impulse acts on both, with opposite signs, so momentum is conserved at *every* e, and they separate with e times
/// the speed at which they met. (The notes' 2.2.1 says that an inelastic collision dissipates momentum: it does not.)
/// Bodies of one velocity do not meet and keep it. Whether they approach is the caller's knowledge: only positions
/// tell.
///
/// \param first, second mass in kg, velocity in m/s
/// \param restitution   e, a plain number from 0 to 1
/// \throws std::invalid_argument for a mass that is not finite and greater than zero, a velocity that is not finite, or
/// a
///         restitution outside its range
template <class Scalar, class Value>
std::pair<PointMass<Scalar, Value>, PointMass<Scalar, Value>> collide(const PointMass<Scalar, Value>& first,
                                                                      const PointMass<Scalar, Value>& second,
                                                                      std::type_identity_t<Scalar> restitution) {
    detail::require_collision(first, second, restitution);
    const auto approach = first.velocity - second.velocity;
    // Shares of the approach, not an impulse divided by a mass: a share is at most 2, whatever the masses are.
    const auto reduced = reduced_mass(first.mass, second.mass);
    const Scalar share1 = (Scalar(1) + restitution) * Scalar(reduced / first.mass);
    const Scalar share2 = (Scalar(1) + restitution) * Scalar(reduced / second.mass);
    return {{first.mass, first.velocity - share1 * approach}, {second.mass, second.velocity + share2 * approach}};
}

/// \f$ \tfrac12 \mu (1 - e^2) |\mathbf u_1 - \mathbf u_2|^2 \f$, in J: the kinetic energy that such a collision turns
/// into something else. Nothing at e = 1; at e = 0 all but the energy of the centre of mass.
/// \throws std::invalid_argument as `collide`
template <class Scalar, class Value>
Quantity<unit::Energy, Scalar> energy_lost(const PointMass<Scalar, Value>& first,
                                           const PointMass<Scalar, Value>& second,
                                           std::type_identity_t<Scalar> restitution) {
    detail::require_collision(first, second, restitution);
    return (Scalar(1) - restitution) * (Scalar(1) + restitution) *
           kinetic_energy(reduced_mass(first.mass, second.mass), first.velocity - second.velocity);
}

} // namespace ansatz::mechanics
