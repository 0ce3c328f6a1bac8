// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Route`: a path that is being walked, and the rule when to search again (notes 6.3).
///
/// The notes: paths should only be recomputed when the best path is likely to change, "once when the entity first
/// starts to move and an additional time for each event that changes parts of the graph that form parts of the path".
/// What lies behind the walker does not matter any more, and what got dearer elsewhere cannot make another path better.
///
/// | an edge ...                        | the path            | `when_touched` (the default) | `also_when_cheaper` |
/// |------------------------------------|---------------------|------------------------------|---------------------|
/// | ahead is blocked or got dearer     | is wrong            | searches                     | searches            |
/// | behind changed                     | is still the best   | nothing                      | see below           |
/// | elsewhere got dearer               | is still the best   | nothing                      | nothing             |
/// | anywhere got cheaper or free       | may not be the best | nothing                      | searches            |
///
/// The second column is why the notes say "likely": a path that was best stays valid when a short cut opens, but it is
/// no longer the best, and only a new search can tell.

#include <ansatz/paths/a_star.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace ansatz::paths {

/// When a path is searched again.
enum class Replan : bool {
    when_touched,      ///< the rest of the path is blocked or got dearer
    also_when_cheaper, ///< or something anywhere was freed or got cheaper
};

/// A path and how far it has been walked.
/// \tparam Search an AStar on a graph; the graph's `version()` and `cheaper_version()` are used where it has them
template <class Search> class Route {
    static_assert(
        requires(const Search& s) { s.path(), s.graph(); },
        "Ansatz paths: a Route is of a search, which it uses again and again: AStar search{map}; Route route{search};");

public:
    using Vertex = typename Search::Vertex; ///< of the graph
    using Cost = typename Search::Cost;     ///< the number of the search

    /// \param search used, not copied; several routes may share one
    explicit Route(Search& search, Replan rule = Replan::when_touched) : search_(&search), rule_(rule) {}

    /// Searches once: when the walker first starts to move.
    /// \throws std::invalid_argument for a start or goal that the graph does not have; the walker goes on as before
    Outcome go(const Vertex& start, const typename Search::Goal& goal) {
        const Vertex from = start; // perhaps here(), or an end of ahead()
        search_->find(from, goal);
        goal_ = goal;
        here_ = from;
        return take();
    }
    /// Whether the walker stands at the end of a path that was found.
    bool arrived() const { return outcome_ == Outcome::found && at_ + 1 == path_.size(); }
    /// How the last search ended.
    Outcome outcome() const { return outcome_; }
    const Vertex& here() const { return here_; } ///< where the walker stands
    /// Where the walker goes next; here() when it has arrived or there is no path.
    const Vertex& next() const { return arrived() || path_.empty() ? here_ : path_[at_ + 1]; }
    std::span<const Vertex> ahead() const { return std::span(path_).subspan(path_.empty() ? 0 : at_); } ///< with here()
    std::size_t searches() const { return searches_; } ///< how often it searched
    /// The walker has reached next().
    /// \return where it stands
    const Vertex& step() {
        if (outcome_ == Outcome::found && !arrived()) here_ = path_[++at_];
        return here_;
    }
    /// Whether the rule asks for a new search. Tests the rest of the path, once for each change of a graph that
    /// counts its changes; a graph without `version()` is checked each time.
    bool needs_new_path() const {
        if (outcome_ == Outcome::not_begun) return false;
        const auto& g = search_->graph();
        if constexpr (requires { g.version(); })
            if (g.version() == version_) return false;
        if (is_touched()) return true;
        if constexpr (requires { g.version(); }) version_ = g.version(); // so much is known of it
        return false;
    }
    /// Searches again from here if the rule asks for it.
    /// \return whether it did
    bool renew() {
        if (!needs_new_path()) return false;
        again();
        return true;
    }

private:
    bool is_touched() const {
        const auto& g = search_->graph();
        if (outcome_ != Outcome::found) { // a way may have opened
            if constexpr (requires { g.cheaper_version(); }) return g.cheaper_version() != cheaper_;
            else return true;
        }
        if (rule_ == Replan::also_when_cheaper) {
            if constexpr (requires { g.cheaper_version(); }) {
                if (g.cheaper_version() != cheaper_) return true;
            } else return true; // the graph cannot tell
        }
        for (std::size_t i = at_; i + 1 < path_.size(); ++i)
            if (step_cost(path_[i], path_[i + 1]) > costs_[i]) return true;
        return false;
    }
    Outcome again() {
        search_->find(here_, goal_);
        return take();
    }
    /// What the search has found.
    Outcome take() {
        outcome_ = search_->outcome();
        ++searches_;
        path_.assign(search_->path().begin(), search_->path().end());
        at_ = 0;
        costs_.clear();
        for (std::size_t i = 0; i + 1 < path_.size(); ++i) costs_.push_back(step_cost(path_[i], path_[i + 1]));
        const auto& g = search_->graph();
        if constexpr (requires { g.version(); }) version_ = g.version();
        if constexpr (requires { g.cheaper_version(); }) cheaper_ = g.cheaper_version();
        return outcome_;
    }
    /// Of the cheapest passable edge between two neighbours; the dearest cost there is where there is none.
    Cost step_cost(const Vertex& from, const Vertex& to) const {
        const auto& g = search_->graph();
        Cost least = detail::infinite<Cost>;
        if (detail::blocked(from, g) || detail::blocked(to, g)) return least;
        const auto edges = out_edges(from, g);
        for (auto e = edges.first; e != edges.second; ++e) {
            if (!(target(*e, g) == to) || !detail::edge_passable(*e, g)) continue;
            const Cost cost = search_->weight(*e);
            if (cost < least) least = cost;
        }
        return least;
    }
    Search* search_;
    Replan rule_;
    typename Search::Goal goal_{};
    Vertex here_{};
    std::vector<Vertex> path_;
    std::vector<Cost> costs_; ///< of each step when it was found
    std::size_t at_ = 0, searches_ = 0, cheaper_ = 0;
    mutable std::size_t version_ = 0; ///< of the graph, up to which nothing is known that asks for a search
    Outcome outcome_ = Outcome::not_begun;
};
/// The route of a search, `Route{search}`.
template <class Search> Route(Search&) -> Route<Search>;
/// The same with a rule, `Route{search, Replan::also_when_cheaper}`.
template <class Search> Route(Search&, Replan) -> Route<Search>;

} // namespace ansatz::paths
