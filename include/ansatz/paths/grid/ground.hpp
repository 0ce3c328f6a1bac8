// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What it costs to walk on a grid: `Even` ground, where only steps count, and `Terrain`, where every tile has a
/// weight.
///
/// A step costs its length in tiles times the weight of the tile that it *enters*. So a weight is how many times slower
/// than usual its tile is (mud 3, road 0.5), and the way there may cost something else than the way back.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/cost.hpp>
#include <ansatz/paths/grid/cell.hpp>
#include <ansatz/units/describe.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace ansatz::paths {

/// What the cheapest steps cost.
template <class Cost> struct Steps {
    /// Over a side.
    Cost straight, diagonal; ///< over a corner
};

/// Every tile weighs 1, and no byte is kept.
struct Even {
    /// Nothing: no tile needs a byte.
    void resize(std::size_t) {}
    /// What a step costs in this number.
    template <class Cost> struct Weights {
        /// Onto any tile.
        [[gnu::always_inline]] Cost of(std::size_t, bool diagonal) const {
            if constexpr (std::is_integral_v<Cost>) // a product: g++ makes more instructions of a choice
                return Tile<Cost>::straight + Cost(diagonal) * (Tile<Cost>::diagonal - Tile<Cost>::straight);
            else return diagonal ? Tile<Cost>::diagonal : Tile<Cost>::straight;
        }
    };
    /// What steps cost in this number.
    template <class Cost> Weights<Cost> weights() const { return {}; }
    /// What the cheapest steps cost: what all do.
    template <class Cost> Steps<Cost> least_step() const { return {Tile<Cost>::straight, Tile<Cost>::diagonal}; }
    double weight(std::size_t) const { return 1; } ///< of a tile
    double least() const { return 1; }             ///< of all tiles
};

/// Every tile has a weight of its own, 1 to begin with.
///
/// What a search reads is apart from what it does not: whole-number steps in one array, weights in another.
class Terrain {
    struct Step {
        std::uint32_t straight = Tile<std::uint32_t>::straight, diagonal = Tile<std::uint32_t>::diagonal;
    };

public:
    static constexpr double heaviest = 60000; ///< so that a step of whole numbers stays far from the end of its number

    /// So many tiles, all of weight 1.
    void resize(std::size_t count) {
        steps_.assign(count, Step{});
        weights_.assign(count, 1.0);
        counts_.clear();
        counts_[1.0] = count;
    }
    /// What a step costs in this number.
    template <class Cost> struct Weights {
        using Kept = std::conditional_t<std::is_integral_v<Cost>, Step, double>; ///< what is read of a tile
        const Kept* kept;                                                        ///< of all tiles, by number
        /// Onto this tile.
        [[gnu::always_inline]] Cost of(std::size_t i, bool diagonal) const {
            if constexpr (std::is_integral_v<Cost>) return Cost(diagonal ? kept[i].diagonal : kept[i].straight);
            else return Cost(kept[i] * double(diagonal ? Tile<Cost>::diagonal : Tile<Cost>::straight));
        }
    };
    /// What steps cost in this number; holds while the grid does.
    template <class Cost> Weights<Cost> weights() const {
        if constexpr (std::is_integral_v<Cost>) return {steps_.data()};
        else return {weights_.data()};
    }
    /// A diagonal counts as no more than two straight steps: there is always that way round in an estimate.
    template <class Cost> Steps<Cost> least_step() const {
        if constexpr (std::is_integral_v<Cost>) {
            const Step at = of(least());
            return {Cost(at.straight), Cost(std::min(at.diagonal, 2 * at.straight))};
        } else return {Cost(least()), Cost(least() * double(Tile<Cost>::diagonal))};
    }
    double weight(std::size_t i) const { return weights_[i]; }                    ///< of a tile
    double least() const { return counts_.empty() ? 1 : counts_.begin()->first; } ///< of all tiles
    /// \throws std::invalid_argument, and changes nothing, for a weight that is negative, infinite, not a number or too
    ///         large for a whole-number cost
    void set(std::size_t i, double weight, const std::string& where, Cell cell) {
        if (!std::isfinite(weight) || weight < 0 || weight > heaviest)
            refuse_value(where, "the weight of " + name_of(cell), weight,
                         "it must be from 0 to 60000 (to block a tile, say set_passable(cell, false))");
        ++counts_[weight];
        const auto old = counts_.find(weights_[i]);
        if (--old->second == 0) counts_.erase(old);
        steps_[i] = of(weight), weights_[i] = weight;
    }

private:
    static Step of(double weight) {
        return {std::uint32_t(std::lround(weight * Tile<std::uint32_t>::straight)),
                std::uint32_t(std::lround(weight * Tile<std::uint32_t>::diagonal))};
    }
    std::vector<Step> steps_;
    std::vector<double> weights_;
    std::map<double, std::size_t> counts_; ///< how many tiles have each weight
};

} // namespace ansatz::paths
