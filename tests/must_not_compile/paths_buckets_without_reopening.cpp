// expect: Buckets are in order only to a bucket's width, and need Reopening
// SPDX-License-Identifier: BSL-1.0
// Buckets that may not open a node again.

#include <ansatz/paths.hpp>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    Grid<> map(4, 4);
#ifdef ANSATZ_MISTAKE
    AStar search{map, Weighted{Octile{}, 1.5}, Buckets{}, NoReopening{}};
#else
    AStar search{map, Weighted{Octile{}, 1.5}, Buckets{}};
#endif
}
