// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `JumpPoints`: a node's successors on a grid are the next tiles at which a shortest way may turn.
///
/// On even ground most shortest ways between two tiles are the same steps in another order. Of each such family this
/// policy follows one: diagonal steps first. It runs along a row, a column or a diagonal without opening a node, until
/// it stands at the goal or where a wall makes another direction necessary. The costs are those of `EveryEdge`.
///
/// Where the goal is near and the map is large it does not run to the ends of the map for each step: as near to the
/// goal as the start is, it goes from tile to tile and keeps to the one order alone; farther out it stops, and opens a
/// node, at twice that distance, four times, and so on.
///
/// Take it for large open maps with `Heap` or `Buckets`: the open list is what it spares. Not for `Terrain` (two orders
/// of the same steps no longer cost the same), nor for maps with blocked edges, and not to watch the notes' workflow:
/// the lists hold turning points only, and nothing is `skipped`.
///
/// D. Harabor and A. Grastien, Online Graph Pruning for Pathfinding on Grid Maps (AAAI 2011), for the idea and the
/// proof; Improving Jump Point Search (ICAPS 2014) for the rules where corners are not cut.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/grid/cell.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/grid/grid.hpp>
#include <ansatz/paths/successors.hpp>

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>

namespace ansatz::paths {

namespace detail {

/// The direction from one tile to another in its row, column or diagonal; -1 from a tile to itself.
constexpr int direction_towards(Cell from, Cell to) {
    constexpr std::int8_t of[] = {6, 3, 7, 2, -1, 0, 5, 1, 4}; // row by row of the nine tiles
    return of[3 * ((to.y > from.y) - (to.y < from.y)) + (to.x > from.x) - (to.x < from.x) + 4];
}
/// Of the directions 0 to 3: the one to the right of d, and the diagonal between the two.
constexpr unsigned right_of(unsigned d) { return (d + 1) & 3; }
constexpr unsigned left_of(unsigned d) { return (d + 3) & 3; }
constexpr unsigned diagonal_right_of(unsigned d) { return 4 + d; }
constexpr unsigned diagonal_left_of(unsigned d) { return 4 + left_of(d); }

/// Which directions a shortest way may go on in, by the open directions of the tiles around.
/// \tparam Cuts whether the corner rule lets a step pass a blocked tile
template <bool Cuts> struct Pruning {
    static constexpr bool has(unsigned open, unsigned d) { return (open >> d & 1) != 0; }

    /// The directions that only a wall makes necessary, for a walk that came by a step to direction d.
    /// \param before the open directions of the tile it came from
    /// \param open   those of the tile it is on
    static constexpr unsigned forced(unsigned before, unsigned open, unsigned d) {
        unsigned turns = 0;
        if (d < 4) {
            aside(before, open, right_of(d), diagonal_right_of(d), turns);
            aside(before, open, left_of(d), diagonal_left_of(d), turns);
        } else if constexpr (Cuts) { // between two free tiles nothing is hidden from a diagonal
            const unsigned a = d - 4, b = right_of(a);
            behind(open, left_of(a), diagonal_left_of(a), turns);
            behind(open, right_of(b), diagonal_right_of(b), turns);
        }
        return turns & open;
    }
    /// Those that he would go on in on open ground.
    static constexpr unsigned natural(unsigned d) {
        return d < 4 ? 1u << d : 1u << d | 1u << (d - 4) | 1u << right_of(d - 4);
    }

private:
    /// A row beside the way.
    static constexpr void aside(unsigned before, unsigned open, unsigned side, unsigned ahead, unsigned& turns) {
        if constexpr (Cuts) { // past the corner of a wall: the tile beside him is blocked, the next one is not
            if (!has(open, side)) turns |= 1u << ahead;
        } else if (!has(before, side) && has(open, side)) // a wall has ended
            turns |= 1u << side | 1u << ahead;
    }
    /// A tile that he passed at a corner.
    static constexpr void behind(unsigned open, unsigned side, unsigned ahead, unsigned& turns) {
        if (!has(open, side)) turns |= 1u << ahead;
    }
};

/// Squares around a goal whose half sides are powers of 2. In the smallest nobody runs; outside, a run ends at the
/// border of the next, where a node is opened though nothing turns. Any node may be opened without a change of the
/// costs.
struct Surroundings {
    static constexpr std::size_t without_end = ~std::size_t(0);
    Cell goal{};
    int least = -1; ///< the power of 2 of the smallest square; -1: there are none

    /// None unless the start is much nearer than the map is wide.
    template <class Map> static Surroundings around(const Map& map, Cell start, Cell goal) {
        const Apart apart(start, goal);
        const auto power = int(std::bit_width(std::max({apart.dx, apart.dy, 7u}))); // the start is in it
        return {goal, std::size_t(4) << power <= std::max(map.width(), map.height()) ? power : -1};
    }
    /// Whether a tile is in the smallest.
    bool holds(Cell c) const {
        const Apart apart(c, goal);
        return least >= 0 && (apart.dx | apart.dy) >> least == 0;
    }
    /// So many steps in this direction to the next border.
    std::size_t steps(Cell at, unsigned d) const {
        if (least < 0) return without_end;
        const std::size_t by_x = along(int(column(at)) - int(column(goal)), direction_x[d]);
        return std::min(by_x, along(int(row(at)) - int(row(goal)), direction_y[d]));
    }

private:
    std::size_t along(int from_goal, int direction) const {
        if (direction == 0) return without_end;
        const int outwards = direction * from_goal; // negative where it comes nearer
        const int power = least + (outwards < 0 ? 0 : int(std::bit_width(unsigned(outwards) >> least)));
        return std::size_t((1 << power) - outwards);
    }
};

/// Runs over one grid from tile to tile.
template <class Map, class Reaches> class Jumps {
    static constexpr bool cuts = Map::neighbours::diagonal(true, false);
    using Rules = Pruning<cuts>;

public:
    Jumps(const Map& map, const Reaches& reaches, const Surroundings& surroundings)
        : open_(map.open_directions()), offsets_(map.index_offsets()), reaches_(reaches), surroundings_(surroundings) {}

    /// How many steps it is to the next tile to stop at; 0 if there is none.
    std::size_t steps(Cell from, std::size_t index, unsigned d) const {
        return d < 4 ? straight(from, index, d) : diagonal(from, index, d);
    }

private:
    std::size_t straight(Cell at, std::size_t index, unsigned d) const {
        const std::size_t most = surroundings_.steps(at, d);
        for (std::size_t n = 1;; ++n) {
            const unsigned before = open_[index];
            if (!Rules::has(before, d)) return 0;
            index += std::size_t(offsets_[d]);
            at = step(at, d);
            if (Rules::forced(before, open_[index], d) != 0 || reaches_(at) || n == most) return n;
        }
    }
    std::size_t diagonal(Cell at, std::size_t index, unsigned d) const {
        const std::size_t most = surroundings_.steps(at, d);
        for (std::size_t n = 1;; ++n) {
            const unsigned before = open_[index];
            if (!Rules::has(before, d)) return 0;
            index += std::size_t(offsets_[d]);
            at = step(at, d);
            if (Rules::forced(before, open_[index], d) != 0 || reaches_(at) || n == most) return n;
            if (straight(at, index, d - 4) != 0 || straight(at, index, right_of(d - 4)) != 0) return n;
        }
    }

    const std::uint8_t* open_;
    const std::int32_t* offsets_;
    const Reaches& reaches_;
    Surroundings surroundings_;
};

template <class Graph> inline constexpr bool is_even_eight_grid = false;
template <class Corners> inline constexpr bool is_even_eight_grid<Grid<Eight<Corners>, Even>> = true;

} // namespace detail

/// The next tiles at which a shortest way may turn: `AStar{map, JumpPoints{}}`.
struct JumpPoints {
    using role = roles::Successors;

    /// Calls `use(q, edge, n)` for each tile to jump to from p, n steps away.
    /// \param reaches stops it; if it has a `start` and a `goal`, both tiles, so do the goal's surroundings
    template <class Map, class Reaches, class Use>
        requires detail::is_even_eight_grid<Map>
    static void each(const Map& map, Cell p, Cell parent, const Reaches& reaches, Use&& use) {
        const std::size_t index = map.index(p);
        const std::uint8_t* const open = map.open_directions();
        unsigned directions = open[index];
        if (const int d = detail::direction_towards(parent, p); d >= 0) {
            using Rules = detail::Pruning<Map::neighbours::diagonal(true, false)>;
            const unsigned before = open[index - std::size_t(map.index_offsets()[d])];
            directions &= Rules::natural(unsigned(d)) | Rules::forced(before, open[index], unsigned(d));
        }
        detail::Surroundings surroundings;
        if constexpr (requires {
                          { reaches.goal } -> std::convertible_to<Cell>;
                      })
            surroundings = detail::Surroundings::around(map, reaches.start, reaches.goal);
        const bool near = surroundings.holds(p);
        const detail::Jumps<Map, Reaches> jumps(map, reaches, surroundings);
        for (; directions != 0; directions &= directions - 1) {
            const auto d = unsigned(std::countr_zero(directions));
            const std::size_t n = near ? 1 : jumps.steps(p, index, d);
            if (n == 0) continue;
            const std::int64_t to = std::int64_t(index) + std::int64_t(n) * map.index_offsets()[d];
            const Cell q{std::uint16_t(p.x + int(n) * detail::direction_x[d]),
                         std::uint16_t(p.y + int(n) * detail::direction_y[d])};
            use(q, GridEdge{p, q, d >= 4, std::uint32_t(to)}, n);
        }
    }
    /// Calls `use(tile)` for the tiles between p and q, from q to p.
    template <class Use> static void between(Cell p, Cell q, Use&& use) {
        const int d = detail::direction_towards(q, p);
        if (d < 0) return;
        for (Cell at = detail::step(q, unsigned(d)); at != p; at = detail::step(at, unsigned(d))) use(at);
    }
    /// \throws std::invalid_argument for a map with blocked edges
    template <class Map> static void require(const Map& map) {
        if (map.blocked_edges() != 0)
            refuse_value("AStar", "the number of blocked edges", std::to_string(map.blocked_edges()),
                         "JumpPoints see blocked tiles only, so that it must be 0; leave JumpPoints out");
    }
};

} // namespace ansatz::paths
