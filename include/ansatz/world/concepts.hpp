// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// One concept for each role that belongs to no module, with every expression that the role needs, and what the
/// concepts of the modules (motion/concepts.hpp, collision/concepts.hpp) have in common.
///
/// A policy author reads the concept of the role, writes a struct with those expressions, and asserts it:
/// `static_assert(ObserverIn<MyRecorder, Space<>>);`. `check.hpp` says the same facts as sentences.

#include <ansatz/world/composition.hpp>
#include <ansatz/world/view.hpp>

#include <concepts>
#include <type_traits>
#include <utility>

namespace ansatz {

namespace detail {

template <class P>
concept DeclaresReads = requires { typename P::reads; } && is_columns<reads_of<P>>;
template <class P>
concept DeclaresWrites = requires { typename P::writes; } && is_columns<writes_of<P>>;
template <class P, class S>
concept Binds = requires { typename Bound<P, S>; } && std::constructible_from<Bound<P, S>, const P&>;

template <class P>
concept HasCheck = requires(const P& p) { p.check(); };

/// The verbs that a policy may have or not. One that is there and cannot be called would be passed over in silence, so
/// it is found by its name alone: beside this struct the name is ambiguous. (Nothing can be beside a final class.)
struct OptionalVerbs {
    int check, prepare, observe, report;
};
template <class P>
struct Beside
    : P
    , OptionalVerbs {};
template <class P> inline constexpr bool can_stand_beside = std::is_class_v<P> && !std::is_final_v<P>;
template <class P> inline constexpr bool names_check = false;
template <class P>
    requires can_stand_beside<P>
inline constexpr bool names_check<P> = !requires { &Beside<P>::check; };
template <class P> inline constexpr bool names_prepare = false;
template <class P>
    requires can_stand_beside<P>
inline constexpr bool names_prepare<P> = !requires { &Beside<P>::prepare; };
template <class P> inline constexpr bool names_observe = false;
template <class P>
    requires can_stand_beside<P>
inline constexpr bool names_observe<P> = !requires { &Beside<P>::observe; };
template <class P> inline constexpr bool names_report = false;
template <class P>
    requires can_stand_beside<P>
inline constexpr bool names_report<P> = !requires { &Beside<P>::report; };

/// What a bound policy prepares once a step, it prepares from the context; it need not prepare anything.
template <class P, class S>
concept PreparesIn = !names_prepare<Bound<P, S>> ||
                     requires(Bound<P, S>& bound, const Context<S, reads_clock<P>>& c) { bound.prepare(c); };

/// The argument in the place of written column `C`: a value that cannot be changed, if it is the one that is `Tried`.
template <class C, class Tried, class S>
using Written = std::conditional_t<std::same_as<C, Tried>, value_of<C, S>, value_of<C, S>&>;

} // namespace detail

/// What decides how a step of a world `W` is taken: `parts(world, dt, kept)` says in how many equal substeps, at least
/// 1, or refuses, before anything is touched; `Kept` is what it keeps between steps. `StepLimit` is one.
template <class P, class W>
concept StepControlFor =
    PlaysRole<P, roles::StepControl> &&
    requires(const P& control, const W& world, const Quantity<unit::Time>& dt, typename P::Kept& kept) {
        { control.parts(world, dt, kept) } -> std::same_as<int>;
    };

namespace detail {
/// A loop as an Execution sees it.
struct AnyLoop {
    void operator()(std::size_t begin, std::size_t end) const;
};
} // namespace detail

/// What runs the loops of a step: `execute(count, grain, loop)` calls `loop(begin, end)` for disjoint ranges that
/// together are 0 to `count`, at the same time if it likes, and comes back when all of them have. execution.hpp says
/// what it may rely on and what relies on it.
///
/// The library has none of its own: without one a step is serial.
template <class E>
concept ExecutionPolicy =
    PlaysRole<E, roles::Execution> &&
    requires(const E& execution, std::size_t n, const detail::AnyLoop& loop) { execution.execute(n, n, loop); };

/// An observer: may declare `reads`; if it has `observe(view)`, the view is read-only. A policy of any role may have
/// `std::string report(const auto& world, const Quantity<unit::Time>& dt) const`, which `World::status` asks: a
/// sentence about the world as it is now, or nothing. `dt` is the length of the last step, or of its substeps where a
/// response or a StepControl divides it; it is not called before the first step.
///
/// \snippet tests/world/page.cpp recorder
///
/// What a game or a test wants to see, it says itself; of the library's own e.g. `WorldRadius` is one. A
/// \ref ansatz::World asks it after each step.
template <class O, class S>
concept ObserverIn =
    PlaysRole<O, roles::Observer> && (writes_of<O>::size == 0) &&
    (!detail::names_observe<O> || requires(O& observer, const ObserverView<S, O>& view) { observer.observe(view); });

} // namespace ansatz
