// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Interpolation`: remembers where each body was before the last step, so that a renderer can draw it in between.
///
/// Use it with FixedStep when pictures are drawn more often, or at other times, than steps are taken. A body that was
/// put somewhere else with `set_position` is drawn there at once, never on the way. Do not compute with the
/// interpolated position; it is up to one step old.

#include <ansatz/motion/integration.hpp>
#include <ansatz/motion/roles.hpp>
#include <ansatz/world/bodies.hpp>

namespace ansatz {

/// An effect that copies Position to DrawnPosition before the step. Costs one vector for each body.
struct Interpolation {
    using role = roles::Effect;
    using reads = Columns<Position>;
    using writes = Columns<DrawnPosition>;
    static constexpr Place place = Place::before_forces;
    static constexpr bool on_platforms = true; ///< bodies that are `moving` are drawn in between as well
    static constexpr bool once_a_step = true;  ///< a step that is taken in substeps (StepLimit) is drawn as one

    template <class S> struct In {
        explicit In(const Interpolation&) {}
        [[gnu::always_inline]] void apply(typename S::Position& drawn, const typename S::Position& x,
                                          const auto&) const {
            drawn = x;
        }
    };
};

/// Where to draw a body, `alpha` of the way from the state before the last step (0) to the present one (1).
/// \param alpha from 0 to 1, usually FixedStep::alpha()
/// \throws std::out_of_range for a stale handle
template <class World_> auto interpolated_position(const World_& world, Handle body, double alpha) {
    static_assert(World_::composition::template stores<DrawnPosition>,
                  "Ansatz: this world does not remember where its bodies were; add Interpolation{} to its policies");
    using Scalar = typename World_::Scalar;
    const auto now = world.position(body);
    // The step copies what moves; a body that rests or is fixed is where it is.
    const auto kind = world.motion(body);
    if (kind == Motion::resting || kind == Motion::fixed) return now;
    const auto before = world.template read<DrawnPosition>(body);
    return before + Scalar(alpha) * (now - before);
}

} // namespace ansatz
