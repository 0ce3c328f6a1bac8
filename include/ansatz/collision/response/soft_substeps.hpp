// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SoftSubsteps`: takes a step in substeps and solves all contacts in each of them, softly and with memory. Beyond the
/// notes.
///
/// Use it for piles, stacks and crowds: it remembers what presses from step to step, which a few iterations of
/// `Impulse` and `Projection` do not make up for in a high column. Heavy bodies on light ones want more substeps and a
/// higher frequency. Pairs are found once a step, with those that may come to touch in it, and again where a sleeper
/// wakes in it; then the forces and the integrator run in each of `parts` substeps, and the contacts are
/// solved between them (soft_contacts.hpp). It needs no other response. What it costs is about `parts` integrations and
/// twice as many passes over the contacts. Where no body wakes, a law of one body is asked once in each substep, for
/// the contacts and the integrator's first stage, and once more in the step.
///
/// **Impacts at one moment** (soft_impacts.hpp). Pairs that meet faster than `threshold` bounce when they meet, one
/// after another in time, and together where they share a body and a moment; the order in which bodies were added makes
/// no difference. At e = 1 kinetic energy is kept, and five balls in a row are a cradle: (1, 0, 0, 0, 0) becomes (0, 0,
/// 0, 0, 1).
///
/// Every integrator is given velocities with which its own next positions keep the bodies apart: what it does to a
/// velocity under constant acceleration is known from `velocity_leads`.

#include <ansatz/collision/concepts.hpp>
#include <ansatz/collision/contact_step.hpp>
#include <ansatz/collision/response/coloured_soft_contacts.hpp>
#include <ansatz/collision/response/soft_contacts.hpp>
#include <ansatz/units/requirements.hpp>

#include <cmath>
#include <concepts>
#include <string_view>
#include <type_traits>

namespace ansatz {

/// An option of SoftSubsteps: contacts are solved by colours, many at once (contact_colours.hpp).
///
/// Use it for piles of a thousand bodies and more; the threads of an Execution share its passes. The same formula for
/// each contact, in another order: what comes out is as good, and is other bits. Along a column the order of ids is
/// better than colours: there news runs from end to end in one pass.
struct Coloured {};

/// \tparam Options Friction, Coloured, both or none
template <class... Options> struct SoftSubsteps {
    static_assert(((std::same_as<Options, Friction> || std::same_as<Options, Coloured>)&&...) &&
                      (0 + ... + int(std::same_as<Options, Friction>)) < 2 &&
                      (0 + ... + int(std::same_as<Options, Coloured>)) < 2,
                  "Ansatz: the options of SoftSubsteps are Friction and Coloured, each once, e.g. "
                  "SoftSubsteps<Friction>{}");
    static constexpr bool rubs = (std::same_as<Options, Friction> || ...);     ///< whether there is friction
    static constexpr bool coloured = (std::same_as<Options, Coloured> || ...); ///< whether contacts go by colours

    using role = roles::Response;
    static constexpr Level level = Level::substeps; ///< what it acts on
    using reads = std::conditional_t<rubs, Columns<Restitution, Friction>, Columns<Restitution>>;
    using writes = Columns<Velocity>;
    /// the contacts, with their impulses
    template <class S> using State = std::conditional_t<coloured, ColouredSoftContacts<S, rubs>, SoftContacts<S, rubs>>;

    /// Number of substeps of a step, at least 1.
    int parts = 4;
    /// 1/s, how fast a depth is removed, finite and greater than zero; at most a quarter of the number of substeps
    /// a second is used
    Parameter<unit::Frequency> frequency = 60.0 * hertz;
    /// Of each contact as a spring; finite and greater than zero
    double damping_ratio = 5;
    /// m, how deep bodies may stay in each other; finite, not negative
    Parameter<unit::Length> slop = 0.0 * metre;
    /// m/s, how fast bodies that were put into each other separate at most; finite and greater than zero
    Parameter<unit::Velocity> push_out = 1.5 * metre_per_second;
    /// m/s, finite, not negative: slower approaches do not bounce
    Parameter<unit::Velocity> threshold = 0.25 * metre_per_second;

    static constexpr std::string_view name = "SoftSubsteps";
    static void parameters(auto& self, auto&& visit) {
        visit("parts", self.parts);
        visit("frequency", self.frequency);
        visit("damping_ratio", self.damping_ratio);
        visit("slop", self.slop);
        visit("push_out", self.push_out);
        visit("threshold", self.threshold);
    }
    /// \throws std::invalid_argument for parameters that are not acceptable
    void check() const {
        if (parts < 1) refuse_value("SoftSubsteps", "parts", parts, "it is at least 1");
        require_positive("SoftSubsteps", "frequency", frequency);
        if (!(damping_ratio > 0) || !is_finite(damping_ratio))
            refuse_value("SoftSubsteps", "damping_ratio", damping_ratio, "it is finite and greater than zero");
        require_not_negative("SoftSubsteps", "slop", slop);
        require_positive("SoftSubsteps", "push_out", push_out);
        require_not_negative("SoftSubsteps", "threshold", threshold);
    }

    template <class S> struct In {
        using Scalar = typename S::Scalar;
        SoftSubsteps policy;
        explicit In(const SoftSubsteps& p) : policy(p) {}

        /// The number of substeps.
        int parts() const { return policy.parts; }
        /// Finds the contacts that may bounce in this step.
        /// \return whether there are any; where there are none, nothing is done for them
        template <class Data> bool find_bouncing(auto& contacts, const Data& data) const {
            const auto larger = [&](const auto& c) {
                return max(data.lanes.template get<Restitution>(c.slot_a),
                           data.lanes.template get<Restitution>(c.slot_b))
                    .value();
            };
            bool any = false;
            contacts.each_acting([&](const auto& c) { any = any || larger(c) > Scalar(0); });
            if (any)
                contacts.each_acting([&](const auto& c) {
                    contacts.impacts.pairs.push_back({std::uint32_t(&c - contacts.all.data()), larger(c)});
                });
            return any;
        }
        /// Those that meet in this substep bounce.
        bool bounce(auto& contacts, Scalar h) const {
            return contacts.impacts.answer(contacts, h, Scalar(policy.threshold.value()));
        }
        /// One pass that holds contacts, and separates those that are too deep.
        void solve(auto& contacts, Scalar h) const {
            const Scalar f = std::min(Scalar(policy.frequency.value()), Scalar(0.25) / h),
                         zeta = Scalar(policy.damping_ratio);
            contacts.solve(h, Softness<Scalar>::of(f, zeta, h), Softness<Scalar>::of(2 * f, zeta, h),
                           Scalar(policy.slop.value()), Scalar(policy.push_out.value()));
        }
        /// How softly rows of joints are held: as contacts with what is not moved.
        Softness<Scalar> softness(Scalar h) const {
            return Softness<Scalar>::of(2 * std::min(Scalar(policy.frequency.value()), Scalar(0.25) / h),
                                        Scalar(policy.damping_ratio), h);
        }
        /// The friction of two bodies.
        template <class Data> Scalar friction(const Data& data, std::size_t a, std::size_t b) const {
            if constexpr (rubs)
                return sqrt(data.lanes.template get<Friction>(a).value() *
                            data.lanes.template get<Friction>(b).value());
            else return Scalar(0);
        }
    };
};

} // namespace ansatz
