// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `DividedSearch`: the pairs of a broadphase and the narrowphase of each, on the threads of an Execution (notes 2.1).
///
/// The pieces of a search, or the pairs of one that cannot be divided, are cut into the same number of shares on any
/// number of threads. Each share has a list of its own for the contacts that it finds; behind the search they are put
/// together in the order of the shares, which is the order of a serial search.

#include <ansatz/collision/broadphase/broadphase.hpp>
#include <ansatz/collision/broadphase/kept_pairs.hpp>
#include <ansatz/collision/contact.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

/// \tparam S      the space
/// \tparam Nearly whether pairs that nearly touch are noted, too
template <class S, bool Nearly> class DividedSearch {
public:
    /// What a share of the pairs comes to.
    struct alignas(64) Share {            // a line of the cache for each: they are written at the same time
        std::vector<Contact<S>> contacts; ///< of those that touch
        std::vector<Contact<S>> near;     ///< of those that nearly do
        std::size_t pairs = 0;            ///< how many there were
    };

    /// Adds the contacts of all pairs.
    /// \tparam Broadphase whose `In<S>` the finder is
    /// \param run   runs loops, `run(count, grain, loop)`
    /// \param test  a function of two indices of boxes and a Share, to which it adds their contact; called on several
    ///              threads
    /// \param found for those that touch
    /// \param near  for those that nearly do; null where none are noted
    template <class Broadphase>
    void find(const auto& run, auto& finder, const Boxes<S>& boxes, const auto& test, std::vector<Contact<S>>& found,
              std::vector<Contact<S>>* near) {
        if constexpr (DividedBroadphaseIn<Broadphase, S>) {
            finder.prepare(boxes, run);
            each_share(run, boxes.size(), finder.pieces(), [&](Share& share, std::size_t first, std::size_t last) {
                finder.find(boxes, first, last, [&](std::size_t i, std::size_t j) {
                    ++share.pairs;
                    test(i, j, share);
                });
            });
            if constexpr (requires { finder.finish(std::size_t()); }) {
                std::size_t pairs = 0;
                for (const Share& share : shares_) pairs += share.pairs;
                finder.finish(pairs);
            }
        } else {
            pairs_.clear();
            finder.find(boxes, [&](std::size_t i, std::size_t j) {
                detail::append(pairs_, detail::BoxPair{std::uint32_t(i), std::uint32_t(j)});
            });
            each_share(run, boxes.size(), pairs_.size(), [&](Share& share, std::size_t first, std::size_t last) {
                for (std::size_t p = first; p < last; ++p) test(pairs_[p].i, pairs_[p].j, share);
            });
        }
        join(&Share::contacts, found, room_);
        if constexpr (Nearly) join(&Share::near, *near, room_of_near_);
    }

private:
    static constexpr std::size_t shares = 64;  // more than most machines have cores; few enough to be put together
    static constexpr std::size_t fewest = 512; // bodies for which another thread is worth waking

    void each_share(const auto& run, std::size_t bodies, std::size_t count, const auto& search) {
        for (Share& share : shares_) {
            for (auto [list, room] : {std::pair(&share.contacts, room_), std::pair(&share.near, room_of_near_)})
                list->clear(), list->reserve(room);
            share.pairs = 0;
        }
        run(shares, bodies < fewest ? shares : 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) search(shares_[n], count * n / shares, count * (n + 1) / shares);
        });
    }
    /// \param room for a list of each share, the next time: contacts go from one share to another
    void join(std::vector<Contact<S>> Share::*list, std::vector<Contact<S>>& all, std::size_t& room) {
        std::size_t sum = 0, largest = 0;
        for (const Share& share : shares_) {
            sum += (share.*list).size();
            largest = std::max(largest, (share.*list).size());
        }
        detail::grow(all, all.size() + sum);
        for (const Share& share : shares_) all.insert(all.end(), (share.*list).begin(), (share.*list).end());
        if (largest > room) room = largest + largest / 4;
    }

    std::array<Share, shares> shares_;
    std::size_t room_ = 0, room_of_near_ = 0; // for contacts, in each share
    std::vector<detail::BoxPair> pairs_;
};

namespace detail {
/// In place of a search that is not divided.
struct NoDividedSearch {};
} // namespace detail

} // namespace ansatz
