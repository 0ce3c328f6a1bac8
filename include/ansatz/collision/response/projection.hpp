// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Projection`: moves bodies apart that intersect, and touches nothing but their positions (notes 2.2).
///
/// Use it with a response that changes velocities (`World{..., Impulse{}, Projection{}}`): alone, bodies that fall onto
/// each other are lifted apart in every step and fall ever faster. The notes do not say how the move is shared: by
/// inverse mass, the centre of mass stays where it is; half and half, it drifts.
///
/// Where many touch, all of a step are moved apart together (contact_pushes.hpp): by what moves the whole least.

#include <ansatz/collision/concepts.hpp>
#include <ansatz/collision/contact_step.hpp>
#include <ansatz/units/requirements.hpp>

#include <string_view>

namespace ansatz {

/// \f$ \Delta\mathbf x_a = \frac{w_a}{w_a + w_b}\,s\,(p - p_0)\,\mathbf N, \quad \Delta\mathbf x_b = -\frac{w_b}{w_a + w_b}\,s\,(p - p_0)\,\mathbf N \f$
/// with w = 1/m.
struct Projection {
    using role = roles::Response;
    static constexpr Level level = Level::positions; ///< what it acts on
    using reads = Columns<>;
    using writes = Columns<Position>;

    /// p0, m: how deep bodies may stay in each other; finite, not negative. Larger than zero, resting bodies keep their
    /// contact.
    Parameter<unit::Length> slop = 0.0 * metre;
    /// s: the fraction of the depth beyond p0 that a step takes away; greater than 0, at most 1
    double share = 1;
    /// The largest number of sweeps over all contacts of a cluster in a step, at least 1. A column of n needs n; fewer
    /// leave it deeper. A cluster that they do not half solve gets up to twice as many again (infeasible_contacts.hpp).
    int sweeps = 24;
    static constexpr bool as_one = true; ///< all contacts of a step are answered together

    static constexpr std::string_view name = "Projection";
    static void parameters(auto& self, auto&& visit) {
        visit("slop", self.slop);
        visit("share", self.share);
        visit("sweeps", self.sweeps);
    }
    /// \throws std::invalid_argument for parameters that are not acceptable
    void check() const {
        require_not_negative("Projection", "slop", slop);
        if (!(share > 0) || !(share <= 1))
            refuse_value("Projection", "share", share, "it is greater than 0 and at most 1");
        if (sweeps < 1) refuse_value("Projection", "sweeps", sweeps, "it is at least 1");
    }

    template <class S> struct In {
        typename S::Length slop;
        typename S::Scalar share;
        int sweeps;
        explicit In(const Projection& projection)
            : slop(S::convert(projection.slop)),
              share(typename S::Scalar(projection.share)),
              sweeps(projection.sweeps) {}

        /// How far the two of a contact are to be moved apart; where they are not too deep, how far they may still
        /// approach.
        void note(auto& push, const auto&, const auto&) const {
            const auto too_deep = push.depth - slop.value();
            push.target = too_deep > 0 ? share * too_deep : too_deep;
        }
        /// Moves all of a step apart.
        void answer(auto& pushes, const auto&...) const { pushes.solve(sweeps); }
        /// Moves the two of one contact apart.
        [[gnu::always_inline]] void respond(const auto& touch, auto& a, auto& b, const auto&) const {
            const auto wa = a.template get<InverseMass>(), wb = b.template get<InverseMass>();
            const auto too_deep = touch.depth - slop;
            if (!(too_deep.value() > 0) || !((wa + wb).value() > 0)) return;
            const typename S::Position push = (share * too_deep) * touch.normal;
            a.template get<Position>() += typename S::Scalar((wa / (wa + wb))) * push;
            b.template get<Position>() -= typename S::Scalar((wb / (wa + wb))) * push;
        }
    };
};

} // namespace ansatz
