// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Grid`: a map of tiles as a Boost.Graph graph that stores no edge (notes 6.1, 6.3).
///
/// Take it for maps of square tiles, which may change under the walker's feet: tiles and single edges are blocked and
/// freed by flags, and weights set, in place, and the next search sees it. It keeps three bytes a tile, and sixteen
/// more where the ground is `Terrain`. For places joined by roads take `Waypoints`.
///
/// It models IncidenceGraph and VertexListGraph, with the properties vertex_index and edge_weight (in tiles), so every
/// algorithm of Boost.Graph that asks for no more runs on it; see grid/graph.hpp.

#include <ansatz/paths/grid/cell.hpp>
#include <ansatz/paths/grid/ground.hpp>
#include <ansatz/paths/grid/neighbours.hpp>
#include <ansatz/units.hpp>
#include <ansatz/units/requirements.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ansatz::paths {

struct Octile;
struct Manhattan;

/// A map of tiles.
/// \tparam Neighbours `Eight<BothFree>`, `Eight<OneFree>`, `Eight<NoneFree>` or `Four`
/// \tparam Ground     `Even` or `Terrain`
template <class Neighbours = Eight<BothFree>, class Ground = Even> class Grid {
public:
    using neighbours = Neighbours;      ///< which steps there are
    using ground = Ground;              ///< what they cost
    using default_cost = std::uint32_t; ///< what a search counts in here unless it is told otherwise
    using default_heuristic = std::conditional_t<Neighbours::directions == 4, Manhattan, Octile>;
    static constexpr std::size_t largest = 65535; ///< columns, and rows

    /// A map on which everything is passable.
    /// \param tile how long the side of a tile is
    /// \throws std::invalid_argument for a size that is not from 1 to 65535, or a tile that is not longer than zero
    Grid(std::size_t width, std::size_t height, Quantity<unit::Length> tile = 1.0 * metre) : tile_(tile) {
        require_side("width", width);
        require_side("height", height);
        require_positive("Grid", "tile", tile);
        width_ = std::uint32_t(width), height_ = std::uint32_t(height);
        for (int d = 0; d < 8; ++d) offsets_[d] = detail::direction_y[d] * std::int32_t(width) + detail::direction_x[d];
        free_.assign(width * height, 1);
        ground_.resize(width * height);
        refresh_all();
    }

    std::size_t width() const { return width_; }                          ///< columns
    std::size_t height() const { return height_; }                        ///< rows
    std::size_t size() const { return free_.size(); }                     ///< how many tiles
    bool contains(Cell c) const { return c.x < width_ && c.y < height_; } ///< whether a tile is on the map
    /// The number of a tile, row by row from 0.
    [[gnu::always_inline]] std::size_t index(Cell c) const {
        return std::size_t(detail::row(c) * width_ + detail::column(c));
    }

    /// \name Flags (notes 6.3: a flag, as opposed to an infinite weight)
    /// All setters take effect at once, and throw std::invalid_argument, changing nothing, for a tile outside the map.
    /// @{
    bool passable(Cell c) const { return contains(c) && free_[index(c)] != 0; }
    void set_passable(Cell c, bool free) {
        require_inside("Grid::set_passable", c);
        if ((free_[index(c)] != 0) == free) return;
        free_[index(c)] = free;
        for (int y = c.y - 1; y <= c.y + 1; ++y)
            for (int x = c.x - 1; x <= c.x + 1; ++x)
                if (x >= 0 && y >= 0 && x < int(width_) && y < int(height_)) refresh(x, y);
        changed(free);
    }
    /// Sets all tiles in one go, row by row: much faster than one by one.
    void set_passable(std::span<const std::uint8_t> free) {
        if (free.size() != size())
            refuse_value("Grid::set_passable", "the number of flags", std::to_string(free.size()),
                         "the map has " + std::to_string(size()) + " tiles");
        for (std::size_t i = 0; i < free.size(); ++i) free_[i] = free[i] != 0;
        refresh_all();
        changed(true);
    }
    /// Whether a step from one tile to a neighbour is possible: flags of both, of the edge, and the corner rule.
    bool passable(Cell from, Cell to) const {
        const int d = contains(from) && contains(to) ? direction(from, to) : -1;
        return d >= 0 && (open_[index(from)] >> d & 1) != 0;
    }
    /// One edge in one direction: a drop that cannot be climbed.
    void set_passable(Cell from, Cell to, bool free) {
        require_inside("Grid::set_passable", from);
        require_inside("Grid::set_passable", to);
        const int d = direction(from, to);
        if (d < 0 || d >= Neighbours::directions)
            refuse_value("Grid::set_passable", "the edge", name_of(from) + " to " + name_of(to),
                         "its ends must be neighbours of this grid");
        if (shut_.empty()) shut_.assign(size(), 0);
        auto& shut = shut_[index(from)];
        const auto bit = std::uint8_t(1u << d);
        if (((shut & bit) == 0) == free) return;
        shut = std::uint8_t(free ? shut & ~bit : shut | bit);
        free ? --blocked_edges_ : ++blocked_edges_;
        refresh(from.x, from.y);
        changed(free);
    }
    /// A thin wall between two tiles, or a door in it: the edge in both directions.
    void set_wall(Cell a, Cell b, bool wall) {
        set_passable(a, b, !wall);
        set_passable(b, a, !wall);
    }
    std::size_t blocked_edges() const { return blocked_edges_; } ///< how many, in one direction each
    /// @}

    /// \name Ground
    /// @{
    double weight(Cell c) const { return ground_.weight(index(c)); }
    double least_weight() const { return ground_.least(); }
    /// \throws std::invalid_argument, and changes nothing, unless the tile is inside and the weight from 0 to 60000
    void set_weight(Cell c, double weight) {
        static_assert(!std::is_same_v<Ground, Even>,
                      "Ansatz paths: the ground of this grid is even; for weights take Grid<Eight<>, Terrain>");
        require_inside("Grid::set_weight", c);
        if constexpr (!std::is_same_v<Ground, Even>) {
            const double old = ground_.weight(index(c));
            ground_.set(index(c), weight, "Grid::set_weight", c);
            if (weight != old) changed(weight < old);
        }
    }
    template <class Cost> Steps<Cost> least_step() const { return ground_.template least_step<Cost>(); }
    template <class Cost> auto weights() const { return ground_.template weights<Cost>(); }
    /// @}

    /// \name Where things are
    /// @{
    Quantity<unit::Length> tile() const { return tile_; }
    VectorQuantity<unit::Length, 2> position(Cell c) const { ///< of its centre; y grows with the rows
        return metres((c.x + 0.5) * tile_.value(), (c.y + 0.5) * tile_.value());
    }
    /// \throws std::invalid_argument for a place outside the map
    Cell cell_at(const VectorQuantity<unit::Length, 2>& place) const {
        const double x = std::floor(place.value()[0] / tile_.value()), y = std::floor(place.value()[1] / tile_.value());
        if (!(x >= 0 && y >= 0 && x < double(width_) && y < double(height_)))
            refuse_value("Grid::cell_at", "the place", place, "the map has " + size_in_words());
        return Cell{std::uint16_t(x), std::uint16_t(y)};
    }
    /// @}

    /// \name Of a path
    /// Each is a sum of straight and of diagonal steps kept apart, so that no rounding piles up.
    /// @{
    double tiles(std::span<const Cell> path) const { ///< its length in tiles, as MovingAI's scenarios give it
        return sum(path, [](Cell) { return 1.0; });
    }
    double cost(std::span<const Cell> path) const { ///< the same with the weights of the tiles that are entered
        return sum(path, [&](Cell c) { return weight(c); });
    }
    Quantity<unit::Length> length(std::span<const Cell> path) const { return tiles(path) * tile_; }
    /// \param speed on ground of weight 1
    Quantity<unit::Time> travel_time(std::span<const Cell> path, Quantity<unit::Velocity> speed) const {
        require_positive("Grid::travel_time", "speed", speed);
        return cost(path) * tile_ / speed;
    }
    /// @}

    /// \name What has changed
    /// @{
    std::size_t version() const { return version_; }         ///< grows with every change
    std::size_t cheaper_version() const { return cheaper_; } ///< grows when something is freed or gets cheaper
    /// @}

    std::uint8_t open_directions(Cell c) const { return open_[index(c)]; } ///< a bit for each direction of detail::step
    /// "4 x 2 tiles".
    std::string size_in_words() const { return std::to_string(width_) + " x " + std::to_string(height_) + " tiles"; }
    const std::uint8_t* open_directions() const { return open_.data(); } ///< the same of all tiles, by number
    const std::int32_t* index_offsets() const { return offsets_; }       ///< from a tile's number to its neighbours'

private:
    static void require_side(const char* what, std::size_t side) {
        if (side < 1 || side > largest)
            refuse_value("Grid", what, std::to_string(side), "it must be from 1 to 65535 tiles");
    }
    void require_inside(const char* where, Cell c) const {
        if (!contains(c)) refuse_value(where, "the tile", name_of(c), "the map has " + size_in_words());
    }
    static int direction(Cell from, Cell to) {
        const int dx = int(to.x) - from.x, dy = int(to.y) - from.y;
        for (int d = 0; d < 8; ++d)
            if (detail::direction_x[d] == dx && detail::direction_y[d] == dy) return d;
        return -1;
    }
    void changed(bool cheaper) {
        ++version_;
        if (cheaper) ++cheaper_;
    }
    bool free_at(int x, int y) const {
        return x >= 0 && y >= 0 && x < int(width_) && y < int(height_) &&
               free_[std::size_t(y) * width_ + std::size_t(x)] != 0;
    }
    /// Which steps lead out of this tile.
    void refresh(int x, int y) {
        const std::size_t i = std::size_t(y) * width_ + std::size_t(x);
        unsigned open = 0;
        if (free_[i] != 0) {
            for (int d = 0; d < 4; ++d)
                if (free_at(x + detail::direction_x[d], y + detail::direction_y[d])) open |= 1u << d;
            for (int d = 4; d < Neighbours::directions; ++d)
                if (free_at(x + detail::direction_x[d], y + detail::direction_y[d]) &&
                    Neighbours::diagonal((open >> (d - 4) & 1) != 0, (open >> ((d - 3) & 3) & 1) != 0))
                    open |= 1u << d;
            if (!shut_.empty()) open &= ~unsigned(shut_[i]);
        }
        open_[i] = std::uint8_t(open);
    }
    void refresh_all() {
        open_.resize(size());
        for (int y = 0; y < int(height_); ++y)
            for (int x = 0; x < int(width_); ++x) refresh(x, y);
    }
    template <class Weight> double sum(std::span<const Cell> path, Weight&& weight) const {
        double straight = 0, diagonal = 0;
        for (std::size_t i = 1; i < path.size(); ++i)
            (path[i].x != path[i - 1].x && path[i].y != path[i - 1].y ? diagonal : straight) += weight(path[i]);
        return straight + diagonal * Tile<double>::diagonal;
    }
    std::uint32_t width_ = 0, height_ = 0;
    std::int32_t offsets_[8]{};
    Quantity<unit::Length> tile_;
    std::vector<std::uint8_t> free_; ///< the flags of the tiles
    std::vector<std::uint8_t> shut_; ///< of the edges, a bit each; empty until one is set
    std::vector<std::uint8_t> open_; ///< made of both by the corner rule
    [[no_unique_address]] Ground ground_;
    std::size_t blocked_edges_ = 0, version_ = 0, cheaper_ = 0;
};

} // namespace ansatz::paths
