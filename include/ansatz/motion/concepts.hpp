// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// One concept for each role of motion, with every expression that the role needs: forces, integrators and effects.
///
/// A policy author reads the concept of the role, writes a struct with those expressions, and asserts it:
/// `static_assert(ForceIn<MyForce, Space<>>);`. motion/check.hpp says the same facts as sentences.

#include <ansatz/motion/facts.hpp>
#include <ansatz/world/concepts.hpp>

#include <Eigen/Core>

#include <concepts>
#include <type_traits>
#include <utility>

namespace ansatz {

namespace detail {

template <class E>
concept HasPlace = requires {
    { E::place } -> std::convertible_to<Place>;
};

template <class P, class S, class... C> constexpr bool lawful(Columns<C...>) {
    if constexpr (Binds<P, S>) {
        using L = const Bound<P, S>&;
        using Ctx = const Context<S, reads_clock<P>>&;
        if constexpr (AnswersAcceleration<Bound<P, S>, const Row<S, without_clock<P>>, Context<S, reads_clock<P>>,
                                          C...>)
            return std::is_convertible_v<decltype(std::declval<L>().acceleration(
                                             std::declval<const value_of<C, S>&>()..., std::declval<Ctx>())),
                                         typename S::Acceleration>;
        else if constexpr (AnswersForce<Bound<P, S>, const Row<S, without_clock<P>>, Context<S, reads_clock<P>>, C...>)
            return std::is_convertible_v<decltype(std::declval<L>().force(std::declval<const value_of<C, S>&>()...,
                                                                          std::declval<Ctx>())),
                                         typename S::Force>;
    }
    return false;
}

/// It can be asked and answers with something else than it should.
template <class P, class S> constexpr bool answers_wrongly() {
    if constexpr (DeclaresReads<P> && !couples_bodies<P> && Binds<P, S>)
        return []<class... C>(Columns<C...>) {
            using Asked = const Row<S, without_clock<P>>;
            using Ctx = Context<S, reads_clock<P>>;
            return (AnswersAcceleration<Bound<P, S>, Asked, Ctx, C...> ||
                    AnswersForce<Bound<P, S>, Asked, Ctx, C...>)&&!lawful<P, S>(Columns<C...>{});
        }(without_clock<P>{});
    return false;
}

template <class P, class S> constexpr bool couples_in() {
    if constexpr (Binds<P, S> && couples_bodies<P>)
        return requires(const Bound<P, S>& f, CouplingView<S, P>& view, const Context<S, reads_clock<P>>& c) {
            f.couple(view, c);
        };
    return false;
}

template <class I, class S, class... W, class... X> constexpr bool advances(Columns<W...>, Columns<X...>) {
    return []<int... K>(std::integer_sequence<int, K...>) {
        return (requires(const verbs_of<I, S>& verbs, value_of<W, S>&... w, value_of<X, S>&... x,
                         const typename S::Acceleration& a, const TimeStep<S>& dt) {
            verbs.advance(Stage<K + first_stage<I>(true)>{}, w..., x..., a, dt);
        } && ...);
    }(std::make_integer_sequence<int, stage_count<I>() - first_stage<I>(true)>{});
}

/// The laws as a solving integrator sees them: a function of position, velocity and the fraction of the step.
template <class S> struct LawsProbe {
    typename S::Acceleration operator()(const typename S::Position&, const typename S::Velocity&, double) const;
    Jacobian<S> jacobian(const typename S::Position&, const typename S::Velocity&, double) const;
};

/// A column that no stage takes by reference would never change, and nothing would say so.
template <class I, class S> constexpr bool copies_what_it_advances() {
    auto copies = []<class Tried, class... W, class... X, int... K>(Columns<Tried>, Columns<W...>, Columns<X...>,
                                                                    std::integer_sequence<int, K...>) {
        return (requires(const verbs_of<I, S>& verbs, value_of<X, S>&... x, const typename S::Acceleration& a,
                         const TimeStep<S>& dt) {
            verbs.advance(Stage<K + first_stage<I>(true)>{}, std::declval<Written<W, Tried, S>>()..., x..., a, dt);
        } && ...);
    };
    auto one_of_them = [&]<class... W>(Columns<W...> written) {
        if constexpr (is_staged<I>)
            return (copies(Columns<W>{}, written, scratch_of<I>{},
                           std::make_integer_sequence<int, stage_count<I>() - first_stage<I>(true)>{}) ||
                    ...);
        else
            return requires(const verbs_of<I, S>& verbs, typename S::Velocity& v, const LawsProbe<S>& laws,
                            const TimeStep<S>& dt) { verbs.solve(typename S::Position(), v, laws, dt); } ||
                   requires(const verbs_of<I, S>& verbs, typename S::Position& x, const LawsProbe<S>& laws,
                            const TimeStep<S>& dt) { verbs.solve(x, typename S::Velocity(), laws, dt); };
    };
    return one_of_them(writes_of<I>{});
}

template <class I, class S>
concept KeepsHistory =
    contains<PreviousPosition, writes_of<I>> && requires(const typename S::Position& x, const typename S::Velocity& v,
                                                         const typename S::Acceleration& a, const typename S::Time& t) {
        { I::mean_velocity(x, x, t) } -> std::convertible_to<typename S::Velocity>;
        { I::velocity_now(v, a, t) } -> std::convertible_to<typename S::Velocity>;
        { I::history(x, v, a, t) } -> std::convertible_to<typename S::Position>;
    };

template <class I, class S>
concept Solves = requires(const verbs_of<I, S>& verbs, typename S::Position& x, typename S::Velocity& v,
                          const LawsProbe<S>& laws, const TimeStep<S>& dt) {
    { verbs.solve(x, v, laws, dt) } -> std::convertible_to<bool>;
};

template <class E, class S, class... W, class... C> constexpr bool applies(Columns<W...>, Columns<C...>) {
    if constexpr (Binds<E, S>)
        return requires(const Bound<E, S>& effect, value_of<W, S>&... w, const value_of<C, S>&... c,
                        const Context<S, reads_clock<E>>& context) { effect.apply(w..., c..., context); };
    return false;
}

template <class E, class S, class... W> constexpr bool copies_what_it_changes(Columns<W...>) {
    if constexpr (Binds<E, S>) {
        auto copies = []<class Tried, class... C>(Columns<Tried>, Columns<C...>) {
            return requires(const Bound<E, S>& effect, const value_of<C, S>&... c,
                            const Context<S, reads_clock<E>>& context) {
                effect.apply(std::declval<Written<W, Tried, S>>()..., c..., context);
            };
        };
        return (copies(Columns<W>{}, difference_of<reads_of<E>, union_of<writes_of<E>, Columns<Clock>>>{}) || ...);
    }
    return false;
}

} // namespace detail

/// A force in space `S` that is a law of one body: declares `reads`, and `In<S>`, made from the policy, answers
/// `acceleration(columns..., context)` or `force(columns..., context)` with exactly that quantity.
///
/// \snippet tests/world/page.cpp wind
///
/// `Gravity`, `QuadraticDrag` and `AppliedForces` are such laws (notes 1.2, 1.7 and 1.9).
template <class P, class S>
concept LawIn = PlaysRole<P, roles::Force> && !detail::couples_bodies<P> && detail::DeclaresReads<P> &&
                detail::Binds<P, S> && detail::PreparesIn<P, S> && detail::lawful<P, S>(detail::without_clock<P>{});

/// A force in space `S` that couples bodies: `static constexpr bool couples_bodies = true;`, and `In<S>` has
/// `couple(view, context)`, which adds forces through the view. Its role may be another than Force: a response whose
/// contacts are forces of the next step couples bodies, too.
///
/// `Attraction` is one (notes 1.3); attraction.hpp shows how it is written.
template <class P, class S>
concept CouplingIn = Policy<P> && detail::couples_bodies<P> && detail::DeclaresReads<P> && detail::couples_in<P, S>() &&
                     detail::PreparesIn<P, S>;

/// A force of either kind.
///
/// \snippet tests/world/page.cpp wind
///
/// `Gravity`, `QuadraticDrag` and `AppliedForces` are laws of one body, `Attraction` couples bodies
/// (notes 1.2, 1.3, 1.7 and 1.9).
template <class P, class S>
concept ForceIn = LawIn<P, S> || (CouplingIn<P, S> && PlaysRole<P, roles::Force>);

/// A force whose derivative is known, or whose answer does not depend on position and velocity.
///
/// `QuadraticDrag` knows its derivative, `Gravity` needs none. Implicit integrators ask for it (notes 1.6.2).
template <class P, class S>
concept DifferentiableIn = LawIn<P, S> && (!detail::depends_on_motion<P> || []<class... C>(Columns<C...>) {
                               return requires(const detail::Bound<P, S>& law, const value_of<C, S>&... c,
                                               const Context<S, detail::reads_clock<P>>& context) {
                                   law.jacobian(c..., context).position;
                                   law.jacobian(c..., context).velocity;
                               };
                           }(detail::without_clock<P>{}));

namespace detail {
/// Takes what a coupling says of its derivatives.
template <class S> struct BlocksProbe {
    using Block = Eigen::Matrix<typename S::Scalar, S::dimension, S::dimension>;
    void operator()(std::size_t, std::size_t, const Block&, const Block&) const;
};
struct StiffnessProbe {
    void operator()(std::size_t, std::size_t, const auto&, const auto&) const {}
};
} // namespace detail

/// A force between bodies whose derivative is known: `In<S>` has `jacobian(view, context, add)`, which calls
/// `add(a, b, by_position, by_velocity)` for each two slots that act on each other with the matrices of the force on a
/// by a's own motion (raw N/m and N s/m, symmetric; on b, and by b's motion, it is the same with the signs of the third
/// law; `b` is `view.size()` for a point that nothing moves), and `stiffnesses(view, f)`, which calls `f(a, b, k, c)`
/// for each two that it ever couples with the largest stiffness and damping between them. `Springs` have both.
template <class P, class S>
concept DifferentiableCouplingIn =
    CouplingIn<P, S> && requires(const detail::Bound<P, S>& force, const ObserverView<S, P>& view,
                                 const Context<S, detail::reads_clock<P>>& context) {
        force.jacobian(view, context, detail::BlocksProbe<S>());
        force.stiffnesses(view, detail::StiffnessProbe());
    };

/// An integrator of stages: `advance(Stage<k>, written..., scratch..., a, dt)` for every stage; where it keeps no
/// Velocity, also `mean_velocity`, `velocity_now` and `history`, which say what velocity means. One without parameters
/// has them as static functions; one with parameters (`name` and `parameters`, as every policy) has `advance` in its
/// `template <class S> struct In`, where they are bound to the space, and is changed by `world.set`.
///
/// \snippet tests/world/page.cpp midpoint
///
/// `ExplicitEuler`, `SemiImplicitEuler`, `Verlet`, `VelocityVerlet` and `RungeKutta4` are such integrators (notes 1.6);
/// the exercises \ref exercise_motion_explicit_euler "explicit_euler",
/// \ref exercise_motion_semi_implicit_euler "semi_implicit_euler" and
/// \ref exercise_motion_verlet "verlet" ask for one.
template <class I, class S>
concept StagedIntegratorIn =
    PlaysRole<I, roles::Integrator> && detail::DeclaresWrites<I> && detail::contains<Position, writes_of<I>> &&
    detail::is_staged<I> && detail::advances<I, S>(writes_of<I>{}, detail::scratch_of<I>{}) &&
    !detail::copies_what_it_advances<I, S>() && (!detail::derives_velocity<I> || detail::KeepsHistory<I, S>);

/// An integrator that solves for the next state: `solve(x, v, laws, dt)` answers whether it succeeded. It is a static
/// function, or one of `In<S>`, as above.
///
/// `ImplicitEuler` and `Odeint` are such integrators (notes 1.6.2); the exercise
/// \ref exercise_motion_implicit_euler "implicit_euler" asks for one.
template <class I, class S>
concept SolvingIntegratorIn = PlaysRole<I, roles::Integrator> && !detail::is_staged<I> && detail::DeclaresWrites<I> &&
                              detail::contains<Position, writes_of<I>> && detail::contains<Velocity, writes_of<I>> &&
                              detail::Solves<I, S> && !detail::copies_what_it_advances<I, S>();

/// An integrator of either kind.
///
/// \snippet tests/world/page.cpp midpoint
///
/// `ExplicitEuler`, `SemiImplicitEuler`, `Verlet`, `VelocityVerlet` and `RungeKutta4` go by stages, `ImplicitEuler`
/// and `Odeint` solve (notes 1.6). The exercises \ref exercise_motion_explicit_euler "explicit_euler" and
/// \ref exercise_motion_implicit_euler "implicit_euler" ask for one of each kind.
template <class I, class S>
concept IntegratorIn = StagedIntegratorIn<I, S> || SolvingIntegratorIn<I, S>;

namespace detail {
template <class D>
concept NamesDegree = Column<typename D::position> && Column<typename D::velocity>;
/// Whether its law answers, with the columns that it reads.
template <class D, class S> constexpr bool accelerates() {
    if constexpr (NamesDegree<D> && Binds<D, S>)
        return []<class... C>(Columns<C...>) {
            return requires(const Bound<D, S>& law, const value_of<typename D::position, S>& x,
                            const value_of<typename D::velocity, S>& v, const value_of<C, S>&... c,
                            const Context<S, reads_clock<D>>& context) { law.acceleration(x, v, c..., context); };
        }(without_clock<D>{});
    else return false;
}
/// Whether what integrators write can be written of its columns: its acceleration moves v, and v moves x.
template <class D, class S> constexpr bool moves_by_its_columns() {
    if constexpr (accelerates<D, S>())
        return []<class... C>(Columns<C...>) {
            using X = value_of<typename D::position, S>;
            using V = value_of<typename D::velocity, S>;
            using A = decltype(std::declval<const Bound<D, S>&>().acceleration(
                std::declval<const X&>(), std::declval<const V&>(), std::declval<const value_of<C, S>&>()...,
                std::declval<const Context<S, reads_clock<D>>&>()));
            return requires(X& x, V& v, const A& a, const TimeStep<S>& dt) {
                x += v * dt;
                x = x + 0.5 * dt * v;
                v += a * dt;
                v = v + 0.5 * dt * a;
            };
        }(without_clock<D>{});
    else return false;
}
} // namespace detail

/// A degree of freedom beside translation: names the columns that stand for `position` and `velocity`, and its `In<S>`
/// has `acceleration(position, velocity, read columns..., context)`, whose answer changes the velocity by `a * dt`, as
/// the velocity changes the position by `v * dt`.
///
/// \snippet tests/world/systems/orientation.cpp turning
///
/// The library has none of its own yet: translation is advanced by an integrator such as
/// \ref ansatz::SemiImplicitEuler "SemiImplicitEuler", and these by the same lines.
template <class D, class S>
concept DegreeOfFreedomIn =
    PlaysRole<D, roles::DegreeOfFreedom> && detail::moves_by_its_columns<D, S>() && detail::PreparesIn<D, S>;

/// An effect in space `S`: declares `writes` (and `reads`), a `place`, and `In<S>` has
/// `apply(written&..., read..., context)`. Where it matters when it acts among those of its place, it says so with
/// `static constexpr int turn`, 0 to 2 (damping 0, StopBelow 1, Rest 2); those of one turn act as listed and should
/// commute.
///
/// \snippet tests/world/page.cpp speed_limit
///
/// `Drag`, `FrameDrag`, `StopBelow`, `Rest` and `Interpolation` are effects (notes 1.7 and 1.8); the exercises
/// \ref exercise_motion_drag "drag" and \ref exercise_motion_rest "rest" ask for one.
template <class E, class S>
concept EffectIn =
    PlaysRole<E, roles::Effect> && detail::DeclaresWrites<E> && detail::HasPlace<E> &&
    detail::applies<E, S>(writes_of<E>{}, difference_of<reads_of<E>, union_of<writes_of<E>, Columns<Clock>>>{}) &&
    !detail::copies_what_it_changes<E, S>(writes_of<E>{}) && detail::PreparesIn<E, S>;

} // namespace ansatz
