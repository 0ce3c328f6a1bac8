// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the compile-time representations share: leaving and entering states, the memory of guards, histories, the
/// clock, the queue of raised events. A representation only decides how to find the transition.
///
/// One `handle` or `update` runs to completion: the transition, then every transition without event and guard, then the
/// events that were raised, in this order until nothing is left. The present state changes when a transition is
/// complete.

#include <ansatz/states/model.hpp>
#include <ansatz/states/options.hpp>

namespace ansatz::states {

namespace detail {

struct Absent {};

/// Calls f with a number as a constant: the switch that every generated one is made of.
template <std::size_t N, std::size_t From = 0> [[gnu::always_inline]] inline bool with_number(std::size_t i, auto&& f) {
    auto at = [&]<std::size_t K>() {
        if constexpr (From + K < N) return bool(f.template operator()<From + K>());
        else return false;
    };
    switch (i) {
    case From: return at.template operator()<0>();
    case From + 1: return at.template operator()<1>();
    case From + 2: return at.template operator()<2>();
    case From + 3: return at.template operator()<3>();
    case From + 4: return at.template operator()<4>();
    case From + 5: return at.template operator()<5>();
    case From + 6: return at.template operator()<6>();
    case From + 7: return at.template operator()<7>();
    case From + 8: return at.template operator()<8>();
    case From + 9: return at.template operator()<9>();
    case From + 10: return at.template operator()<10>();
    case From + 11: return at.template operator()<11>();
    case From + 12: return at.template operator()<12>();
    case From + 13: return at.template operator()<13>();
    case From + 14: return at.template operator()<14>();
    case From + 15: return at.template operator()<15>();
    default:
        if constexpr (From + 16 < N) return with_number<N, From + 16>(i, f);
        else return false;
    }
}

/// A label of a switch over the events that mean something in a state; one that is not needed is a number no event has.
template <class M, std::size_t Leaf> constexpr std::size_t label(std::size_t k) {
    constexpr const auto& known = M::template events_of<Leaf>;
    return k < known.size ? std::size_t(known.at[k]) : 0x10000 + k;
}
/// Calls f with the event as a constant, if it means something in this state.
template <class M, std::size_t Leaf, std::size_t From = 0>
[[gnu::always_inline]] inline bool switch_over(std::size_t event, auto&& f) {
    constexpr const auto& known = M::template events_of<Leaf>;
    auto at = [&]<std::size_t K>() {
        if constexpr (From + K < known.size) return bool(f.template operator()<known.at[From + K]>());
        else return false;
    };
    switch (event) {
    case label<M, Leaf>(From): return at.template operator()<0>();
    case label<M, Leaf>(From + 1): return at.template operator()<1>();
    case label<M, Leaf>(From + 2): return at.template operator()<2>();
    case label<M, Leaf>(From + 3): return at.template operator()<3>();
    case label<M, Leaf>(From + 4): return at.template operator()<4>();
    case label<M, Leaf>(From + 5): return at.template operator()<5>();
    case label<M, Leaf>(From + 6): return at.template operator()<6>();
    case label<M, Leaf>(From + 7): return at.template operator()<7>();
    default:
        if constexpr (From + 8 < known.size) return switch_over<M, Leaf, From + 8>(event, f);
        else return false;
    }
}

/// Calls an action, whatever of context, time and queue it wants.
template <class M, class F, class Context>
constexpr void act(const F& f, Context& context, Quantity<unit::Time> dt, EventQueue& queue) {
    if constexpr (std::is_same_v<F, Raised>) queue.raise(EventId(M::find_event(f.event)));
    else if constexpr (std::is_invocable_v<const F&, Context&>) std::invoke(f, context);
    else if constexpr (std::is_invocable_v<const F&, Context&, EventQueue&>) std::invoke(f, context, queue);
    else if constexpr (std::is_invocable_v<const F&, Context&, Quantity<unit::Time>>) std::invoke(f, context, dt);
    else {
        static_assert(std::is_invocable_v<const F&, Context&, Quantity<unit::Time>, EventQueue&>,
                      "Ansatz: an action is a function of the machine's Context, or of it and an EventQueue&, or "
                      "raise(\"event\"); "
                      "that of each_update may take the time of the update too");
        std::invoke(f, context, dt, queue);
    }
}

/// The class of a state's behaviour, or NoBehaviour.
template <class Node> struct BehaviourOf;
template <class... P> struct BehaviourOf<State<P...>> {
    template <class Q> static constexpr auto of(std::type_identity<Q>) { return std::type_identity<NoBehaviour>{}; }
    template <class B> static constexpr auto of(std::type_identity<Behaves<B>>) { return std::type_identity<B>{}; }
    template <class A, class B> static constexpr auto pick(std::type_identity<A> a, std::type_identity<B> b) {
        if constexpr (std::is_same_v<A, NoBehaviour>) return b;
        else return a;
    }
    static constexpr auto all() { return std::type_identity<NoBehaviour>{}; }
    template <class F, class... R> static constexpr auto all(F first, R... rest) {
        return pick(of(first), all(rest...));
    }
    using type = typename decltype(all(std::type_identity<P>{}...))::type;
};

// Whether a class has a function of a name, whatever it takes and whoever may call it: then the name is there twice in
// WithNames. Data that bears it, the exit of a room, is none.
struct OfThoseNames {
    int enter, exit, update;
};
template <class B>
struct WithNames
    : B
    , OfThoseNames {};
template <class B> constexpr bool may_have_members = std::is_class_v<B> && !std::is_final_v<B>;
template <class B>
concept NamesEnter = may_have_members<B> && !requires { &WithNames<B>::enter; } &&
                     !requires { requires std::is_member_object_pointer_v<decltype(&B::enter)>; };
template <class B>
concept NamesExit = may_have_members<B> && !requires { &WithNames<B>::exit; } &&
                    !requires { requires std::is_member_object_pointer_v<decltype(&B::exit)>; };
template <class B>
concept NamesUpdate = may_have_members<B> && !requires { &WithNames<B>::update; } &&
                      !requires { requires std::is_member_object_pointer_v<decltype(&B::update)>; };

/// Calls `enter`, `exit` or `update` of a state class, if it has it.
template <class B, class Context> constexpr void behave_enter(B& b, Context& c, EventQueue& q) {
    if constexpr (requires { b.enter(c, q); }) b.enter(c, q);
    else if constexpr (requires { b.enter(c); }) b.enter(c);
    else
        static_assert(!NamesEnter<B>, "Ansatz: the enter of this state's class would never be called; it is public and "
                                      "takes the machine's Context, void enter(Npc&), or it and an EventQueue&");
}
template <class B, class Context> constexpr void behave_exit(B& b, Context& c, EventQueue& q) {
    if constexpr (requires { b.exit(c, q); }) b.exit(c, q);
    else if constexpr (requires { b.exit(c); }) b.exit(c);
    else
        static_assert(!NamesExit<B>, "Ansatz: the exit of this state's class would never be called; it is public and "
                                     "takes the machine's Context, void exit(Npc&), or it and an EventQueue&");
}
template <class B, class Context>
constexpr void behave_update(B& b, Context& c, Quantity<unit::Time> dt, EventQueue& q) {
    if constexpr (requires { b.update(c, dt, q); }) b.update(c, dt, q);
    else if constexpr (requires { b.update(c, q); }) b.update(c, q);
    else if constexpr (requires { b.update(c, dt); }) b.update(c, dt);
    else if constexpr (requires { b.update(c); }) b.update(c);
    else
        static_assert(!NamesUpdate<B>,
                      "Ansatz: the update of this state's class would never be called; it is public and takes the "
                      "machine's Context, or it and the time, void update(Npc&, Quantity<unit::Time>)");
}

template <class T> struct GuardOf;
template <class... P> struct GuardOf<Transition<P...>> {
    template <class Q> static constexpr auto of(std::type_identity<Q>) { return std::type_identity<void>{}; }
    template <class G> static constexpr auto of(std::type_identity<When<G>>) { return std::type_identity<G>{}; }
    template <class A, class B> static constexpr auto pick(std::type_identity<A> a, std::type_identity<B> b) {
        if constexpr (std::is_void_v<A>) return b;
        else return a;
    }
    static constexpr auto all() { return std::type_identity<void>{}; }
    template <class F, class... R> static constexpr auto all(F first, R... rest) {
        return pick(of(first), all(rest...));
    }
    using type = typename decltype(all(std::type_identity<P>{}...))::type;
};

template <class G> struct MemoryOf {
    using type = typename G::Memory;
    static constexpr bool timed = G::needs_time;
};
template <> struct MemoryOf<void> {
    using type = NoMemory;
    static constexpr bool timed = false;
};

template <std::size_t I, class T> struct Slot {
    T it{};
};
// Those that hold nothing: one for all, so that many of them still take no byte.
template <std::size_t I, class T>
    requires(std::is_same_v<T, NoBehaviour> || std::is_same_v<T, NoMemory>)
struct Slot<I, T> {
    static inline T it{};
};
template <std::size_t I> struct Slot<I, Absent> {};
template <class S, class... T> struct Slots;
template <std::size_t... I, class... T> struct Slots<std::index_sequence<I...>, T...> : Slot<I, T>... {};
template <std::size_t I, class T> constexpr T& slot(Slot<I, T>& s) { return s.it; }

/// The longest that one handle or update goes on by itself: a machine that raises events for ever is stopped and says
/// so.
inline constexpr std::uint32_t most_steps = 1000;

// A bool of a type of its own, so that beside others of no size it still has a place.
struct Flag {
    bool it = false;
    constexpr Flag& operator=(bool b) {
        it = b;
        return *this;
    }
    // NOLINTNEXTLINE(google-explicit-constructor): it is a bool
    constexpr operator bool() const { return it; }
};

// Says that a machine is at work, and that it is not any more, also when an action throws; nothing where its flag has
// no size, since nothing can call it back.
template <class F> struct Busy {
    F& flag;
    constexpr explicit Busy(F& f) : flag(f) {
        if constexpr (!std::is_empty_v<F>) flag = true;
    }
    constexpr ~Busy() {
        if constexpr (!std::is_empty_v<F>) flag = false;
    }
    Busy(const Busy&) = delete;
};

// What follows from a model alone, whatever represents it.
template <class M> struct Shape {
    static constexpr bool has_final = [] {
        for (const auto& s : M::rows.states)
            if (s.kind == Kind::final) return true;
        return false;
    }();
    static constexpr bool remembers_children(std::size_t s) {
        for (std::size_t i = s + 1; i < M::rows.states[s].end; ++i)
            if (is_history(M::rows.states[i].kind) && M::parent(i) == s) return true;
        return false;
    }
    // Only what the history H can hold, so that nothing else is compiled.
    template <std::size_t H>
    static constexpr auto holdable = [] {
        Ids<M::state_count> found;
        for (std::uint16_t s = M::parent(H) + 1; s < M::rows.states[M::parent(H)].end; ++s)
            if (M::rows.states[H].kind == Kind::deep_history
                    ? M::is_leaf(s)
                    : M::parent(s) == M::parent(H) && !is_history(M::rows.states[s].kind))
                found.add(s);
        if (M::is_leaf(M::parent(H))) found.add(M::parent(H)); // it was there alone
        return found;
    }();
    // done.state.S
    template <std::size_t S>
    static constexpr auto done_event = [] {
        constexpr auto name = M::rows.states[S].name;
        std::array<char, 11 + name.size()> text{'d', 'o', 'n', 'e', '.', 's', 't', 'a', 't', 'e', '.'};
        for (std::size_t i = 0; i < name.size(); ++i) text[11 + i] = name[i];
        return M::find_event({text.data(), text.size()});
    }();
};

} // namespace detail

/// The types of a model's parts.
template <class M> struct Parts {
    /// The State<...> of the state S.
    template <std::size_t S> using Node = std::remove_cvref_t<decltype(*std::get<S>(M::state_nodes))>;
    /// The Transition<...> of the transition T.
    template <std::size_t T> using TransitionNode = std::remove_cvref_t<decltype(*std::get<T>(M::transition_nodes))>;
    /// The class of the state S, or NoBehaviour.
    template <std::size_t S> using Behaviour = typename detail::BehaviourOf<Node<S>>::type;
    /// The guard of the transition T, or void.
    template <std::size_t T> using GuardType = typename detail::GuardOf<TransitionNode<T>>::type;
    /// What that guard remembers, or NoMemory.
    template <std::size_t T> using Memory = typename detail::MemoryOf<GuardType<T>>::type;
    /// Whether it remembers anything.
    template <std::size_t T> static constexpr bool remembers = !std::is_same_v<Memory<T>, NoMemory>;

    /// \cond
    template <class S> struct AllOf;
    template <std::size_t... I> struct AllOf<std::index_sequence<I...>> {
        using Behaviours = detail::Slots<std::index_sequence<I...>, Behaviour<I>...>;
    };
    /// \endcond
    /// The data of all states that have a class.
    using Behaviours = typename AllOf<std::make_index_sequence<M::state_count>>::Behaviours;
    /// \cond
    template <class S> struct Guards;
    template <std::size_t... T> struct Guards<std::index_sequence<T...>> {
        using Memories = detail::Slots<std::index_sequence<T...>, Memory<T>...>;
        static constexpr bool remember = (remembers<T> || ...);
        static constexpr bool timed = (detail::MemoryOf<GuardType<T>>::timed || ...);
    };
    /// \endcond
    /// The memories of all guards, and whether any of them remembers or needs the time.
    using AllGuards = Guards<std::make_index_sequence<M::transition_count>>;
};

} // namespace ansatz::states
