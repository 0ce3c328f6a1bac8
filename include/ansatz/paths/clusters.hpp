// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Clusters`: a grid cut into squares, and the few tiles by which one gets from square to square, as a graph: what
/// `GateSearch` searches (HPA*, Botea, Mueller and Schaeffer 2004; notes 6.3: the cost of a search grows with the
/// nodes that it expands).
///
/// Where two squares touch, tiles that are free on both sides make up an entrance. Of every entrance some pairs of
/// tiles are gates. Between the gates of one square the cheapest ways inside of it are kept: what they cost, and for
/// every tile of the square the next step to each gate. Ways that lead through another gate anyway are left out.
///
/// There is a path from gate to gate where there is one on the grid, whatever its rule of corners, its ground and its
/// blocked edges. `update` finds which squares are not as they were, and makes those again and no others; of their
/// neighbours only those whose gates change with them.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/cost.hpp>
#include <ansatz/paths/grid/grid.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz::paths {

/// From a gate to another, inside of a square or across its border.
struct GateEdge {
    Cell to;                                                            ///< a gate
    std::uint32_t cost = 0;                                             ///< as a search of the grid counts it
    friend bool operator==(const GateEdge&, const GateEdge&) = default; ///< whether they are the same
};

/// \tparam Map a Grid
template <class Map> class Clusters {
public:
    using default_cost = std::uint32_t;                        ///< as on a grid
    using default_heuristic = typename Map::default_heuristic; ///< as on the grid
    using Cost = std::uint32_t;                                ///< as on a grid
    static constexpr std::uint8_t no_step = 255;               ///< where there is no way
    static constexpr Cost no_way = detail::infinite<Cost>;     ///< where there is no way

    /// \param map  read, never copied: it must live as long as this
    /// \param side of a square, in tiles
    /// \throws std::invalid_argument for a side that is not from 4 to 64
    explicit Clusters(const Map& map, std::size_t side = 32) : map_(&map), side_(side) {
        if (side < 4 || side > 64)
            refuse_value("Clusters", "side", std::to_string(side), "it must be from 4 to 64 tiles");
        across_ = (map.width() + side - 1) / side, down_ = (map.height() + side - 1) / side;
        squares_.resize(across_ * down_);
        number_.assign(map.size(), none);
        update();
    }
    explicit Clusters(const Map&&, std::size_t = 32) = delete; // a map that is gone after this line

    /// Makes those squares again that are not as they were. \return how many
    std::size_t update() {
        if (made_ && version_ == map_->version()) return 0;
        std::vector<std::uint8_t> changed(squares_.size()), near(squares_.size());
        for (std::size_t s = 0; s < squares_.size(); ++s) {
            if (!look(s)) continue;
            changed[s] = 1;
            for_each_around(s, [&](std::size_t t) { near[t] = 1; });
        }
        for (std::size_t s = 0; s < squares_.size(); ++s) // all gates before all ways
            if (near[s] && find_gates(s)) changed[s] = 1;
        std::size_t count = 0;
        for (std::size_t s = 0; s < squares_.size(); ++s)
            if (changed[s]) make(s), ++count;
        for (std::size_t s = 0; s < squares_.size(); ++s)
            if (near[s] || changed[s]) join(s);
        made_ = true;
        version_ = map_->version();
        return count;
    }
    /// Whether the map is as it was when it was read.
    bool is_current() const { return version_ == map_->version(); }
    const Map& map() const { return *map_; }                ///< what it is made of
    std::size_t side() const { return side_; }              ///< of a square, in tiles
    std::size_t squares() const { return squares_.size(); } ///< how many
    /// How many gates there are.
    std::size_t gates() const {
        std::size_t sum = 0;
        for (const Square& s : squares_) sum += s.gates.size();
        return sum;
    }
    /// How many edges between them.
    std::size_t edges() const {
        std::size_t sum = 0;
        for (const Square& s : squares_) sum += s.edges.size();
        return sum;
    }
    /// The least that a step costs: what Octile and Manhattan ask for.
    template <class Number> Steps<Number> least_step() const { return map_->template least_step<Number>(); }

    std::size_t square_of(Cell c) const { return c.y / side_ * across_ + c.x / side_; } ///< the square of a tile
    bool is_gate(Cell c) const { return number_[map_->index(c)] != none; }              ///< whether a tile is a gate
    const std::vector<Cell>& gates_of(std::size_t square) const { return squares_[square].gates; } ///< row by row
    /// The edges that lead away from a gate.
    std::pair<const GateEdge*, const GateEdge*> edges_of(Cell gate) const {
        const Square& s = squares_[square_of(gate)];
        const auto k = number_[map_->index(gate)];
        return {s.edges.data() + s.first[k], s.edges.data() + s.first[k + 1]};
    }
    /// The direction of the next step from a tile to a gate of the same square, inside of it; `no_step` where there is
    /// none.
    std::uint8_t step_to(Cell gate, Cell from) const {
        const Square& s = squares_[square_of(gate)];
        return s.step[number_[map_->index(gate)] * side_ * side_ + local(from)];
    }
    /// What the way is that these steps lead along, inside of a square; `no_way` where there is none.
    Cost cost_to(Cell gate, Cell from) const {
        const auto weights = map_->template weights<Cost>();
        Cost sum = 0;
        while (!(from == gate)) {
            const auto d = step_to(gate, from);
            if (d == no_step) return no_way;
            from = detail::step(from, d);
            sum = detail::add(sum, weights.of(map_->index(from), d >= 4));
        }
        return sum;
    }
    /// The cheapest ways inside of its square from every tile to one.
    /// \param steps the direction of each next step, by the tile's place in the square
    /// \param costs what they cost
    /// \return whether no way costs more than a number holds: such a way is none
    bool ways_to(Cell goal, std::vector<std::uint8_t>& steps, std::vector<Cost>& costs) const {
        costs.assign(side_ * side_, no_way);
        steps.assign(side_ * side_, no_step);
        return fill(goal, steps.data(), costs.data());
    }
    /// Whether there are such ways between gates.
    bool too_far() const {
        return std::any_of(squares_.begin(), squares_.end(), [](const Square& s) { return s.too_far; });
    }
    /// The place of a tile in its square, row by row.
    std::size_t local(Cell c) const { return c.y % side_ * side_ + c.x % side_; }

    /// Whether they are the same, square by square.
    friend bool operator==(const Clusters& a, const Clusters& b) {
        return a.side_ == b.side_ && a.number_ == b.number_ && a.squares_ == b.squares_;
    }

private:
    static constexpr std::uint16_t none = 0xffff;
    /// A step across a border.
    struct Crossing {
        Cell from, to;
        bool operator==(const Crossing&) const = default;
    };
    struct Square {
        std::vector<std::uint8_t> open; ///< what the map was: the directions, and where it has them the weights
        std::vector<double> weights;
        std::vector<Cell> gates;          ///< row by row
        std::vector<Crossing> crossings;  ///< that lead out of it
        std::vector<Cost> between;        ///< from gate to gate
        std::vector<std::uint8_t> step;   ///< by gate, then by the place of the tile
        std::vector<GateEdge> edges;      ///< by gate
        std::vector<std::uint32_t> first; ///< of the edges of each gate
        bool too_far = false;             ///< some way between gates costs more than a number holds
        bool operator==(const Square&) const = default;
    };
    struct Box {
        int x0, y0, x1, y1; ///< the last ones are inside
    };
    Box box(std::size_t square) const {
        const int x = int(square % across_ * side_), y = int(square / across_ * side_), n = int(side_) - 1;
        return {x, y, std::min(x + n, int(map_->width()) - 1), std::min(y + n, int(map_->height()) - 1)};
    }
    static Cell cell(int x, int y) { return {std::uint16_t(x), std::uint16_t(y)}; }
    template <class F> void for_each_around(std::size_t square, F&& f) const {
        const int x = int(square % across_), y = int(square / across_);
        for (int v = std::max(0, y - 1); v <= std::min(int(down_) - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(int(across_) - 1, x + 1); ++u)
                f(std::size_t(v) * across_ + std::size_t(u));
    }
    /// Notes what the map is here. \return whether it was something else
    bool look(std::size_t square) {
        const Box b = box(square);
        Square& s = squares_[square];
        const std::size_t n = std::size_t(b.x1 - b.x0 + 1), rows = std::size_t(b.y1 - b.y0 + 1);
        bool other = s.open.size() != n * rows;
        s.open.resize(n * rows);
        constexpr bool has_weights = !std::is_same_v<typename Map::ground, Even>;
        if constexpr (has_weights) s.weights.resize(n * rows);
        for (std::size_t r = 0; r < rows; ++r) {
            const auto* now = map_->open_directions() + map_->index(cell(b.x0, b.y0 + int(r)));
            auto* was = s.open.data() + r * n;
            if (!std::equal(now, now + n, was)) other = true;
            std::copy(now, now + n, was);
            if constexpr (has_weights)
                for (std::size_t c = 0; c < n; ++c) {
                    const double weight = map_->weight(cell(b.x0 + int(c), b.y0 + int(r)));
                    if (s.weights[r * n + c] != weight) other = true;
                    s.weights[r * n + c] = weight;
                }
        }
        return other;
    }
    /// Whether one gets from one place at a border to another, both ways, near the border and inside of the square.
    bool linked(Cell a, Cell b) const {
        constexpr int deep = 3;
        const Box all = box(square_of(a));
        const int x0 = std::max(all.x0, std::min(a.x, b.x) - deep), x1 = std::min(all.x1, std::max(a.x, b.x) + deep);
        const int y0 = std::max(all.y0, std::min(a.y, b.y) - deep), y1 = std::min(all.y1, std::max(a.y, b.y) + deep);
        const auto place = [&](Cell c) { return std::size_t((c.y - y0) * (x1 - x0 + 1) + c.x - x0); };
        thread_local std::vector<Cell> open;
        thread_local std::vector<std::uint8_t> seen;
        seen.assign(std::size_t((x1 - x0 + 1) * (y1 - y0 + 1)), 0);
        open.assign(1, a);
        seen[place(a)] = 1;
        while (!open.empty()) {
            const Cell at = open.back();
            open.pop_back();
            if (at == b) return true;
            for (unsigned d = 0; d < unsigned(Map::neighbours::directions); ++d) {
                const int x = at.x + detail::direction_x[d], y = at.y + detail::direction_y[d];
                if (x < x0 || y < y0 || x > x1 || y > y1) continue;
                const Cell to = cell(x, y);
                if (seen[place(to)] != 0 || !map_->passable(at, to) || !map_->passable(to, at)) continue;
                seen[place(to)] = 1;
                open.push_back(to);
            }
        }
        return false;
    }
    /// The crossings of the border along `a` and `b = a + across`, step by step `along`: of those that stand for each
    /// other, because one gets from one to the other on both sides, some at even distances.
    template <class Use> void border(Cell a, Cell b, Cell along, std::size_t n, Use&& use) const {
        const auto at = [&](Cell c, std::size_t i) { return cell(int(c.x + i * along.x), int(c.y + i * along.y)); };
        const auto ways = [&](std::size_t i) {
            return unsigned(map_->passable(at(a, i), at(b, i))) | unsigned(map_->passable(at(b, i), at(a, i))) << 1;
        };
        std::array<std::uint8_t, 64> places{}; // of one entrance
        std::size_t count = 0;
        unsigned alike = 0;
        const auto flush = [&] {
            if (count == 0) return;
            const std::size_t length = std::size_t(places[count - 1] - places[0]);
            const std::size_t gaps = length <= spacing() / 2 ? 0 : (length + spacing() - 1) / spacing();
            std::size_t last = n;
            for (std::size_t k = 0; k <= gaps; ++k) {
                const std::size_t wanted = gaps == 0 ? count / 2 : k * (count - 1) / gaps;
                if (places[wanted] == last) continue;
                last = places[wanted];
                use(at(a, last), at(b, last), alike);
            }
            count = 0;
        };
        for (std::size_t i = 0; i < n; ++i) {
            const unsigned way = ways(i);
            if (way == 0) continue;
            if (count > 0) {
                const std::size_t before = places[count - 1];
                if (way != alike || i - before > 5 || !linked(at(a, before), at(a, i)) ||
                    !linked(at(b, before), at(b, i)))
                    flush();
            }
            alike = way;
            places[count++] = std::uint8_t(i);
        }
        flush();
        for (std::size_t i = 0; i < n; ++i) // diagonal steps that no two straight ones stand for
            for (const int d : {-1, 1}) {
                if ((d < 0 && i == 0) || (d > 0 && i + 1 == n)) continue;
                const std::size_t k = i + std::size_t(std::ptrdiff_t(d));
                diagonal(at(a, i), at(b, k), at(a, k), at(b, i), use);
                diagonal(at(b, i), at(a, k), at(b, k), at(a, i), use);
            }
    }
    /// A diagonal step, if it can not be made by way of p or of q.
    template <class Use> void diagonal(Cell from, Cell to, Cell p, Cell q, Use&& use) const {
        const auto by = [&](Cell c) { return map_->passable(from, c) && map_->passable(c, to); };
        if (map_->passable(from, to) && !by(p) && !by(q)) use(from, to, 1u);
    }
    /// All crossings around a square: use(one, other, ways), of which one or the other is inside.
    template <class Use> void for_each_crossing(std::size_t square, Use&& use) const {
        const Box b = box(square);
        const int w = int(map_->width()), h = int(map_->height());
        const auto columns = std::size_t(b.x1 - b.x0 + 1), rows = std::size_t(b.y1 - b.y0 + 1);
        if (b.x1 + 1 < w) border(cell(b.x1, b.y0), cell(b.x1 + 1, b.y0), {0, 1}, rows, use);
        if (b.x0 > 0) border(cell(b.x0 - 1, b.y0), cell(b.x0, b.y0), {0, 1}, rows, use);
        if (b.y1 + 1 < h) border(cell(b.x0, b.y1), cell(b.x0, b.y1 + 1), {1, 0}, columns, use);
        if (b.y0 > 0) border(cell(b.x0, b.y0 - 1), cell(b.x0, b.y0), {1, 0}, columns, use);
        for (const auto& [x, y, dx, dy] : {std::array{b.x0, b.y0, -1, -1}, std::array{b.x1, b.y0, 1, -1},
                                           std::array{b.x0, b.y1, -1, 1}, std::array{b.x1, b.y1, 1, 1}}) {
            if (x + dx < 0 || y + dy < 0 || x + dx >= w || y + dy >= h) continue;
            const Cell at = cell(x, y), far = cell(x + dx, y + dy), p = cell(x + dx, y), q = cell(x, y + dy);
            diagonal(at, far, p, q, use);
            diagonal(far, at, p, q, use);
        }
    }
    /// \return whether they are others than before
    bool find_gates(std::size_t square) {
        Square& s = squares_[square];
        std::vector<Cell> gates;
        s.crossings.clear();
        const auto inside = [&](Cell c) { return square_of(c) == square; };
        for_each_crossing(square, [&](Cell a, Cell b, unsigned ways) {
            gates.push_back(inside(a) ? a : b);
            if (inside(a) && (ways & 1) != 0) s.crossings.push_back({a, b});
            if (inside(b) && (ways & 2) != 0) s.crossings.push_back({b, a});
        });
        std::sort(gates.begin(), gates.end());
        gates.erase(std::unique(gates.begin(), gates.end()), gates.end());
        if (gates == s.gates) return false;
        for (const Cell c : s.gates) number_[map_->index(c)] = none;
        s.gates = std::move(gates);
        for (std::size_t k = 0; k < s.gates.size(); ++k) number_[map_->index(s.gates[k])] = std::uint16_t(k);
        return true;
    }
    /// The ways between the gates of a square.
    void make(std::size_t square) {
        Square& s = squares_[square];
        const std::size_t n = s.gates.size(), area = side_ * side_;
        s.too_far = false, s.between.assign(n * n, no_way);
        s.step.assign(n * area, no_step);
        std::vector<Cost> costs(area);
        for (std::size_t k = 0; k < n; ++k) {
            costs.assign(area, no_way);
            if (!fill(s.gates[k], s.step.data() + k * area, costs.data())) s.too_far = true;
            for (std::size_t i = 0; i < n; ++i) s.between[i * n + k] = costs[local(s.gates[i])];
        }
    }
    /// The edges of a square: inside of it those that no third gate stands for, and across its border.
    void join(std::size_t square) {
        Square& s = squares_[square];
        const std::size_t n = s.gates.size();
        s.edges.clear();
        s.first.assign(1, 0);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < n; ++k) {
                const Cost cost = s.between[i * n + k];
                if (i == k || cost == no_way) continue;
                bool by_another = false; // only shorter ways count, so that none is left out for one that is left out
                for (std::size_t m = 0; m < n && !by_another; ++m) {
                    const Cost there = s.between[i * n + m], on = s.between[m * n + k];
                    by_another = there < cost && on < cost && there + on == cost;
                }
                if (!by_another) s.edges.push_back({s.gates[k], cost});
            }
            for (const Crossing& c : s.crossings)
                if (c.from == s.gates[i]) {
                    const bool over_corner = c.from.x != c.to.x && c.from.y != c.to.y;
                    s.edges.push_back({c.to, map_->template weights<Cost>().of(map_->index(c.to), over_corner)});
                }
            s.first.push_back(std::uint32_t(s.edges.size()));
        }
    }
    /// Dijkstra's algorithm backwards from a tile, inside of its square; whether all costs were numbers.
    bool fill(Cell goal, std::uint8_t* steps, Cost* costs) const {
        struct Entry {
            Cost cost;
            Cell at;
            bool operator<(const Entry& o) const { return cost > o.cost; } // the least on top
        };
        thread_local std::vector<Entry> open;
        const Box b = box(square_of(goal));
        const auto weights = map_->template weights<Cost>();
        open.assign(1, {0, goal});
        costs[local(goal)] = 0;
        bool near = true;
        while (!open.empty()) {
            const Entry least = open.front();
            std::pop_heap(open.begin(), open.end());
            open.pop_back();
            if (least.cost != costs[local(least.at)]) continue;
            const auto index = map_->index(least.at);
            const Cost enter[2]{weights.of(index, false), weights.of(index, true)};
            for (unsigned d = 0; d < unsigned(Map::neighbours::directions); ++d) {
                const int x = least.at.x - detail::direction_x[d], y = least.at.y - detail::direction_y[d];
                if (x < b.x0 || y < b.y0 || x > b.x1 || y > b.y1) continue;
                const Cell from = cell(x, y);
                if ((map_->open_directions(from) >> d & 1) == 0) continue;
                const Cost cost = detail::add(least.cost, enter[d >= 4]);
                auto& known = costs[local(from)];
                if (cost == no_way && known == no_way) near = false;
                if (!(cost < known)) continue;
                known = cost, steps[local(from)] = std::uint8_t(d);
                open.push_back({cost, from});
                std::push_heap(open.begin(), open.end());
            }
        }
        return near;
    }

    std::size_t spacing() const { return side_ * 3 / 8; } ///< the most between two gates of an entrance, about
    const Map* map_;
    std::size_t side_, across_ = 0, down_ = 0, version_ = 0;
    bool made_ = false;
    std::vector<Square> squares_;
    std::vector<std::uint16_t> number_; ///< of the gate on each tile, in its square
};

} // namespace ansatz::paths
