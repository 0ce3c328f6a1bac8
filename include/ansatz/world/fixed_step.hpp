// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `FixedStep`: turns the uneven time between frames into equal steps of a world.
///
/// The time that a frame took goes into an accumulator; whole steps are taken out of it, what is left says how far
/// between two states the picture lies (`alpha`). The accumulator is clamped, because a program that was stopped for
/// ten seconds would otherwise owe six hundred steps, take longer than a frame for them and never catch up. Use it
/// whenever a clock of the real world drives a simulation; a measurement simply calls `step`.

#include <ansatz/core/error.hpp>
#include <ansatz/units.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace ansatz {

/// Real time in, whole steps of one length out.
class FixedStep {
public:
    /// \param dt       length of a step, finite and greater than zero; at least 0.25 ns, or with a shorter clamp a
    /// billionth of that
    /// \param longest  time beyond which a frame's arrears are dropped, at least dt; a quarter of a second by default
    /// \throws std::invalid_argument for other values
    explicit FixedStep(Parameter<unit::Time> dt, Parameter<unit::Time> longest = 0.25 * second) : dt_(dt) {
        if (!is_finite(dt) || !(dt.value() > 0))
            refuse_value("FixedStep", "dt", dt, "a step is finite and greater than 0 s");
        if (!is_finite(longest) || longest.value() < dt.value())
            refuse_value("FixedStep", "longest", longest, "the clamp is finite and at least one step, " + describe(dt));
        const auto usual = std::min(longest.value(), 0.25) * second; // a longer clamp is one that shall not act
        if (!(usual.value() / dt.value() <= most_in_a_frame))
            refuse_value("FixedStep", "dt", dt,
                         "a frame of " + describe(usual) + " would not end; a step is at least " +
                             describe(usual / most_in_a_frame) + ", or the clamp is shorter");
        // The clamp is a whole number of steps, so that it cannot lose part of one; 0.25 s is 15 steps of 1/60 s,
        // although 0.25 / (1/60) may round below 15.
        most_ = std::uint64_t(std::min(std::floor(longest.value() / dt.value() * (1 + 1e-12)), 0x1p53));
    }

    /// Seconds without their unit.
    template <class Number>
        requires(detail::Builtin<Number>)
    explicit FixedStep(const Number&) : FixedStep(1.0 * second) {
        static_assert(detail::never<Number>,
                      "Ansatz: FixedStep takes the time of a step; write e.g. FixedStep{1.0 / 60 * second}");
    }

    /// The length of its steps, s.
    Quantity<unit::Time> dt() const { return dt_; }
    /// How far the present lies between the last two states: 0 at the former, towards 1 at the latter.
    double alpha() const { return left_; }
    /// Time that was dropped by the clamp, in all.
    Quantity<unit::Time> dropped() const { return dropped_; }

    /// Adds a frame's time and takes the steps that it pays for.
    /// \param world any object with `step(dt)`
    /// \param frame_time finite and not negative; at most a billion steps, where the clamp lets more pass
    /// \return how many steps were taken
    /// \throws std::invalid_argument before anything is changed
    template <class World_> std::uint64_t advance(World_& world, Parameter<unit::Time> frame_time) {
        return advance(world, frame_time, [](World_&) {});
    }
    /// The same, calling `before_step(world)` before each step: the place for forces from outside, which act during one
    /// step, so that a body is pushed alike on a screen of 30 and of 144 pictures a second, and for reading the events
    /// of each step, of which the world keeps the last step's only.
    /// \return how many steps were taken
    template <class World_, class BeforeStep>
    std::uint64_t advance(World_& world, Parameter<unit::Time> frame_time, BeforeStep&& before_step) {
        constexpr bool takes_the_world = std::invocable<BeforeStep&, World_&>;
        static_assert(takes_the_world, "Ansatz: FixedStep::advance calls its third argument with the world, before "
                                       "each step; write e.g. [&](auto& world) { world.apply_force(ball, thrust); }");
        if (!is_finite(frame_time) || frame_time.value() < 0)
            refuse_value("FixedStep::advance", "frame_time", frame_time, "a frame's time is finite and not negative");
        // Counted in steps: the fraction of a step that is left never mixes with large sums.
        double owed = std::min(left_ + frame_time.value() / dt_.value(), std::numeric_limits<double>::max());
        // A spike of exactly n steps is n steps, whichever way the division was rounded.
        const double nearest = std::round(owed);
        if (std::abs(owed - nearest) <= 1e-12 * (1 + nearest)) owed = nearest;
        const double whole = std::floor(owed);
        const auto steps = std::uint64_t(std::min(whole, double(most_)));
        if (!(double(steps) <= most_in_a_frame))
            refuse_value("FixedStep::advance", "frame_time", frame_time,
                         "a frame of so many steps would not end; it is at most " + describe(most_in_a_frame * dt_));
        for (std::uint64_t i = 0; i < steps; ++i) {
            if constexpr (takes_the_world) before_step(world);
            world.step(dt_); // a world that refuses dt does so here, before this clock has changed
        }
        left_ = owed - whole;
        if (whole > double(most_)) dropped_ += (whole - double(most_)) * dt_;
        return steps;
    }
    /// Seconds without their unit.
    template <class World_, class Number>
        requires(detail::Builtin<Number>)
    std::uint64_t advance(World_&, const Number&) {
        static_assert(
            detail::never<Number>,
            "Ansatz: FixedStep::advance takes the time of a frame; write e.g. advance(world, 0.016 * second)");
        return 0;
    }

private:
    static constexpr double most_in_a_frame = 1e9; // minutes of computing, at the least

    Quantity<unit::Time> dt_;
    Quantity<unit::Time> dropped_{};
    double left_ = 0; // in steps, below 1
    std::uint64_t most_ = 0;
};

} // namespace ansatz
