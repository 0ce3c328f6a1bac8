// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Compensated<Integrator>`: any integrator of stages that keeps a velocity, and what rounding drops from positions is
/// kept, so that small motions add up far from the origin.
///
/// Use it where a float world is larger than `resolved_radius` says: at 4096 m the places of a float are 0.49 mm apart,
/// and 0.05 m/s at 240 Hz, 0.21 mm in a step, is rounded away in each step, for ever. With it the same body arrives. It
/// costs one vector for each body, and six additions an axis and step. Not where the *place* itself must be finer: what
/// others see, forces, contacts and your program, is the position as before, to the places of the scalar. For that take
/// double, or move the origin. Near the origin, and in double within a solar system, it does nothing that you would
/// notice.
///
/// How: within a step the inner integrator does not move x, which is large, but d, how far the body is from where it
/// stood when the step began, which is small and begins with what was dropped before. Motion is the same wherever one
/// counts from, so that the lines of the integrator need not know. At the end of the step the position is x + d
/// rounded, and what the rounding dropped, which is known exactly, is the next d:
///
/// \f[ d = r_n + \Delta x, \qquad x_{n+1} = \mathrm{fl}(x_n + d), \qquad r_{n+1} = x_n + d - x_{n+1} \f]
///
/// W. Kahan, Comm. ACM 8, 40 (1965); O. Møller, BIT 5, 37 (1965); E. Hairer, C. Lubich, G. Wanner, Geometric Numerical
/// Integration, VIII.5. Deliberately not provided: the same of velocities, which are as large as what changes them; of
/// Verlet, whose velocity is itself a difference of two rounded positions (take VelocityVerlet); and of integrators
/// that solve.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/motion/integrators/semi_implicit_euler.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ansatz {

namespace detail {
/// Where a body stood when the step began: scratch of `Compensated`.
struct StartOfStep {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "scratch";
};
/// Whether an integrator moves a position by stages that need not know from where it is counted.
template <class I>
inline constexpr bool moves_from_anywhere =
    PlaysRole<I, roles::Integrator> && is_staged<I> && std::is_same_v<writes_of<I>, Columns<Position, Velocity>> &&
    !requires { I::first_stage(true); };
} // namespace detail

/// \tparam IntegratorT one of stages that writes `Columns<Position, Velocity>`: ExplicitEuler, SemiImplicitEuler,
///                     VelocityVerlet, RungeKutta4, or one of your own
template <class IntegratorT> struct Compensated {
    static_assert(detail::moves_from_anywhere<IntegratorT>,
                  "Ansatz: Compensated of something that does not advance a position and a velocity by stages; write "
                  "e.g. Compensated<SemiImplicitEuler>, and in the place of Verlet Compensated<VelocityVerlet>");
    using role = roles::Integrator;
    /// `IntegratorT`; after that sentence another, so that no more is said
    using Inner = std::conditional_t<detail::moves_from_anywhere<IntegratorT>, IntegratorT, SemiImplicitEuler>;
    using writes = Columns<Position, Velocity, PositionRemainder>;
    static constexpr int stages = detail::stage_count<Inner>();
    /// What the inner one leaves for a later stage; where there is one, also where the step began.
    using scratch = std::conditional_t<stages == 1, detail::scratch_of<Inner>,
                                       union_of<Columns<detail::StartOfStep>, detail::scratch_of<Inner>>>;

    Inner integrator{}; ///< the inner one, with its parameters

    /// \name As the inner one
    /// @{

    /// The times of the stages, as fractions of the step.
    static constexpr auto nodes = []<int... K>(std::integer_sequence<int, K...>) {
        return std::array<double, std::size_t(stages)>{detail::node<Inner>(K)...};
    }(std::make_integer_sequence<int, stages>{});
    /// Of a step: v + leads a dt is the velocity where x is.
    static constexpr double velocity_leads = [] {
        if constexpr (requires { Inner::velocity_leads; }) return double(Inner::velocity_leads);
        return 0.0;
    }();
    /// Zero where the inner one does not say.
    static constexpr int order = [] {
        if constexpr (requires { Inner::order; }) return int(Inner::order);
        return 0;
    }();
    static constexpr bool reversible = requires { requires Inner::reversible; };

    static constexpr std::string_view name = "Compensated";
    static void parameters([[maybe_unused]] auto& self, [[maybe_unused]] auto&& visit) {
        if constexpr (requires { Inner::parameters(self.integrator, visit); })
            Inner::parameters(self.integrator, visit);
    }
    void check() const {
        if constexpr (requires { integrator.check(); }) integrator.check();
    }
    /// @}

    template <class S> struct In {
        [[no_unique_address]] detail::BoundIntegrator<Inner, S> integrator; ///< the inner one
        explicit In(const Compensated& compensated) : integrator(compensated.integrator) {}

        /// Stage `K` of the inner integrator, of the way since the step began.
        /// \param first where the step began, of several stages; of one, what the inner one is given first
        template <int K>
        [[gnu::always_inline]] void advance(Stage<K>, auto& x, auto& v, auto& remainder, auto& first,
                                            auto&... rest) const {
            if constexpr (stages == 1) {
                const auto start = x;
                stage<K>(x, v, remainder, start, first, rest...);
            } else {
                if constexpr (K == 0) first = x;
                stage<K>(x, v, remainder, first, rest...);
            }
        }

    private:
        template <int K>
        [[gnu::always_inline]] void stage(auto& x, auto& v, auto& way, const auto& start, auto&... rest) const {
            if constexpr (requires { integrator.verbs; }) integrator.verbs.advance(Stage<K>{}, way, v, rest...);
            else Inner::advance(Stage<K>{}, way, v, rest...);
            x = start + way;
            if constexpr (K == stages - 1) way = detail::dropped_from_sum(start, way, x);
        }
    };
};
template <class I> Compensated(I) -> Compensated<I>; ///< around an integrator

} // namespace ansatz
