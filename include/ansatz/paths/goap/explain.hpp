// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `explain`: why there is no plan, in a sentence that names what is missing.
///
/// It forgets for a moment that actions also undo things, and collects all facts that could ever come to hold, or to
/// cease. If a fact of the goal is not among them, it follows back what that fact would need until something is found
/// that no action brings about. If all are among them, they exclude each other, and only the search could tell.

#include <ansatz/paths/goap/domain.hpp>

#include <cstddef>
#include <string>

namespace ansatz::goap {

namespace detail {

/// Facts that can come to hold, and facts that can cease to.
template <std::size_t W> struct Possible {
    State<W> to_hold, to_cease;
    bool has(Fact f) const { return (f.holds ? to_hold : to_cease).has(f.number); }
    bool all(const Condition<W>& c) const {
        return (c.value & ~to_hold) == State<W>{} && (c.care & ~c.value & ~to_cease) == State<W>{};
    }
    Possible(const Domain<W>& domain, const State<W>& start) : to_hold(start), to_cease(~start) {
        for (bool more = true; more;) {
            more = false;
            for (const auto& rule : domain.rules()) {
                if (!all(rule.needs) || all(rule.makes)) continue;
                to_hold = to_hold | rule.makes.value;
                to_cease = to_cease | (rule.makes.care & ~rule.makes.value);
                more = true;
            }
        }
    }
    /// The first part of a condition that is not possible.
    bool first_missing(const Condition<W>& c, std::size_t facts, Fact& missing) const {
        for (std::size_t i = 0; i < facts; ++i)
            if (const Fact f{i, c.value.has(i)}; c.care.has(i) && !has(f)) {
                missing = f;
                return true;
            }
        return false;
    }
};
} // namespace detail

/// Why no plan leads from this state to that goal; empty if every fact of the goal can be had by itself.
template <std::size_t W>
[[gnu::cold]] std::string explain(const Domain<W>& domain, const State<W>& start, const Condition<W>& goal) {
    const detail::Possible<W> possible(domain, start);
    auto quoted = [&](Fact f) { return std::string(f.holds ? "" : "not ") + "\"" + domain.name_of(f) + "\""; };
    Fact missing;
    if (!possible.first_missing(goal, domain.facts(), missing)) return "";
    std::string text = "the goal wants " + quoted(missing);
    State<W> asked[2]{};
    for (;;) { // each fact is asked for once, so this ends
        asked[missing.holds].set(missing.number, true);
        bool someone = false, follows = false;
        for (Action a = 0; a < domain.actions() && !follows; ++a) {
            const auto& rule = domain.rules()[a];
            if (!rule.makes.care.has(missing.number) || rule.makes.value.has(missing.number) != missing.holds) continue;
            someone = true;
            Fact next;
            if (!possible.first_missing(rule.needs, domain.facts(), next) || asked[next.holds].has(next.number))
                continue;
            text += ", for which \"" + domain.name_of(a) + "\" needs " + quoted(next);
            missing = next;
            follows = true;
        }
        if (follows) continue;
        if (someone) return text + ", and what would make it so needs it first";
        return text + ", and no action makes it so";
    }
}

} // namespace ansatz::goap
