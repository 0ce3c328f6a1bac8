// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `StepLimit`: what a world does with a step that is too long for its springs (notes 3).
///
/// Add `StepLimit<Refuse>{}` and such a step is refused with the longest that would do, before anything is touched; add
/// `StepLimit<Divide>{}` and it is taken in as many equal substeps as are needed. Either checks every spring before
/// each step, which costs nearly as much as their forces (0.8 to 0.9 of a step, 10,000 bodies in a grid): for worlds
/// whose springs change while they run. Elsewhere ask `stable_step(world)` once. Not needed with ImplicitEuler, which
/// never grows.
///
/// The limit is that of stable_step.hpp, on the safe side, which for cloth is 1.4 to 1.6 times too careful. With
/// `.measured = 20` the springs' stiffness is measured instead, as they are stretched now, by at most so many power
/// iterations before each step (measured_stiffness.hpp), and 0.95 of the step that follows from it is the limit. Where
/// that has not converged, or is shorter, the certain limit holds. An iteration costs about two passes over the
/// springs, 12 to 16 are made, so that it pays where a step is divided into many substeps. Not where ropes are slack,
/// or a sheet folds within a step: what is not felt now is not measured.
///
/// Each substep counts as a tick and is followed by all that follows a step; what broke, fell asleep or woke in any of
/// them is among the events of the step. `Interpolation` draws the whole step.

#include <ansatz/springs/stable_step.hpp>
#include <ansatz/world/world.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace ansatz {

/// Option of StepLimit: a step that is too long is an error.
struct Refuse {};
/// Option of StepLimit: a step that is too long is taken in substeps.
struct Divide {};

/// \tparam Beyond what a step beyond the limit is: Refuse or Divide
template <class Beyond = void> struct StepLimit {
    static_assert(std::same_as<Beyond, Refuse> || std::same_as<Beyond, Divide>,
                  "Ansatz: a StepLimit refuses or divides; write StepLimit<Refuse>{} "
                  "or StepLimit<Divide>{}");
    using role = roles::StepControl;

    /// The fraction of the largest stable step that is let through; greater than 0, 1 is all of it
    double part = 1;
    /// The number of substeps that a step is divided into at most; where more are needed, it is refused
    int most_parts = 1000;
    /// How many power iterations measure the springs before a step, at most; 0 for the certain bound
    int measured = 0;

    static constexpr std::string_view name = "StepLimit";
    static void parameters(auto& self, auto&& visit) {
        visit("part", self.part);
        visit("most_parts", self.most_parts);
        visit("measured", self.measured);
    }
    void check() const {
        if (!(part > 0) || !(part <= 1)) refuse_value("StepLimit", "part", part, "it is greater than 0 and at most 1");
        if (most_parts < 1) refuse_value("StepLimit", "most_parts", most_parts, "it is at least 1");
        if (measured < 0) refuse_value("StepLimit", "measured", measured, "it is at least 0, which measures nothing");
    }

    /// What it keeps between steps, so that a step that is warm allocates nothing.
    struct Kept {
        StiffnessScratch scratch;           ///< room for the sums at each body
        MeasuredStiffnessScratch measuring; ///< room for power iteration
        Stiffness of{};                     ///< for which the limit was found
        Quantity<unit::Time> limit{};       ///< s
        bool found = false;                 ///< whether there is a limit yet
    };

    /// The number of substeps that a step is taken in.
    /// \throws std::invalid_argument where it is refused
    template <class World_> int parts(const World_& world, const Quantity<unit::Time>& dt, Kept& kept) const {
        const auto now = stiffness_of(world, kept.scratch);
        using I = typename World_::Integrator;
        constexpr bool may_change = requires { typename detail::Bound<I, typename World_::S>; };
        if (!kept.found || may_change || !(now == kept.of)) {
            kept.limit = stable_step<I>(now, world.template get<I>());
            kept.of = now;
            kept.found = true;
        }
        auto limit = part * kept.limit;
        if (dt <= limit) return 1;
        if (measured > 0) limit = std::max(limit, part * measured_limit<I>(world, now, kept));
        if (dt <= limit) return 1;
        const double needed = limit.value() > 0 ? std::ceil(dt / limit) : HUGE_VAL;
        if (std::same_as<Beyond, Divide> && needed <= most_parts) return int(needed);
        refuse_step(dt, limit);
    }

private:
    /// 0.95 of what the springs allow as they are now; zero where they could not be measured.
    template <class I, class World_>
    Quantity<unit::Time> measured_limit(const World_& world, Stiffness springs, Kept& kept) const {
        const auto found = measured_stiffness(world, measured, kept.measuring);
        if (!found.converged) return 0.0 * second;
        springs.largest = std::min(springs.largest, found.largest);
        return 0.95 * stable_step<I>(springs, world.template get<I>());
    }
    /// To four digits, for a person to read and to type.
    static Quantity<unit::Time> rounded_down(const Quantity<unit::Time>& t) {
        const double scale = std::pow(10.0, 3 - std::floor(std::log10(t.value())));
        return std::floor(t.value() * scale) / scale * second;
    }
    [[noreturn, gnu::cold, gnu::noinline]] void refuse_step(const Quantity<unit::Time>& dt,
                                                            const Quantity<unit::Time>& limit) const {
        std::string better;
        if (!(limit.value() > 0))
            better = "this integrator grows with every step where springs are not damped; take SemiImplicitEuler, or "
                     "ImplicitEuler";
        else if (std::same_as<Beyond, Refuse>)
            better = "the longest that is stable for these springs is " + describe(rounded_down(limit)) +
                     "; take that, StepLimit<Divide>, or ImplicitEuler";
        else
            better = "the longest that is stable for these springs is " + describe(rounded_down(limit)) +
                     ", and most_parts is " + describe(most_parts) + "; take a shorter step, or ImplicitEuler";
        refuse_value("World::step", "dt", dt, better);
    }
};

} // namespace ansatz
