// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What stands in the attributes of a machine's file: lists of names, names as a sentence shows them, and the condition
/// In('x'), which holds while the machine is in x.

#include <ansatz/core/compiler_flags.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ansatz::states::detail {

/// Splits a text at white space.
inline std::vector<std::string> words(std::string_view text) {
    std::vector<std::string> found;
    for (std::size_t at = text.find_first_not_of(" \t\n\r"); at != std::string_view::npos;) {
        const auto end = text.find_first_of(" \t\n\r", at);
        found.emplace_back(text.substr(at, end - at));
        at = end == std::string_view::npos ? end : text.find_first_not_of(" \t\n\r", end);
    }
    return found;
}

/// A name as a sentence shows it: not longer than a line, and without what a terminal would act on.
inline std::string shown(std::string_view name) {
    std::string text = "\"";
    for (const char c : name.substr(0, 80)) text += static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
    return text + (name.size() > 80 ? "...\"" : "\"");
}

/// What a condition asks that is In('x') or !In('x'), the predicate of SCXML; no state for another condition.
struct InPredicate {
    std::string_view state;
    bool negated = false;
};
inline InPredicate in_predicate(std::string_view condition) {
    const auto skip = [&] {
        while (!condition.empty() && std::string_view(" \t\n\r").find(condition.front()) != std::string_view::npos)
            condition.remove_prefix(1);
    };
    const auto take = [&](std::string_view what) {
        skip();
        if (!condition.starts_with(what)) return false;
        condition.remove_prefix(what.size());
        return true;
    };
    InPredicate asked;
    asked.negated = take("!");
    if (!take("In") || !take("(")) return {};
    skip();
    if (condition.empty() || (condition.front() != '\'' && condition.front() != '"')) return {};
    const auto end = condition.find(condition.front(), 1);
    if (end == std::string_view::npos) return {};
    const auto state = condition.substr(1, end - 1);
    condition.remove_prefix(end + 1);
    if (!take(")")) return {};
    skip();
    if (!condition.empty()) return {};
    asked.state = state;
    return asked;
}

/// The first byte of a text that no XML of UTF-8 may hold: a control character, half a character, one of the surrogates
/// or of the two that are none; the length of the text where there is none.
inline std::size_t first_bad_byte(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = [&](std::size_t k) { return i + k < text.size() ? unsigned(std::uint8_t(text[i + k])) : 0u; };
        const unsigned lead = byte(0);
        const std::size_t length = lead < 0x80 ? 1 : lead >> 5 == 6 ? 2 : lead >> 4 == 14 ? 3 : lead >> 3 == 30 ? 4 : 0;
        if (length == 0) return i;
        unsigned code = length == 1 ? lead : lead & (0x7fu >> length);
        for (std::size_t k = 1; k < length; ++k) {
            if (byte(k) >> 6 != 2) return i;
            code = code << 6 | (byte(k) & 0x3f);
        }
        static constexpr unsigned least[] = {0, 0x20, 0x80, 0x800, 0x10000};
        const bool blank = code == '\t' || code == '\n' || code == '\r';
        if ((code < least[length] && !blank) || code > 0x10ffff || code >> 11 == 0x1b || code == 0xfffe ||
            code == 0xffff)
            return i;
        i += length;
    }
    return text.size();
}

} // namespace ansatz::states::detail
