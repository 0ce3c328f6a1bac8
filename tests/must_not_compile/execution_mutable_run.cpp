// expect: Ansatz: the run of an ensemble is called with one parameter, by several threads at once
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// A run that counts itself, in a lambda that is mutable: threads would count at once.

#include <ansatz/execution/ensemble.hpp>

#include <vector>

using namespace ansatz;

int main() {
    const std::vector<double> steps{0.1, 0.2};
#ifdef ANSATZ_MISTAKE
    const auto twice = ensemble([n = 0](double step) mutable { return step * ++n; }, steps);
#else
    const auto twice = ensemble([n = 1](double step) { return step * n; }, steps);
#endif
    static_cast<void>(twice.size());
}
