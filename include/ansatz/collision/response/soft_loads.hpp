// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SoftLoads`: impulses of `SoftSubsteps` that remember a load which has gone, or become light. Beyond the notes.
///
/// Warm start begins a step with the impulses of the one before: what lies still is held from the first pass on. Where
/// a heavy body has been taken from a column, or gravity has been switched off, they hold up something that is not
/// there, and the few passes of a step would not find out before the rest had been thrown into the air.
///
/// What lies still tells: all that its contacts do to it, friction included, is equal and opposite to what acceleration
/// does,
/// \f$ \sum_c w J_c = -a h \f$. A body that is pushed by some times as much is no memory of lying still. What pushes it
/// is made as small as what is pushed against: gravity, and what is upon it now. That is a smaller load for those
/// below, so it is done again, layer by layer.

#include <ansatz/collision/contact.hpp>
#include <ansatz/world/bodies.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

/// What is kept here lives within a step.
template <class S> class SoftLoads {
public:
    using Scalar = typename S::Scalar;
    using Raw = Vector<Scalar, S::dimension>; ///< raw SI

    /// Takes off what is too much after the warm start. In `pushed` is then, by slot of those that are awake, what
    /// impulses do to a body together.
    /// \param before by slot: the velocities before the warm start, m/s
    /// \return whether there was anything: then velocities are those before, and a warm start is due with what is left
    bool take_off(auto& contacts, const std::vector<Raw>& before) {
        auto& bodies = contacts.bodies;
        auto& nets = contacts.pushed;
        nets.resize(bodies.size());
        suspects_.clear();
        suspects_.reserve(contacts.awake());
        for (std::size_t slot = 0; slot < contacts.awake(); ++slot) {
            nets[slot] = bodies[slot].weight > Scalar(0) ? Raw(bodies[slot].u - before[slot]) : Raw::Zero();
            if (is_overpushed(contacts, slot)) suspects_.push_back(std::uint32_t(slot));
        }
        if (suspects_.empty()) return false;
        begin(contacts);
        bool less = false;
        for (int round = 0; round < most_rounds && find_overpushed(contacts) && lessen(contacts); ++round) less = true;
        if (!less) return false;
        for (std::size_t slot = 0; slot < contacts.awake(); ++slot)
            if (bodies[slot].weight > Scalar(0)) bodies[slot].u = before[slot];
        return true;
    }
    /// Room for so many bodies.
    void reserve(std::size_t n) {
        known_.reserve(n);
        suspects_.reserve(n);
        found_.reserve(n);
        first_.reserve(n + 1);
    }
    /// Room for so many contacts.
    void reserve_contacts(std::size_t n) {
        of_body_.reserve(2 * n);
        marked_.reserve(n / 64 + 1);
    }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const SoftLoads& other) {
        const auto make = [](auto& list, const auto& as) { list.reserve(as.size()); };
        make(known_, other.known_);
        make(suspects_, other.suspects_);
        make(found_, other.found_);
        make(first_, other.first_);
        make(of_body_, other.of_body_);
        make(marked_, other.marked_);
    }

private:
    static constexpr int most_rounds = 64; // a layer of a pile in each
    static constexpr int times = 4;        // bodies that fall about are pushed by a few times what acceleration does

    /// A body that its impulses push too much.
    struct Overpushed {
        std::uint32_t slot;
        bool is_suspect = false; // its pushes have changed since
        Raw towards;             // a unit vector: where they push it together
        Scalar keep{1};          // the share of what pushes it there that is right
    };
    /// What is known of a body: its place among those that are overpushed, or one of these.
    static constexpr std::uint32_t nothing = 0xffffffffu, suspect = nothing - 1;

    bool is_overpushed(const auto& contacts, std::size_t slot) const {
        return contacts.pushed[slot].squaredNorm() > Scalar(times * times) * contacts.kicks[slot].squaredNorm();
    }
    /// Which contacts act on each body, in their order: of a pile only those of a few bodies are looked at.
    void begin(auto& contacts) {
        const std::size_t awake = contacts.awake();
        known_.assign(awake, nothing);
        for (const auto slot : suspects_) known_[slot] = suspect;
        found_.clear();
        first_.assign(awake + 1, 0);
        contacts.each_acting([&](const auto& c) {
            for (const auto slot : {c.slot_a, c.slot_b})
                if (slot < awake) ++first_[slot];
        });
        std::uint32_t count = 0;
        for (auto& first : first_) first = count += first; // where those of a body end
        of_body_.resize(count);
        for (auto n = std::uint32_t(contacts.acting()); n-- > 0;) {
            const auto& c = contacts.nth_acting(n);
            for (const auto slot : {c.slot_a, c.slot_b})
                if (slot < awake) of_body_[--first_[slot]] = n;
        }
        marked_.assign(contacts.acting() / 64 + 1, 0);
    }
    /// Of those whose pushes have changed, and of those found before: into `found_`.
    bool find_overpushed(const auto& contacts) {
        for (const auto& over : found_)
            if (!over.is_suspect) suspects_.push_back(over.slot);
        found_.clear();
        for (const auto slot : suspects_) {
            known_[slot] = nothing;
            if (!is_overpushed(contacts, slot)) continue;
            const Raw& net = contacts.pushed[slot];
            known_[slot] = std::uint32_t(found_.size());
            detail::append(found_, Overpushed{slot, false, net / sqrt(net.squaredNorm())});
        }
        suspects_.clear();
        return !found_.empty();
    }
    /// \return whether there was anything to take
    bool lessen(auto& contacts) {
        for (auto& over : found_) weigh(contacts, over);
        bool any = false;
        each_marked([&](std::uint32_t n) { any = lessen_one(contacts, contacts.nth_acting(n)) || any; });
        return any;
    }
    /// What pushes a body, and how much of that is right. Its contacts are marked.
    void weigh(const auto& contacts, Overpushed& over) {
        const auto slot = over.slot;
        Scalar by(0), against(0); // along that, m/s; the second is negative
        for (auto at = first_[slot]; at < first_[slot + 1]; ++at) {
            const auto n = of_body_[at];
            marked_[n / 64] |= std::uint64_t(1) << n % 64;
            const auto& c = contacts.nth_acting(n);
            const Scalar weight = contacts.bodies[slot].weight;
            const Raw impulse = contacts.whole(c);
            const Scalar along = dot(Raw(c.slot_a == slot ? weight * impulse : -weight * impulse), over.towards);
            (along > Scalar(0) ? by : against) += along;
        }
        const Scalar needed = std::max(-dot(over.towards, contacts.kicks[slot]), Scalar(0)) - against;
        if (by - needed > Scalar(1e-5) * by) over.keep = needed / by;
    }
    bool lessen_one(auto& contacts, auto& c) {
        const Raw impulse = contacts.whole(c);
        Scalar keep(1);
        const auto ask = [&](std::uint32_t slot, const Scalar& sign) {
            if (slot >= known_.size() || known_[slot] >= found_.size()) return;
            const auto& over = found_[known_[slot]];
            if (dot(over.towards, impulse) * sign > Scalar(0)) keep = std::min(keep, over.keep);
        };
        ask(c.slot_a, Scalar(1));
        ask(c.slot_b, Scalar(-1));
        if (!(keep < Scalar(1)) || !(c.impulse > Scalar(0))) return false;
        const Raw less = (keep - 1) * impulse;
        for (const auto slot : {c.slot_a, c.slot_b}) {
            const Scalar weight = contacts.bodies[slot].weight;
            if (!(weight > Scalar(0))) continue;
            if (slot == c.slot_a) contacts.pushed[slot] += weight * less;
            else contacts.pushed[slot] -= weight * less;
            if (auto& was = known_[slot]; was < found_.size() ? std::exchange(found_[was].is_suspect, true)
                                                              : std::exchange(was, suspect) == suspect)
                continue;
            suspects_.push_back(slot);
        }
        c.impulse *= keep;
        if constexpr (std::remove_cvref_t<decltype(contacts)>::rubs) c.rubbing *= keep;
        return true;
    }
    /// In the order of the contacts, and takes the marks away.
    void each_marked(const auto& f) {
        for (std::uint32_t word = 0; word < marked_.size(); ++word)
            for (auto& bits = marked_[word]; bits != 0; bits &= bits - 1)
                f(word * 64 + std::uint32_t(std::countr_zero(bits)));
    }

    std::vector<std::uint32_t> known_;    // by slot of those that are awake
    std::vector<std::uint32_t> suspects_; // slots that may be overpushed, each once
    std::vector<Overpushed> found_;       // those that are
    std::vector<std::uint32_t> first_;    // by slot: where those of a body begin in `of_body_`
    std::vector<std::uint32_t> of_body_;  // which of the acting contacts
    std::vector<std::uint64_t> marked_;   // a bit for each acting contact
};

} // namespace ansatz
