// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `in_ranges`: how a loop over the rows of a world is run, by the world's Execution if it has one.
///
/// An Execution is a policy of your own, on std::thread or on whatever your program runs its threads with:
///
///     struct MyThreads {
///         using role = roles::Execution;
///         void execute(std::size_t count, std::size_t grain, const auto& loop) const;
///     };
///
/// `execute` calls `loop(begin, end)` for ranges that are disjoint and together are 0 to `count`, in any order, on any
/// threads, and returns when all of them have returned. A range of less than `grain` is not worth a thread. An
/// Execution may say how many threads it has, `int threads() const`: then what is divided at a cost is not divided
/// further. Which ranges, and on which threads, changes no bit of a world: a row writes its own values only, counts are
/// whole numbers, and the elements of a sum are added row by row in the order in which a serial loop adds them
/// (motion/gathering.hpp).
///
/// What a policy may rely on: no loop asks for another one, and none throws unless a policy of yours does; what that
/// throws must leave `execute`, once the other ranges have returned, and the world is lost then, as it is where a
/// serial step throws. What relies on it: `execute` may be called by several threads at once, by those that ask a world
/// that does not change and by those that step its copies, so that threads that are kept serve one call at a time. The
/// laws, filters and shapes of a world with an Execution are asked at the same time, so that they must not change what
/// they share; those of the library do not.
///
/// Not for what a step does in an order, such as answering one contact after the other, islands of sleep, and the door:
/// that stays serial.

#include <ansatz/world/roles.hpp>
#include <ansatz/world/types.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace ansatz {

namespace detail {
template <class P> struct IsExecution : std::bool_constant<PlaysRole<P, roles::Execution>> {};
/// The one of a world that has one.
template <class... P> const auto& execution_of(const std::tuple<P...>& policies) {
    return std::get<typename FirstIn<filter<IsExecution, P...>>::type>(policies);
}

/// How many threads the Execution of a world has, if it says so: `threads()`; else 0.
template <class C, class Policies> std::size_t threads_of([[maybe_unused]] const Policies& policies) {
    if constexpr (C::executed)
        if constexpr (requires { std::size_t(execution_of(policies).threads()); })
            return std::size_t(execution_of(policies).threads());
    return 0;
}

/// How many rows of a lane fill a cache line: ranges that begin there share none.
template <class Scalar> inline constexpr std::size_t rows_of_a_line = sizeof(Scalar) < 64 ? 64 / sizeof(Scalar) : 1;
/// A range of fewer cache lines takes less time than waking a thread does.
inline constexpr std::size_t grain_in_lines = 32;

/// What runs a loop where no Execution does.
struct Serially {
    template <class Loop>
    [[gnu::always_inline]] void operator()(std::size_t count, std::size_t, const Loop& loop) const {
        loop(std::size_t(0), count);
    }
};
/// Runs loops as the Execution of a world does: `run(count, grain, loop)`.
template <class C, class Policies>
[[gnu::always_inline]] inline auto runner_of([[maybe_unused]] const Policies& policies) {
    if constexpr (C::executed)
        return [&policies](std::size_t count, std::size_t grain, const auto& loop) {
            execution_of(policies).execute(count, grain, loop);
        };
    else return Serially();
}
} // namespace detail

/// Runs loops as an Execution does, `run(count, grain, loop)`, for code that does not know its type; made without one,
/// on the thread that calls. It refers to the Execution, which must outlive it.
class LoopRunner {
public:
    LoopRunner() = default; ///< Of no Execution.
    /// Of one.
    template <class Execution>
        requires(!std::same_as<Execution, LoopRunner>)
    explicit LoopRunner(const Execution& execution)
        : execution_(&execution), execute_([](const void* of, std::size_t count, std::size_t grain, const Loop& loop) {
              static_cast<const Execution*>(of)->execute(count, grain, loop);
          }) {}
    /// Of one that is gone when it is asked.
    template <class Execution>
        requires(!std::same_as<Execution, LoopRunner>)
    explicit LoopRunner(const Execution&&) = delete;
    /// Calls `loop(begin, end)` for ranges that together are 0 to `count`.
    template <class L> void operator()(std::size_t count, std::size_t grain, const L& loop) const {
        if (execute_ == nullptr) return loop(std::size_t(0), count);
        execute_(execution_, count, grain, {&loop, [](const void* of, std::size_t begin, std::size_t end) {
                                                (*static_cast<const L*>(of))(begin, end);
                                            }});
    }

private:
    struct Loop {
        const void* of;
        void (*call)(const void*, std::size_t, std::size_t);
        void operator()(std::size_t begin, std::size_t end) const { call(of, begin, end); }
    };
    const void* execution_ = nullptr;
    void (*execute_)(const void*, std::size_t, std::size_t, const Loop&) = nullptr;
};

/// Calls `loop(first, last)` for ranges of `begin` to `end`, which the Execution of a world runs; once for all of it
/// where the world has none. Every range but the first begins at a multiple of a cache line's rows.
/// \tparam C the world's composition
/// \param policies of the world
template <class C, class Policies, class Loop>
[[gnu::always_inline]] inline void in_ranges([[maybe_unused]] const Policies& policies, std::size_t begin,
                                             std::size_t end, const Loop& loop) {
    if constexpr (C::executed) {
        if (begin >= end) return;
        constexpr std::size_t line = detail::rows_of_a_line<typename C::S::Scalar>;
        const std::size_t before = begin / line, behind = (end + line - 1) / line;
        const auto part = [&](std::size_t first, std::size_t last) {
            if (first < last) loop(std::max(begin, (before + first) * line), std::min(end, (before + last) * line));
        };
        detail::execution_of(policies).execute(behind - before, detail::grain_in_lines, part);
    } else loop(begin, end);
}

} // namespace ansatz
