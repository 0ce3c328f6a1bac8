// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ContactGroups`: which contacts of a step are solved by one thread, and which by others at the same time, for
/// `SoftSubsteps<Coloured>`. Beyond the notes.
///
/// Bodies are divided by their ids into blocks of 1024 or more. The contacts within a block are a group, and so are
/// those between two blocks. Groups that have no block in common push different bodies: they are one *stage*, whose
/// groups may be solved in any order or at the same time, to the same bits. The groups within blocks are the first
/// stage; those between blocks get the first stage that neither of their blocks has yet. All this follows from ids and
/// contacts alone, so that a world has the same groups on any number of threads.
///
/// Bodies that lie beside each other and were added one after the other share a block: few stages, with most contacts
/// in the first. Where ids say nothing about places there are as many stages as blocks, or up to twice as
/// many. Up to 1024 ids there is one group.
///
/// Domain decomposition with coloured interfaces: Y. Saad, Iterative Methods for Sparse Linear Systems (2003), 12.4 and
/// 14.3.

#include <ansatz/collision/contact.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

/// Contacts by their numbers, group by group.
class ContactGroups {
public:
    static constexpr std::size_t fewest = 1024; ///< ids in a block, but for the last
    static constexpr std::size_t most = 32;     ///< blocks: their groups fit into 62 stages

    /// A part of a list.
    struct Range {
        std::uint32_t begin = 0;                           ///< where it begins
        std::uint32_t end = 0;                             ///< behind its last one
        std::uint32_t size() const { return end - begin; } ///< how many
    };

    /// Divides contacts. Within a group they stay in their order.
    /// \param count how many there are
    /// \param ids   one more than the largest id of a body
    /// \param moved a function of a contact's number: the ids of the bodies that it may push, a pair with the smaller
    ///              one first, or of the same id where it is one; asked for several at the same time if `run` does
    /// \param run   runs a loop, `run(count, grain, loop)`
    void divide(std::size_t count, std::size_t ids, const auto& moved, const auto& run) {
        groups_.clear();
        stages_.clear();
        order_.clear();
        if (count == 0) return;
        if (ids <= fewest) {
            groups_.push_back({0, std::uint32_t(count)});
            stages_.push_back({0, 1});
            return;
        }
        int shift = std::countr_zero(fewest); // from an id to its block
        while (most << shift < ids) ++shift;
        const std::size_t blocks = ((ids - 1) >> shift) + 1;
        sizes_.assign(blocks * blocks, 0);
        group_of_.resize(count);
        run(count, worth_a_thread, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                const auto [a, b] = moved(n);
                group_of_[n] = std::uint16_t((a >> shift) * blocks + (b >> shift));
            }
        });
        for (const auto group : group_of_) ++sizes_[group];
        find_stages(blocks);
        detail::grow(order_, count); // by a share: behind `clear`, `resize` takes just what it needs
        order_.resize(count);
        for (std::size_t n = 0; n < count; ++n) order_[sizes_[group_of_[n]]++] = std::uint32_t(n);
    }
    /// How many groups there are.
    std::size_t size() const { return groups_.size(); }
    /// The places of the contacts of one.
    Range operator[](std::size_t group) const { return groups_[group]; }
    /// The groups of each stage, in the order in which they are solved.
    const std::vector<Range>& stages() const { return stages_; }
    /// The numbers of the contacts by their places; null where each stands in the place of its number.
    const std::uint32_t* order() const { return order_.empty() ? nullptr : order_.data(); }

    /// Calls `f(group)` for all groups, those of a stage at the same time if `run` does.
    /// \param run runs a loop, as in `divide`
    void each(const auto& run, const auto& f) const {
        for (const Range stage : stages_) {
            const std::size_t contacts = groups_[stage.end - 1].end - groups_[stage.begin].begin;
            const std::size_t grain = (worth_a_thread * stage.size() + contacts - 1) / contacts;
            run(stage.size(), grain, [&](std::size_t begin, std::size_t end) {
                for (std::size_t n = begin; n < end; ++n) f(stage.begin + n);
            });
        }
    }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const ContactGroups& other) {
        const auto make = [](auto& list, const auto& as) { list.reserve(as.size()); };
        make(groups_, other.groups_);
        make(stages_, other.stages_);
        make(order_, other.order_);
        make(group_of_, other.group_of_);
        make(sizes_, other.sizes_);
        make(found_, other.found_);
    }

private:
    static constexpr std::size_t worth_a_thread = 512; // contacts: a pass over fewer takes less time than waking one

    /// From how many contacts each group has, by its blocks: the groups, stage by stage. Then `sizes_` are the places
    /// of their first contacts.
    void find_stages(std::size_t blocks) {
        std::array<std::uint64_t, most> taken{}; // by block: a bit for each stage
        found_.clear();
        for (std::size_t apart = 0; apart < blocks; ++apart) // neighbours first: they have the most contacts
            for (std::size_t p = 0, q = apart; q < blocks; ++p, ++q) {
                if (sizes_[p * blocks + q] == 0) continue;
                const int stage = apart == 0 ? 0 : std::countr_one(taken[p] | taken[q] | 1u);
                taken[p] |= std::uint64_t(1) << stage;
                taken[q] |= std::uint64_t(1) << stage;
                found_.push_back(std::uint32_t(stage) << 16 | std::uint32_t(p * blocks + q));
            }
        std::sort(found_.begin(), found_.end());
        std::uint32_t begin = 0, stage_before = 0xffff;
        for (const std::uint32_t one : found_) {
            auto& size = sizes_[one & 0xffff];
            groups_.push_back({begin, begin + size});
            begin += std::exchange(size, begin);
            const auto n = std::uint32_t(groups_.size());
            if (std::exchange(stage_before, one >> 16) != one >> 16) stages_.push_back({n - 1, n});
            else stages_.back().end = n;
        }
    }

    std::vector<Range> groups_, stages_;
    std::vector<std::uint32_t> order_;    // contacts, group by group; empty where there is one group
    std::vector<std::uint16_t> group_of_; // by contact
    std::vector<std::uint32_t> sizes_;    // by the blocks of a group
    std::vector<std::uint32_t> found_;    // the stage of a group, and its blocks
};

} // namespace ansatz
