// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How a user's own datum stands in a file: as text.
// not in the umbrella: it is a part of save.hpp
///
/// A whole number, a bool, an enumeration and a std::string stand as they are read. Any other type has two functions
/// beside it, found by argument:
///
///     std::string datum_to_text(const Sprite& sprite);
///     void datum_from_text(Sprite& sprite, const std::string& text);   // throws std::invalid_argument
///
/// Without them a trivially copyable type, a double among them, is saved byte for byte: for programs of one compiler
/// and machine, and not for a struct with pointers, which mean nothing in another run; a pointer itself is not saved.
/// Any bytes of a file are taken back, so that files of strangers ask for the two functions as well.
/// What is left (a std::shared_ptr, say) is not saved: a body that the loading world has keeps its datum, every other
/// begins with a new one.

#include <ansatz/core/error.hpp>

#include <charconv>
#include <concepts>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace ansatz::detail {

template <class T>
concept DatumHasText = requires(const T& datum, T& into, const std::string& text) {
    { datum_to_text(datum) } -> std::convertible_to<std::string>;
    datum_from_text(into, text);
};
template <class T>
inline constexpr bool datum_is_bytes = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T> &&
                                       !std::is_member_pointer_v<T> && !std::same_as<T, std::nullptr_t>;
/// Whether it is saved.
template <class T>
inline constexpr bool datum_is_saved = DatumHasText<T> || std::same_as<T, std::string> || datum_is_bytes<T>;

template <class T> std::string datum_text(const T& datum) {
    if constexpr (DatumHasText<T>) return datum_to_text(datum);
    else if constexpr (std::same_as<T, std::string>) return datum;
    else if constexpr (std::same_as<T, bool>) return datum ? "true" : "false";
    else if constexpr (std::is_enum_v<T>) return datum_text(static_cast<std::underlying_type_t<T>>(datum));
    else if constexpr (std::is_integral_v<T>) return std::to_string(datum);
    else {
        constexpr const char* digits = "0123456789abcdef";
        unsigned char bytes[sizeof(T)];
        std::memcpy(bytes, &datum, sizeof(T));
        std::string text;
        for (const unsigned char byte : bytes) text += {digits[byte / 16], digits[byte % 16]};
        return text;
    }
}

/// \throws std::invalid_argument with what was expected
template <class T> void datum_from(T& datum, const std::string& text) {
    if constexpr (DatumHasText<T>) datum_from_text(datum, text);
    else if constexpr (std::same_as<T, std::string>) datum = text;
    else if constexpr (std::same_as<T, bool>) {
        if (text != "true" && text != "false") throw std::invalid_argument("\"true\" or \"false\"");
        datum = text == "true";
    } else if constexpr (std::is_enum_v<T>) {
        std::underlying_type_t<T> number{};
        datum_from(number, text);
        datum = static_cast<T>(number);
    } else if constexpr (std::is_integral_v<T>) {
        T number{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc() || end != text.data() + text.size())
            throw std::invalid_argument("a whole number, as text, that the datum's type can hold");
        datum = number;
    } else {
        const auto digit = [](char c) {
            return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
        };
        unsigned char bytes[sizeof(T)];
        bool whole = text.size() == 2 * sizeof(T);
        for (std::size_t i = 0; whole && i < sizeof(T); ++i) {
            const int high = digit(text[2 * i]), low = digit(text[2 * i + 1]);
            whole = high >= 0 && low >= 0;
            bytes[i] = static_cast<unsigned char>(16 * high + low);
        }
        if (!whole)
            throw std::invalid_argument("the " + std::to_string(sizeof(T)) +
                                        " bytes of the datum as hexadecimal digits, two a byte");
        std::memcpy(&datum, bytes, sizeof(T));
    }
}

} // namespace ansatz::detail
