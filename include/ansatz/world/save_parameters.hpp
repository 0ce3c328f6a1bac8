// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How the parameters of a policy or a shape are written to a file and read from it: a part of save.hpp.
// not in the umbrella: it is a part of save.hpp, and needs nlohmann-json

#include <ansatz/units.hpp>
#include <ansatz/world/file_value.hpp>
#include <ansatz/world/properties.hpp>

#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

namespace ansatz::detail {

/// The parameters of a description by their names: quantities as raw SI numbers, vectors as lists of them.
template <class P> void write_parameters(Json& json, const P& description) {
    P::parameters(description, [&](std::string_view what, const auto& value) {
        auto& number = json[std::string(what)];
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_integral_v<Value>) number = value;
        else if constexpr (std::is_floating_point_v<Value>) number = number_to_file(value);
        else if constexpr (vector_valued<stripped<Value>>)
            for (int i = 0; i < value.value().size(); ++i) number.push_back(number_to_file(value.value()[i]));
        else number = number_to_file(value.value());
    });
}
/// \throws std::invalid_argument naming the place in the file
template <class P> void read_parameters(P& description, const FileValue& json) {
    P::parameters(description, [&](std::string_view what, auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        const auto given = json.at(std::string(what).c_str());
        if constexpr (std::is_same_v<Value, bool>) value = given.yes();
        else if constexpr (std::is_integral_v<Value>) value = given.template integer<Value>();
        else if constexpr (std::is_floating_point_v<Value>) value = given.template number<Value>();
        else {
            using Q = stripped<Value>;
            if constexpr (vector_valued<Q>) {
                auto v = value.value();
                given.size_is(std::size_t(v.size()), "numbers");
                for (int i = 0; i < v.size(); ++i) v[i] = given.at(std::size_t(i)).template number<double>();
                value = Q::from_value(v);
            } else value = Q::from_value(given.template number<double>());
        }
    });
}

template <class P> void FileValue::parameters(P& description) const { read_parameters(description, *this); }

/// What modules write with, so that they need not know the parser.
struct Files {
    using Json = detail::Json; ///< a value in a file
    /// A number.
    template <class T> static Json number(const T& x) { return number_to_file(x); }
    /// Parameters by their names.
    template <class P> static void parameters(Json& json, const P& description) { write_parameters(json, description); }
};

} // namespace ansatz::detail
