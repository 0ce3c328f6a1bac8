// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How a machine names its parts while it runs: numbers in the order of the description, which cannot be mixed up, and
/// the moment at which a guard is asked. Names are for the description, for files and for people; look one up once
/// (`event<GuardNpc>("alarm")`) and keep the number.

#include <ansatz/units.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ansatz {

/// A state: its place in the description, depth first. 0 is the machine itself, the root of all states.
enum class StateId : std::uint16_t { root = 0, none = 0xffff };
/// An event: its place among the names that the description mentions.
enum class EventId : std::uint16_t { none = 0xffff };
/// A transition: its place in the description.
enum class TransitionId : std::uint16_t { none = 0xffff };

/// The number of an id, to index an array with.
template <class Id>
    requires(std::is_enum_v<Id>)
constexpr std::size_t index(Id id) {
    return std::size_t(id);
}

namespace states {

/// What a state is.
enum class Kind : std::uint8_t { state, parallel, final, shallow_history, deep_history };

/// Whether a state is a memory of where its parent was, not a place to be.
constexpr bool is_history(Kind kind) { return kind == Kind::shallow_history || kind == Kind::deep_history; }

/// Whether an event of this name belongs to a list of descriptors: "alarm lost.*" takes alarm, alarm.loud and
/// lost.sight, not alarmed; "*" takes everything (the rule of SCXML: a descriptor is a prefix of whole words).
constexpr bool matches(std::string_view descriptors, std::string_view name) {
    while (!descriptors.empty()) {
        const auto end = descriptors.find_first_of(" \t\n\r");
        auto one = descriptors.substr(0, end);
        descriptors = end == std::string_view::npos ? std::string_view{} : descriptors.substr(end + 1);
        if (one == "*" || one == ".*") return true;
        if (one.ends_with(".*")) one.remove_suffix(2);
        if (one.ends_with('.')) one.remove_suffix(1);
        if (one.empty() || !name.starts_with(one)) continue;
        if (name.size() == one.size() || name[one.size()] == '.') return true;
    }
    return false;
}

/// What a guard is asked with: the user's context, the data of the state that asks, and the time.
/// \tparam Context  the user's
/// \tparam Own      the state class of the transition's source, or NoBehaviour
template <class Context, class Own> struct Question {
    Context& context; ///< the user's
    const Own& own;   ///< the data of the transition's source
    Quantity<unit::Time>
        in_state;            ///< since the source of the transition was entered; 0 s where the machine keeps no time
    Quantity<unit::Time> dt; ///< of this update; 0 s where an event asks
};

/// The data of a state that has none.
struct NoBehaviour {};

} // namespace states
} // namespace ansatz
