// SPDX-License-Identifier: BSL-1.0
// Groups that move as wholes: the same as with dense matrices, and what they save.

#include <ansatz/motion/integrators/group_correction.hpp>

#include <ansatz/motion/integrators/matrix_free.hpp>
#include <ansatz/motion/integrators/pair_matrix.hpp>

#include "tests/catch.hpp"
#include "tests/dice.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

using namespace ansatz;

namespace {

template <class T> using Dense = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
template <class T> using Numbers = Eigen::Matrix<T, Eigen::Dynamic, 1>;

/// Springs between neighbours of a row and some others, masses, and couplings that are no springs'; and the same,
/// dense.
template <class T, int d> struct Both {
    using Block = Eigen::Matrix<T, d, d>;
    using Vec = Eigen::Matrix<T, d, 1>;
    GroupCorrection<T, d> groups;
    Dense<T> dense;

    Both(int bodies, std::uint64_t seed) { fill(bodies, seed); }
    void fill(int bodies, std::uint64_t seed) {
        test::Dice dice(seed);
        const auto vec = [&] { return Vec(Vec::NullaryExpr([&] { return T(dice.number(-1, 1)); })); };
        std::vector<std::pair<int, int>> pairs;
        for (int n = 0; n + 1 < bodies; ++n) // the last fifth is coupled to nothing
            if (n < bodies * 4 / 5) pairs.emplace_back(n, dice.one_in(4) ? dice.below(n + 1) : n + 1);
        groups.group(std::size_t(bodies), [&](const auto& f) {
            for (const auto& [a, b] : pairs) f(std::size_t(a), std::size_t(b));
        });
        groups.clear();
        dense.setZero(bodies * d, bodies * d);
        const auto at = [&](int i, int j) { return dense.template block<d, d>(i * d, j * d); };
        for (const auto& [a, b] : pairs) {
            const Vec axis = vec();
            const Block k = T(10) * axis * axis.transpose();
            if (dice.one_in(3)) { // no spring's
                const Block mixed = T(0.2) * axis * vec().transpose();
                groups.add(std::size_t(a), std::size_t(b), mixed);
                at(a, b) += mixed;
                at(b, a) += mixed.transpose();
            } else {
                groups.add_spring(std::size_t(a), std::size_t(b), k);
                at(a, a) += k, at(b, b) += k;
                at(a, b) -= k, at(b, a) -= k;
            }
        }
        for (int i = 0; i < bodies; ++i) {
            const Block own = Block::Identity() * T(dice.number(2, 4));
            groups.add(std::size_t(i), own);
            at(i, i) += own;
        }
        groups.finish();
    }
    /// P E^-1 P^T x by dense matrices.
    Numbers<T> corrected(const Numbers<T>& x) const {
        const auto bodies = x.size() / d;
        Dense<T> P = Dense<T>::Zero(x.size(), Eigen::Index(groups.groups().size()) * d);
        for (Eigen::Index body = 0; body < bodies; ++body)
            if (const auto group = groups.groups().of(std::size_t(body)); group != BodyGroups::none)
                P.template block<d, d>(body * d, Eigen::Index(group) * d).setIdentity();
        const Dense<T> E = P.transpose() * dense * P;
        return P * E.ldlt().solve(P.transpose() * x).eval();
    }
};

/// The matrix of an implicit step of a sheet of 1 m, n x n, under tension.
struct SheetMatrix {
    PairMatrix<double, 3> matrix;
    Eigen::Index rows;
    SheetMatrix(int n, bool grouped) : rows(3 * n * n) {
        std::vector<std::pair<int, int>> pairs;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                if (i + 1 < n) pairs.emplace_back(j * n + i, j * n + i + 1);
                if (j + 1 < n) pairs.emplace_back(j * n + i, (j + 1) * n + i);
                if (i + 1 < n && j + 1 < n) pairs.emplace_back(j * n + i, (j + 1) * n + i + 1);
                if (i + 1 < n && j + 1 < n) pairs.emplace_back(j * n + i + 1, (j + 1) * n + i);
            }
        if (grouped)
            matrix.group(n * n, [&](const auto& f) {
                for (const auto& [a, b] : pairs) f(std::size_t(a), std::size_t(b));
            });
        matrix.clear(n * n);
        for (const auto& [a, b] : pairs) {
            const Eigen::Vector3d axis = Eigen::Vector3d(b % n - a % n, b / n - a / n, 0).normalized();
            const Eigen::Matrix3d along = axis * axis.transpose();
            matrix.add_both(a, b, Eigen::Matrix3d(along + 0.2 * (Eigen::Matrix3d::Identity() - along)));
        }
        for (int i = 0; i < n * n; ++i) matrix.add(i, Eigen::Matrix3d(Eigen::Matrix3d::Identity() * (3.0 / (n * n))));
        matrix.finish();
    }
    Eigen::Index iterations(double leave) {
        MatrixFree::Solver<double> solver;
        Eigen::VectorXd x;
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(rows, -1, 2), weight = Eigen::VectorXd::Ones(rows);
        REQUIRE(solver.solve(matrix, b, weight, x, leave));
        return solver.iterations();
    }
};

} // namespace

TEMPLATE_TEST_CASE_SIG("what groups move is what dense matrices say", "[springs][implicit]", ((class T, int d), T, d),
                       (float, 2), (float, 3), (double, 2), (double, 3)) {
    const T close = T(std::is_same_v<T, float> ? 1e-4 : 1e-12);
    Both<T, d> both(1, 1);
    CHECK_FALSE(both.groups.works());
    for (const int bodies : {200, 201, 400, 100, 400, 300}) { // the same object: smaller again, and the same again
        both.fill(bodies, std::uint64_t(bodies));
        REQUIRE(both.groups.works());
        const Numbers<T> x = Numbers<T>::LinSpaced(bodies * d, -1, 3);
        Numbers<T> y = Numbers<T>::Ones(x.size());
        both.groups.correct(x.data(), y.data());
        const Numbers<T> wanted = both.corrected(x) + Numbers<T>::Ones(x.size());
        CHECK((y - wanted).norm() <= close * wanted.norm());
        for (int body = 0; body < bodies; ++body)
            if (both.groups.groups().of(std::size_t(body)) == BodyGroups::none)
                CHECK((y.segment(body * d, d).array() == T(1)).all()); // they stay as they are
    }
}

TEST_CASE("what cannot be factored, or was not said to be coupled, is left out", "[springs][implicit]") {
    using Block = Eigen::Matrix3d;
    constexpr std::size_t bodies = 160;
    GroupCorrection<double, 3> groups;
    const auto rope = [](const auto& f) {
        for (std::size_t n = 0; n < 159; ++n) f(n, n + 1);
    };
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(3 * bodies, -1, 3);
    for (const double own :
         {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        groups.group(bodies, rope);
        groups.clear();
        for (std::size_t n = 0; n < bodies; ++n) groups.add(n, Block(own * Block::Identity()));
        groups.finish();
        CHECK_FALSE(groups.works());
        Eigen::VectorXd y = Eigen::VectorXd::Ones(3 * bodies);
        groups.correct(x.data(), y.data());
        CHECK(y == Eigen::VectorXd::Ones(3 * bodies));
    }
    // Both ends, and a body that there is not: nothing of them, and nothing is written where nothing stands.
    Eigen::VectorXd before;
    for (const bool more : {false, true}) {
        groups.group(bodies, rope);
        groups.clear();
        for (std::size_t n = 0; n < bodies; ++n) groups.add(n, Block::Identity());
        if (more) {
            groups.add(bodies - 1, std::size_t(0), Block(0.5 * Block::Identity()));
            groups.add(std::size_t(1000), std::size_t(0), Block::Identity());
            groups.add(std::size_t(1000), Block::Identity());
        }
        groups.finish();
        REQUIRE(groups.works());
        Eigen::VectorXd y = Eigen::VectorXd::Zero(3 * bodies);
        groups.correct(x.data(), y.data());
        if (more) CHECK(y == before);
        before = y;
    }
}

TEST_CASE("with groups, iterations are fewer, and grow less with the sheet", "[springs][implicit]") {
    Eigen::Index last = 0, last_alone = 0;
    for (const int n : {24, 48}) {
        const auto alone = SheetMatrix(n, false).iterations(1e-10), grouped = SheetMatrix(n, true).iterations(1e-10);
        CAPTURE(n, alone, grouped);
        CHECK(3 * grouped <= 2 * alone);
        if (n == 48) {
            CHECK(3 * grouped <= alone);
            CHECK(double(grouped) / double(last) < 0.9 * double(alone) / double(last_alone));
        }
        last = grouped, last_alone = alone;
    }
}
