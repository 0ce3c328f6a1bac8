// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `StateGraph`: "each possible state is a node on a graph and state changes are edges" (notes 6.2), as an
/// IncidenceGraph of Boost.Graph that is never stored. With 64 facts it would have 2^64 vertices; a search makes those
/// that it comes to.

#include <ansatz/paths/goap/domain.hpp>
#include <ansatz/paths/implicit_graph.hpp>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace ansatz::goap {

/// An action in a state.
template <std::size_t Words> struct Change {
    /// Before it.
    State<Words> from, to; ///< after it
    Action action = 0;     ///< what is done
    friend bool operator==(const Change& a, const Change& b) { return a.from == b.from && a.action == b.action; }
};

/// The changes that are possible in a state, one after the other; an action that would change nothing is none.
template <std::size_t Words> class Changes {
public:
    using Rule = typename Domain<Words>::Rule; ///< what an action does
    using iterator_category = std::forward_iterator_tag;
    using value_type = Change<Words>;
    using difference_type = std::ptrdiff_t;
    using pointer = const value_type*;
    using reference = value_type;
    Changes() = default;
    /// At the first change from `at` on.
    /// \param first, end all rules of the domain
    Changes(const State<Words>& from, const Rule* first, const Rule* at, const Rule* end)
        : from_(from), first_(first), at_(at), end_(end) {
        skip();
    }
    /// What it points to.
    value_type operator*() const { return {from_, at_->after(from_), Action(at_ - first_)}; }
    Changes& operator++() {
        ++at_;
        skip();
        return *this;
    }
    Changes operator++(int) {
        auto old = *this;
        ++*this;
        return old;
    }
    friend bool operator==(const Changes& a, const Changes& b) { return a.at_ == b.at_; }

private:
    void skip() {
        while (at_ != end_ && (!at_->needs.holds_in(from_) || at_->makes.holds_in(from_))) ++at_;
    }
    State<Words> from_;
    const Rule *first_ = nullptr, *at_ = nullptr, *end_ = nullptr;
};

/// All states of a domain.
template <std::size_t Words = 1> class StateGraph {
public:
    using goal_type = Condition<Words>; ///< a search ends in any state in which this holds
    /// \param domain read, never copied: it must live as long as this
    explicit StateGraph(const Domain<Words>& domain) : domain_(&domain) {}
    /// The domain of these states.
    const Domain<Words>& domain() const { return *domain_; }
    using Rules = std::vector<typename Domain<Words>::Rule>; ///< one for each action
    /// What the actions do: as the domain says, or as a caller that leaves some out.
    const Rules& rules() const { return instead_ != nullptr ? *instead_ : domain_->rules(); }
    /// Rules in the place of the domain's, one for each of its actions; null: those of the domain. They are read,
    /// never copied. A rule that makes nothing is no change, and so no edge.
    void use(const Rules* instead) { instead_ = instead; }

private:
    const Domain<Words>* domain_;
    const Rules* instead_ = nullptr;
};

/// What a change costs, as a property map.
template <std::size_t Words> struct ChangeCosts {
    using key_type = Change<Words>;
    using value_type = double;
    using reference = double;
    using category = boost::readable_property_map_tag;
    const Domain<Words>* domain; ///< whose actions these are; they may become more while one plans in slices
    friend double get(const ChangeCosts& map, const Change<Words>& c) { return map.domain->rules()[c.action].cost; }
};

template <std::size_t W> std::pair<Changes<W>, Changes<W>> out_edges(const State<W>& s, const StateGraph<W>& g) {
    const auto& rules = g.rules();
    const auto *first = rules.data(), *end = first + rules.size();
    return {Changes<W>(s, first, first, end), Changes<W>(s, first, end, end)};
}
template <std::size_t W> std::size_t out_degree(const State<W>& s, const StateGraph<W>& g) {
    const auto edges = out_edges(s, g);
    return std::size_t(std::distance(edges.first, edges.second));
}
template <std::size_t W> State<W> source(const Change<W>& c, const StateGraph<W>&) { return c.from; }
template <std::size_t W> State<W> target(const Change<W>& c, const StateGraph<W>&) { return c.to; }
template <std::size_t W> ChangeCosts<W> get(boost::edge_weight_t, const StateGraph<W>& g) { return {&g.domain()}; }
template <std::size_t W> std::string name_of(const State<W>& s, const StateGraph<W>& g) { return g.domain().words(s); }

} // namespace ansatz::goap

namespace boost {
template <std::size_t W>
struct graph_traits<ansatz::goap::StateGraph<W>>
    : ansatz::paths::ImplicitGraphTraits<ansatz::goap::State<W>, ansatz::goap::Change<W>, ansatz::goap::Changes<W>> {};
template <std::size_t W> struct property_map<ansatz::goap::StateGraph<W>, edge_weight_t> {
    using type = ansatz::goap::ChangeCosts<W>;
    using const_type = type;
};
} // namespace boost
