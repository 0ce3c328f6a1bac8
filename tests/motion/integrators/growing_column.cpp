// SPDX-License-Identifier: BSL-1.0
// A vector of Eigen's that becomes longer in its room: where its numbers stand, and what it is in expressions.

#include <ansatz/motion/integrators/growing_column.hpp>

#include "tests/catch.hpp"

#include <cstdint>
#include <utility>

using namespace ansatz;

TEST_CASE("a growing column stays where it is while it has room", "[motion][implicit]") {
    GrowingColumn<double> x;
    CHECK(x.size() == 0);
    x.reserve(9);
    x.setZero(4);
    const double* const place = x.data();
    CHECK(reinterpret_cast<std::uintptr_t>(place) % 64 == 0);
    for (const Eigen::Index rows : {7, 2, 9}) {
        x = Eigen::VectorXd::LinSpaced(rows, 1, double(rows));
        CHECK(x.size() == rows);
        CHECK(x.data() == place);
        CHECK(x[rows - 1] == double(rows));
    }
    x.reserve(3); // less than there is
    CHECK(x.data() == place);
    x.reserve(1000);
    CHECK(x == Eigen::VectorXd::LinSpaced(9, 1, 9));
    x.setZero(3);
    CHECK(x == Eigen::VectorXd::Zero(3));
}

TEST_CASE("a growing column is a vector, and a value", "[motion][implicit]") {
    GrowingColumn<float> x, y;
    x = Eigen::VectorXf::LinSpaced(5, 1, 5);
    y = 2 * x + x; // another length than it had
    y -= x;
    CHECK(y == 2 * x);
    auto copy = y;
    CHECK(copy.data() != y.data());
    y[0] = 7;
    CHECK(copy[0] == 2);
    const float* const place = y.data();
    y.swap(x);
    CHECK(x.data() == place);
    CHECK(y[0] == 1);
    GrowingColumn<float> moved = std::move(x);
    CHECK(moved.data() == place);
    CHECK(moved[0] == 7);
    copy = moved;
    CHECK(copy == moved);
    CHECK(copy.data() != place);
}
