// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Events: what happened in a world, in a buffer that you poll after a step. There are no callbacks, because code that
/// runs in the middle of a step could change what the step is working on.

#include <ansatz/world/bodies.hpp>

#include <span>
#include <vector>

namespace ansatz {

/// A body fell asleep, or woke.
struct Event {
    /// What can happen.
    enum class Kind : std::uint8_t { slept, woke };
    Kind kind;                                                    ///< what happened
    Handle body;                                                  ///< of which body
    friend bool operator==(const Event&, const Event&) = default; ///< the same thing to the same body
};

/// The events of the last step, and of what was done to the world between the step before and it.
class Events {
public:
    /// Those of the last step, and of calls since.
    std::span<const Event> now() const { return now_; }

    /// Between two steps a body can wake once; within a step it can wake and fall asleep. Those that were removed since
    /// have left their events.
    void reserve(std::size_t bodies) {
        now_.reserve(3 * bodies);
        next_.reserve(3 * bodies);
        if (next_.capacity() - next_.size() < bodies) next_.reserve(2 * next_.capacity());
    }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const Events& other) {
        now_.reserve(other.now_.size());
        next_.reserve(other.next_.size());
    }
    /// Between steps: shown together with those of the next step.
    void between_steps(Event e) { next_.push_back(e); }
    /// Forgets what the last step brought.
    void begin_step() {
        now_.swap(next_);
        next_.clear();
    }
    /// Notes an event of this step.
    void in_step(Event e) { now_.push_back(e); }

private:
    std::vector<Event> now_;
    std::vector<Event> next_;
};

} // namespace ansatz
