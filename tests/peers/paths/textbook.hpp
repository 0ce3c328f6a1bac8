// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// boost::astar_search as Boost.Graph's documentation shows it: a stored graph, a vector for each map, a visitor that
/// throws at the goal.

#include <ansatz/paths/grid/grid.hpp>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/astar_search.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace peers {

template <class OutEdges, class Directed> class Textbook {
    using Graph = boost::adjacency_list<OutEdges, boost::vecS, Directed, boost::no_property,
                                        boost::property<boost::edge_weight_t, double>>;
    using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
    struct Found {};
    struct AtGoal : boost::default_astar_visitor {
        Vertex goal;
        explicit AtGoal(Vertex g) : goal(g) {}
        template <class G> void examine_vertex(Vertex u, const G&) {
            if (u == goal) throw Found{};
        }
    };

public:
    explicit Textbook(const ansatz::paths::Grid<>& map) : graph_(map.size()), width_(map.width()) {
        constexpr bool once = std::is_same_v<Directed, boost::undirectedS>;
        for (auto [v, end] = vertices(map); v != end; ++v)
            for (auto [e, last] = out_edges(*v, map); e != last; ++e) {
                const auto edge = *e;
                if (!once || map.index(edge.from) < map.index(edge.to))
                    boost::add_edge(map.index(edge.from), map.index(edge.to), edge.diagonal ? std::sqrt(2.0) : 1.0,
                                    graph_);
            }
    }
    double find(ansatz::paths::Cell from, ansatz::paths::Cell to) {
        const Vertex start = from.y * width_ + from.x, goal = to.y * width_ + to.x;
        std::vector<Vertex> parents(num_vertices(graph_));
        std::vector<double> costs(num_vertices(graph_));
        auto estimate = [&](Vertex v) {
            const double dx = std::abs(double(v % width_) - to.x), dy = std::abs(double(v / width_) - to.y);
            return std::max(dx, dy) + (std::sqrt(2.0) - 1) * std::min(dx, dy);
        };
        try {
            boost::astar_search(
                graph_, start, estimate,
                boost::predecessor_map(
                    boost::make_iterator_property_map(parents.begin(), get(boost::vertex_index, graph_)))
                    .distance_map(boost::make_iterator_property_map(costs.begin(), get(boost::vertex_index, graph_)))
                    .visitor(AtGoal(goal)));
        } catch (const Found&) {
            path_.clear();
            for (Vertex v = goal;; v = parents[v]) {
                path_.push_back(v);
                if (parents[v] == v) break;
            }
            return costs[goal];
        }
        return -1;
    }

private:
    Graph graph_;
    std::size_t width_;
    std::vector<Vertex> path_;
};

} // namespace peers
