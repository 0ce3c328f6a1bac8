// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Degrees of freedom beside translation: an orientation, a temperature that has inertia, anything with a rate that
/// something accelerates. Each is advanced by the lines of the world's integrator, written once for x, v and a.
///
///     struct Turning {
///         using role = roles::DegreeOfFreedom;
///         using position = Orientation;          // a column: what stands for x
///         using velocity = AngularVelocity;      // and for v
///         using reads = Columns<InverseInertia>; // what else its law reads
///         template <class S> struct In {
///             explicit In(const Turning&) {}
///             auto acceleration(const auto& x, const auto& v, const auto& inertia, const auto& context) const;
///         };
///     };
///
/// Translation needs no name: each world has it. The scratch of an integrator follows from what x and v are here, and a
/// column of a shape of your own (columns.hpp) takes part by the operators that the integrators write: `x + v * dt`,
/// `x += v * dt`. All degrees of a body advance together, stage by stage: each law sees the state of its stage. An
/// integrator that keeps a history instead of a velocity, or solves, is refused by a sentence.
///
/// Bodies that are `fixed` do not turn, platforms go on as they are, and Rest tests the velocity of translation
/// alone: a body that only turns may fall asleep, and stands still then.

#include <ansatz/motion/integration.hpp>
#include <ansatz/motion/roles.hpp>

#include <tuple>
#include <utility>

namespace ansatz {

namespace detail {

/// Scratch of the kind of another column, and of its rate of change.
template <class C, int Number> struct ScratchLike {
    using Unit = typename C::Unit;
    static constexpr auto shape = C::shape;
    static constexpr std::string_view name = "scratch";
};
template <class C, int Number> struct ScratchRate {
    using Unit = typename boost::units::divide_typeof_helper<typename C::Unit, unit::Time>::type;
    static constexpr auto shape = C::shape;
    static constexpr std::string_view name = "scratch";
};

/// What stands for a column of translation in degree of freedom D.
template <class D, class C> struct Counterpart {
    using type = void;
};
template <class D> struct Counterpart<D, Position> {
    using type = typename D::position;
};
template <class D> struct Counterpart<D, Velocity> {
    using type = typename D::velocity;
};
template <class D, int Number> struct Counterpart<D, ScratchVector<unit::Length, Number>> {
    using type = ScratchLike<typename D::position, Number>;
};
template <class D, int Number> struct Counterpart<D, ScratchVector<unit::Velocity, Number>> {
    using type = ScratchLike<typename D::velocity, Number>;
};
template <class D, int Number> struct Counterpart<D, ScratchVector<unit::Acceleration, Number>> {
    using type = ScratchRate<typename D::velocity, Number>;
};
template <class D, class... C> Columns<typename Counterpart<D, C>::type...> counterparts(Columns<C...>);
/// A list of columns of translation, for a degree of freedom: not a union, since each place has its meaning.
template <class D, class List> using counterparts_of = decltype(counterparts<D>(List{}));

template <class D> using columns_of_degree = Columns<typename D::position, typename D::velocity>;

/// The answer of a degree's law in a row.
template <class D, class S, class R, class... C>
[[gnu::always_inline]] inline auto ask_degree(const Bound<D, S>& law, const R& row, Columns<C...>,
                                              const Context<S>& context) {
    return law.acceleration(row.template get<typename D::position>(), row.template get<typename D::velocity>(),
                            row.template get<C>()..., context.template restricted<reads_clock<D>>());
}

} // namespace detail

/// The degrees of freedom `D...` in space `S`.
/// \tparam Coasts whether nothing accelerates them: platforms
template <class S, bool Coasts, class... D> class DegreesOfFreedom {
    using List = std::tuple<D...>;

public:
    using writes = union_of<detail::columns_of_degree<D>...>;    ///< what is advanced
    using needs = union_of<writes, detail::without_clock<D>...>; ///< and what the laws read
    static constexpr bool empty = sizeof...(D) == 0;             ///< whether there are none
    using coasting = DegreesOfFreedom<S, true, D...>;            ///< the same without acceleration
    /// What integrator `I` leaves for a later stage.
    template <class I>
    using scratch = union_of<detail::counterparts_of<D, detail::scratch_of<detail::plain_integrator_of<I>>>...>;

    /// Binds them to the space.
    explicit DegreesOfFreedom(const D&... policies) : degrees_(detail::Bound<D, S>(policies)...) {}
    /// Those of bodies that nothing accelerates.
    coasting without_acceleration() const {
        return std::apply([](const auto&... bound) { return coasting(typename coasting::FromBound{}, bound...); },
                          degrees_);
    }

    /// Lets laws that compute something once a step do it.
    void prepare([[maybe_unused]] const Context<S>& context) {
        [[maybe_unused]] auto one = [](auto& degree, const auto& limited) {
            if constexpr (requires { degree.prepare(limited); }) degree.prepare(limited);
        };
        (one(std::get<detail::place_of<D, List>>(degrees_), context.template restricted<detail::reads_clock<D>>()),
         ...);
    }
    /// What the laws say of a body as it stands in a row.
    template <class R> [[gnu::always_inline]] auto accelerations(const R& row, const Context<S>& context) const {
        return std::tuple(one<D>(row, context)...);
    }
    /// Stage `K` of integrator `I` for each of them.
    template <class I, int K, class R, class All>
    [[gnu::always_inline]] void advance(const detail::BoundIntegrator<I, S>& integrator, R& row, const All& all,
                                        const TimeStep<S>& dt) const {
        using Plain = detail::plain_integrator_of<I>;
        (detail::advance<Plain, K>(
             detail::plain_integrator(integrator), row, detail::counterparts_of<D, writes_of<Plain>>{},
             detail::counterparts_of<D, detail::scratch_of<Plain>>{}, std::get<detail::place_of<D, List>>(all), dt),
         ...);
    }

private:
    template <class, bool, class...> friend class DegreesOfFreedom;
    struct FromBound {};
    explicit DegreesOfFreedom(FromBound, const detail::Bound<D, S>&... bound) : degrees_(bound...) {}

    template <class One, class R> [[gnu::always_inline]] auto one(const R& row, const Context<S>& context) const {
        const auto a = detail::ask_degree<One, S>(std::get<detail::place_of<One, List>>(degrees_), row,
                                                  detail::without_clock<One>{}, context);
        if constexpr (Coasts) return zero<std::remove_cvref_t<decltype(a)>>();
        else return a;
    }
    std::tuple<detail::Bound<D, S>...> degrees_;
};

} // namespace ansatz
