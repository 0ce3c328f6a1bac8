// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The schedule of a step: the systems of all modules and policies of a world, in the order of their phases.
///
/// A system says at which phase it acts, `static constexpr Phase phase = phases::fields;`, under which `name`, and
/// what it does, `static void run(auto& step)`. The order is that of the phases, and of the names within one phase; how
/// the policies are listed means nothing. Phases are places on a line, not an enumeration: `between(phases::positions,
/// phases::fields)` is one, too, and a module names its own.
///
/// A *driver* is a system that owns the phases up to another one, `static constexpr Phase until = phases::fields;`.
/// It is handed what stands in between as a function, `run(step, inside)`, and calls it as it likes: a response that
/// takes a step in substeps calls it several times.

#include <ansatz/world/composition.hpp>

#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace ansatz {

/// A place in the order of a step.
struct Phase {
    double at;                                                               ///< greater is later
    friend constexpr bool operator==(const Phase&, const Phase&) = default;  ///< the same place
    friend constexpr auto operator<=>(const Phase&, const Phase&) = default; ///< earlier or later
};
/// A place behind one and before another.
constexpr Phase between(Phase a, Phase b) { return {(a.at + b.at) / 2}; }

/// The phases that the library names.
namespace phases {
inline constexpr Phase wake{0};      ///< bodies that must not sleep any longer wake
inline constexpr Phase begin{10};    ///< the state that the step starts from is read
inline constexpr Phase substeps{20}; ///< a driver that takes the step in substeps owns what follows, behind `positions`
inline constexpr Phase forces{30};   ///< laws and couplings, and the effects before them
inline constexpr Phase integration{40}; ///< stages; then the effects behind them
inline constexpr Phase positions{50};   ///< solvers that move bodies behind the integrator
inline constexpr Phase fields{70};      ///< what has a state of its own advances
inline constexpr Phase end{80};         ///< effects of the whole step
inline constexpr Phase clock{90};       ///< time goes on
inline constexpr Phase breaking{100};   ///< what is too weak for the state that was made breaks
inline constexpr Phase sums{110};       ///< what queries read and the next step begins with is summed
inline constexpr Phase rest{120};       ///< bodies that have come to rest fall asleep
inline constexpr Phase observers{130};  ///< observers see the state
} // namespace phases

namespace detail {

template <class Y> inline constexpr bool is_driver = requires { Y::until; };

/// Systems by phase, then by name.
template <class List> struct InOrder;
template <class... Y> struct InOrder<Types<Y...>> {
    static constexpr int size = int(sizeof...(Y));
    struct Entry {
        Phase phase;
        std::string_view name;
        int number;
        constexpr bool operator<(const Entry& other) const {
            return phase != other.phase ? phase < other.phase : name < other.name;
        }
    };
    static constexpr auto order = [] {
        std::array<Entry, sizeof...(Y)> all{};
        int n = 0;
        ((all[std::size_t(n)] = Entry{Y::phase, Y::name, n}, ++n), ...);
        for (int i = 1; i < size; ++i)
            for (int k = i; k > 0 && all[std::size_t(k)] < all[std::size_t(k - 1)]; --k)
                std::swap(all[std::size_t(k)], all[std::size_t(k - 1)]);
        return all;
    }();
    /// Whether two of one name stand at one phase, so that their order would be that of the list.
    static constexpr bool ambiguous = [] {
        for (int i = 1; i < size; ++i)
            if (order[std::size_t(i)].phase == order[std::size_t(i - 1)].phase &&
                order[std::size_t(i)].name == order[std::size_t(i - 1)].name)
                return true;
        return false;
    }();
    template <int K>
    using at = std::tuple_element_t<std::size_t(order[std::size_t(K)].number), std::tuple<std::type_identity<Y>...>>;
    /// The first from `K` on that stands at a phase or behind it.
    static constexpr int first_at(int from, Phase phase) {
        while (from < size && order[std::size_t(from)].phase < phase) ++from;
        return from;
    }
};

/// Runs the systems from `K` up to `End`.
template <class Schedule, int K, int End, class StepT> void run_systems(StepT& step) {
    if constexpr (K < End) {
        using Y = typename Schedule::template at<K>::type;
        if constexpr (is_driver<Y>) {
            constexpr int behind = Schedule::first_at(K + 1, Y::until);
            static_assert(behind <= End, "Ansatz: two drivers of a step overlap; one must own the phases of the other");
            Y::run(step, [](auto& part) { run_systems<Schedule, K + 1, behind>(part); });
            run_systems<Schedule, behind, End>(step);
        } else {
            Y::run(step);
            run_systems<Schedule, K + 1, End>(step);
        }
    }
}

} // namespace detail
} // namespace ansatz
