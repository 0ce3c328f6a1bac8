// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `BlockMatrix`: the sparse, symmetric matrix of an implicit step, in blocks of one body by another, on Eigen's sparse
/// module.
// not in the umbrella: only worlds that couple bodies and solve need it, and Eigen's sparse module takes half a second
///
/// Where the blocks are, the pattern, is found once and kept as long as every block that is wanted has a place in it: a
/// spring that breaks or a body that sleeps leaves zeros behind, and only a spring that is added makes a new pattern.
/// So a step that is warm allocates nothing. Use it for implicit integrators of your own.

#include <ansatz/core/compiler_flags.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

/// \tparam Scalar    float or double
/// \tparam dimension rows and columns of a block
template <class Scalar, int dimension> class BlockMatrix {
public:
    /// As Eigen keeps it: by columns. The matrix is symmetric, so that what is a row here is a column there, and a
    /// product with its transpose gathers where one with itself would scatter.
    using Matrix = Eigen::SparseMatrix<Scalar, Eigen::ColMajor, int>;
    using Block = Eigen::Matrix<Scalar, dimension, dimension>; ///< one body by another
    using Index = Eigen::Index;                                ///< counts bodies

    /// The matrix.
    const Matrix& matrix() const { return matrix_; }
    /// Bodies.
    Index bodies() const { return Index(first_.empty() ? 0 : first_.size() - 1); }

    /// Makes the pattern: the diagonal, and both blocks of every pair. All values are zero then.
    /// \param pairs bodies that act on each other; in any order, doubled or not; sorted when it returns
    void make_pattern(Index bodies, std::vector<std::pair<int, int>>& pairs) {
        const auto given = pairs.size();
        for (std::size_t k = 0; k < given; ++k) pairs.emplace_back(pairs[k].second, pairs[k].first);
        for (int i = 0; i < int(bodies); ++i) pairs.emplace_back(i, i);
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

        first_.assign(std::size_t(bodies) + 1, 0);
        column_.resize(pairs.size());
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            ++first_[std::size_t(pairs[k].first) + 1];
            column_[k] = pairs[k].second;
        }
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];

        matrix_.resize(bodies * dimension, bodies * dimension);
        matrix_.resizeNonZeros(Index(pairs.size()) * dimension * dimension);
        for (Index i = 0; i < bodies; ++i)
            for (int r = 0; r < dimension; ++r) {
                auto at = place(i, first_[std::size_t(i)], r);
                matrix_.outerIndexPtr()[i * dimension + r] = int(at);
                for (auto k = first_[std::size_t(i)]; k < first_[std::size_t(i) + 1]; ++k)
                    for (int c = 0; c < dimension; ++c) matrix_.innerIndexPtr()[at++] = column_[k] * dimension + c;
            }
        matrix_.outerIndexPtr()[bodies * dimension] = int(pairs.size()) * dimension * dimension;
        set_zero();
    }
    /// All values zero; the pattern stays.
    void set_zero() { std::fill_n(matrix_.valuePtr(), matrix_.data().size(), Scalar(0)); }
    /// Adds to the block of body i by body j.
    /// \return whether the pattern has a place for it
    template <class B> bool add(Index i, Index j, const B& block) {
        const auto begin = column_.begin() + std::ptrdiff_t(first_[std::size_t(i)]),
                   end = column_.begin() + std::ptrdiff_t(first_[std::size_t(i) + 1]);
        const auto found = std::lower_bound(begin, end, int(j));
        if (found == end || *found != int(j)) return false;
        for (int r = 0; r < dimension; ++r) {
            Scalar* value = matrix_.valuePtr() + place(i, std::size_t(found - column_.begin()), r);
            for (int c = 0; c < dimension; ++c) value[c] += block(r, c);
        }
        return true;
    }

private:
    /// Where row r of the k-th block stands among the values.
    Index place(Index i, std::size_t k, int r) const {
        const auto first = Index(first_[std::size_t(i)]), blocks = Index(first_[std::size_t(i) + 1]) - first;
        return (first * dimension + r * blocks + (Index(k) - first)) * dimension;
    }

    Matrix matrix_;
    std::vector<std::size_t> first_; // of each body's blocks
    std::vector<int> column_;        // which body a block is by
};

} // namespace ansatz
