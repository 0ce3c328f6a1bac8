// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `springs`: Hooke's law and the damped spring as functions of quantities (notes 3).
///
/// Use them to say what one spring does, to choose its constants by how it should swing (a frequency and a damping
/// ratio are easier to imagine than newtons per metre), and inside a force of your own. For springs between the bodies
/// of a world take springs.hpp, which calls the same functions.
///
/// | symbol  | meaning                                    | unit  |
/// |---------|--------------------------------------------|-------|
/// | k       | stiffness, the notes' spring constant      | N/m   |
/// | c       | damping                                    | N s/m |
/// | x       | displacement: length minus rest length     | m     |
/// | v       | velocity along the axis, of lengthening    | m/s   |
/// | m       | mass that swings; of two, the reduced mass | kg    |
/// | f       | frequency, in swings per second            | 1/s   |
/// | omega   | angular frequency, 2 pi f                  | 1/s   |
/// | zeta    | damping ratio, c / (2 sqrt(k m))           | 1     |
///
/// The notes write F = -kx for "the force required to displace a spring". That is the force *of* the spring; whoever
/// displaces it needs +kx.

#include <ansatz/units/requirements.hpp>
#include <ansatz/world/properties.hpp>

#include <type_traits>

namespace ansatz::springs {

namespace detail {
/// A quantity of this unit: a number, or a number or a vector.
template <class Unit, class Q>
inline constexpr bool is_number_in = ansatz::detail::has_unit<Unit, ansatz::detail::stripped<Q>> &&
                                     !ansatz::detail::vector_valued<ansatz::detail::stripped<Q>>;
template <class Unit, class Q>
inline constexpr bool is_in = ansatz::detail::has_unit<Unit, ansatz::detail::stripped<Q>>;
inline constexpr double two_pi = 6.283185307179586476925286766559;
} // namespace detail

/// \f$ F = -k x \f$: what a spring does to whoever displaced it (Hooke's law, notes 3).
/// \param stiffness    N/m
/// \param displacement m, a number along the axis or a vector
template <class K, class X> auto force(const K& stiffness, const X& displacement) {
    constexpr bool units = detail::is_number_in<unit::Stiffness, K> && detail::is_in<unit::Length, X>;
    static_assert(units, "Ansatz: springs::force takes a stiffness and a displacement; write e.g. force(100.0 * "
                         "newton_per_metre, 0.1 * metre)");
    if constexpr (units)
        return ansatz::detail::stripped<decltype(-(stiffness * displacement))>(-(stiffness * displacement));
}

/// \f$ F = -k x - c v \f$: the damped spring along its axis (notes 3).
/// \param stiffness    N/m
/// \param displacement m
/// \param damping      N s/m
/// \param velocity     m/s, *in the axis of the spring*: what moves across it is not damped
template <class K, class X, class C, class V>
auto force(const K& stiffness, const X& displacement, const C& damping, const V& velocity) {
    constexpr bool units = detail::is_number_in<unit::Stiffness, K> && detail::is_in<unit::Length, X> &&
                           detail::is_number_in<unit::Damping, C> && detail::is_in<unit::Velocity, V>;
    static_assert(units, "Ansatz: springs::force takes stiffness, displacement, damping and velocity; write e.g. "
                         "force(100.0 * newton_per_metre, "
                         "0.1 * metre, 2.0 * newton_second_per_metre, 1.0 * metre_per_second)");
    if constexpr (units)
        return ansatz::detail::stripped<decltype(-(stiffness * displacement))>(-(stiffness * displacement) -
                                                                               damping * velocity);
}

/// What a spring may do: push and pull, or only pull.
enum class Acts : bool {
    both_ways, ///< a spring
    pulling    ///< a rope: slack while it is shorter than its rest length, and it never pushes
};

/// \f$ T = k\,(L - l) + c\,\dot L \f$: what a spring of length L pulls with, negative where it pushes; N.
/// \tparam How a rope's tension is never negative, however fast it shortens
/// \param length      L, m
/// \param rest_length l, m
/// \param speed       dL/dt, m/s: how fast it lengthens
template <Acts How = Acts::both_ways, class L, class R, class V, class K, class C>
[[gnu::always_inline]] inline auto tension(const L& length, const R& rest_length, const V& speed, const K& stiffness,
                                           const C& damping) {
    constexpr bool units = detail::is_number_in<unit::Length, L> && detail::is_number_in<unit::Length, R> &&
                           detail::is_number_in<unit::Velocity, V> && detail::is_number_in<unit::Stiffness, K> &&
                           detail::is_number_in<unit::Damping, C>;
    static_assert(units,
                  "Ansatz: springs::tension takes length, rest length, speed, stiffness and damping; write e.g. "
                  "tension(1.1 * metre, "
                  "1.0 * metre, 0.0 * metre_per_second, 100.0 * newton_per_metre, 2.0 * newton_second_per_metre)");
    if constexpr (units) {
        using Force = ansatz::detail::stripped<decltype(stiffness * length)>;
        const Force pull = stiffness * (length - rest_length) + damping * speed;
        if constexpr (How == Acts::pulling)
            return length > rest_length && pull.value() > typename Force::value_type(0)
                       ? pull
                       : Force::from_value(typename Force::value_type(0));
        else return pull;
    }
}

namespace detail {
/// The same for ends so near that the square of their distance is nothing: a spring that comes to rest passes through
/// such lengths.
template <Acts How, class Force, class X, class V, class R, class K, class C>
[[gnu::cold, gnu::noinline]] Force between_near(X to, V departing, R rest_length, K stiffness,
                                                C damping) { // copies: the loop keeps its own in registers
    const auto length = robust_norm(to);
    if (length.value() == 0) return zero<Force>();
    auto axis = to.value();
    if (!ansatz::detail::unit_vector(to.value(), axis)) axis /= length.value(); // not a number: nor is the force
    return Force(tension<How>(length, rest_length, dot(departing, axis), stiffness, damping) * axis);
}
} // namespace detail

/// \f$ \mathbf F_a = T \mathbf n \f$ with \f$ \mathbf n = \mathbf d / |\mathbf d| \f$: the force of a spring on its first end;
/// on the second it is the opposite (notes 1.3). Damped is what moves along the axis, nothing else. Ends in one place
/// have no axis and feel nothing.
/// \param to        d, m: from the first end to the second
/// \param departing m/s: the velocity of the second end less that of the first
/// \return a vector in N
template <Acts How = Acts::both_ways, class X, class V, class R, class K, class C>
[[gnu::always_inline]] inline auto between(const X& to, const V& departing, const R& rest_length, const K& stiffness,
                                           const C& damping) {
    constexpr bool vectors = detail::is_in<unit::Length, X> && detail::is_in<unit::Velocity, V> &&
                             !detail::is_number_in<unit::Length, X> && !detail::is_number_in<unit::Velocity, V>;
    constexpr bool numbers = detail::is_number_in<unit::Length, R> && detail::is_number_in<unit::Stiffness, K> &&
                             detail::is_number_in<unit::Damping, C>;
    static_assert(
        vectors,
        "Ansatz: springs::between takes the vector from the first end to the second, and the second's velocity less "
        "the first's; "
        "write e.g. between(metres(0, -1, 0), metres_per_second(0, 0, 0), 1.0 * metre, 100.0 * newton_per_metre, 2.0 * "
        "newton_second_per_metre)");
    static_assert(
        numbers || !vectors,
        "Ansatz: springs::between takes behind its two vectors a rest length, a stiffness and a damping; write e.g. "
        "1.0 * metre, 100.0 * newton_per_metre, 2.0 * newton_second_per_metre");
    if constexpr (vectors && numbers) {
        using Force = ansatz::detail::stripped<decltype(stiffness * to)>;
        const auto squared = squared_norm(to);
        using Scalar = typename ansatz::detail::stripped<decltype(squared)>::value_type;
        if (!(squared.value() >= ansatz::detail::smallest_square<Scalar>()))
            return detail::between_near<How, Force>(to, departing, rest_length, stiffness, damping);
        const auto length = sqrt(squared);
        const auto per_length = Scalar(1) / length;
        const auto pull = tension<How>(length, rest_length, dot(departing, to) * per_length, stiffness, damping);
        return Force((pull * per_length) * to);
    }
}

/// \f$ \tfrac12 k x^2 \f$: what a displaced spring holds, J.
template <class K, class X> auto energy(const K& stiffness, const X& displacement) {
    constexpr bool units = detail::is_number_in<unit::Stiffness, K> && detail::is_number_in<unit::Length, X>;
    static_assert(units, "Ansatz: springs::energy takes a stiffness and a displacement; write e.g. energy(100.0 * "
                         "newton_per_metre, 0.1 * metre)");
    if constexpr (units) return 0.5 * stiffness * displacement * displacement;
}

/// \name Constants from how it should swing, and back
/// Masses are finite and greater than zero, frequencies not negative, ratios not negative.
/// All throw std::invalid_argument for other values.
/// @{

/// \f$ m_1 m_2 / (m_1 + m_2) \f$: the mass that swings when a spring joins two free ones, kg.
template <class M1, class M2> auto reduced_mass(const M1& first, const M2& second) {
    constexpr bool units = detail::is_number_in<unit::Mass, M1> && detail::is_number_in<unit::Mass, M2>;
    static_assert(
        units,
        "Ansatz: springs::reduced_mass takes two masses; write e.g. reduced_mass(1.0 * kilogram, 3.0 * kilogram)");
    if constexpr (units) {
        require_positive("springs::reduced_mass", "first", first);
        require_positive("springs::reduced_mass", "second", second);
        return ansatz::detail::stripped<M1>(first * (second / (first + second)));
    }
}
/// \f$ k = m (2 \pi f)^2 \f$, N/m.
/// \param frequency swings per second, 1/s
template <class F, class M> auto stiffness(const F& frequency, const M& mass) {
    constexpr bool units = detail::is_number_in<unit::Frequency, F> && detail::is_number_in<unit::Mass, M>;
    static_assert(
        units,
        "Ansatz: springs::stiffness takes a frequency and a mass; write e.g. stiffness(2.0 / second, 1.0 * kilogram)");
    if constexpr (units) {
        require_not_negative("springs::stiffness", "frequency", frequency);
        require_positive("springs::stiffness", "mass", mass);
        const auto omega = detail::two_pi * frequency;
        return mass * omega * omega;
    }
}
/// \f$ c = 2 \zeta m\, 2 \pi f \f$, N s/m.
/// \param ratio zeta: 1 returns fastest without swinging over, less swings, more creeps
template <class F, class R, class M> auto damping(const F& frequency, const R& ratio, const M& mass) {
    constexpr bool units = detail::is_number_in<unit::Frequency, F> && std::is_convertible_v<R, double> &&
                           detail::is_number_in<unit::Mass, M>;
    static_assert(units, "Ansatz: springs::damping takes a frequency, a damping ratio and a mass; write e.g. "
                         "damping(2.0 / second, 0.1, 1.0 * kilogram)");
    if constexpr (units) {
        const double zeta = ratio;
        require_not_negative("springs::damping", "frequency", frequency);
        require_not_negative("springs::damping", "ratio", zeta * unit::Dimensionless());
        require_positive("springs::damping", "mass", mass);
        return (2 * zeta * detail::two_pi) * frequency * mass;
    }
}
/// \f$ \omega = \sqrt{k / m} \f$ of the undamped spring, 1/s.
template <class K, class M> auto angular_frequency(const K& stiffness, const M& mass) {
    constexpr bool units = detail::is_number_in<unit::Stiffness, K> && detail::is_number_in<unit::Mass, M>;
    static_assert(units, "Ansatz: springs::angular_frequency takes a stiffness and a mass; write e.g. "
                         "angular_frequency(100.0 * newton_per_metre, 1.0 * kilogram)");
    if constexpr (units) {
        require_not_negative("springs::angular_frequency", "stiffness", stiffness);
        require_positive("springs::angular_frequency", "mass", mass);
        return sqrt(stiffness / mass);
    }
}
/// \f$ f = \omega / 2 \pi \f$: swings per second of the undamped spring, 1/s.
template <class K, class M> auto frequency(const K& stiffness, const M& mass) {
    constexpr bool units = detail::is_number_in<unit::Stiffness, K> && detail::is_number_in<unit::Mass, M>;
    static_assert(units, "Ansatz: springs::frequency takes a stiffness and a mass; write e.g. frequency(100.0 * "
                         "newton_per_metre, 1.0 * kilogram)");
    if constexpr (units) return angular_frequency(stiffness, mass) / detail::two_pi;
}
/// \f$ 2 \sqrt{k m} \f$: the damping above which nothing swings, N s/m. Not sqrt(k m).
template <class K, class M> auto critical_damping(const K& stiffness, const M& mass) {
    constexpr bool units = detail::is_number_in<unit::Stiffness, K> && detail::is_number_in<unit::Mass, M>;
    static_assert(units, "Ansatz: springs::critical_damping takes a stiffness and a mass; write e.g. "
                         "critical_damping(100.0 * newton_per_metre, 1.0 * kilogram)");
    if constexpr (units) {
        require_not_negative("springs::critical_damping", "stiffness", stiffness);
        require_positive("springs::critical_damping", "mass", mass);
        return 2.0 * (sqrt(stiffness / mass) * mass);
    }
}
/// \f$ \zeta = c / (2 \sqrt{k m}) \f$, a number; infinite for a damper without stiffness.
template <class K, class C, class M> double damping_ratio(const K& stiffness, const C& damping, const M& mass) {
    constexpr bool units = detail::is_number_in<unit::Stiffness, K> && detail::is_number_in<unit::Damping, C> &&
                           detail::is_number_in<unit::Mass, M>;
    static_assert(units, "Ansatz: springs::damping_ratio takes a stiffness, a damping and a mass; write e.g. "
                         "damping_ratio(100.0 * newton_per_metre, "
                         "2.0 * newton_second_per_metre, 1.0 * kilogram)");
    if constexpr (units) {
        require_not_negative("springs::damping_ratio", "damping", damping);
        const auto critical = critical_damping(stiffness, mass);
        return damping.value() == 0 ? 0.0 : double(damping.value() / critical.value());
    } else return 0;
}
/// @}

} // namespace ansatz::springs
