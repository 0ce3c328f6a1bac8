// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The events that are raised while a machine is busy: in an action, in a state's `enter`. They wait until the
/// transition is complete, and are handled in order before `handle` or `update` returns; so a transition never begins
/// inside another. The queue has a fixed size and takes no memory from the heap; an event too many is dropped and
/// counted.

#include <ansatz/states/ids.hpp>

#include <array>

namespace ansatz {

namespace states {
struct MachineArchive; // save.hpp
}

/// Where actions raise events: `[](Npc& npc, EventQueue& events) { events.raise(event<GuardNpc>("shot")); }`.
class EventQueue {
public:
    static constexpr std::size_t capacity = 16; ///< events that can wait

    /// Handled when the present transition is complete. EventId::none, and one too many, is dropped.
    /// \return whether there was room
    constexpr bool raise(EventId event) {
        if (event == EventId::none) return false;
        if (size_ == capacity) {
            ++dropped_;
            return false;
        }
        waiting_[(first_ + size_++) % capacity] = event;
        return true;
    }
    /// Takes the oldest out.
    constexpr EventId take() {
        if (size_ == 0) return EventId::none;
        const EventId event = waiting_[first_];
        first_ = std::uint8_t((first_ + 1) % capacity);
        --size_;
        return event;
    }
    constexpr bool empty() const { return size_ == 0; }          ///< nothing waits
    constexpr std::size_t size() const { return size_; }         ///< how many wait
    constexpr std::uint32_t dropped() const { return dropped_; } ///< events for which there was no room

    /// The same memory: what waits, what was taken before, how many were dropped.
    friend constexpr bool operator==(const EventQueue&, const EventQueue&) = default;

private:
    friend struct states::MachineArchive;
    std::array<EventId, capacity> waiting_{};
    std::uint8_t first_ = 0, size_ = 0;
    std::uint32_t dropped_ = 0;
};

} // namespace ansatz
