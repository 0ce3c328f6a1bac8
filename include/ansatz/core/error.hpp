// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How the library refuses: one function raises every run-time error, with one form of sentence.
///
/// Everything that can be wrong is refused at the door (`add`, `set`, construction, loading, and `step(dt)` before it
/// touches anything); a step itself never throws. A sentence says where, what, the value with its unit, and what would
/// be right: "World::add: mass is -3 kg; a mass is finite and greater than 0 kg".
///
/// What makes a sentence is marked cold, here and in describe.hpp: optimised for speed and inlined, the sentences were
/// half of the machine code of a small program and a tenth of the time it takes to compile.
///
/// A build without exceptions (`-fno-exceptions`) defines `ansatz::refuse` itself; there the library only declares it.

#include <ansatz/core/compiler_flags.hpp>

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ansatz {

/// What kind of refusal: a value that is not acceptable, or something that is not there (any more).
enum class Refusal { invalid_argument, out_of_range };

#if defined(__cpp_exceptions)
/// Raises every run-time error of the library.
/// \throws std::invalid_argument or std::out_of_range, by `kind`
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse(Refusal kind, const std::string& sentence) {
    if (kind == Refusal::out_of_range) throw std::out_of_range(sentence);
    throw std::invalid_argument(sentence);
}
#else
/// Yours to define where exceptions are switched off. It must not return.
[[noreturn]] void refuse(Refusal kind, const std::string& sentence);
#endif

namespace detail {
/// The pieces of a sentence as one text. std::string is a template: what a sentence calls of it, every program with a
/// world compiles, so that all of them call this.
[[gnu::cold, gnu::noinline]] inline std::string joined(std::initializer_list<std::string_view> pieces) {
    std::string text;
    for (const std::string_view piece : pieces) text.append(piece.data(), piece.size());
    return text;
}
} // namespace detail

/// The library's one form of a sentence about a value: "<where>: <what> is <value>; <accepted>".
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse_value(std::string_view where, std::string_view what,
                                                                std::string_view value, std::string_view accepted) {
    refuse(Refusal::invalid_argument, detail::joined({where, ": ", what, " is ", value, "; ", accepted}));
}

} // namespace ansatz
