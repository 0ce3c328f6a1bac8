// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The sentences about the roles of bodies that collide: what is wrong with a broadphase, a filter, a narrowphase and
/// its shapes, a response; and what to write instead. world/check.hpp asks for them by role, and says how they are
/// made.

#include <ansatz/collision/concepts.hpp>
#include <ansatz/collision/facts.hpp>
#include <ansatz/collision/narrowphase/pairs.hpp>
#include <ansatz/world/check.hpp>

#include <type_traits>

namespace ansatz::detail {

/// What is checked in a policy of each role.
template <class Role> struct ChecksOfCollision;

// ------------------------------------------------------------------ broadphase
template <> struct ChecksOfCollision<roles::Broadphase> {
    template <class P, class S> using Facts = BroadphaseFacts<P, S>;
    template <class P, class S> using Sentences = CheckBroadphase<P, S>;
};

// ------------------------------------------------------------------ filter
template <class F, class S> struct FilterFacts {
    static constexpr bool columns = DeclaresReads<F>;
    static constexpr bool binds = !columns || Binds<F, S>;
    static constexpr bool verbs = !columns || !binds || FilterIn<F, S>;
    static constexpr bool ok = columns && binds && verbs;
};
template <class F, class S> struct CheckFilter {
    using Facts = FilterFacts<F, S>;
    static_assert(
        Facts::columns,
        "Ansatz: a collision filter without columns; declare what it reads, e.g. `using reads = Columns<Member>;`");
    static_assert(
        Facts::binds,
        "Ansatz: a collision filter that cannot be bound to a space; it needs `template <class S> struct In` with a "
        "constructor from the policy, e.g. `explicit In(const MyFilter&)`");
    static_assert(Facts::verbs, "Ansatz: a collision filter with a wrong signature; its In<S> needs `bool passes(const "
                                "auto& a, const auto& b) const`, "
                                "which sees a body's columns as a.template get<Column>()");
};
template <> struct ChecksOfCollision<roles::Filter> {
    template <class P, class S> using Facts = FilterFacts<P, S>;
    template <class P, class S> using Sentences = CheckFilter<P, S>;
};

// ------------------------------------------------------------------ shapes
template <class T, class S> struct ShapeFacts {
    static constexpr bool is_shape = ShapeDescription<T>;
    static constexpr bool named = !is_shape || ShapeNamed<T>;
    static constexpr bool made = !named || !is_shape || ShapeMade<T, S>;
    static constexpr bool kept = !made || !named || !is_shape || ShapeKept<T, S>;
    static constexpr bool box = !kept || !made || !named || !is_shape || ShapeBoxed<T, S>;
    static constexpr bool ok = is_shape && named && made && kept && box;
};
template <class T, class S> struct CheckShape {
    using Facts = ShapeFacts<T, S>;
    static_assert(Facts::is_shape, "Ansatz: a Narrowphase of something that is no shape; name shapes, e.g. "
                                   "Narrowphase<Sphere, Plane, Box>; a shape of "
                                   "yours says that it is one, `using shape = MyShape;`");
    static_assert(Facts::named,
                  "Ansatz: a shape that does not say what it is; it needs `static constexpr std::string_view name = "
                  "\"MyShape\";` and, if a box "
                  "holds it, `static constexpr bool bounded = true;` (false for what has no end, like a Plane)");
    static_assert(Facts::made, "Ansatz: a shape that cannot be bound to a space; it needs `template <class S> struct "
                               "In` with a constructor from the shape, "
                               "`explicit In(const MyShape&)`, and in it `using description = MyShape;`");
    static_assert(Facts::kept, "Ansatz: a shape that cannot be copied; it and its In<S> are stored by kind, and need a "
                               "copy constructor and an assignment");
    static_assert(Facts::box, "Ansatz: a shape that a box holds (`bounded`) and that does not say which; its In<S> "
                              "needs `void bounds(const typename "
                              "S::Position& x, typename S::Position& lower, typename S::Position& upper) const`");
};
template <class List, class S> struct CheckShapes;
template <class... T, class S> struct CheckShapes<Types<T...>, S> : CheckShape<T, S>... {};

// ------------------------------------------------------------------ narrowphase
/// Those that say which shapes they know, and only in the list of which something can be wrong.
template <class N> struct ShapesNamedBy {
    using type = void;
};
template <class N>
    requires requires { typename N::shapes; }
struct ShapesNamedBy<N> {
    using type = typename N::shapes;
};

template <class List, class S> struct ListFacts { // no list
    static constexpr bool some = true, once = true, shapes = true, meet = true, pairs = true;
};
template <class... T, class S> struct ListFacts<Types<T...>, S> {
    template <class One> static constexpr int times = (0 + ... + int(std::same_as<One, T>));
    static constexpr bool some = sizeof...(T) > 0;
    static constexpr bool once = ((times<T> == 1) && ...);
    static constexpr bool shapes = (ShapeFacts<T, S>::ok && ...);
    static constexpr bool any_bounded() {
        if constexpr (some && shapes) return (T::bounded || ...);
        return true;
    }
    static constexpr bool meet = any_bounded();
    static constexpr bool all_pairs() {
        if constexpr (once && shapes) return pairs_can_meet<S>(Types<T...>());
        return true;
    }
    static constexpr bool pairs = all_pairs();
};
template <class N, class S> struct NarrowphaseFacts {
    using List = ListFacts<typename ShapesNamedBy<N>::type, S>;
    static constexpr bool list = List::some && List::once && List::shapes && List::meet && List::pairs;
    static constexpr bool has_verbs() { // not with ||: g++ checks both sides, and reads the noise behind a broken list
        if constexpr (list) return NarrowphaseIn<N, S>;
        return true;
    }
    static constexpr bool verbs = has_verbs();
    static constexpr bool old_name = requires { N::sweeps; } && !requires { N::continuous; };
    // Loops over bodies and contacts are marked `flatten`. g++ then inlines the arithmetic of big numbers as well, and
    // takes 19 GB for it.
#if defined(__OPTIMIZE__) && defined(__GNUC__) && !defined(__clang__)
    static constexpr bool compiles = std::is_floating_point_v<typename S::Scalar>;
#else
    static constexpr bool compiles = true;
#endif
    static constexpr bool ok = list && verbs && !old_name && compiles;
};
template <class N, class S> struct CheckNarrowphaseList {
    using List = typename NarrowphaseFacts<N, S>::List;
    static_assert(List::some,
                  "Ansatz: a Narrowphase without shapes; name those of your world, e.g. Narrowphase<Sphere, Plane>");
    static_assert(List::once,
                  "Ansatz: a Narrowphase names a shape twice; name each once, e.g. Narrowphase<Sphere, Plane>");
    static_assert(List::meet, "Ansatz: a Narrowphase of shapes that never meet: those without a box (planes) meet only "
                              "those that have one; add "
                              "one, e.g. Narrowphase<Sphere, Plane>");
    static_assert(NarrowphaseFacts<N, S>::verbs,
                  "Ansatz: a narrowphase with a wrong signature; it needs all that NarrowphaseIn names "
                  "(collision/concepts.hpp); Narrowphase<Sphere, Plane> has it, and yours may wrap it");
    static_assert(!NarrowphaseFacts<N, S>::old_name,
                  "Ansatz: a narrowphase that says `sweeps`, which is `continuous` now; write `static constexpr bool "
                  "continuous = true;`");
    static_assert(
        NarrowphaseFacts<N, S>::compiles,
        "Ansatz: bodies that collide in numbers of Boost.Multiprecision are too much for g++ where it "
        "optimises (it inlines their arithmetic until memory runs out); take float or double, clang++, or -O0");
};
template <class N, class S> constexpr auto sentences_about_narrowphase() {
    using Facts = NarrowphaseFacts<N, S>;
    if constexpr (!Facts::List::shapes) return std::type_identity<CheckShapes<typename ShapesNamedBy<N>::type, S>>{};
    else if constexpr (!Facts::List::pairs) return std::type_identity<CheckPairs<typename ShapesNamedBy<N>::type, S>>{};
    else return std::type_identity<CheckNarrowphaseList<N, S>>{};
}
template <> struct ChecksOfCollision<roles::Narrowphase> {
    template <class P, class S> using Facts = NarrowphaseFacts<P, S>;
    template <class P, class S> using Sentences = typename decltype(sentences_about_narrowphase<P, S>())::type;
};

// ------------------------------------------------------------------ response
template <class R, class S> struct ResponseFacts {
    static constexpr bool level = HasLevel<R>;
    static constexpr bool answers = answers_contacts<R>;
    static constexpr bool presses = acts_at<R>(Level::accelerations);
    static constexpr bool substeps = acts_at<R>(Level::substeps);
    static constexpr bool columns =
        !level || (DeclaresReads<R> || (!presses && std::is_same_v<reads_of<R>, Columns<>>));
    static constexpr bool writes = !columns || !answers || (DeclaresWrites<R> && changes_its_level<R>);
    static constexpr bool binds = !columns || !level || Binds<R, S>;
    static constexpr bool before = level && columns && writes && binds;
    static constexpr bool copies() { // not with &&: columns that are none are an error on its right-hand side
        if constexpr (before && answers) return RespondsToCopies<R, S>;
        return false;
    }
    static constexpr bool references = !copies();
    static constexpr bool models() {
        if constexpr (before && references) return ResponseIn<R, S>;
        return true;
    }
    static constexpr bool respond = !answers || models();
    static constexpr bool couples() {
        if constexpr (before && presses) return CouplingIn<R, S>;
        return true;
    }
    static constexpr bool couple = couples();
    static constexpr bool kept = !before || !couple || answers || KeepsContactsIn<R, S>;
    static constexpr bool solve = !kept || !substeps || models();
    static constexpr bool ok = before && references && respond && couple && kept && solve;
};
template <class R, class S> struct CheckResponse {
    using Facts = ResponseFacts<R, S>;
    static_assert(Facts::level,
                  "Ansatz: a response that does not say on what it acts; write e.g. `static constexpr Level level = "
                  "Level::velocities;` "
                  "(an impulse), Level::positions (a projection) or Level::accelerations (a force of the next step)");
    static_assert(Facts::columns,
                  "Ansatz: a response whose columns the world cannot read; declare what it needs, e.g. `using reads = "
                  "Columns<Restitution>;`, or `Columns<>` for nothing");
    static_assert(
        Facts::writes,
        "Ansatz: a response that does not change what it acts on; at Level::velocities it says `using writes = "
        "Columns<Velocity>;`, at Level::positions `using writes = Columns<Position>;`");
    static_assert(Facts::binds, "Ansatz: a response that cannot be bound to a space; it needs `template <class S> "
                                "struct In` with a constructor from "
                                "the policy, e.g. `explicit In(const MyResponse&)`");
    static_assert(
        Facts::references,
        "Ansatz: a response cannot change the bodies, because it takes them by value or by const reference; write "
        "`void respond(const auto& contact, auto& a, auto& b, const auto& meeting) const`");
    static_assert(Facts::respond, "Ansatz: a response with a wrong signature; its In<S> needs `void respond(const "
                                  "auto& contact, auto& a, auto& b, const "
                                  "auto& meeting) const`, which changes e.g. a.template get<Velocity>()");
    static_assert(Facts::couple, "Ansatz: a response at Level::accelerations is a force between bodies; it needs "
                                 "`static constexpr bool couples_bodies = "
                                 "true;` and, in its In<S>, couple(view, context)");
    static_assert(Facts::kept, "Ansatz: a response that acts in the next step keeps its contacts until then; give it "
                               "`template <class S> using State`, a "
                               "class with take(data, contacts) and what PenaltyContacts has beside it");
    static_assert(
        Facts::solve,
        "Ansatz: a response at Level::substeps with a wrong signature; its In<S> needs parts(), solve(contacts, h), "
        "find_bouncing(contacts, data), bounce(contacts, h) and friction(data, a, b), its State what "
        "SoftContacts has");
};
template <> struct ChecksOfCollision<roles::Response> {
    template <class P, class S> using Facts = ResponseFacts<P, S>;
    template <class P, class S> using Sentences = CheckResponse<P, S>;
};

// ------------------------------------------------------------------ how many
template <class... P> struct CollisionCounts {
    static constexpr int broadphases = count_of_role<roles::Broadphase, P...>;
    static constexpr int filters = count_of_role<roles::Filter, P...>;
    static constexpr int narrowphases = count_of_role<roles::Narrowphase, P...>;
    static constexpr int responses = count_of_role<roles::Response, P...>;
    static constexpr int in_substeps = (0 + ... + int(RespondsAt<Level::substeps>::template here<P>()));
    static constexpr int in_next_step = (0 + ... + int(RespondsAt<Level::accelerations>::template here<P>()));
    static constexpr int at_velocities = (0 + ... + int(RespondsAt<Level::velocities>::template here<P>()));
    static constexpr bool acting = in_substeps <= 1 && (in_substeps == 0 || (in_next_step == 0 && at_velocities == 0));
    static constexpr bool ok = broadphases <= 1 && filters <= 1 && narrowphases == broadphases &&
                               (responses >= 1) == (narrowphases == 1) && filters <= broadphases && acting;
};
template <class... P> struct CheckCollisionCounts {
    using Facts = CollisionCounts<P...>;
    static_assert(Facts::broadphases <= 1,
                  "Ansatz: World has more than one broadphase; keep one, or nest them as one policy");
    static_assert(Facts::filters <= 1, "Ansatz: World has more than one collision filter; keep one");
    static_assert(Facts::narrowphases <= 1, "Ansatz: World has more than one narrowphase; keep one");
    static_assert(Facts::broadphases == 0 || Facts::narrowphases >= 1,
                  "Ansatz: World has a broadphase but no narrowphase to test its pairs; add one");
    static_assert(Facts::narrowphases == 0 || Facts::broadphases >= 1,
                  "Ansatz: World has a narrowphase but no broadphase to find its pairs; add one");
    static_assert(Facts::responses == 0 || Facts::narrowphases >= 1,
                  "Ansatz: World has a response but no narrowphase to find contacts; add one");
    static_assert(Facts::narrowphases == 0 || Facts::responses >= 1,
                  "Ansatz: World finds contacts but has no response to them; add one");
    static_assert(Facts::filters == 0 || Facts::broadphases >= 1,
                  "Ansatz: World has a collision filter but no broadphase whose pairs it could filter; add one");
    static_assert(Facts::in_substeps <= 1, "Ansatz: World has more than one response that takes a step in substeps; "
                                           "keep one, e.g. SoftSubsteps<Friction>{}");
    static_assert(
        Facts::in_substeps == 0 || Facts::in_next_step == 0,
        "Ansatz: World has a response that takes a step in substeps (SoftSubsteps) and one whose contacts are "
        "forces of the next step (Penalty), which "
        "would hold the same bodies twice; keep one of the two");
    static_assert(Facts::in_substeps == 0 || Facts::at_velocities == 0,
                  "Ansatz: World has a response that takes a step in substeps (SoftSubsteps) and one that changes "
                  "velocities at its end (Impulse), which would "
                  "answer the same contacts twice; keep one of the two");
};

} // namespace ansatz::detail
