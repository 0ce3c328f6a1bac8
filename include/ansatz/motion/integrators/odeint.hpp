// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Odeint<Stepper>`: any explicit one-step stepper of Boost.Numeric.Odeint as an integrator (beyond the notes).
// not in the umbrella: it is the only header that needs Boost.Numeric.Odeint, which takes a second to compile
///
/// Use it for methods that this library does not write again, such as Fehlberg's of order 8:
/// `Odeint<boost::numeric::odeint::runge_kutta_fehlberg78<std::array<double, 6>>>`. The state type that you name is
/// replaced by one of the world's scalar and dimension. A stepper with memory is refused: a multistep method or one
/// whose last stage is the next step's first (Dormand-Prince) would remember a state from before an impulse or a
/// contact. So are controlled steppers: a world's step has the length that it was asked for. It advances body
/// by body; RungeKutta4 runs in lanes.

#include <ansatz/motion/concepts.hpp>

#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/algebra/default_operations.hpp>
#include <boost/numeric/odeint/algebra/range_algebra.hpp>
#include <boost/numeric/odeint/stepper/base/explicit_error_stepper_base.hpp>
#include <boost/numeric/odeint/stepper/base/explicit_stepper_base.hpp>
#include <boost/numeric/odeint/util/resizer.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace ansatz {

namespace detail {

template <class S> using OdeintState = std::array<typename S::Scalar, 2 * std::size_t(S::dimension)>;

/// The same stepper on another state; `void` for a class template of another shape (multistep methods count their steps
/// in the first parameter).
template <class Stepper, class S> struct OdeintRebind {
    using type = void;
    using together = void;
};
template <template <class, class, class, class, class, class, class> class Stepper, class State, class Value,
          class Deriv, class Time, class Algebra, class Operations, class Resizer, class S>
struct OdeintRebind<Stepper<State, Value, Deriv, Time, Algebra, Operations, Resizer>, S> {
    using type = Stepper<OdeintState<S>, typename S::Scalar, OdeintState<S>, typename S::Scalar,
                         boost::numeric::odeint::array_algebra, boost::numeric::odeint::default_operations,
                         boost::numeric::odeint::never_resizer>;
    /// On the state of all bodies.
    using Long = std::vector<typename S::Scalar>;
    using together = Stepper<Long, typename S::Scalar, Long, typename S::Scalar, boost::numeric::odeint::range_algebra,
                             boost::numeric::odeint::default_operations, boost::numeric::odeint::always_resizer>;
};

template <class Base, unsigned short Order, class... Rest>
std::true_type is_one_step(const boost::numeric::odeint::explicit_stepper_base<Base, Order, Rest...>*);
template <class Base, unsigned short Order, unsigned short StepperOrder, unsigned short ErrorOrder, class... Rest>
std::true_type
is_one_step(const boost::numeric::odeint::explicit_error_stepper_base<Base, Order, StepperOrder, ErrorOrder, Rest...>*);
std::false_type is_one_step(const void*);

template <class Stepper>
constexpr bool explicit_one_step = !std::is_void_v<typename OdeintRebind<Stepper, Space<>>::type> &&
                                   decltype(is_one_step(static_cast<const Stepper*>(nullptr)))::value;

} // namespace detail

/// \tparam Stepper e.g. `boost::numeric::odeint::runge_kutta_cash_karp54<std::array<double, 6>>`; include its header
template <class Stepper> struct Odeint {
    static_assert(
        detail::explicit_one_step<Stepper>,
        "Ansatz: Odeint takes Boost.Odeint's explicit one-step steppers, e.g. "
        "runge_kutta_fehlberg78<std::array<double, 6>>; a "
        "stepper with memory (multistep, or first-same-as-last like runge_kutta_dopri5) is wrong after an impulse");

    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int order = int(Stepper::order_value);

    /// The same for all bodies at once, where forces couple them.
    template <class S> class Together {
    public:
        /// One step of the stepper for y = (x, v) of all bodies.
        template <class System, class Dt> bool solve(System& system, const Dt& dt) {
            using Scalar = typename S::Scalar;
            system.read(x_, v_, a_); // the masses are not needed
            const auto n = x_.size();
            y_.resize(2 * std::size_t(n));
            std::copy_n(x_.data(), n, y_.begin());
            std::copy_n(v_.data(), n, y_.begin() + n);
            auto set = [&](const State& y) {
                std::copy_n(y.begin(), n, x_.data());
                std::copy_n(y.begin() + n, n, v_.data());
                system.write(x_, v_);
            };
            auto slopes = [&](const State& y, State& slope, const Scalar& t) {
                set(y);
                system.accelerations(static_cast<double>(t / dt.value()), a_);
                std::copy_n(v_.data(), n, slope.begin());
                std::copy_n(a_.data(), n, slope.begin() + n);
            };
            stepper_.do_step(slopes, y_, Scalar(0), dt.value());
            set(y_);
            return true;
        }

    private:
        using State = std::vector<typename S::Scalar>;
        typename detail::OdeintRebind<Stepper, S>::together stepper_;
        State y_;
        Eigen::Matrix<typename S::Scalar, Eigen::Dynamic, 1> x_, v_, a_;
    };

    /// One step of the stepper for y = (x, v) of one body, y' = (v, a).
    static bool solve(auto& x, auto& v, const auto& laws, const auto& dt) {
        using X = std::remove_cvref_t<decltype(x)>;
        using V = std::remove_cvref_t<decltype(v)>;
        using Vec = typename X::value_type;
        using Scalar = typename Vec::Scalar;
        constexpr int dimension = Vec::RowsAtCompileTime;
        using S = Space<Scalar, dimension>;
        using State = detail::OdeintState<S>;

        State y;
        for (int i = 0; i < dimension; ++i) {
            y[std::size_t(i)] = x.value()[i];
            y[std::size_t(i + dimension)] = v.value()[i];
        }
        auto system = [&](const State& state, State& slope, const Scalar& t) {
            Vec position, velocity;
            for (int i = 0; i < dimension; ++i) {
                position[i] = state[std::size_t(i)];
                velocity[i] = state[std::size_t(i + dimension)];
            }
            const auto a = laws(X::from_value(position), V::from_value(velocity), static_cast<double>(t / dt.value()));
            for (int i = 0; i < dimension; ++i) {
                slope[std::size_t(i)] = velocity[i];
                slope[std::size_t(i + dimension)] = a.value()[i];
            }
        };
        typename detail::OdeintRebind<Stepper, S>::type stepper;
        stepper.do_step(system, y, Scalar(0), dt.value());
        for (int i = 0; i < dimension; ++i) {
            x = set_component(x, i, y[std::size_t(i)]);
            v = set_component(v, i, y[std::size_t(i + dimension)]);
        }
        return true;
    }

private:
    template <class Q> static Q set_component(const Q& q, int i, const typename Q::value_type::Scalar& to) {
        auto value = q.value();
        value[i] = to;
        return Q::from_value(value);
    }
};

} // namespace ansatz
