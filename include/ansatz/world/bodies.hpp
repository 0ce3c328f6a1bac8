// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Bodies`: which body stands in which slot of the lanes, and which slots the step walks.
///
/// Slots are kept in four neighbouring ranges, awake | resting | moving | fixed, so that the step walks one dense range
/// and ten thousand resting bodies cost it nothing. A body's id never changes while it lives; its slot does. A handle
/// is an id with a generation, so that it survives the removal of other bodies and a stale one is known as stale.
/// Everything here is a value: a copy of a world answers to the same handles.

#include <ansatz/core/error.hpp>
#include <ansatz/units/describe.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ansatz {

/// Names a body, in the world that made it and in every copy of that world.
struct Handle {
    std::uint32_t id = 0xffffffffu; ///< counts up with each body; given again only with another generation
    std::uint32_t generation = 0;   ///< how often the id was given before
    friend bool operator==(const Handle&, const Handle&) = default; ///< whether they name one body
};

/// How a body takes part in the step.
enum class Motion : std::uint8_t {
    awake,   ///< forces and integrator act on it
    resting, ///< nothing is computed for it until something wakes it (notes 1.1, 1.8)
    moving,  ///< a platform: infinite mass, keeps the velocity it was given
    fixed    ///< infinite mass, no physics touches it (notes 1.1)
};

/// "fixed", "moving" or "resting".
inline const char* name_of(Motion m) {
    constexpr const char* names[] = {"awake", "resting", "moving", "fixed"};
    return names[std::size_t(m)];
}

namespace detail {
/// A handle that names nothing any more, or never did; of a body, or of a number of another kind. Numbers are
/// of one type, for which every program compiles `describe` once.
[[noreturn, gnu::cold, gnu::noinline]] inline void
refuse_handle(const char* what, std::uint32_t id, std::uint32_t generation, std::size_t given_out, const char* where) {
    const auto number = describe(std::size_t(id));
    if (id == Handle{}.id && generation == Handle{}.generation)
        refuse(Refusal::out_of_range, joined({where, ": the handle is empty; use one that World::add returned"}));
    if (id < given_out)
        refuse(Refusal::out_of_range,
               joined({where, ": the handle is stale: ", what, " ", number, " of generation ",
                       describe(std::size_t(generation)), " was removed; ask contains(handle) first"}));
    refuse(Refusal::out_of_range,
           joined({where, ": the handle names ", what, " ", number, ", but this world has given out only ",
                   describe(given_out), "; use a handle of this world or of the one it was copied from"}));
}
/// A component that a column does not have.
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse_component(std::string_view column, int component,
                                                                    std::size_t components) {
    refuse(Refusal::out_of_range, joined({"World::lane: component ", describe(component), " of ", column, ": it has ",
                                          describe(components), ", counted from 0"}));
}
/// A slot that no body has.
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse_slot(std::size_t slot, std::size_t bodies) {
    refuse(Refusal::out_of_range,
           joined({"World::body_at: slot ", describe(slot), ": there are ", describe(bodies), ", counted from 0"}));
}
} // namespace detail

/// The directory of a world's bodies. Slots are positions in the lanes; the owner of the lanes is told of every swap.
class Bodies {
public:
    /// A body's place in the lanes; it changes when other bodies are removed, sleep or wake.
    using Slot = std::uint32_t;

    /// All bodies.
    std::size_t size() const { return id_at_.size(); }
    /// First slot of a range, and the slot behind its last.
    std::size_t begin(Motion m) const { return m == Motion::awake ? 0 : end_[std::size_t(m) - 1]; }
    /// Behind the last slot of a kind.
    std::size_t end(Motion m) const { return end_[std::size_t(m)]; }
    /// How many there are of a kind.
    std::size_t count(Motion m) const { return end(m) - begin(m); }

    /// Whether the body of a slot may move in a step: it is awake, or a platform.
    [[gnu::always_inline]] bool goes(std::size_t slot) const {
        return slot < end(Motion::awake) || (slot >= begin(Motion::moving) && slot < end(Motion::moving));
    }
    /// Whether any body may be.
    bool any_goes() const { return count(Motion::awake) > 0 || count(Motion::moving) > 0; }

    /// Whether the handle names a body that is still there.
    bool contains(Handle h) const {
        return h.id < slot_of_.size() && generation_[h.id] == h.generation && slot_of_[h.id] != none;
    }

    /// \throws std::out_of_range for a handle whose body was removed, or that no body ever had
    Slot slot(Handle h, const char* where) const {
        if (contains(h)) return slot_of_[h.id];
        detail::refuse_handle("body", h.id, h.generation, ids(), where);
    }

    /// In which range a slot lies.
    Motion motion(std::size_t slot) const {
        std::size_t m = 0;
        while (slot >= end_[m]) ++m;
        return Motion(m);
    }
    /// The handle of the body in a slot.
    Handle handle(std::size_t slot) const { return {id_at_[slot], generation_[id_at_[slot]]}; }
    /// The ids of all bodies, by slot.
    const std::uint32_t* ids_by_slot() const { return id_at_.data(); }
    /// The id of the body in a slot.
    std::uint32_t id(std::size_t slot) const { return id_at_[slot]; }

    /// Ids ever given out; those whose body is gone answer `false` to `alive`.
    std::size_t ids() const { return slot_of_.size(); }
    /// Whether a body has this id.
    bool alive(std::uint32_t id) const { return slot_of_[id] != none; }
    /// Where the body with this id is.
    Slot slot_of_id(std::uint32_t id) const { return slot_of_[id]; }
    /// The generation that its handle must have.
    std::uint32_t generation_of_id(std::uint32_t id) const { return generation_[id]; }

    /// A number that changes where bodies come to other slots, and where a verb or a system changes one that stands: a
    /// cache of bodies that do not move need not visit them while it is the same. Zero only before the first body.
    std::uint64_t changes() const { return changes_; }
    /// The same for each `block` slots.
    const std::vector<std::uint32_t>& changes_by_block() const { return changes_by_block_; }
    static constexpr std::size_t block = 64; ///< slots that have one number
    /// The body of a slot has been put somewhere else.
    void note_change(std::size_t slot) {
        ++changes_;
        auto& changes = changes_by_block_[slot / block];
        if (++changes == 0) changes = 1;
    }

    /// Room for so many bodies, at once.
    [[gnu::cold]] void reserve(std::size_t n) {
        changes_by_block_.reserve(n / block + 1);
        id_at_.reserve(n);
        slot_of_.reserve(n);
        generation_.reserve(n);
        free_.reserve(n);
    }

    /// Room for every id to be given back, so that `erase` cannot fail; a copied vector has no more room than it needs.
    void reserve_notes() { free_.reserve(slot_of_.size()); }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const Bodies& other) {
        changes_by_block_.reserve(other.changes_by_block_.size());
        id_at_.reserve(other.id_at_.size());
        slot_of_.reserve(other.slot_of_.size());
        generation_.reserve(other.generation_.size());
        free_.reserve(other.free_.size());
    }

    /// The id that the next `push_back` gives out.
    std::uint32_t next_id() const { return free_.empty() ? std::uint32_t(slot_of_.size()) : free_.back(); }

    /// Adds to a hash which handles the next bodies will get; those of living bodies are the owner's to add.
    template <class Hash> void add_free_to(Hash& hash) const {
        hash.add(free_.size());
        for (const auto id : free_) {
            hash.add(id);
            hash.add(generation_[id]);
        }
    }

    /// How often a resting body has woken. What was kept for resting bodies is out of date where this has changed
    /// since.
    std::uint64_t woken() const { return woken_; }

    /// Adds a body in the last slot, as fixed; `move` then brings it where it belongs. With room for it, it cannot
    /// fail.
    Handle push_back() {
        std::uint32_t id;
        if (free_.empty()) {
            id = std::uint32_t(slot_of_.size());
            append(slot_of_, none);
            append(generation_, 0);
            if (free_.capacity() < slot_of_.size()) free_.reserve(slot_of_.capacity());
        } else {
            id = free_.back();
            free_.pop_back();
        }
        slot_of_[id] = Slot(id_at_.size());
        append(id_at_, id);
        if (changes_by_block_.size() * block < id_at_.size()) append(changes_by_block_, 0);
        note_change(id_at_.size() - 1);
        ++end_[3];
        return {id, generation_[id]};
    }

    /// Moves the body in `slot` to another range; calls `swap(i, j)` for each pair of slots to exchange.
    template <class Swap> Slot move(Slot slot, Motion to, Swap&& swap) {
        auto from = std::size_t(motion(slot));
        if (Motion(from) == Motion::resting && to == Motion::awake) ++woken_;
        for (; from < std::size_t(to); ++from) { // upwards: to the end of the range, then the border moves down over it
            exchange(slot, Slot(end_[from] - 1), swap);
            slot = Slot(--end_[from]);
        }
        for (; from > std::size_t(to); --from) { // downwards: to the beginning of the range, then the border moves up
            exchange(slot, Slot(end_[from - 1]), swap);
            slot = Slot(end_[from - 1]++);
        }
        return slot;
    }

    /// Removes the body in `slot`; its handle becomes stale. The last slot is free afterwards.
    template <class Swap> void erase(Slot slot, Swap&& swap) {
        slot = move(slot, Motion::fixed, swap);
        exchange(slot, Slot(size() - 1), swap);
        const auto id = id_at_.back();
        id_at_.pop_back();
        --end_[3];
        slot_of_[id] = none;
        ++generation_[id];
        append(free_, id);
    }

    /// The same bodies in the same slots, and the same handles to come.
    friend bool operator==(const Bodies& a, const Bodies& b) {
        if (a.ids() != b.ids() || a.free_ != b.free_ || a.generation_ != b.generation_) return false;
        for (std::uint32_t id = 0; id < a.ids(); ++id)
            if (a.alive(id) != b.alive(id) || (a.alive(id) && a.motion(a.slot_of_[id]) != b.motion(b.slot_of_[id])))
                return false;
        return true;
    }

private:
    friend struct Archive;
    static constexpr Slot none = 0xffffffffu;

    // Moved from, it is empty like the vectors beside it.
    struct Ends {
        std::array<std::size_t, 4> end{};
        Ends() = default;
        Ends(const Ends&) = default;
        Ends(Ends&& other) noexcept : end(std::exchange(other.end, {})) {}
        Ends& operator=(const Ends&) = default;
        Ends& operator=(Ends&& other) noexcept {
            end = std::exchange(other.end, {});
            return *this;
        }
        std::size_t& operator[](std::size_t i) { return end[i]; }
        const std::size_t& operator[](std::size_t i) const { return end[i]; }
    };

    /// One function for the four of them: what a vector does when it grows is most of what compiling `add` takes.
    [[gnu::noinline]] static void append(std::vector<std::uint32_t>& to, std::uint32_t value) { to.push_back(value); }

    template <class Swap> void exchange(Slot i, Slot j, Swap& swap) {
        note_change(i);
        if (i == j) return;
        note_change(j);
        swap(i, j);
        std::swap(id_at_[i], id_at_[j]);
        slot_of_[id_at_[i]] = i;
        slot_of_[id_at_[j]] = j;
    }

    std::vector<std::uint32_t> id_at_;      // by slot
    std::vector<Slot> slot_of_;             // by id
    std::vector<std::uint32_t> generation_; // by id
    std::vector<std::uint32_t> free_;       // ids to give out again, last freed first
    std::vector<std::uint32_t> changes_by_block_;
    std::uint64_t changes_ = 0;
    Ends end_; // of each range
    std::uint64_t woken_ = 0;
};

} // namespace ansatz
