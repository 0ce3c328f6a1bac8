// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Landmarks`: a heuristic for road maps and everything else where the straight line misleads.
///
/// From a few far-away vertices the true costs to all others are calculated beforehand. If it is far from here to a
/// landmark and near from the goal to it, then it cannot be near from here to the goal (the triangle inequality):
/// \f[ d(v, t) \ge d(v, L) - d(t, L), \qquad d(v, t) \ge d(L, t) - d(L, v). \f]
/// The largest of these is h: never too much, and exact behind every landmark. Making one costs two searches of the
/// whole graph and two numbers a vertex. Blocked or dearer edges leave it right; when something gets cheaper it must be
/// made anew: on a graph that counts its changes (`cheaper_version()`) it is 0 everywhere until then, and so on any
/// that has grown.
///
/// \see A. V. Goldberg, C. Harrelson, "Computing the shortest path: A* search meets graph theory", SODA 2005.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/true_costs.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace ansatz::paths {

/// Landmarks of one graph: `AStar search{graph, Landmarks<int>(graph, 8)};`.
/// \tparam Number what the search counts in: the same, so that whole numbers stay exact
template <class Number = double> class Landmarks {
    struct Table {
        std::vector<std::vector<Number>> to, from; ///< a row for each landmark
        std::size_t cheaper = 0;
    };

public:
    using role = roles::Heuristic;

    /// Chooses so many landmarks, each as far as possible from those before.
    /// \param given  `WeightsOf{map}`, where the search has one
    /// \throws std::invalid_argument for no landmarks, or more than there are vertices
    template <class Graph, class Given = detail::NotGiven>
    Landmarks(const Graph& g, std::size_t count, const Given& given = {}) : table_(std::make_shared<Table>()) {
        if (count < 1 || count > num_vertices(g))
            refuse_value("Landmarks", "their number", std::to_string(count),
                         "it must be from 1 to the " + std::to_string(num_vertices(g)) + " vertices");
        if constexpr (requires { g.cheaper_version(); }) table_->cheaper = g.cheaper_version();
        std::vector<VertexOf<Graph>> all;
        const auto range = vertices(g);
        for (auto v = range.first; v != range.second; ++v)
            if (!detail::blocked(VertexOf<Graph>(*v), g)) all.push_back(*v);
        const auto index = detail::index_of(g);
        std::vector<Number> nearest; // of all landmarks, from each vertex
        for (std::size_t k = 0; k < count && k < all.size(); ++k) {
            VertexOf<Graph> next = all.front();
            for (const auto& v : all) // the farthest that can be reached; what cannot be tells nothing
                if (k > 0 && nearest[get(index, v)] < detail::infinite<Number> &&
                    nearest[get(index, v)] > nearest[get(index, next)])
                    next = v;
            table_->to.push_back(true_costs<Number>(g, next, Toward::to_it, given));
            table_->from.push_back(true_costs<Number>(g, next, Toward::from_it, given));
            const auto& row = table_->from.back();
            if (k == 0) nearest = row;
            for (std::size_t i = 0; i < row.size(); ++i) nearest[i] = std::min(nearest[i], row[i]);
        }
    }
    std::size_t count() const { return table_->to.size(); } ///< how many there are

    template <class Cost, class Graph> auto bind(const Graph& g, const GoalOf<Graph>& goal) const {
        static_assert(std::is_same_v<Cost, Number>,
                      "Ansatz paths: Landmarks<Number> must count in the number of the search; write "
                      "Landmarks<Cost>(graph, count), with CostIn<Cost>{} if the search has one");
        // Numbered behind the tables: a vertex that the graph has got since.
        bool valid = table_->to.empty() || table_->to.front().size() >= num_vertices(g);
        if constexpr (requires { g.cheaper_version(); }) valid = valid && g.cheaper_version() == table_->cheaper;
        const auto index = detail::index_of(g);
        return [table = valid ? table_ : std::make_shared<Table>(), index,
                t = std::size_t(get(index, goal))](const VertexOf<Graph>& v) {
            const std::size_t i = std::size_t(get(index, v));
            Cost h = 0;
            for (std::size_t k = 0; k < table->to.size(); ++k) {
                const auto &to = table->to[k], &from = table->from[k];
                h = std::max({h, more(to[i], to[t]), more(from[t], from[i])});
            }
            return h;
        };
    }

private:
    /// a - b where both are known and it is more than rounding; else nothing.
    static Number more(Number a, Number b) {
        if (!(a < detail::infinite<Number>) || !(b < a)) return 0;
        if constexpr (std::is_integral_v<Number>) return a - b;
        else return std::max(Number(0), a - b - a * 64 * std::numeric_limits<Number>::epsilon());
    }
    std::shared_ptr<Table> table_; ///< copies of the policy share it
};

} // namespace ansatz::paths
