// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `FileValue`: a value in a file of a world, with its place, so that every refusal says where and what was expected.
// not in the umbrella: it is a part of save.hpp, and needs nlohmann-json

#include <ansatz/core/error.hpp>
#include <ansatz/units.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <istream>
#include <limits>
#include <string>
#include <type_traits>

namespace ansatz {

namespace detail {

using Json = nlohmann::ordered_json;

/// Reads a file. What nests deeper than any file of ours is left out: a hundred thousand brackets must not be followed
/// down, and to copy them or to write them into a sentence is to follow them down.
inline Json parse_file(std::istream& in, bool throws = true) {
    constexpr int deepest = 100;
    return Json::parse(
        in, [](int depth, Json::parse_event_t, Json&) { return depth < deepest; }, throws);
}

/// A value in a file, with its place for the sentence about it.
struct FileValue {
    const Json& json;
    std::string place;
    bool root = false;

    [[noreturn]] void refuse_here(const std::string& expected) const {
        // What nests deeply is named, not shown: a file of a hundred thousand brackets must not be followed down.
        auto shown = deeper_than(json, 4) ? std::string(json.is_array() ? "a list" : "an object") : json.dump();
        if (shown.size() > 40) shown = shown.substr(0, 37) + "...";
        refuse(Refusal::invalid_argument, place + " is " + shown + "; expected " + expected);
    }
    static bool deeper_than(const Json& json, int levels) {
        if (!json.is_structured()) return false;
        return levels == 0 ||
               std::any_of(json.begin(), json.end(), [&](const Json& part) { return deeper_than(part, levels - 1); });
    }
    /// Whether an object has a value of this name: for what stands there only at times.
    bool has(const char* key) const { return json.is_object() && json.contains(key); }
    FileValue at(const char* key) const {
        if (!json.is_object()) refuse_here(std::string("an object with \"") + key + "\"");
        const auto found = json.find(key);
        if (found == json.end())
            refuse(Refusal::invalid_argument, place + ": expected \"" + key + "\", but there is none");
        return {*found, place + (root ? ": " : ".") + key};
    }
    FileValue at(std::size_t i) const { return {json[i], place + "[" + std::to_string(i) + "]"}; }
    std::size_t size(const char* of) const {
        if (!json.is_array()) refuse_here(std::string("a list of ") + of);
        return json.size();
    }
    void size_is(std::size_t n, const char* of) const {
        if (size(of) != n) refuse_here("a list of " + std::to_string(n) + " " + of);
    }
    std::uint64_t whole(std::uint64_t most) const {
        if (!json.is_number_unsigned() || json.get<std::uint64_t>() > most)
            refuse_here("a whole number from 0 to " + std::to_string(most));
        return json.get<std::uint64_t>();
    }
    /// The same with a sign, where its type has one.
    template <class T> T integer() const {
        if constexpr (std::is_signed_v<T>)
            if (json.is_number_integer() && !json.is_number_unsigned()) {
                const auto value = json.get<std::int64_t>();
                if (value < std::int64_t(std::numeric_limits<T>::min()))
                    refuse_here("a whole number from " + std::to_string(std::numeric_limits<T>::min()) + " to " +
                                std::to_string(std::numeric_limits<T>::max()));
                return T(value);
            }
        return T(whole(std::uint64_t(std::numeric_limits<T>::max())));
    }
    bool yes() const {
        if (!json.is_boolean()) refuse_here("true or false");
        return json.get<bool>();
    }
    void is(const Json& expected, const char* why) const {
        if (json != expected) refuse_here(expected.dump() + why);
    }
    /// The parameters of a policy, or of anything else that names them: save_parameters.hpp.
    template <class P> void parameters(P& description) const;
    /// A finite number. Class scalars stand as text, because JSON's numbers are read as doubles.
    template <class T> T number() const {
        T value{};
        if constexpr (std::is_floating_point_v<T>) {
            if (!json.is_number()) refuse_here("a finite number");
            value = static_cast<T>(json.get<double>());
        } else {
            if (!json.is_string()) refuse_here("a number as text");
            try {
                value = T(json.get<std::string>());
            } catch (const std::exception&) {
                refuse_here("a number as text");
            }
        }
        if (!is_finite(value)) refuse_here("a finite number that the world's scalar can hold");
        return value;
    }
};

template <class T> Json number_to_file(const T& x) {
    if constexpr (std::is_floating_point_v<T>) {
        if (is_finite(x)) return double(x);
        return x != x ? "nan" : x > 0 ? "inf" : "-inf"; // for a person to read; load refuses it
    } else return x.str(std::numeric_limits<T>::max_digits10, std::ios_base::scientific);
}

} // namespace detail
} // namespace ansatz
