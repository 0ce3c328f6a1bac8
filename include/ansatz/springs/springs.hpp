// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Springs` and `Ropes`: damped springs between the bodies of a world (notes 3).
///
/// Use them for chains, ropes, suspension bridges, cloth, anything elastic. Add the policy, then the springs:
/// `world.add(Spring{ball, hook, 100.0 * newton_per_metre, 2.0 * newton_second_per_metre})`. They take every
/// integrator; what they need is a step short enough for the stiffest of them, which `stable_step.hpp` computes, or an
/// implicit integrator. Not for rigid rods: a spring stiff enough to look rigid wants steps nobody pays for.
///
/// | policy                | its springs                                                         |
/// |-----------------------|---------------------------------------------------------------------|
/// | `Springs{}`           | pull and push, damped along their axis                              |
/// | `Springs<Undamped>{}` | no damping: the velocity is not read, so that the motion is reversible  |
/// | `Springs<Breaking>{}` | each may break at a force or a strain                               |
/// | `Ropes{}`             | only pull; takes the same options                                   |
///
/// Ends in one place have no axis: such a spring does nothing until they separate. A spring is gone with a body that it
/// holds. A body on a spring falls asleep where what remains of the forces on it is less than `Rest::pull` allows. Not
/// provided: torsion, bending.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/springs/constraint.hpp>
#include <ansatz/springs/network.hpp>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string_view>

namespace ansatz {

/// Option of Springs and Ropes: no damping, not even a number for it.
struct Undamped {};
/// Option of Springs and Ropes: each may be given a force or a strain at which it breaks.
struct Breaking {};

namespace detail {

template <class Option>
inline constexpr bool is_spring_option = std::same_as<Option, Undamped> || std::same_as<Option, Breaking>;

/// What Springs and Ropes have in common.
/// \tparam E Spring or Rope
template <class E, springs::Acts How, class... Options> struct SpringForce {
    static_assert((is_spring_option<Options> && ...),
                  "Ansatz: the options of Springs and Ropes are Undamped and Breaking, e.g. Ropes<Breaking>{}");
    static constexpr bool damped = !(std::same_as<Options, Undamped> || ...); ///< whether springs have a damping
    static constexpr bool breaks = (std::same_as<Options, Breaking> || ...);  ///< whether springs break

    using role = roles::Force;
    using reads = std::conditional_t<damped, Columns<Position, Velocity>, Columns<Position>>;
    static constexpr bool follows_from_ends = true; // motion/still_forces.hpp
    static constexpr bool couples_bodies = true;
    using Element = E;                                                    ///< what World::add takes for it
    template <class S> using State = SpringNetwork<S, E, damped, breaks>; ///< where they are kept

    static void parameters(auto&, auto&&) {}

    template <class S> struct In {
        using Network = State<S>;
        using Link = typename Network::Link;
        using Scalar = typename S::Scalar;
        explicit In(const SpringForce&) {}

        /// The forces of all springs.
        void couple(auto& view, const auto&) const {
            for (const auto& spring : view.state().pairs())
                view.add_force_pair(spring.a, spring.b, pull_of(view, spring));
            for (const auto& spring : view.state().hung()) view.add_force(spring.a, pull_of(view, spring));
        }

        /// \name One spring by itself: first those between bodies, then those at points, each by id
        /// @{
        std::size_t element_count(const auto& view) const {
            return view.state().pairs().size() + view.state().hung().size();
        }
        /// The slots of its ends; `view.size()` for a point.
        std::array<std::size_t, 2> ends(const auto& view, std::size_t k) const {
            const auto& pairs = view.state().pairs();
            if (k < pairs.size()) return {pairs[k].a, pairs[k].b};
            return {view.state().hung()[k - pairs.size()].a, view.size()};
        }
        /// The forces on them, N.
        std::array<typename S::Force, 2> forces(const auto& view, std::size_t k, const auto&) const {
            const auto& pairs = view.state().pairs();
            const auto f =
                k < pairs.size() ? pull_of(view, pairs[k]) : pull_of(view, view.state().hung()[k - pairs.size()]);
            return {f, -f};
        }
        /// @}

        /// How the force on the first end changes with its position and velocity: on the second end it is the opposite,
        /// and with the second end's position and velocity too. Of a slack or pushing spring only the part along the
        /// axis is given, so that the system of an implicit step stays positive definite; so is the turning of the axis
        /// left out of what the damping does. Newton's method arrives at the same state without them.
        /// \param add called with the slots of the ends (or `view.size()` for a point) and the matrices in N/m and N
        /// s/m
        void jacobian(const auto& view, const auto&, auto&& add) const {
            using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>;
            each(view, [&](std::uint32_t id, const Link& link, std::size_t a) {
                const bool anchored = link.b == Network::no_body;
                const std::size_t b = anchored ? view.size() : std::size_t(view.slot_of_id(link.b));
                const auto to = (anchored ? view.state().anchor(id) : view.template get<Position>(b)) -
                                view.template get<Position>(a);
                const auto length = robust_norm(to);
                const Scalar slack = length.value() - link.rest_length;
                if (!(length.value() > Scalar(0)) || (How == springs::Acts::pulling && !(slack > Scalar(0)))) return;
                const auto axis = Vector<Scalar, S::dimension>(to.value() / length.value());
                const Matrix along = axis * axis.transpose();
                // T / L of the elastic part: how stiff it is across the axis.
                const Scalar across = slack > Scalar(0) ? link.stiffness * slack / length.value() : Scalar(0);
                const Matrix by_position = -link.stiffness * along - across * (Matrix::Identity() - along);
                if constexpr (damped) add(a, b, by_position, Matrix(-link.damping * along));
                else add(a, b, by_position, Matrix(Matrix::Zero()));
            });
        }

        /// How stiff and how damped each spring is at most, whatever its length: for a bound of the stable step.
        /// \param f called with the slots of the ends (or `view.size()` for a point), N/m and N s/m
        void stiffnesses(const auto& view, auto&& f) const {
            each(view, [&](std::uint32_t, const Link& link, std::size_t a) {
                f(a, link.b == Network::no_body ? view.size() : std::size_t(view.slot_of_id(link.b)), link.stiffness,
                  damping_of(link));
            });
        }

        /// What `constraints` gives.
        using constraint_types = Types<SpringConstraint<S, How>, AnchoredSpringConstraint<S, How>>;
        /// Every spring as what a solver of positions holds, first those between bodies, then those at points, each by
        /// id (springs/constraint.hpp). Where a world has such a solver, springs are not forces.
        /// \param f called with one of `constraint_types`
        void constraints(const auto& view, auto&& f) const {
            for (const auto& l : view.state().pairs())
                f(SpringConstraint<S, How>{{l.a, l.b}, l.rest_length, l.stiffness, damping_of(l)});
            hung_constraints(view, f);
        }
        /// Those at points alone.
        void hung_constraints(const auto& view, auto&& f) const {
            for (const auto& l : view.state().hung())
                f(AnchoredSpringConstraint<S, How>{{l.a}, l.rest_length, l.stiffness, damping_of(l), l.anchor.value()});
        }

        /// All of them, for a solver that takes those between bodies together.
        const Network& network(const auto& view) const { return view.state(); }
        static constexpr bool pulls_only = How == springs::Acts::pulling; ///< whether they never push

        /// \f$ \sum \tfrac12 k x^2 \f$; a slack rope holds nothing.
        typename S::Energy potential_energy(const auto& view) const {
            typename S::Energy sum{};
            each(view, [&](std::uint32_t id, const Link& link, std::size_t a) {
                const auto stretched =
                    robust_norm(typename S::Position(end(view, id, link) - view.template get<Position>(a))) -
                    S::Length::from_value(link.rest_length);
                if (How == springs::Acts::pulling && !(stretched.value() > Scalar(0))) return;
                sum += springs::energy(S::template ScalarOf<unit::Stiffness>::from_value(link.stiffness), stretched);
            });
            return sum;
        }

        /// What each spring pulls with, N, and its strain; for those who ask (Breaking, debug draw).
        /// \param f called with the id, the tension and the strain
        void tensions(const auto& view, auto&& f) const {
            each(view, [&](std::uint32_t id, const Link& link, std::size_t a) {
                const auto to = end(view, id, link) - view.template get<Position>(a);
                const auto length = robust_norm(to);
                const auto v =
                    link.b == Network::no_body ? leaving(view, a) : departing(view, a, view.slot_of_id(link.b));
                const auto speed = length.value() > Scalar(0) ? dot(v, to) / length : typename S::Speed();
                const auto rest = S::Length::from_value(link.rest_length);
                const auto tension = length.value() > Scalar(0)
                                         ? springs::tension<How>(length, rest, speed, stiffness_of(link), c_of(link))
                                         : S::template ScalarOf<unit::Force>::from_value(Scalar(0));
                const Scalar strain = link.rest_length > Scalar(0)
                                          ? Scalar((length.value() - link.rest_length) / link.rest_length)
                                          : Scalar(0);
                f(id, tension, strain);
            });
        }

        /// Whether one of the springs breaks in the state that the step has made; `note` is called for each.
        void breaking(const auto& view, auto&& note) const
            requires breaks
        {
            using std::abs;
            tensions(view, [&](std::uint32_t id, const auto& tension, const Scalar& strain) {
                const auto& limit = view.state().limit(id);
                if (abs(tension.value()) > limit.force || abs(strain) > limit.strain) note(id, tension, strain);
            });
        }

    private:
        static void each(const auto& view, auto&& f) {
            view.state().for_each(
                [&](std::uint32_t id, const Link& link) { f(id, link, std::size_t(view.slot_of_id(link.a))); });
        }
        [[gnu::always_inline]] static auto stiffness_of(const auto& link) {
            return S::template ScalarOf<unit::Stiffness>::from_value(link.stiffness);
        }
        [[gnu::always_inline]] static Scalar damping_of(const auto& link) {
            if constexpr (damped) return link.damping;
            else return Scalar(0);
        }
        [[gnu::always_inline]] static auto c_of(const auto& link) {
            return S::template ScalarOf<unit::Damping>::from_value(damping_of(link));
        }
        static typename S::Position end(const auto& view, std::uint32_t id, const Link& link) {
            return link.b == Network::no_body ? view.state().anchor(id)
                                              : view.template get<Position>(view.slot_of_id(link.b));
        }
        [[gnu::always_inline]] static typename S::Velocity departing(const auto& view, std::size_t a, std::size_t b) {
            if constexpr (damped) return view.template get<Velocity>(b) - view.template get<Velocity>(a);
            else return S::template zero_vector<unit::Velocity>();
        }
        [[gnu::always_inline]] static typename S::Velocity leaving(const auto& view, std::size_t a) {
            if constexpr (damped) return -view.template get<Velocity>(a);
            else return S::template zero_vector<unit::Velocity>();
        }
        [[gnu::always_inline]] static typename S::Force pull_of(const auto& view, const Link& spring) {
            return pull(spring, view.template get<Position>(spring.b) - view.template get<Position>(spring.a),
                        departing(view, spring.a, spring.b));
        }
        [[gnu::always_inline]] static typename S::Force pull_of(const auto& view,
                                                                const typename Network::Hung& spring) {
            return pull(spring, spring.anchor - view.template get<Position>(spring.a), leaving(view, spring.a));
        }
        [[gnu::always_inline]] static typename S::Force pull(const auto& link, const typename S::Position& to,
                                                             const typename S::Velocity& v) {
            return springs::between<How>(to, v, S::Length::from_value(link.rest_length), stiffness_of(link),
                                         c_of(link));
        }
    };
};

} // namespace detail

/// Springs that pull and push.
/// \tparam Options Undamped, Breaking, both or none, in any order
template <class... Options> struct Springs : detail::SpringForce<Spring, springs::Acts::both_ways, Options...> {
    static constexpr std::string_view name = "Springs"; ///< in a saved file
};
/// Springs that only pull.
/// \tparam Options Undamped, Breaking, both or none, in any order
template <class... Options> struct Ropes : detail::SpringForce<Rope, springs::Acts::pulling, Options...> {
    static constexpr std::string_view name = "Ropes"; ///< in a saved file
};

} // namespace ansatz
