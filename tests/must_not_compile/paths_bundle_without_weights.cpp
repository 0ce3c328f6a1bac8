// expect: the edges of this graph carry a structure of yours, and nothing says which member is the weight
// SPDX-License-Identifier: BSL-1.0
// Edges with members, of which one is meant to be the weight.

#include <ansatz/paths.hpp>

#include <boost/graph/adjacency_list.hpp>

using namespace ansatz;
using namespace ansatz::paths;

struct Street {
    double km = 1;
};

int main() {
    boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, Street> streets(2);
#ifdef ANSATZ_MISTAKE
    AStar search{streets};
#else
    AStar search{streets, WeightsOf{get(&Street::km, streets)}};
    AStar hops{streets, UnitWeights{}};
    hops.find(0, 1);
#endif
    search.find(0, 1);
}
