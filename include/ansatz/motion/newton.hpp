// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `mechanics`: Newton's three laws as functions of quantities, scalar or vector (notes 1.1 to 1.3).
///
/// Use them to say in a program what the law says: which force a thrust is, what acceleration a load leaves, whether
/// the forces on a bridge balance. The units do half of the checking: a force that was divided by a velocity is no
/// acceleration. Not for the inside of a simulation: there a Force policy answers and the world sums and integrates; to
/// push a body from outside use AppliedForces. Forces in space are vectors and forces along a line are numbers; both
/// work, with any scalar.
///
/// | symbol | meaning               | unit  |
/// |--------|-----------------------|-------|
/// | m      | mass                  | kg    |
/// | a      | acceleration          | m/s^2 |
/// | F      | force                 | N     |

#include <ansatz/units/requirements.hpp>
#include <ansatz/world/properties.hpp>

#include <limits>
#include <string_view>
#include <type_traits>

namespace ansatz::mechanics {

namespace detail {

/// A quantity of this unit, scalar or vector.
template <class Unit, class Q>
inline constexpr bool is_in = ansatz::detail::has_unit<Unit, ansatz::detail::stripped<Q>>;
/// A scalar quantity of this unit.
template <class Unit, class Q>
inline constexpr bool is_scalar_in = is_in<Unit, Q> && !ansatz::detail::vector_valued<ansatz::detail::stripped<Q>>;
/// Several of one unit, shape and scalar.
template <class Unit, class First, class... Rest>
inline constexpr bool are_in =
    is_in<Unit, First> && (std::is_same_v<ansatz::detail::stripped<First>, ansatz::detail::stripped<Rest>> && ...);

/// |q| of a scalar or a vector.
template <class Q> auto magnitude(const Q& q) {
    if constexpr (ansatz::detail::vector_valued<Q>) return norm(q);
    else return abs(q);
}

} // namespace detail

/// \f$ \sum \mathbf F \f$: forces on one body act together as their vector sum (notes 1.2).
/// \param first, rest forces in N, all scalars or all vectors of one dimension
template <class First, class... Rest> auto resultant(const First& first, const Rest&... rest) {
    constexpr bool forces = detail::are_in<unit::Force, First, Rest...>;
    static_assert(forces, "Ansatz: mechanics::resultant takes forces of one kind; write e.g. resultant(newtons(0, 5, "
                          "0), newtons(1, 0, 0))");
    if constexpr (forces) {
        ansatz::detail::stripped<First> sum = first;
        ((sum += rest), ...);
        return sum;
    }
}

/// \f$ \mathbf F = m \mathbf a \f$: the resultant that gives a mass this acceleration (second law, notes 1.2).
/// \param mass         kg, finite and greater than zero
/// \param acceleration m/s^2, a number or a vector
/// \throws std::invalid_argument for another mass
template <class Mass, class Acceleration> auto force(const Mass& mass, const Acceleration& acceleration) {
    constexpr bool units = detail::is_scalar_in<unit::Mass, Mass> && detail::is_in<unit::Acceleration, Acceleration>;
    static_assert(units, "Ansatz: mechanics::force takes a mass and an acceleration; write e.g. force(2.0 * kilogram, "
                         "metres_per_second_squared(0, -9.81, 0))");
    if constexpr (units) {
        require_positive("mechanics::force", "mass", mass);
        return mass * acceleration;
    }
}

/// \f$ \mathbf a = \mathbf F / m \f$: what a resultant does to a mass (second law, notes 1.2). %Zero for no force, which is
/// the first law: the velocity stays what it is.
/// \param resultant N, a number or a vector
/// \param mass      kg, finite and greater than zero
/// \throws std::invalid_argument for another mass
template <class Force, class Mass> auto acceleration(const Force& resultant, const Mass& mass) {
    constexpr bool units = detail::is_in<unit::Force, Force> && detail::is_scalar_in<unit::Mass, Mass>;
    static_assert(units, "Ansatz: mechanics::acceleration takes a force and a mass; write e.g. acceleration(newtons(0, "
                         "5, 0), 2.0 * kilogram)");
    if constexpr (units) {
        require_positive("mechanics::acceleration", "mass", mass);
        return resultant / mass;
    }
}

/// \f$ -\mathbf F \f$: what the second body does to the first while the first does F to the second (third law, notes 1.3).
/// The two act on different bodies, so they never balance each other.
template <class Force> auto reaction(const Force& action) {
    constexpr bool units = detail::is_in<unit::Force, Force>;
    static_assert(units, "Ansatz: mechanics::reaction takes a force; write e.g. reaction(newtons(0, 5, 0))");
    if constexpr (units) return ansatz::detail::stripped<Force>(-action);
}

/// Whether the forces on a body leave its velocity alone (first law, notes 1.1): their sum is zero, or no larger than
/// the
/// rounding of the sum, \f$ |\sum \mathbf F| \le n \varepsilon \sum |\mathbf F| \f$. There is no threshold in newtons, so the
/// answer does not depend on how heavy things are.
template <class First, class... Rest> bool in_equilibrium(const First& first, const Rest&... rest) {
    constexpr bool forces = detail::are_in<unit::Force, First, Rest...>;
    static_assert(
        forces,
        "Ansatz: mechanics::in_equilibrium takes forces of one kind; write e.g. in_equilibrium(weight, push, pull)");
    if constexpr (forces) {
        using Force = ansatz::detail::stripped<First>;
        const Force firstly = first;
        auto all = detail::magnitude(firstly);
        ((all += detail::magnitude(Force(rest))), ...);
        using Scalar = typename decltype(all)::value_type;
        const Scalar rounding = std::numeric_limits<Scalar>::epsilon() * Scalar(double(1 + sizeof...(Rest)));
        return detail::magnitude(resultant(firstly, rest...)) <= rounding * all;
    }
    return false;
}

} // namespace ansatz::mechanics
