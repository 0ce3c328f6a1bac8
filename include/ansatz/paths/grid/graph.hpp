// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Grid` as a graph of Boost.Graph: IncidenceGraph and VertexListGraph, vertex_index and edge_weight.
///
/// A vertex is a `Cell`, an edge a `GridEdge`. Edges are made on demand: a byte a tile says which steps
/// lead out of it, so flags and corner rule are not asked again for each search.

#include <ansatz/paths/grid/declaration.hpp>
#include <ansatz/paths/heuristics/grid_metrics.hpp>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>

#include <bit>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace ansatz::paths {

/// A step from one tile to a neighbour.
struct GridEdge {
    /// The tile it leaves.
    Cell from, to;              ///< the tile it enters
    bool diagonal = false;      ///< over a corner
    std::uint32_t to_index = 0; ///< the number of `to`, which the grid has at hand
    friend bool operator==(const GridEdge& a, const GridEdge& b) { return a.from == b.from && a.to == b.to; }
};

/// The steps that lead out of a tile, one after the other.
class GridEdges {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = GridEdge;
    using difference_type = std::ptrdiff_t;
    using pointer = const GridEdge*;
    using reference = GridEdge;
    GridEdges() = default;
    /// At the first step that is open.
    /// \param index   the number of `from`
    /// \param offsets from a number to its neighbours'
    /// \param open    a bit for each direction in which a step leads
    GridEdges(Cell from, std::uint32_t index, const std::int32_t* offsets, std::uint8_t open)
        : from_(std::bit_cast<std::uint32_t>(from)), open_(open), index_(index), offsets_(offsets) {}
    [[gnu::always_inline]] GridEdge operator*() const {
        const unsigned d = unsigned(std::countr_zero(open_));
        return {std::bit_cast<Cell>(from_), detail::step(std::bit_cast<Cell>(from_), d), (d >> 2 & 1) != 0,
                index_ + std::uint32_t(offsets_[d])};
    }
    [[gnu::always_inline]] GridEdges& operator++() {
        open_ &= open_ - 1;
        return *this;
    }
    GridEdges operator++(int) {
        auto old = *this;
        ++*this;
        return old;
    }
    [[gnu::always_inline]] friend bool operator==(const GridEdges& a, const GridEdges& b) { return a.open_ == b.open_; }

private:
    std::uint32_t from_ = 0; // the word that a Cell is: g++ would keep its halves apart
    unsigned open_ = 0;
    std::uint32_t index_ = 0;
    const std::int32_t* offsets_ = nullptr;
};

/// The tiles of a grid, row by row.
class GridCells {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Cell;
    using difference_type = std::ptrdiff_t;
    using pointer = const Cell*;
    using reference = Cell;
    GridCells() = default;
    /// At the tile of this number.
    GridCells(std::size_t width, std::size_t at) : width_(width), at_(at) {}
    Cell operator*() const { return {std::uint16_t(at_ % width_), std::uint16_t(at_ / width_)}; }
    GridCells& operator++() {
        ++at_;
        return *this;
    }
    GridCells operator++(int) {
        auto old = *this;
        ++*this;
        return old;
    }
    friend bool operator==(const GridCells& a, const GridCells& b) { return a.at_ == b.at_; }

private:
    std::size_t width_ = 1, at_ = 0;
};

/// The number of a tile, as a property map.
struct GridIndex {
    using key_type = Cell;
    using value_type = std::size_t;
    using reference = std::size_t;
    using category = boost::readable_property_map_tag;
    std::uint32_t width; ///< columns of the grid
    [[gnu::always_inline]] friend std::size_t get(const GridIndex& map, Cell c) {
        // NOLINTNEXTLINE(bugprone-misplaced-widening-cast): a grid has fewer tiles than 2^32
        return std::size_t(detail::row(c) * map.width + detail::column(c));
    }
    /// The number of this tile.
    std::size_t operator[](Cell c) const { return get(*this, c); }
};

/// What a step costs in a number, as a property map.
template <class Cost, class Ground> struct GridWeights {
    using key_type = GridEdge;
    using value_type = Cost;
    using reference = Cost;
    using category = boost::readable_property_map_tag;
    typename Ground::template Weights<Cost> of; ///< what the ground tells
    [[gnu::always_inline]] friend Cost get(const GridWeights& map, const GridEdge& e) {
        return map.of.of(e.to_index, e.diagonal);
    }
};

template <class N, class G> std::pair<GridEdges, GridEdges> out_edges(Cell c, const Grid<N, G>& g) {
    const std::uint32_t index = std::uint32_t(g.index(c));
    return {GridEdges(c, index, g.index_offsets(), g.open_directions()[index]), GridEdges(c, index, nullptr, 0)};
}
template <class N, class G> std::size_t out_degree(Cell c, const Grid<N, G>& g) {
    return std::size_t(std::popcount(g.open_directions(c)));
}
template <class N, class G> Cell source(const GridEdge& e, const Grid<N, G>&) { return e.from; }
template <class N, class G> Cell target(const GridEdge& e, const Grid<N, G>&) { return e.to; }
template <class N, class G> std::pair<GridCells, GridCells> vertices(const Grid<N, G>& g) {
    return {GridCells(g.width(), 0), GridCells(g.width(), g.size())};
}
/// The number of a step's target, at hand: a search then does not calculate it.
inline std::size_t target_index(const GridEdge& e, const GridIndex&) { return e.to_index; }
template <class N, class G> std::size_t num_vertices(const Grid<N, G>& g) { return g.size(); }
template <class N, class G> GridIndex get(boost::vertex_index_t, const Grid<N, G>& g) {
    return {std::uint32_t(g.width())};
}
/// What a step costs, in tiles.
template <class N, class G> GridWeights<double, G> get(boost::edge_weight_t, const Grid<N, G>& g) {
    return edge_weights(g, std::type_identity<double>{});
}
/// What a step costs, in the number of a search.
template <class N, class G, class Cost>
GridWeights<Cost, G> edge_weights(const Grid<N, G>& g, std::type_identity<Cost>) {
    return {g.template weights<Cost>()};
}
template <class N, class G> std::size_t get(boost::vertex_index_t tag, const Grid<N, G>& g, Cell c) {
    return get(get(tag, g), c);
}
template <class N, class G> double get(boost::edge_weight_t tag, const Grid<N, G>& g, const GridEdge& e) {
    return get(get(tag, g), e);
}
/// For Buckets: an eighth of the lightest step.
template <class N, class G, class Cost> double bucket_width(const Grid<N, G>& g, std::type_identity<Cost>) {
    return double(g.template least_step<Cost>().straight) / 8;
}
template <class N, class G> bool has_vertex(Cell c, const Grid<N, G>& g) { return g.contains(c); }
template <class N, class G> bool is_blocked(Cell c, const Grid<N, G>& g) {
    return g.open_directions(c) == 0 && !g.passable(c); // a tile with a way out is free: the flags need not be fetched
}
template <class N, class G> std::string name_of(Cell c, const Grid<N, G>&) { return name_of(c); }
/// "2.4142137 tiles", in whatever number a search has counted.
template <class Cost, class N, class G> std::string cost_in_words(Cost cost, const Grid<N, G>&) {
    return describe(float(double(cost) / double(Tile<Cost>::straight))) + " tiles"; // as many digits as are read
}
template <class N, class G> std::string size_in_words(const Grid<N, G>& g) {
    return "the map has " + g.size_in_words();
}

} // namespace ansatz::paths

namespace boost {
template <class N, class G> struct graph_traits<ansatz::paths::Grid<N, G>> {
    struct traversal_category
        : virtual incidence_graph_tag
        , virtual vertex_list_graph_tag {};
    using vertex_descriptor = ansatz::paths::Cell;
    using edge_descriptor = ansatz::paths::GridEdge;
    using out_edge_iterator = ansatz::paths::GridEdges;
    using vertex_iterator = ansatz::paths::GridCells;
    using directed_category = directed_tag;
    using edge_parallel_category = disallow_parallel_edge_tag;
    using vertices_size_type = std::size_t;
    using edges_size_type = std::size_t;
    using degree_size_type = std::size_t;
    using adjacency_iterator = void;
    using in_edge_iterator = void;
    using edge_iterator = void;
    static vertex_descriptor null_vertex() { return {65535, 65535}; }
};
template <class N, class G> struct property_map<ansatz::paths::Grid<N, G>, vertex_index_t> {
    using type = ansatz::paths::GridIndex;
    using const_type = type;
};
template <class N, class G> struct property_map<ansatz::paths::Grid<N, G>, edge_weight_t> {
    using type = ansatz::paths::GridWeights<double, G>;
    using const_type = type;
};
} // namespace boost
