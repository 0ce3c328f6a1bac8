// expect: the edges of this graph carry a structure of yours, and nothing says which member is the weight
// SPDX-License-Identifier: BSL-1.0
// The same where landmarks, checks and true costs visit the whole graph, here through a view.

#include <ansatz/paths.hpp>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/filtered_graph.hpp>

using namespace ansatz;
using namespace ansatz::paths;

struct Street {
    double km = 1;
};
using Streets = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Street>;

int main() {
    const Streets streets;
    const boost::filtered_graph<Streets, boost::keep_all> open(streets, boost::keep_all{});
#ifdef ANSATZ_MISTAKE
    return int(true_costs(open, 0).size());
#else
    return int(true_costs(open, 0, Toward::to_it, WeightsOf{get(&Street::km, streets)}).size());
#endif
}
