// SPDX-License-Identifier: BSL-1.0
#include <Eigen/Core>
#include <boost/units/systems/si.hpp>
int main() {}
