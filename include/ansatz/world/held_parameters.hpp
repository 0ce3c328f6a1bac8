// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Whether a world's scalar can hold the parameters of a policy or a shape, whose numbers are doubles: asked at the
/// door, for all that name their parameters (`name` and `parameters`, see Gravity). What a step converts is what was
/// accepted here.

#include <ansatz/core/error.hpp>
#include <ansatz/units.hpp>
#include <ansatz/world/properties.hpp>

#include <concepts>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

namespace ansatz::detail {

/// Whether a scalar has numbers of a smaller size than double has.
template <class Scalar>
inline constexpr bool narrower_than_double =
    std::numeric_limits<Scalar>::max_exponent < std::numeric_limits<double>::max_exponent;

template <class P>
concept NamesParameters = requires(P& p) {
    { P::name } -> std::convertible_to<std::string_view>;
    P::parameters(p, [](std::string_view, auto&) {});
};

template <class Scalar>
[[noreturn, gnu::cold, gnu::noinline]] void refuse_not_held(std::string_view where, std::string_view what,
                                                            const std::string& value) {
    refuse_value(where, what, value,
                 "the world's scalar holds numbers up to " + describe(double(std::numeric_limits<Scalar>::max())));
}
/// \throws std::invalid_argument for a finite number that is none in the world's scalar
template <class S, class Unit, class Value>
void require_held(std::string_view where, std::string_view what, const boost::units::quantity<Unit, Value>& q) {
    if constexpr (narrower_than_double<typename S::Scalar>)
        if (is_finite(q) && !is_finite(scalar_cast<typename S::Scalar>(q)))
            refuse_not_held<typename S::Scalar>(where, what, describe(q));
}

/// Asks a policy or a shape about its parameters: as they were given, and as the world's scalar has them.
/// \throws std::invalid_argument naming both
template <class S, class P> void check_in(const P& policy) {
    using Scalar = typename S::Scalar;
    if constexpr (requires { policy.check(); }) policy.check();
    if constexpr (narrower_than_double<Scalar> && NamesParameters<P> && std::copy_constructible<P>) {
        P held = policy;
        P::parameters(held, [](std::string_view what, auto& value) {
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_floating_point_v<Value>) {
                const auto narrow = Value(Scalar(value));
                if (is_finite(value) && !is_finite(narrow)) refuse_not_held<Scalar>(P::name, what, describe(value));
                value = narrow;
            } else if constexpr (!std::is_integral_v<Value>) {
                const stripped<Value> wide = value;
                require_held<S>(P::name, what, wide);
                const stripped<Value> narrow = scalar_cast<double>(scalar_cast<Scalar>(wide));
                // A shape asks about what becomes zero where it is bound, and names what was given.
                if constexpr (!vector_valued<stripped<Value>> && !requires { typename P::role; })
                    if (narrow.value() == 0 && wide.value() != 0) return;
                value = narrow;
            }
        });
        if constexpr (requires { held.check(); }) held.check(); // what is greater than zero may be none in it
    }
}

} // namespace ansatz::detail
