// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The sentences: what is wrong with a list of policies, in words, and what to write instead.
///
/// Each policy is checked in a struct of its own, so that the compiler's note ("required from CheckForce<MyDrag, ...>")
/// names the culprit; one assertion a rule, never inside a fold, where g++ hides the text. The facts stand apart from
/// the sentences, because a struct whose assertion failed is no constant for clang any more, and a page of errors would
/// follow the one to read. The concepts say the same facts for code that must ask instead of stop.

#include <ansatz/world/concepts.hpp>

#include <string_view>

namespace ansatz::detail {

/// Makes the compiler check the sentences of `Check...`.
template <class... Check> inline constexpr bool read_sentences = ((sizeof(Check) > 0) && ... && true);

template <class P> struct RoleFacts {
    static constexpr bool named = !std::is_void_v<role_of<P>>;
    static constexpr bool known = !named || known_role<role_of<P>>;
    static constexpr bool check = !names_check<P> || HasCheck<P>;
    static constexpr bool ok = named && known && check;
};
template <class P> constexpr bool role_is_here() {
    if constexpr (!std::is_void_v<module_of_role<role_of<P>>>) return module_is_here<module_of_role<role_of<P>>>;
    return true;
}
template <class P> struct CheckRole {
    static_assert(
        RoleFacts<P>::named,
        "Ansatz: unknown policy: this type names no role; give it one, e.g. `using role = ansatz::roles::Force;`");
    static_assert(RoleFacts<P>::known, "Ansatz: unknown role: a policy's role is one of ansatz::roles: Space, "
                                       "Integrator, Force, Effect, DegreeOfFreedom, "
                                       "StepControl, System, Observer, Execution, or one of a module, such as "
                                       "Broadphase, Filter, Narrowphase, Response of "
                                       "<ansatz/collision.hpp>");
    static_assert(RoleFacts<P>::check,
                  "Ansatz: a policy whose check the world cannot call; write `void check() const`");
};

template <class O, class S> struct ObserverFacts {
    static constexpr bool writes_nothing = writes_of<O>::size == 0;
    static constexpr bool observe = !writes_nothing || ObserverIn<O, S>;
    static constexpr bool ok = writes_nothing && observe;
};
template <class O, class S> struct CheckObserver {
    using Facts = ObserverFacts<O, S>;
    static_assert(
        Facts::writes_nothing,
        "Ansatz: an observer sees and never changes; it declares `reads` and no `writes` (an Effect may write)");
    static_assert(Facts::observe,
                  "Ansatz: an observer whose observe the world cannot call; write `void observe(const auto& view)`");
};

template <class E> struct ExecutionFacts {
    static constexpr bool runs = ExecutionPolicy<E>;
    static constexpr bool tells = !requires(E& e) { e.threads(); } || requires(const E& e) {
        { e.threads() } -> std::convertible_to<std::size_t>;
    };
    static constexpr bool ok = runs && tells;
};
template <class E> struct CheckExecution {
    static_assert(ExecutionFacts<E>::tells, "Ansatz: an execution whose number of threads the world cannot ask for; "
                                            "write `int threads() const`, or leave it out");
    static_assert(ExecutionFacts<E>::runs,
                  "Ansatz: an execution whose execute the world cannot call; write `void execute(std::size_t count, "
                  "std::size_t grain, const auto& loop) const`, which calls loop(begin, end) for ranges of 0 to count");
};

struct NoFacts {
    static constexpr bool ok = true;
};
struct CheckNothing {};

template <class F, class C> struct FactsAndSentences {
    using Facts = F;
    using Sentences = C;
};
/// A role whose module is only a name: its header is not included.
template <class P> struct CheckModule {
    static_assert(module_is_here<module_of_role<role_of<P>>>,
                  "Ansatz: a policy whose role belongs to a module that is not included; add its header, e.g. "
                  "#include <ansatz/motion.hpp> or <ansatz/collision.hpp>");
};
struct NotHere {
    static constexpr bool ok = false;
};
template <class P, class S> struct OfModule {
    using Facts = typename module_of_role<role_of<P>>::template FactsOf<P, S>;
    /// Named only when they are read.
    struct Sentences : module_of_role<role_of<P>>::template SentencesOf<P, S> {};
};
template <class P, class S> constexpr auto check_for() {
    if constexpr (PlaysRole<P, roles::Observer>)
        return std::type_identity<FactsAndSentences<ObserverFacts<P, S>, CheckObserver<P, S>>>{};
    else if constexpr (PlaysRole<P, roles::Execution>)
        return std::type_identity<FactsAndSentences<ExecutionFacts<P>, CheckExecution<P>>>{};
    else if constexpr (!std::is_void_v<module_of_role<role_of<P>>>) {
        if constexpr (module_is_here<module_of_role<role_of<P>>>) return std::type_identity<OfModule<P, S>>{};
        else return std::type_identity<FactsAndSentences<NotHere, CheckModule<P>>>{};
    } else return std::type_identity<FactsAndSentences<NoFacts, CheckNothing>>{};
}
template <class P, class S> using FactsFor = typename decltype(check_for<P, S>())::type::Facts;
template <class P, class S> using CheckFor = typename decltype(check_for<P, S>())::type::Sentences;

template <class... P> struct CountFacts {
    static constexpr int spaces = count_of_role<roles::Space, P...>;
    static constexpr int controls = count_of_role<roles::StepControl, P...>;
    static constexpr int executions = count_of_role<roles::Execution, P...>;
    static constexpr int data = (0 + ... + int(is_datum<P>));
    static constexpr bool moves = modules_of<P...>::size > 0;
    static constexpr bool ok = spaces <= 1 && controls <= 1 && executions <= 1 && data <= 1 && moves;
};
template <class... P> struct CheckCounts {
    using Facts = CountFacts<P...>;
    static_assert(Facts::moves, "Ansatz: World has no integrator; add one, e.g. SemiImplicitEuler");
    static_assert(Facts::spaces <= 1, "Ansatz: World has more than one Space; keep one, e.g. Space<float, 2>");
    static_assert(
        Facts::controls <= 1,
        "Ansatz: World has more than one policy that decides how a step is taken; keep one, e.g. StepLimit<Divide>{}");
    static_assert(
        Facts::executions <= 1,
        "Ansatz: World has more than one policy that runs its loops; keep one Execution, or none for a serial "
        "step");
    static_assert(Facts::data <= 1,
                  "Ansatz: World has more than one Datum; keep one, e.g. of a struct that holds them all");
};

// What the modules of a list say about all of it.
template <class M, class... P> constexpr bool counts_are_right() {
    if constexpr (requires { M::template Counts<P...>::ok; }) return M::template Counts<P...>::ok;
    return true;
}
template <class... M, class... P> constexpr bool all_counts_are_right(Types<M...>, Types<P...>) {
    return (counts_are_right<M, P...>() && ...);
}
template <class M, class... P> constexpr bool read_counts() {
    if constexpr (!counts_are_right<M, P...>()) return read_sentences<typename M::template CheckCounts<P...>>;
    return true;
}
/// The module of the lowest layer speaks first: without an integrator nothing else is worth saying.
template <class... P> constexpr bool read_all_counts(Types<>, Types<P...>) { return true; }
template <class First, class... M, class... P> constexpr bool read_all_counts(Types<First, M...>, Types<P...> all) {
    return read_all_counts(Types<M...>{}, all) && read_counts<First, P...>();
}
/// And about policies that do not go together.
template <class M, class... P> constexpr bool goes_together() {
    if constexpr (requires { M::template Together<P...>::ok; }) return M::template Together<P...>::ok;
    return true;
}
template <class... M, class... P> constexpr bool all_go_together(Types<M...>, Types<P...>) {
    return (goes_together<M, P...>() && ...);
}
template <class M, class... P> constexpr bool read_together() {
    if constexpr (!goes_together<M, P...>()) return M::template read_together<P...>();
    return true;
}
template <class... M, class... P> constexpr bool read_all_together(Types<M...>, Types<P...>) {
    return (read_together<M, P...>() && ...);
}

template <class P, class... All> inline constexpr bool stands_once = (0 + ... + int(std::same_as<P, All>)) == 1;
template <class P, class... All> struct CheckOnce {
    static_assert(stands_once<P, All...>,
                  "Ansatz: World has the same policy twice; each type of policy stands once in the list");
};

template <class... C> constexpr bool names_differ(Columns<C...>) {
    auto times = [](std::string_view name) { return (0 + ... + int(C::name == name)); };
    return ((times(C::name) == 1) && ...);
}

/// Two policies of one name would be one in a saved file.
template <class P> constexpr std::string_view name_or_none() {
    if constexpr (requires { std::string_view(P::name); }) return P::name;
    return {};
}
template <class... P> constexpr bool policies_named_apart() {
    [[maybe_unused]] auto times = [](std::string_view name) { return (0 + ... + int(name_or_none<P>() == name)); };
    return ((name_or_none<P>().empty() || times(name_or_none<P>()) == 1) && ...);
}

template <class... P> struct NameFacts {
    static constexpr bool named = names_differ(typename Composition<P...>::needed{});
    static constexpr bool policies_named = policies_named_apart<P...>();
    static constexpr bool ok = named && policies_named;
};
template <class... P> struct CheckNames {
    static_assert(NameFacts<P...>::named,
                  "Ansatz: two columns of this world have the same name, by which they are saved and hashed; give "
                  "each its own `static constexpr std::string_view name`");
    static_assert(NameFacts<P...>::policies_named,
                  "Ansatz: two policies of this world have the same name, by which they are saved; give "
                  "each its own `static constexpr std::string_view name`");
};

/// All sentences about one list of policies, in an order in which the first is the one to read.
template <class... P> constexpr bool check_world() {
    using S = space_of<P...>;
    using All = Types<P...>;
    if constexpr (!(RoleFacts<P>::ok && ...)) return !read_sentences<CheckRole<P>...>;
    else if constexpr (!(role_is_here<P>() && ...)) return !read_sentences<CheckModule<P>...>;
    else if constexpr (!all_counts_are_right(modules_of<P...>{}, All{})) {
        return !read_all_counts(modules_of<P...>{}, All{});
    } else if constexpr (!CountFacts<P...>::ok) return !read_sentences<CheckCounts<P...>>;
    else if constexpr (!(stands_once<P, P...> && ...)) return !read_sentences<CheckOnce<P, P...>...>;
    else if constexpr (!(FactsFor<P, S>::ok && ...)) return !read_sentences<CheckFor<P, S>...>;
    else if constexpr (!all_go_together(modules_of<P...>{}, All{}))
        return !read_all_together(modules_of<P...>{}, All{});
    else if constexpr (!NameFacts<P...>::ok) return !read_sentences<CheckNames<P...>>;
    else return true;
}
template <class... P> inline constexpr bool is_world = check_world<P...>();

/// A list that is no world is taken for one of what stands in for its modules, so that only the sentence is read.
struct NoWorld {
    using role = roles::Observer;
};
template <class List> struct CompositionOf;
template <class... P> struct CompositionOf<Types<P...>> {
    using type = Composition<P...>;
};
template <class... M> constexpr auto stand_ins(Types<M...>) {
    return std::type_identity<
        typename CompositionOf<joined_types<Types<NoWorld>, typename StandIn<M>::type...>>::type>{};
}
template <bool IsWorld, class... P> struct ComposedOf {
    using type = Composition<P...>;
};
template <class... P> struct ComposedOf<false, P...> {
    using type = typename decltype(stand_ins(modules_of<P...>{}))::type;
};

} // namespace ansatz::detail
