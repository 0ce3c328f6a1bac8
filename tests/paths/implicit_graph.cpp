// SPDX-License-Identifier: BSL-1.0
// Graphs whose edges are made on demand are what Boost.Graph calls incidence graphs.

#include <ansatz/paths/implicit_graph.hpp>

#include <ansatz/paths/cluster_graph.hpp>
#include <ansatz/paths/goap/state_graph.hpp>
#include <ansatz/paths/grid/grid.hpp>
#include <ansatz/paths/reservations.hpp>

#include "tests/catch.hpp"

#include <boost/concept/assert.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/graph_concepts.hpp>

#include <iterator>
#include <map>
#include <type_traits>

namespace {

using namespace ansatz;

/// The numbers from 0 on: from n lead steps to 2 n and 2 n + 1, up to a last number.
struct Doubling {
    unsigned last;
};
struct Step {
    unsigned from, to;
    friend bool operator==(const Step&, const Step&) = default;
};
class Steps {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Step;
    using difference_type = std::ptrdiff_t;
    using pointer = const Step*;
    using reference = Step;
    Steps() = default;
    Steps(unsigned from, unsigned at) : from_(from), at_(at) {}
    Step operator*() const { return {from_, 2 * from_ + at_}; }
    Steps& operator++() {
        ++at_;
        return *this;
    }
    Steps operator++(int) {
        const auto old = *this;
        ++*this;
        return old;
    }
    friend bool operator==(const Steps& a, const Steps& b) { return a.at_ == b.at_; }

private:
    unsigned from_ = 0, at_ = 0;
};
std::pair<Steps, Steps> out_edges(unsigned n, const Doubling& g) {
    const unsigned first = n == 0 ? 1U : 0U; // nothing leads from 0 to itself
    const unsigned end = 2 * n > g.last ? first : (2 * n + 1 > g.last ? 1U : 2U);
    return {Steps(n, first), Steps(n, end)};
}
std::size_t out_degree(unsigned n, const Doubling& g) {
    const auto [at, end] = out_edges(n, g);
    return std::size_t(std::distance(at, end));
}
unsigned source(const Step& step, const Doubling&) { return step.from; }
unsigned target(const Step& step, const Doubling&) { return step.to; }

} // namespace

template <> struct boost::graph_traits<Doubling> : ansatz::paths::ImplicitGraphTraits<unsigned, Step, Steps> {
    static unsigned null_vertex() { return ~0U; }
};

TEST_CASE("a graph of one's own with these traits is searched by Boost.Graph", "[paths][implicit_graph]") {
    BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Doubling>));
    std::map<unsigned, boost::default_color_type> colours;
    std::map<unsigned, int> depth{{0, 0}};
    const auto note =
        boost::make_bfs_visitor(boost::record_distances(boost::make_assoc_property_map(depth), boost::on_tree_edge()));
    boost::queue<unsigned> open;
    boost::breadth_first_visit(Doubling{20}, 0U, open, note, boost::make_assoc_property_map(colours));
    CHECK(depth.size() == 21);
    for (const auto& [n, steps] : depth) {
        int digits = 0; // n has so many binary digits, and each step adds one
        for (unsigned rest = n; rest > 0; rest /= 2) ++digits;
        CHECK(steps == digits);
    }
}

TEST_CASE("the library's graphs that make their edges have them", "[paths][implicit_graph]") {
    using Map = paths::Grid<>;
    const auto agrees = []<class G, class Parallel>(std::type_identity<G>, Parallel) {
        using Traits = boost::graph_traits<G>;
        return std::is_same_v<typename Traits::edge_parallel_category, Parallel> &&
               std::is_same_v<typename Traits::traversal_category, boost::incidence_graph_tag> &&
               std::is_same_v<typename std::iterator_traits<typename Traits::out_edge_iterator>::value_type,
                              typename Traits::edge_descriptor>;
    };
    CHECK(agrees(std::type_identity<paths::ClusterGraph<Map>>{}, boost::allow_parallel_edge_tag{}));
    CHECK(agrees(std::type_identity<goap::StateGraph<1>>{}, boost::allow_parallel_edge_tag{}));
    CHECK(agrees(std::type_identity<paths::TimedGrid<Map>>{}, boost::disallow_parallel_edge_tag{}));
}
