// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The few conditions that parameters of policies are held to, each with the library's one form of a sentence.
/// A policy's `check()` calls them; the world calls `check()` before it takes the policy.

#include <ansatz/core/error.hpp>
#include <ansatz/units/describe.hpp>
#include <ansatz/units/function.hpp>

#include <string_view>

namespace ansatz {

/// \throws std::invalid_argument unless every component is finite
template <class Unit, class Value>
void require_finite(std::string_view where, std::string_view what, const boost::units::quantity<Unit, Value>& q) {
    if (!is_finite(q)) refuse_value(where, what, q, "it must be finite");
}
/// \throws std::invalid_argument unless finite and at least zero
template <class Unit, class Value>
void require_not_negative(std::string_view where, std::string_view what, const boost::units::quantity<Unit, Value>& q) {
    if (!is_finite(q) || q.value() < 0) refuse_value(where, what, q, "it must be finite and not negative");
}
/// \throws std::invalid_argument unless finite and greater than zero
template <class Unit, class Value>
void require_positive(std::string_view where, std::string_view what, const boost::units::quantity<Unit, Value>& q) {
    if (!is_finite(q) || !(q.value() > 0)) refuse_value(where, what, q, "it must be finite and greater than zero");
}

} // namespace ansatz
