// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `OscillationReport`: a watcher that sees a machine turn back and forth (notes 5.2, state oscillations).
///
/// More than n transitions between the same two states within a time are an oscillation. The report says which states,
/// since when, and how often; it does not stop the machine. Against it help a band of hysteresis, where the value is
/// noisy, and a dwell time, where the behaviour of the states itself throws the value back.

#include <ansatz/states/options.hpp>

#include <algorithm>

namespace ansatz {

/// Option of Machine: sees oscillations between pairs of states.
class OscillationReport {
public:
    /// Pairs of states that are watched at once; the one that rested longest makes room.
    static constexpr std::size_t most_pairs = 16;
    static constexpr std::size_t most_turns = 32; ///< the largest n

    /// A pair of states between which the machine oscillated.
    struct Oscillation {
        StateId a = StateId::none,    ///< one state
            b = StateId::none;        ///< the other
        Quantity<unit::Time> since{}; ///< the first transition of those that were too many
        std::uint64_t turns = 0;      ///< transitions between the two, since the report began
    };

    /// \param turns   more than this many transitions between two states, 1 to 31
    /// \param within  in this time, finite and greater than 0 s
    /// \throws std::invalid_argument for others
    explicit OscillationReport(std::uint32_t turns = 4, Parameter<unit::Time> within = 1.0 * second)
        : turns_(turns), within_(within) {
        if (turns < 1 || turns >= most_turns)
            refuse_value("OscillationReport", "turns", std::to_string(turns), "it is 1 to 31");
        if (!(within.value() > 0) || !is_finite(within))
            refuse_value("OscillationReport", "within", within, "it is finite and greater than 0 s");
    }

    /// A transition goes from the outermost state that it leaves to the outermost that it enters.
    void operator()(const Happening& h) {
        using What = Happening::What;
        if (h.what == What::exited) left_ = h.state;
        if (h.what != What::entered || left_ == StateId::none) return;
        turn(left_, h.state, h.time);
        left_ = StateId::none;
    }

    bool oscillates() const { return size() > 0; } ///< whether there was any
    /// How many pairs oscillated.
    std::size_t size() const {
        return std::size_t(std::count_if(pairs_.begin(), pairs_.end(), [](const Pair& p) { return p.reported; }));
    }
    /// The pairs that oscillated, one after the other.
    template <class F> void for_each(F&& f) const {
        for (const auto& p : pairs_)
            if (p.reported) f(Oscillation{p.a, p.b, p.since, p.turns});
    }

private:
    struct Pair {
        StateId a = StateId::none, b = StateId::none;
        std::uint64_t turns = 0;
        bool reported = false;
        Quantity<unit::Time> since{}, last{};
        std::array<Quantity<unit::Time>, most_turns> times{};
    };
    void turn(StateId from, StateId to, Quantity<unit::Time> now) {
        if (from == to) return;
        const StateId a = std::min(from, to), b = std::max(from, to);
        auto pair = std::find_if(pairs_.begin(), pairs_.end(), [&](const Pair& p) { return p.a == a && p.b == b; });
        if (pair == pairs_.end()) {
            // A pair that was reported stays as long as there is another.
            pair = std::min_element(pairs_.begin(), pairs_.end(), [](const Pair& p, const Pair& q) {
                return std::pair(p.reported, p.a == StateId::none ? -1.0 : p.last.value()) <
                       std::pair(q.reported, q.a == StateId::none ? -1.0 : q.last.value());
            });
            *pair = Pair{};
            pair->a = a, pair->b = b;
        }
        pair->last = now;
        pair->times[std::size_t(pair->turns++ % most_turns)] = now;
        if (pair->turns > turns_ && !pair->reported) {
            const auto first = pair->times[std::size_t((pair->turns - 1 - turns_) % most_turns)];
            if ((now - first).value() <= within_.value() * (1 + 1e-9)) pair->reported = true, pair->since = first;
        }
    }

    std::uint32_t turns_;
    Quantity<unit::Time> within_;
    std::array<Pair, most_pairs> pairs_{};
    StateId left_ = StateId::none;
};

} // namespace ansatz
