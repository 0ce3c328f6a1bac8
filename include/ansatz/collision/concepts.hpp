// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// One concept for each role of bodies that collide, with every expression that a world needs of it: `FilterIn`,
/// `NarrowphaseIn` and `ResponseIn`. The broadphase's own, `BroadphaseIn`, is in collision/broadphase/broadphase.hpp, a
/// shape's, `ShapeIn`, in collision/shapes.hpp.
///
/// A policy author reads the concept of the role, writes a struct with those expressions, and asserts it:
/// `static_assert(ResponseIn<MyResponse, Space<>>);`. collision/check.hpp says the same facts as sentences.

#include <ansatz/collision/broadphase/broadphase.hpp>
#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/contact_step.hpp>
#include <ansatz/collision/shapes.hpp>
#include <ansatz/motion/concepts.hpp>

#include <concepts>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {

/// What a filter sees of a body.
template <class F, class S> using FilterRow = Row<S, reads_of<F>>;
/// What a response that answers contact by contact sees of a body.
template <class R, class S> using ResponseRow = Row<S, union_of<writes_of<R>, reads_of<R>, Columns<InverseMass>>>;

// In place of what only a world has.
template <class S> struct PullProbe {
    typename S::template ScalarOf<unit::Acceleration> operator()() const { return {}; }
};
struct DataProbe {};
struct FrictionProbe {
    double operator()(std::size_t, std::size_t) const { return 0; }
};
struct KindProbe {
    template <class> void operator()() const {}
};
struct HashProbe {
    void add(std::uint64_t) {}
    void add_number(const auto&) {}
};

template <class R>
concept HasLevel = requires {
    { R::level } -> std::convertible_to<Level>;
};
template <class R> inline constexpr bool acts_at(Level level) {
    if constexpr (HasLevel<R>) return R::level == level;
    return false;
}
/// Which answer each contact for itself, when it has been found.
template <class R>
inline constexpr bool answers_contacts = acts_at<R>(Level::velocities) || acts_at<R>(Level::positions);

/// What it is for: a response on positions that changes none has no effect.
template <class R>
inline constexpr bool changes_its_level =
    (!acts_at<R>(Level::velocities) || (contains<Velocity, writes_of<R>> && !contains<Position, writes_of<R>>)) &&
    (!acts_at<R>(Level::positions) || contains<Position, writes_of<R>>);

/// \tparam A, B how the bodies are handed over: by reference, or as a value that cannot be changed
template <class R, class S, class A, class B>
concept RespondsTo = requires(const Bound<R, S>& response, const Contact<S>& contact, A a, B b,
                              const ContactContext<S, PullProbe<S>>& meeting) {
    response.respond(contact, static_cast<A>(a), static_cast<B>(b), meeting);
};
template <class R, class S>
concept Responds = Binds<R, S> && RespondsTo<R, S, ResponseRow<R, S>&, ResponseRow<R, S>&>;
/// It would change a copy, and nothing would say so.
template <class R, class S>
concept RespondsToCopies = Binds<R, S> && (RespondsTo<R, S, ResponseRow<R, S>&&, ResponseRow<R, S>&> ||
                                           RespondsTo<R, S, ResponseRow<R, S>&, ResponseRow<R, S>&&>);

/// What is kept for the next step: it takes the contacts, and is a part of the world's value like any other.
template <class State, class S>
concept KeepsContacts = std::copyable<State> && std::default_initializable<State> &&
                        requires(State& state, const State& kept, const DataProbe& data,
                                 const std::vector<Contact<S>>& contacts, const Bodies& bodies, HashProbe& hash) {
                            state.take(data, contacts);
                            state.arrange(bodies, std::uint64_t());
                            state.begin_step();
                            state.reserve_notes();
                            state.body_removed(std::uint32_t());
                            kept.add_to(hash);
                        };
template <class R, class S>
concept KeepsContactsIn = keeps_state<R, S> && KeepsContacts<state_of<R, S>, S>;

/// What a response that owns substeps does between two of them, and its contacts with it.
template <class R, class S>
concept SolvesContactsIn = Binds<R, S> && KeepsContactsIn<R, S> &&
                           requires(const Bound<R, S>& response, state_of<R, S>& contacts, const typename S::Scalar& h,
                                    const DataProbe& data, std::size_t slot) {
                               { response.parts() } -> std::same_as<int>;
                               { response.find_bouncing(contacts, data) } -> std::same_as<bool>;
                               { response.bounce(contacts, h) } -> std::same_as<bool>;
                               response.solve(contacts, h);
                               response.friction(data, slot, slot);
                               contacts.begin(data, FrictionProbe());
                               contacts.relax(h);
                               contacts.warm_start();
                               contacts.unload(std::vector<Vector<typename S::Scalar, S::dimension>>());
                               contacts.calm(std::vector<Vector<typename S::Scalar, S::dimension>>());
                               contacts.expect_platforms(true);
                               contacts.note_impacts();
                               contacts.impacts;
                               contacts.bodies;
                               contacts.kicks;
                               contacts.pushed;
                               contacts.all;
                           };

/// A filter that reads tables beside the columns of two bodies.
template <class F, class S> constexpr bool passes_by_tables() {
    return requires(const Bound<F, S>& filter, const ObserverView<S, F>& view, std::size_t slot) {
        { filter.passes(view, slot, slot) } -> std::convertible_to<bool>;
    };
}
/// Whether the bodies in two slots are tested.
template <class S, class F, class Data>
[[gnu::always_inline]] inline bool passes(const F& policy, const Data& data, std::size_t a, std::size_t b) {
    const Bound<F, S> filter(policy);
    if constexpr (sees_of<F>::size > 0) return filter.passes(ObserverView<S, F>(data), a, b);
    else {
        const reads_of<F> looked_at{};
        return filter.passes(data.lanes.get(looked_at, a), data.lanes.get(looked_at, b));
    }
}
/// The same, by the filters of a world: one or none.
template <class S, class Policies, class Data, class... F>
[[gnu::always_inline]] inline bool pass([[maybe_unused]] const Policies& policies, [[maybe_unused]] const Data& data,
                                        [[maybe_unused]] std::size_t a, [[maybe_unused]] std::size_t b, Types<F...>) {
    return (passes<S>(std::get<F>(policies), data, a, b) && ...);
}
template <class F, class S> constexpr bool passes_in() {
    if constexpr (Binds<F, S> && sees_of<F>::size > 0) return passes_by_tables<F, S>();
    else if constexpr (Binds<F, S>)
        return requires(const Bound<F, S>& filter, const FilterRow<F, S>& a, const FilterRow<F, S>& b) {
            { filter.passes(a, b) } -> std::convertible_to<bool>;
        };
    return false;
}

} // namespace detail

/// A filter in space `S`: declares `reads`, and `In<S>`, made from the policy, answers `passes(a, b)`, whether two
/// bodies are tested, from the declared columns of both: `a.template get<Column>()`. It must answer the same for
/// `(b, a)`. One that sees tables (`using sees = Types<Springs<>>;`) answers `passes(view, a, b)`, by slots, in steps;
/// what asks from outside (`world.query()`) is no body, and passes it.
///
/// `Layers` is one, `Unjoined` one that sees tables (notes 2.1).
template <class F, class S>
concept FilterIn = PlaysRole<F, roles::Filter> && detail::DeclaresReads<F> && detail::passes_in<F, S>();

/// A narrowphase in space `S`: keeps the shapes of bodies (`Shapes<S>`, `knows<Kind>`, `for_each_kind(f)`), says
/// whether some have a box and some have none (`any_bounded`, `any_unbounded`), finds out whether two intersect
/// (`collide_bodies<S>`) or nearly do (`nearly_collide<S>`), and names what a world holds of all that
/// (`Collisions<Composition>`).
///
/// `Narrowphase` is one, and `Swept` wraps it (notes 2.1.2); yours will rather wrap it, too.
template <class N, class S>
concept NarrowphaseIn = PlaysRole<N, roles::Narrowphase> &&
                        requires {
                            typename N::template Shapes<S>;
                            typename N::template Collisions<detail::DataProbe>;
                            { N::any_bounded } -> std::convertible_to<bool>;
                            { N::any_unbounded } -> std::convertible_to<bool>;
                            { N::template knows<int> } -> std::convertible_to<bool>;
                            N::for_each_kind(detail::KindProbe());
                        } &&
                        requires(const typename N::template Shapes<S>& shapes, std::uint32_t id,
                                 const typename S::Position& x, const typename S::Length& margin, Touch<S>& touch) {
                            { N::template collide_bodies<S>(shapes, id, x, id, x, touch) } -> std::same_as<bool>;
                            {
                                N::template nearly_collide<S>(shapes, id, x, id, x, margin, touch)
                            } -> std::same_as<bool>;
                        };

/// A response in space `S` that answers one contact at a time: at the level of velocities or of positions, which it
/// writes, and `In<S>` has `respond(contact, a, b, meeting)`, which changes the columns of the two bodies that it
/// declared: `a.template get<Velocity>()`. It may read `InverseMass` undeclared: zero for what nothing moves.
///
/// `Impulse` and `Projection` are such (notes 2.2.1).
template <class R, class S>
concept ContactResponseIn = PlaysRole<R, roles::Response> && detail::answers_contacts<R> && detail::DeclaresWrites<R> &&
                            detail::changes_its_level<R> && detail::Responds<R, S> && !detail::RespondsToCopies<R, S>;

/// A response in space `S` whose contacts are forces of the next step: at the level of accelerations, it couples bodies
/// like a force between them (`CouplingIn`), and `template <class S> State` keeps the contacts that it is given by
/// `take(data, contacts)` at the end of a step.
///
/// `Penalty` is one (notes 2.2.2).
template <class R, class S>
concept ForceResponseIn = PlaysRole<R, roles::Response> && detail::acts_at<R>(Level::accelerations) &&
                          CouplingIn<R, S> && detail::KeepsContactsIn<R, S>;

/// A response in space `S` that takes a step in substeps and solves all contacts between them. `SoftSubsteps` is one,
/// and says what each of the verbs is for. Its contacts may have `run_by(runner)`, which is told at the beginning of a
/// step what runs loops in a world with an Execution (`LoopRunner`), and `finish()`, at its end.
template <class R, class S>
concept SubstepResponseIn =
    PlaysRole<R, roles::Response> && detail::acts_at<R>(Level::substeps) && detail::SolvesContactsIn<R, S>;

/// A response in space `S`, at whichever level: `Projection`, `Impulse`, `Penalty` and `SoftSubsteps` are such
/// (notes 2.2).
template <class R, class S>
concept ResponseIn = ContactResponseIn<R, S> || ForceResponseIn<R, S> || SubstepResponseIn<R, S>;

} // namespace ansatz
