// expect: WeightsOf takes a property map of the graph's edges
// SPDX-License-Identifier: BSL-1.0
// A member, where the property map that reads it belongs.

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
    AStar search{streets, WeightsOf{&Street::km}};
#else
    AStar search{streets, WeightsOf{get(&Street::km, streets)}};
#endif
    search.find(0, 1);
}
