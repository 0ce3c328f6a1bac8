// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SpringColours`: the springs of a network by colours: no two of a colour hold the same body, so that all of a colour
/// may be held at once.
///
/// Colours are given by id: each spring has the first that none of its bodies has yet. What they are depends on which
/// springs there are and in which order they were added, not on which bodies sleep or where they are stored. A grid
/// with the springs of its threads and both diagonals has 8 at each body and comes out with about a dozen colours.

#include <ansatz/core/compiler_flags.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ansatz {

/// Lanes of springs, colour by colour.
/// \tparam Scalar of the world
template <class Scalar> class SpringColours {
public:
    static constexpr std::size_t most = 64; ///< colours; a spring that finds none is in `others`

    std::vector<std::uint32_t> a;  ///< slots of the first ends
    std::vector<std::uint32_t> b;  ///< and of the second ones
    std::vector<Scalar> rest;      ///< m
    std::vector<Scalar> stiffness; ///< N/m
    std::vector<Scalar> damping;   ///< N s/m

    /// Colours the springs of a network, unless they are those that it has; in room that it has, once warm.
    /// \param bodies how many slots there are
    /// \param room   how many there may be another time
    void colour(const auto& network, std::size_t bodies, std::size_t room = 0) {
        const auto& pairs = network.pairs();
        // The lanes of what was moved from are gone, and where colours begin is not.
        if (network.arrangement() == made_of_ && begin_.back() == a.size() && a.size() == pairs.size()) return;
        taken_.reserve(room);
        taken_.assign(bodies, 0);
        which_.resize(pairs.size());
        begin_.fill(0);
        for (std::size_t n = 0; n < pairs.size(); ++n) {
            const std::uint64_t both = taken_[pairs[n].a] | taken_[pairs[n].b];
            const auto colour = std::size_t(std::countr_one(both));
            which_[n] = std::uint8_t(colour);
            ++begin_[colour + 1];
            if (colour == most) continue;
            taken_[pairs[n].a] |= std::uint64_t(1) << colour;
            taken_[pairs[n].b] |= std::uint64_t(1) << colour;
        }
        for (std::size_t c = 0; c <= most; ++c) begin_[c + 1] += begin_[c];
        for (auto* lane : {&rest, &stiffness, &damping}) lane->resize(pairs.size());
        for (auto* lane : {&a, &b}) lane->resize(pairs.size());
        auto next = begin_;
        for (std::size_t n = 0; n < pairs.size(); ++n) put(next[which_[n]]++, pairs[n]);
        made_of_ = network.arrangement();
    }
    /// How many springs there are.
    std::size_t size() const { return a.size(); }
    /// How many colours.
    std::size_t colours() const {
        std::size_t count = 0;
        while (count < most && begin_[count + 1] > begin_[count]) ++count;
        return count;
    }
    /// Where those of a colour begin; of colour `most`, those that have none.
    std::size_t begin(std::size_t colour) const { return begin_[colour]; }
    /// And end.
    std::size_t end(std::size_t colour) const { return begin_[colour + 1]; }

private:
    template <class Link> void put(std::size_t at, const Link& link) {
        a[at] = link.a;
        b[at] = link.b;
        rest[at] = link.rest_length;
        stiffness[at] = link.stiffness;
        if constexpr (requires { Scalar(link.damping); }) damping[at] = link.damping;
        else damping[at] = Scalar(0);
    }

    std::array<std::size_t, most + 2> begin_{}; // of each colour, and of what has none
    std::uint64_t made_of_ = std::numeric_limits<std::uint64_t>::max();
    std::vector<std::uint64_t> taken_; // by slot: a bit for each colour
    std::vector<std::uint8_t> which_;  // by spring
};

} // namespace ansatz
