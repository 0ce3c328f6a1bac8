// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `GroupCorrection`: the second half of a preconditioner in two levels, which moves groups of bodies as wholes. Beyond
/// the notes.
// not in the umbrella: only worlds that couple bodies and solve by MatrixFree need it
///
/// An iteration of conjugate gradients carries information from a body to its neighbours, so that a sheet of n x n
/// bodies takes some n of them until one end knows that the other is held. Beside each body's own block, let every
/// group of neighbours (body_groups.hpp) move as a whole, by the exact solution of the small system that is left of the
/// matrix
/// then, \f$ E = P^T A P \f$, where P gives each body the movement of its group:
///
/// \f[ M^{-1} = D^{-1} + P\,E^{-1}P^T \f]
///
/// Information then crosses the sheet in one iteration. The solution is the same, since it is the residual that ends
/// the iterations and not the preconditioner.
///
/// E is factored by Cholesky inside its envelope: a row begins where its first number does, and groups that lie beside
/// each other have numbers near each other.
///
/// R. A. Nicolaides, Deflation of Conjugate Gradients with Applications to Boundary Value Problems, SIAM J. Numer.
/// Anal. 24 (1987); B. Smith, P. Bjorstad, W. Gropp, Domain Decomposition (1996), for two levels that are added.

#include <ansatz/motion/integrators/body_groups.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ansatz {

namespace detail {
/// The sum of `f(i)` for i below n, in four parts that are added in one order: what vector units do, and the same bits
/// in every build.
template <class Scalar, class F> [[gnu::always_inline]] inline Scalar sum_in_four(Eigen::Index n, F&& f) {
    std::array<Scalar, 4> part{};
    const auto whole = n / 4 * 4;
    for (Eigen::Index i = 0; i < whole; i += 4)
        for (int k = 0; k < 4; ++k) part[std::size_t(k)] += f(i + k);
    for (Eigen::Index i = whole; i < n; ++i) part[std::size_t(i - whole)] += f(i);
    return (part[0] + part[1]) + (part[2] + part[3]);
}
} // namespace detail

/// \tparam Scalar    float or double
/// \tparam dimension numbers of a body
template <class Scalar, int dimension> class GroupCorrection {
public:
    using Block = Eigen::Matrix<Scalar, dimension, dimension>; ///< one group by another

    /// Room for so many bodies; for pairs and the factor there is room for twice as many as there have been.
    void reserve(std::size_t bodies) {
        groups_.reserve(bodies);
        const std::size_t groups = bodies / BodyGroups::fewest, rows = dim * groups;
        begin_.reserve(groups);
        first_.reserve(rows);
        sums_.reserve(rows);
        rows_.reserve(std::min<std::size_t>(rows * (rows + 1) / 2, 1 << 14)); // of a small system the whole
    }
    /// Makes the groups, where the pairs are others than last time. Pairs that are added to the matrix and are none of
    /// these are left out of the correction.
    /// \param each_pair calls a function with the two bodies of each pair that may be coupled and that move
    void group(std::size_t bodies, const auto& each_pair) {
        std::size_t next = 0;
        if (bodies != bodies_) bodies_ = 0; // until it is done
        each_pair([&](std::size_t a, std::size_t b) {
            const std::array pair{std::uint32_t(a), std::uint32_t(b)};
            if (next < pairs_.size() && pairs_[next] != pair) bodies_ = 0, pairs_[next] = pair;
            if (next == pairs_.size()) {
                bodies_ = 0;
                if (pairs_.capacity() == next) pairs_.reserve(std::max<std::size_t>(64, 2 * next));
                pairs_.push_back(pair);
            }
            ++next;
        });
        if (next != pairs_.size()) bodies_ = 0, pairs_.resize(next);
        if (bodies_ == bodies) return;
        const auto again = [this](const auto& f) {
            for (const auto& pair : pairs_) f(pair[0], pair[1]);
        };
        groups_.make(bodies, again);
        lay_out(again);
        bodies_ = bodies;
    }
    /// Whether there are groups that may move against each other; otherwise nothing need be added.
    bool wanted() const { return bodies_ > 0 && groups_.size() > 1; }
    /// Before a matrix is added.
    void clear() {
        std::fill(rows_.begin(), rows_.end(), Scalar(0));
        works_ = false;
    }
    /// Adds the block of a body by itself.
    [[gnu::always_inline]] void add(std::size_t body, const Block& block) {
        if (const auto group = group_of(body); group != BodyGroups::none) put(group, group, block);
    }
    /// Adds the block of a body by another, and its transpose to that of the other by it.
    [[gnu::always_inline]] void add(std::size_t a, std::size_t b, const Block& block) {
        const auto i = group_of(a), j = group_of(b);
        if (i == BodyGroups::none || j == BodyGroups::none) return;
        if (i == j) put(i, i, Block(block + block.transpose()));
        else if (i > j) put(i, j, block);
        else put(j, i, Block(block.transpose()));
    }
    /// Adds a spring between two bodies: a block to both by themselves, its opposite to one by the other.
    [[gnu::always_inline]] void add_spring(std::size_t a, std::size_t b, const Block& block) {
        const auto i = group_of(a), j = group_of(b);
        if (i == j) return; // within a group it pulls at nothing
        if (i != BodyGroups::none) put(i, i, block);
        if (j != BodyGroups::none) put(j, j, block);
        if (i != BodyGroups::none && j != BodyGroups::none)
            put(std::max(i, j), std::min(i, j), Block(-block)); // it is symmetric
    }
    /// After everything has been added. A matrix that is not positive definite has no factor, and is not used.
    void finish() { works_ = wanted() && factor(); }
    /// Whether there is anything to correct.
    bool works() const { return works_; }
    /// The groups.
    const BodyGroups& groups() const { return groups_; }

    /// Adds \f$ P\,E^{-1}P^T x \f$ to y; not from two threads at once, which would share the room for it.
    void correct(const Scalar* x, Scalar* y) const {
        if (!works_) return;
        std::fill(sums_.begin(), sums_.end(), Scalar(0));
        for (std::size_t body = 0; body < bodies_; ++body)
            if (const std::size_t group = groups_.of(body); group != BodyGroups::none)
                for (std::size_t k = 0; k < dim; ++k) sums_[dim * group + k] += x[dim * body + k];
        substitute();
        for (std::size_t body = 0; body < bodies_; ++body)
            if (const std::size_t group = groups_.of(body); group != BodyGroups::none)
                for (std::size_t k = 0; k < dim; ++k) y[dim * body + k] += sums_[dim * group + k];
    }

private:
    static constexpr std::size_t dim = std::size_t(dimension);

    std::uint32_t group_of(std::size_t body) const { return body < bodies_ ? groups_.of(body) : BodyGroups::none; }
    /// Where the rows of the factor begin.
    void lay_out(const auto& each_pair) {
        const std::size_t size = dim * groups_.size();
        begin_.resize(groups_.size());
        for (std::size_t group = 0; group < groups_.size(); ++group) begin_[group] = std::uint32_t(group);
        each_pair([&](std::size_t a, std::size_t b) {
            const auto i = groups_.of(a), j = groups_.of(b);
            if (i == BodyGroups::none || j == BodyGroups::none) return;
            auto& begin = begin_[std::max(i, j)];
            begin = std::min(begin, std::min(i, j));
        });
        first_.resize(size);
        std::size_t end = 0;
        for (std::size_t row = 0; row < size; ++row) {
            first_[row] = end;
            end += row - start(row) + 1;
        }
        if (rows_.capacity() < end) rows_.reserve(2 * end); // a sheet that tears is coupled in another way
        rows_.resize(end);
        sums_.resize(size);
    }
    /// The first column of a row.
    std::size_t start(std::size_t row) const { return dim * begin_[row / dim]; }
    /// A row, as if it began at column 0. That is never before the list: every row above has at least its diagonal.
    Scalar* row_of(std::size_t row) { return rows_.data() + first_[row] - start(row); }
    const Scalar* row_of(std::size_t row) const { return rows_.data() + first_[row] - start(row); }
    /// Adds a block at or below the diagonal, unless its groups were not said to be coupled.
    [[gnu::always_inline]] void put(std::size_t i, std::size_t j, const Block& block) {
        if (j < begin_[i]) return;
        for (std::size_t r = 0; r < dim; ++r) {
            Scalar* row = row_of(dim * i + r) + dim * j;
            const std::size_t columns = i == j ? r + 1 : dim;
            for (std::size_t c = 0; c < columns; ++c) row[c] += block(Eigen::Index(r), Eigen::Index(c));
        }
    }
    [[gnu::always_inline]] static Scalar sum(const Scalar* a, const Scalar* b, std::size_t n) {
        return detail::sum_in_four<Scalar>(Eigen::Index(n), [&](Eigen::Index i) { return a[i] * b[i]; });
    }
    /// E = L L^T, row by row in place; on the diagonal stands the inverse of L's.
    /// \return whether it is positive definite
    bool factor() {
        using std::sqrt;
        for (std::size_t i = 0; i < sums_.size(); ++i) {
            Scalar* row = row_of(i);
            for (std::size_t j = start(i); j < i; ++j) {
                const Scalar* above = row_of(j);
                const std::size_t from = std::max(start(i), start(j));
                row[j] = (row[j] - (from < j ? sum(row + from, above + from, j - from) : Scalar(0))) * above[j];
            }
            const Scalar rest = row[i] - sum(row + start(i), row + start(i), i - start(i));
            if (!(rest > Scalar(0)) || !(rest <= std::numeric_limits<Scalar>::max())) return false;
            row[i] = 1 / sqrt(rest);
        }
        return true;
    }
    /// Solves for the sums.
    void substitute() const {
        Scalar* x = sums_.data();
        for (std::size_t i = 0; i < sums_.size(); ++i)
            x[i] = (x[i] - sum(row_of(i) + start(i), x + start(i), i - start(i))) * row_of(i)[i];
        for (std::size_t i = sums_.size(); i-- > 0;) {
            const Scalar* row = row_of(i);
            const Scalar value = x[i] *= row[i];
            for (std::size_t j = start(i); j < i; ++j) x[j] -= value * row[j];
        }
    }

    BodyGroups groups_;
    std::vector<std::array<std::uint32_t, 2>> pairs_; // of which the groups were made
    std::size_t bodies_ = 0;                          // how many; 0 where there are no groups yet
    std::vector<std::uint32_t> begin_;                // the first group to which each is coupled
    std::vector<std::size_t> first_;                  // where a row stands
    std::vector<Scalar> rows_;                        // E, then its factor
    mutable std::vector<Scalar> sums_;                // one for each row
    bool works_ = false;
};

} // namespace ansatz
