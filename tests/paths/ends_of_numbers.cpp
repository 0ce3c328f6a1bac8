// SPDX-License-Identifier: BSL-1.0
// Costs near the largest that their number holds.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/cost.hpp>

#include "tests/catch.hpp"

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>

using namespace ansatz::paths;

TEMPLATE_TEST_CASE("a way whose cost its number does not hold is no way, new or better", "[paths][P10]", std::int8_t,
                   std::uint8_t, std::int16_t, std::uint16_t, int, std::uint32_t, std::int64_t, std::uint64_t) {
    using Cost = TestType;
    boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                          boost::property<boost::edge_weight_t, Cost>>
        g(5);
    const Cost most = std::numeric_limits<Cost>::max();
    boost::add_edge(0, 1, Cost(100), g);
    boost::add_edge(0, 2, Cost(most - 2), g);
    const auto on = boost::add_edge(2, 1, Cost(0), g).first; // were the sum to begin again at zero, less than 100
    const auto out = boost::add_edge(2, 3, Cost(0), g).first;
    AStar search{g, CostIn<Cost>{}};
    AStar by_buckets{g, CostIn<Cost>{}, Buckets{}};
    const auto both = [&](std::size_t goal) {
        const Outcome outcome = search.find(0, goal);
        CHECK(by_buckets.find(0, goal) == outcome);
        CHECK(by_buckets.cost() == search.cost());
        return outcome;
    };
    for (const int more : {2, 3, 10, 50, 100, 127}) {
        put(boost::edge_weight, g, on, Cost(more));
        put(boost::edge_weight, g, out, Cost(more));
        CHECK(both(4) == Outcome::too_far); // an edge to 4 is missing, and that to 3 leads past the end
        REQUIRE(search.node(1));
        CHECK(search.node(1)->g == 100);
        CHECK(search.node(3) == nullptr);
        CHECK(both(3) == Outcome::too_far);
        CHECK(both(1) == Outcome::found);
        CHECK(search.cost() == 100);
    }
    put(boost::edge_weight, g, out, Cost(1));
    CHECK(both(3) == Outcome::found); // the last cost that is one
    CHECK(search.cost() == most - 1);
    CHECK(both(4) == Outcome::no_path);
}
