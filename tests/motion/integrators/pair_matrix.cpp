// SPDX-License-Identifier: BSL-1.0
// A matrix that is a list of pairs: beside the same as a dense one.

#include <ansatz/motion/integrators/pair_matrix.hpp>

#include "tests/catch.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <random>
#include <type_traits>
#include <utility>

using namespace ansatz;
using Catch::Approx;

namespace {

/// Masses, springs, springs to points, and couplings whose blocks are no springs', in any order; and the same, dense.
template <class T, int d> struct Both {
    using Block = Eigen::Matrix<T, d, d>;
    using Vec = Eigen::Matrix<T, d, 1>;
    PairMatrix<T, d> pairs;
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> dense;
    std::size_t springs = 0, others = 0;

    Both(int bodies, unsigned seed) { fill(bodies, seed); }
    void fill(int bodies, unsigned seed) {
        std::mt19937 random(seed);
        const auto number = [&] { return T(double(random()) / double(random.max()) - 0.5); };
        const auto vec = [&] { return Vec(Vec::NullaryExpr(number)); };
        pairs.clear(bodies);
        dense.setZero(bodies * d, bodies * d);
        springs = others = 0;
        const auto at = [&](int i, int j) { return dense.template block<d, d>(i * d, j * d); };
        for (int n = 0; n < 5 * bodies; ++n) {
            const int a = int(random() % unsigned(bodies)), b = int(random() % unsigned(bodies));
            const Vec axis = vec(), other = vec();
            const Block along = axis * axis.transpose(), k = T(10) * along, mixed = T(2) * axis * other.transpose();
            switch (random() % 3) {
            case 0: // a spring, or one that ends in one body, which is nothing
                if (random() % 2 == 0) pairs.add_both(a, b, k);
                else {
                    pairs.add(a, k);
                    pairs.add(b, k);
                    pairs.add(a, b, Block(-k));
                }
                at(a, a) += k;
                at(b, b) += k;
                at(a, b) -= k;
                at(b, a) -= k;
                springs += a != b;
                break;
            case 1: // to a point
                pairs.add(a, k);
                at(a, a) += k;
                break;
            default: // of a constraint of several bodies
                if (a == b) break;
                pairs.add(a, Block(T(3) * axis * axis.transpose()));
                pairs.add(b, Block(T(3) * other * other.transpose()));
                pairs.add(a, b, mixed);
                at(a, a) += T(3) * axis * axis.transpose();
                at(b, b) += T(3) * other * other.transpose();
                at(a, b) += mixed;
                at(b, a) += mixed.transpose();
                ++others;
            }
        }
        for (int i = 0; i < bodies; ++i) {
            pairs.add(i, Block(Block::Identity()));
            at(i, i) += Block::Identity();
        }
        pairs.finish();
    }
};

} // namespace

TEMPLATE_TEST_CASE_SIG("a matrix of pairs multiplies as the dense one, and is preconditioned by its blocks",
                       "[implicit]", ((class T, int d), T, d), (double, 3), (double, 2), (float, 3), (float, 2)) {
    using Column = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    const T close = std::is_same_v<T, float> ? T(2e-5) : T(1e-13);
    Both<T, d> both(1, 1);
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const int bodies = 1 + int(seed);
        both.fill(bodies, seed); // over what was there
        CHECK(both.pairs.bodies() == bodies);
        CHECK(both.pairs.springs() == both.springs);
        CHECK(both.pairs.others() == both.others);
        const Column x = Column::LinSpaced(bodies * d, T(-1), T(2));
        Column y;
        both.pairs.multiply(x, y);
        const Column truth = both.dense * x;
        CHECK((y - truth).norm() <= close * both.dense.norm() * x.norm());
        both.pairs.precondition(x, y);
        for (int i = 0; i < bodies; ++i) {
            const Eigen::Matrix<T, d, d> own = both.dense.template block<d, d>(i * d, i * d);
            const Eigen::Matrix<T, d, 1> back = own * y.template segment<d>(i * d);
            CHECK((back - x.template segment<d>(i * d)).norm() <= 100 * close * own.norm() * y.norm());
        }
    }
}

TEST_CASE("bodies that a spring holds move along with each other as if it were not there, to the last digit",
          "[implicit]") {
    PairMatrix<float, 3> m;
    using Block = Eigen::Matrix3f;
    m.clear(2);
    const Block k = 1e9f * Block::Identity(), one = Block::Identity();
    m.add(0, k);
    m.add(1, k);
    m.add(0, 1, Block(-k));
    m.add(0, one);
    m.add(1, one);
    m.finish();
    Eigen::VectorXf x = Eigen::VectorXf::Constant(6, 0.3f), y;
    m.multiply(x, y);
    CHECK(y == x);
}

TEST_CASE("a preconditioner is positive whatever the blocks are, and does not depend on their size", "[implicit]") {
    using Block = Eigen::Matrix3d;
    PairMatrix<double, 3> m;
    m.clear(4);
    Block turned;
    turned << 2, 1, 0, 1, 3, 1, 0, 1, 4;
    m.add(0, Block(1e-200 * turned));
    m.add(1, Block(1e200 * turned));
    m.add(2, Block(-turned)); // has no factors
    m.add(3, Block(Block::Zero()));
    m.finish();
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(12, 1, 2);
    Eigen::VectorXd y;
    m.precondition(x, y);
    const Eigen::Vector3d small = turned.ldlt().solve(x.segment<3>(0)), large = turned.ldlt().solve(x.segment<3>(3));
    CHECK((1e-200 * y.segment<3>(0) - small).norm() <= 1e-14 * small.norm());
    CHECK((1e200 * y.segment<3>(3) - large).norm() <= 1e-14 * large.norm());
    for (int i = 6; i < 12; ++i) CHECK((std::isfinite(y[i]) && y[i] > 0));
}
