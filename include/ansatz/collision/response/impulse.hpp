// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Impulse`: changes the velocities of bodies that run into each other, at once (notes 2.2.1).
///
/// Use it for anything that bounces. With `Projection` beside it bodies also stop sinking into each other.
/// `Impulse<Friction>` slows what slides; without the option there is no coefficient, no byte and no instruction of it.
///
/// | symbol | meaning                                                         | unit   |
/// |--------|-----------------------------------------------------------------|--------|
/// | N      | contact normal, from b to a                                     | 1      |
/// | v_N    | N . (v_a - v_b): negative while they approach                   | m/s    |
/// | e      | coefficient of restitution, the larger of the two bodies'       | 1      |
/// | w      | 1/m                                                             | 1/kg   |
/// | J      | impulse along N on a; on b it is -J                             | N s    |
///
/// The notes write v_ab = v_a + v_b; the relative velocity is the difference, or two bodies that fly side by side would
/// push each other. And momentum is kept whatever e is (the two impulses are opposite); what is lost is kinetic energy,
/// by
/// \f$ \tfrac12 \mu (1 - e^2) v_N^2 \f$ with the reduced mass mu.
///
/// **Restitution that is right.** A velocity is known at another time than the position, by the integrator's own
/// measure
/// (`velocity_leads`), and bodies are found when they are already some way inside each other. Both are taken into
/// account, so that a ball with e = 1 comes back to its height with every integrator. Approaches slower than
/// `threshold` do not bounce: in a step of 1/60 s gravity alone gives 0.16 m/s to what lies on the ground.
///
/// **Many at once.** Contacts that approach faster than `threshold` are reflected, those that hang together as one,
/// again and again while any two still approach: a blow goes through a row of balls one by one, and two that are hit at
/// once are hit alike. Then resting contacts are held, all of them together (contact_pushes.hpp). Neither step adds
/// energy, and neither depends on the order of insertion.

#include <ansatz/collision/concepts.hpp>
#include <ansatz/collision/contact_step.hpp>
#include <ansatz/collision/restitution.hpp>
#include <ansatz/units/requirements.hpp>

#include <concepts>
#include <optional>
#include <string_view>

namespace ansatz {

/// \f$ J = \frac{-(1 + e)\,v_N}{w_a + w_b} \f$: the impulse on the first of two bodies along N, from the second to the first; zero
/// where they separate.
/// \param va, vb m/s, vectors
/// \param wa, wb 1/m, 1/kg, not both zero
template <class V, class W, class N, class E>
auto collision_impulse(const V& va, const V& vb, const W& wa, const W& wb, const N& normal, const E& e) {
    const auto along = dot(va - vb, normal);
    using J = std::decay_t<decltype(along / (wa + wb))>;
    return along.value() < 0 ? J(-(1 + e) * along / (wa + wb)) : J();
}

namespace detail {
/// Coulomb's law: what slides is slowed by at most mu times the impulse along the normal.
template <class S, class Body, class J>
void slow_sliding(const Vector<typename S::Scalar, S::dimension>& normal, Body& a, Body& b, const J& pressed) {
    const auto wa = a.template get<InverseMass>(), wb = b.template get<InverseMass>();
    auto& va = a.template get<Velocity>();
    auto& vb = b.template get<Velocity>();
    const typename S::Velocity between = va - vb;
    const typename S::Velocity sliding = between - dot(between, normal) * normal;
    const auto speed = norm(sliding);
    if (!(speed.value() > 0)) return;
    const auto mu = sqrt(a.template get<Friction>().value() * b.template get<Friction>().value());
    // No more than would stop it.
    const auto holding = min(std::decay_t<J>(speed / (wa + wb)), std::decay_t<J>(mu * pressed));
    const typename S::Momentum j = (-holding / speed) * sliding;
    va += wa * j;
    vb -= wb * j;
}
} // namespace detail

/// \tparam Options Friction, or none
template <class... Options> struct Impulse {
    static_assert((std::same_as<Options, Friction> && ...) && sizeof...(Options) < 2,
                  "Ansatz: the option of Impulse is Friction, e.g. Impulse<Friction>{}");
    static constexpr bool rubs = sizeof...(Options) > 0; ///< whether there is friction

    using role = roles::Response;
    static constexpr Level level = Level::velocities; ///< what it acts on
    using reads = Columns<Restitution, Options...>;
    using writes = Columns<Velocity>;

    /// m/s, finite, not negative: slower approaches do not bounce. At least 1.5 g dt with the acceleration g of
    /// gravity, or resting bodies tremble.
    Parameter<unit::Velocity> threshold = 0.25 * metre_per_second;
    /// The largest number of sweeps over all contacts of a cluster in a step, at least 1: for blows, and again for
    /// resting contacts. A blow goes one body further with each sweep, and a column of n needs n. A cluster that they
    /// do not half solve gets up to twice as many again (infeasible_contacts.hpp).
    int sweeps = 24;
    static constexpr bool as_one = true; ///< all contacts of a step are answered together

    static constexpr std::string_view name = "Impulse";
    static void parameters(auto& self, auto&& visit) {
        visit("threshold", self.threshold);
        visit("sweeps", self.sweeps);
    }
    /// \throws std::invalid_argument for parameters that are not acceptable
    void check() const {
        require_not_negative("Impulse", "threshold", threshold);
        if (sweeps < 1) refuse_value("Impulse", "sweeps", sweeps, "it is at least 1");
    }

    template <class S> struct In {
        typename S::Speed threshold;
        int sweeps;
        explicit In(const Impulse& impulse) : threshold(S::convert(impulse.threshold)), sweeps(impulse.sweeps) {}

        /// The material of the two bodies of a contact.
        void note(auto& push, const auto& a, const auto& b) const {
            push.restitution = max(a.template get<Restitution>(), b.template get<Restitution>()).value();
            if constexpr (rubs)
                push.friction = sqrt(a.template get<Friction>().value() * b.template get<Friction>().value());
        }
        /// Changes the velocities of a step: contacts that approach fast enough bounce, then no contact may approach.
        void answer(auto& pushes, const typename S::Time& dt, const typename S::Scalar& leads, bool parted,
                    const auto& pull) const {
            using Scalar = typename S::Scalar;
            bool any = false;
            for (auto& push : pushes.pushes) {
                if (push.restitution > Scalar(0) && leads != Scalar(0))
                    push.ahead = leads * pull(push).value() * dt.value();
                any = any || (push.touches && push.restitution > Scalar(0));
                // Bodies that do not touch yet may close their gap.
                if (!push.touches) push.target = push.depth / dt.value();
            }
            if (any && parted) go_back(pushes, leads * dt.value(), pull);
            for (int round = 0; any && round < sweeps; ++round)
                any = pushes.bounce([&](auto& push) { return parting(push); });
            // Faster than the threshold, or so far away that it would take more than that: stopped at the touch.
            const Scalar slow = threshold.value();
            for (auto& push : pushes.pushes)
                push.waits = !push.touches && (slow > Scalar(0) || push.restitution > Scalar(0)) &&
                             max(-(pushes.along(push) + push.ahead), -push.target) > slow;
            pushes.solve(sweeps);
            if constexpr (rubs)
                for (int round = 0; round < 4; ++round) {
                    pushes.rub();
                    pushes.solve(sweeps);
                }
        }
        /// Changes the velocities of the two of one contact, if they approach each other.
        [[gnu::always_inline]] void respond(const auto& touch, auto& a, auto& b, const auto& meeting) const {
            using Scalar = typename S::Scalar;
            auto& va = a.template get<Velocity>();
            auto& vb = b.template get<Velocity>();
            const auto wa = a.template get<InverseMass>(), wb = b.template get<InverseMass>();
            const auto e = max(a.template get<Restitution>(), b.template get<Restitution>()).value();
            const typename S::Speed along = dot(va - vb, touch.normal);
            typename S::Speed wanted{};
            if (e > Scalar(0)) wanted = bounce(touch, along, e, meeting);
            if (!(along < wanted)) return;
            const auto j = (wanted - along) / (wa + wb);
            va += (wa * j) * touch.normal;
            vb -= (wb * j) * touch.normal;
            if constexpr (rubs) detail::slow_sliding<S>(touch.normal, a, b, j);
        }

    private:
        /// Those that will be separated get the velocities of where they touched, if something pulls at them.
        void go_back(auto& pushes, const typename S::Scalar& lead, const auto& pull) const {
            using Scalar = typename S::Scalar;
            const auto bounces = [&](const auto& push) {
                return push.touches && push.restitution > Scalar(0) &&
                       -(pushes.along(push) + push.ahead) > threshold.value();
            };
            bool any = false, pulled = false;
            for (auto& push : pushes.pushes) {
                push.bounces = bounces(push);
                any = any || push.bounces;
            }
            for (const auto& push : pushes.pushes) pulled = pulled || (any && pull(push).value() != Scalar(0));
            if (!pulled) return;
            pushes.back_to_touch(
                sweeps, lead, [](const auto& push) { return push.bounces; },
                [&](const auto& push) { return pull(push).value(); });
        }
        /// The speed at which a contact that bounces is to separate. What pulls is accounted for once in a step.
        std::optional<typename S::Scalar> parting(auto& push) const {
            using Scalar = typename S::Scalar;
            const auto& e = push.restitution;
            if (!push.touches || !(e > Scalar(0))) return {};
            if (push.bounced)
                return -push.along > threshold.value() ? std::optional<Scalar>(-e * push.along) : std::nullopt;
            if (!(-(push.along + push.ahead) > threshold.value())) return {};
            const auto speed = -e * (push.along + push.ahead) - push.ahead;
            push.bounced = true;
            push.target = min(speed, Scalar(0));
            return speed;
        }
        /// The velocity along N that the integrator has to be given, so that the two separate as they should; zero if
        /// they do not bounce.
        typename S::Speed bounce(const auto& touch, const typename S::Speed& along, const typename S::Scalar& e,
                                 const auto& meeting) const {
            using Scalar = typename S::Scalar;
            if (meeting.leads == Scalar(0) && !meeting.parted)
                return -along > threshold ? typename S::Speed(-e * along) : typename S::Speed();
            const auto pull = meeting.pull();
            const typename S::Speed ahead = (meeting.leads * pull) * meeting.dt;
            const typename S::Speed now = along + ahead;
            if (!(-now > threshold)) return {};
            // Moved apart, they are where they touched first, and were slower there by what the pull did on the way in.
            const auto squared = now * now + Scalar(2) * pull * touch.depth;
            const typename S::Speed touching = !meeting.parted               ? typename S::Speed(-now)
                                               : squared.value() > Scalar(0) ? sqrt(squared)
                                                                             : typename S::Speed();
            return e * touching - ahead;
        }
    };
};

} // namespace ansatz
