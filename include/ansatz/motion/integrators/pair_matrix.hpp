// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `PairMatrix`: the symmetric matrix of an implicit step as a list of the pairs of bodies that act on each other,
/// which is never put together.
// not in the umbrella: only worlds that couple bodies and solve by MatrixFree need it
///
/// Use it for implicit integrators of your own that only ever multiply by the matrix, as conjugate gradients do: it is
/// filled by one pass over the springs, has no pattern that could grow old, and takes a third of the memory of a sparse
/// matrix. A spring between two bodies is kept as what it is, a block that acts on the difference of two vectors,
/// \f$ y_a \mathrel{+}= K(x_a - x_b),\; y_b \mathrel{-}= K(x_a - x_b) \f$, which is half of the multiplications and says to the
/// last digit that nothing happens to a body that moves along with its neighbours. Where blocks are wanted by their
/// place, by factors for example, take BlockMatrix.
///
/// Loops are written out in one order, so that every build comes to the same bits.

#include <ansatz/motion/integrators/group_correction.hpp>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ansatz {

/// \tparam Scalar    float or double
/// \tparam dimension rows and columns of a block
template <class Scalar, int dimension> class PairMatrix {
public:
    using Block = Eigen::Matrix<Scalar, dimension, dimension>;     ///< one body by another
    using Index = Eigen::Index;                                    ///< counts bodies
    static constexpr int packed = dimension * (dimension + 1) / 2; ///< numbers of a symmetric block

    /// Makes room for so many pairs, so that what comes to be coupled later (a rope that becomes taut) allocates
    /// nothing.
    void reserve(std::size_t pairs) {
        springs_.reserve(pairs);
        pairs_.reserve(pairs);
    }
    /// Makes room for so many bodies, so that one that a step makes by dividing another allocates nothing.
    void reserve_bodies(std::size_t bodies) {
        own_.reserve(bodies);
        alone_.reserve(bodies);
        products_.reserve(bodies);
        inverse_.reserve(bodies);
        groups_.reserve(bodies);
    }
    /// Says which bodies may be coupled and move, by all of whom `precondition` then moves groups as wholes; without
    /// it, each body by its own block alone. Where the pairs are the same as last time, nothing is done.
    /// \param each_pair calls a function with the two bodies of each pair
    void group(Index bodies, const auto& each_pair) { groups_.group(std::size_t(bodies), each_pair); }
    /// Forgets everything; the room stays.
    void clear(Index bodies) {
        own_.assign(std::size_t(bodies), Block::Zero());
        alone_.assign(std::size_t(bodies), Block::Zero());
        springs_.clear();
        pairs_.clear();
        waiting_ = 0;
    }
    /// Adds to the block of body i by itself.
    void add(Index i, const Block& block) {
        own_[std::size_t(i)] += block;
        if (waiting_ == 2) {
            release(0);
            kept_[0] = kept_[1];
            waiting_ = 1;
        }
        kept_[std::size_t(waiting_++)] = {i, block};
    }
    /// Adds a block of body i by body j, and its transpose to that of j by i. One that follows upon the opposite block
    /// of both by themselves is a spring between them.
    void add(Index i, Index j, const Block& block) {
        if (i == j) {
            add(i, Block(block + block.transpose()));
            return;
        }
        if (is_spring(i, j, block)) {
            Spring spring{int(i), int(j), {}};
            pack(-block, spring.block);
            springs_.push_back(spring);
            waiting_ = 0;
        } else pairs_.push_back({int(i), int(j), block});
    }
    /// Adds a block to those of both bodies by themselves, its opposite to that of i by j, and the transpose of that to
    /// the one of j by i.
    void add_both(Index i, Index j, const Block& block) {
        if (i == j || block != block.transpose()) {
            add(i, block);
            add(j, block);
            add(i, j, Block(-block));
            return;
        }
        own_[std::size_t(i)] += block;
        own_[std::size_t(j)] += block;
        springs_.push_back({int(i), int(j), {}});
        pack(block, springs_.back().block);
    }
    /// Behind all that was added, before anything is multiplied: what both bodies of no spring have is theirs alone.
    void finish() {
        for (int k = 0; k < waiting_; ++k) release(std::size_t(k));
        waiting_ = 0;
        products_.resize(own_.size());
        inverse_.resize(own_.size());
        for (std::size_t i = 0; i < own_.size(); ++i) invert(own_[i], inverse_[i]);
        add_to_groups();
    }
    /// Bodies.
    Index bodies() const { return Index(own_.size()); }
    /// The number of a row on the diagonal.
    const Scalar& diagonal(Index row) const {
        return own_[std::size_t(row / dimension)](row % dimension, row % dimension);
    }
    /// Pairs that are kept as springs.
    std::size_t springs() const { return springs_.size(); }
    /// Pairs whose block is not symmetric or not that of both bodies by themselves.
    std::size_t others() const { return pairs_.size(); }

    /// \f$ y = A x \f$; not from two threads at once, which would share the room for it.
    /// \param x,y one of Eigen's vectors, or a GrowingColumn, each
    template <class X, class Y> void multiply(const X& x, Y& y) const {
        y.resize(x.size());
        const Scalar* in = x.data();
        Scalar* out = y.data();
        Product* products = products_.data();
        for (std::size_t i = 0; i < alone_.size(); ++i) {
            Product& of = products[i];
            for (int c = 0; c < dimension; ++c) of.in[c] = in[i * dimension + std::size_t(c)];
            for (int r = 0; r < dimension; ++r) {
                Scalar sum = alone_[i](r, 0) * of.in[0];
                for (int c = 1; c < dimension; ++c) sum += alone_[i](r, c) * of.in[c];
                of.out[r] = sum;
            }
        }
        for (const Spring& s : springs_) {
            Product &a = products[s.a], &b = products[s.b];
            const Wide apart = a.in - b.in;
            Wide pull = s.column(0) * apart[0];
            for (int c = 1; c < dimension; ++c) pull += s.column(c) * apart[c];
            a.out += pull;
            b.out -= pull;
        }
        for (std::size_t i = 0; i < alone_.size(); ++i)
            for (int r = 0; r < dimension; ++r) out[i * dimension + std::size_t(r)] = products[i].out[r];
        for (const Pair& p : pairs_)
            for (int r = 0; r < dimension; ++r)
                for (int c = 0; c < dimension; ++c) {
                    out[std::ptrdiff_t(p.a) * dimension + r] += p.block(r, c) * in[std::ptrdiff_t(p.b) * dimension + c];
                    out[std::ptrdiff_t(p.b) * dimension + r] += p.block(c, r) * in[std::ptrdiff_t(p.a) * dimension + c];
                }
    }
    /// \f$ y = D^{-1} x \f$, D being the blocks of the bodies by themselves (block Jacobi), and what groups of bodies
    /// move as wholes (group_correction.hpp): the preconditioner. Not from two threads at once.
    template <class X, class Y> void precondition(const X& x, Y& y) const {
        y.resize(x.size());
        for (std::size_t i = 0; i < inverse_.size(); ++i)
            apply(inverse_[i], x.data() + i * dimension, y.data() + i * dimension);
        groups_.correct(x.data(), y.data());
    }
    /// The groups that it moves as wholes.
    const GroupCorrection<Scalar, dimension>& groups() const { return groups_; }

private:
    using Packed = std::array<Scalar, std::size_t(packed)>; // 3 x 3: xx, xy, xz, yy, yz, zz
    // As many numbers as vector units take at once: what a body has, or a column of a block. What stands behind the
    // last component is of no meaning; in a column it repeats a number of the block, since with a zero there
    // g++ 12 makes a solve that takes five times as long.
    using Wide = Eigen::Array<Scalar, dimension == 3 ? 4 : dimension, 1>;
    struct Spring {
        int a, b;
        Packed block; // of either by itself
        [[gnu::always_inline]] Wide column(int c) const {
            if constexpr (dimension == 2) return Wide(block[std::size_t(c)], block[std::size_t(c + 1)]);
            else if (c == 0) return Wide(block[0], block[1], block[2], block[3]);
            else if (c == 1) return Wide(block[1], block[3], block[4], block[4]);
            else return Wide(block[2], block[4], block[5], block[5]);
        }
    };
    struct Product { // what a body is multiplied with, and what it comes to
        Wide in = Wide::Zero(), out = Wide::Zero();
    };
    struct Pair {
        int a, b;
        Block block; // of a by b
    };
    struct Waiting {
        Index body = 0;
        Block block = Block::Zero();
    };

    void add_to_groups() {
        groups_.clear();
        if (!groups_.wanted()) return;
        for (std::size_t i = 0; i < alone_.size(); ++i) groups_.add(i, alone_[i]);
        for (const Spring& s : springs_) groups_.add_spring(std::size_t(s.a), std::size_t(s.b), unpacked(s.block));
        for (const Pair& p : pairs_) groups_.add(std::size_t(p.a), std::size_t(p.b), p.block);
        groups_.finish();
    }
    static Block unpacked(const Packed& from) {
        Block block;
        std::size_t k = 0;
        for (int r = 0; r < dimension; ++r)
            for (int c = r; c < dimension; ++c) block(r, c) = block(c, r) = from[k++];
        return block;
    }
    void release(std::size_t k) { alone_[std::size_t(kept_[k].body)] += kept_[k].block; }
    bool is_spring(Index i, Index j, const Block& block) const {
        if (waiting_ != 2) return false;
        const bool theirs = (kept_[0].body == i && kept_[1].body == j) || (kept_[0].body == j && kept_[1].body == i);
        return theirs && kept_[0].block == -block && kept_[1].block == -block && block == block.transpose();
    }
    static void pack(const Block& block, Packed& into) {
        std::size_t k = 0;
        for (int r = 0; r < dimension; ++r)
            for (int c = r; c < dimension; ++c) into[k++] = block(r, c);
    }
    [[gnu::always_inline]] static void apply(const Packed& m, const Scalar* x, Scalar* y) {
        if constexpr (dimension == 3) {
            y[0] = m[0] * x[0] + m[1] * x[1] + m[2] * x[2];
            y[1] = m[1] * x[0] + m[3] * x[1] + m[4] * x[2];
            y[2] = m[2] * x[0] + m[4] * x[1] + m[5] * x[2];
        } else {
            y[0] = m[0] * x[0] + m[1] * x[1];
            y[1] = m[1] * x[0] + m[2] * x[1];
        }
    }
    /// By Cholesky's factors, which neither overflow nor vanish where a determinant would. A block that has none is
    /// taken by its diagonal: a preconditioner may be anything that is positive.
    static void invert(const Block& block, Packed& into) {
        using std::abs;
        using std::sqrt;
        Scalar lower[dimension][dimension] = {}, back[dimension][dimension] = {};
        bool positive = true;
        for (int c = 0; c < dimension; ++c)
            for (int r = c; r < dimension; ++r) {
                Scalar rest = (block(r, c) + block(c, r)) / 2;
                for (int k = 0; k < c; ++k) rest -= lower[r][k] * lower[c][k];
                if (r == c) {
                    positive = positive && rest > Scalar(0);
                    lower[r][c] = positive ? Scalar(sqrt(rest)) : Scalar(1);
                } else lower[r][c] = rest / lower[c][c];
            }
        for (int c = 0; c < dimension; ++c) // the inverse of the factor, column by column
            for (int r = c; r < dimension; ++r) {
                Scalar rest(r == c ? 1 : 0);
                for (int k = c; k < r; ++k) rest -= lower[r][k] * back[k][c];
                back[r][c] = rest / lower[r][r];
            }
        std::size_t at = 0;
        for (int r = 0; r < dimension; ++r)
            for (int c = r; c < dimension; ++c) {
                Scalar sum(0);
                for (int k = c; k < dimension; ++k) sum += back[k][r] * back[k][c];
                if (!positive) sum = r == c && block(r, r) != Scalar(0) ? Scalar(1) / abs(block(r, r)) : Scalar(r == c);
                into[at++] = sum;
            }
    }

    std::vector<Block> own_, alone_; // all of a body's, and that part which is no spring's
    std::vector<Spring> springs_;
    std::vector<Pair> pairs_;
    mutable std::vector<Product> products_; // room for multiply
    std::vector<Packed> inverse_;
    GroupCorrection<Scalar, dimension> groups_;
    std::array<Waiting, 2> kept_; // blocks of bodies by themselves, whose bodies are not known yet
    int waiting_ = 0;
};

} // namespace ansatz
