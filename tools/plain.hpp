// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Where a quantity of the course's programs loses its unit: on its way into a picture or a table,
/// whose axis or column then carries the unit's symbol.

#include <ansatz/units/symbol.hpp>

#include <string>
#include <type_traits>

namespace ansatz::workbook {

/// The number in a quantity (in its own unit), or the number itself.
template <class Value> double plain(const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) return static_cast<double>(value);
    else if constexpr (requires { value.value(); }) return static_cast<double>(value.value());
    else return static_cast<double>(value); // a high-precision scalar
}

/// The symbol of a value's unit: "m/s"; empty for plain numbers and dimensionless quantities.
template <class Value> std::string unit_of() {
    if constexpr (requires { typename Value::unit_type; }) return std::string{symbol(typename Value::unit_type{})};
    else return {};
}

} // namespace ansatz::workbook
