// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Laws`: the per-body forces of a world, bound to its space and summed as listed.
///
/// A law answers with an acceleration or with a force; a force is divided by the mass here, so no law does it twice.
/// Use `Laws` by itself when you have an integrator of your own and want the sum of ansatz's laws for one body.

#include <ansatz/world/context.hpp>
#include <ansatz/world/row.hpp>

#include <tuple>

namespace ansatz {

/// The derivatives of a law's answer: by position (1/s^2, or N/m for a force) and by velocity (1/s, or N s/m).
template <class S, class Answer = unit::Acceleration> struct Jacobian {
    /// da/dx, 1/s^2
    typename S::template MatrixOf<typename boost::units::divide_typeof_helper<Answer, unit::Length>::type> position;
    /// da/dv, 1/s
    typename S::template MatrixOf<typename boost::units::divide_typeof_helper<Answer, unit::Velocity>::type> velocity;
};
/// The Jacobian of a law that answers with a force.
template <class S> using ForceJacobian = Jacobian<S, unit::Force>;

namespace detail {

template <class L, class R, class Ctx, class... C>
concept AnswersAcceleration =
    requires(const L& law, R& row, const Ctx& c) { law.acceleration(row.template get<C>()..., c); };
template <class L, class R, class Ctx, class... C>
concept AnswersForce = requires(const L& law, R& row, const Ctx& c) { law.force(row.template get<C>()..., c); };

/// Calls a member of law `P` with the columns it declared.
template <class P, class S, class R, class... C>
[[gnu::always_inline]] inline auto ask(const Bound<P, S>& law, const R& row, Columns<C...>, const Context<S>& context) {
    const auto limited = context.template restricted<reads_clock<P>>();
    if constexpr (AnswersAcceleration<Bound<P, S>, const R, decltype(limited), C...>)
        return law.acceleration(row.template get<C>()..., limited);
    else return row.template get<InverseMass>() * law.force(row.template get<C>()..., limited);
}

template <class P, class S, class R, class... C>
auto ask_jacobian(const Bound<P, S>& law, const R& row, Columns<C...>, const Context<S>& context) {
    return law.jacobian(row.template get<C>()..., context.template restricted<reads_clock<P>>());
}

/// A law whose answer does not depend on the state that an integrator solves for needs no Jacobian: it is zero.
template <class P>
inline constexpr bool depends_on_motion = contains<Position, reads_of<P>> || contains<Velocity, reads_of<P>>;

template <class S, class P, class... C> constexpr bool answers_force(Columns<C...>) {
    if constexpr (requires { typename Bound<P, S>; }) {
        using R = const Row<S, without_clock<P>>;
        using Ctx = Context<S, reads_clock<P>>;
        if constexpr (!AnswersAcceleration<Bound<P, S>, R, Ctx, C...>) return AnswersForce<Bound<P, S>, R, Ctx, C...>;
    }
    return false;
}
/// What a law needs: what it reads, and the mass if its force must become an acceleration.
template <class P, class S>
using needs_of_law =
    union_of<reads_of<P>, std::conditional_t<answers_force<S, P>(without_clock<P>{}), Columns<InverseMass>, Columns<>>>;

} // namespace detail

/// The per-body forces `P...` in space `S`.
template <class S, class... P> class Laws {
public:
    /// The columns that they declared, and all that evaluating them needs (the mass, where one is a force).
    using reads = union_of<reads_of<P>...>;
    using needs = union_of<detail::needs_of_law<P, S>...>;                  ///< the columns that the laws read
    static constexpr bool empty = sizeof...(P) == 0;                        ///< whether there are none
    static constexpr bool time_dependent = (detail::reads_clock<P> || ...); ///< whether one of them asks for the time

    /// Binds them to the space.
    explicit Laws(const P&... policies) : laws_(detail::Bound<P, S>(policies)...) {}

    /// Lets laws that compute something once a step do it.
    void prepare([[maybe_unused]] const Context<S>& context) {
        (prepare_one(std::get<detail::place_of<P, List>>(laws_), context.template restricted<detail::reads_clock<P>>()),
         ...);
    }

    /// The sum of the accelerations, as listed; without any law a zero that the compiler knows, so that no instruction
    /// and no lane is spent on it.
    /// \param row a `Row` with at least the columns of `reads`
    template <class R> [[gnu::always_inline]] auto acceleration(const R& row, const Context<S>& context) const {
        if constexpr (sizeof...(P) == 0) return Zero<typename S::Acceleration>();
        else return sum<R, P...>(row, context);
    }

    /// The sum of the Jacobians, as accelerations.
    template <class R> Jacobian<S> jacobian(const R& row, const Context<S>& context) const {
        Jacobian<S> total{};
        (add_jacobian<P>(total, row, context), ...);
        return total;
    }

    /// One of them.
    template <class Policy> const detail::Bound<Policy, S>& get() const {
        return std::get<detail::place_of<Policy, List>>(laws_);
    }

private:
    // By place, because two policies may be bound by one In, as a force and one derived from it.
    using List = std::tuple<P...>;

    template <class L> static void prepare_one([[maybe_unused]] L& law, [[maybe_unused]] const auto& context) {
        if constexpr (requires { law.prepare(context); }) law.prepare(context);
    }

    template <class Policy, class R>
    [[gnu::always_inline]] typename S::Acceleration one(const R& row, const Context<S>& context) const {
        return detail::ask<Policy, S>(get<Policy>(), row, detail::without_clock<Policy>{}, context);
    }
    template <class R, class First, class... Rest>
    [[gnu::always_inline]] typename S::Acceleration sum(const R& row, const Context<S>& context) const {
        typename S::Acceleration total = one<First>(row, context);
        ((total += one<Rest>(row, context)), ...);
        return total;
    }
    template <class Policy, class R>
    void add_jacobian(Jacobian<S>& total, const R& row, const Context<S>& context) const {
        if constexpr (detail::depends_on_motion<Policy>) {
            const auto part =
                detail::ask_jacobian<Policy, S>(get<Policy>(), row, detail::without_clock<Policy>{}, context);
            // NOLINTNEXTLINE(bugprone-assignment-in-if-condition): nothing is assigned
            if constexpr (requires { total.position += part.position; }) {
                total.position += part.position;
                total.velocity += part.velocity;
            } else {
                total.position += row.template get<InverseMass>() * part.position;
                total.velocity += row.template get<InverseMass>() * part.velocity;
            }
        }
    }

    std::tuple<detail::Bound<P, S>...> laws_;
};

} // namespace ansatz
