// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `GrowingColumn`: one of Eigen's vectors that becomes longer in the room that was made for it.
// not in the umbrella: only integrators that solve for all bodies at once need it
///
/// Use it for what an integrator of your own keeps from step to step with a row for each component of each body. An
/// `Eigen::VectorXd` takes new memory whenever its length changes, so that a step in which a vertex splits would
/// allocate; this does so only where `reserve` was not told. In expressions it is a vector like any other.

#include <ansatz/world/lanes.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <new>
#include <vector>

namespace ansatz {

/// \tparam Scalar float or double
template <class Scalar>
class GrowingColumn : public Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, 1>, Eigen::AlignedMax> {
    using View = Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, 1>, Eigen::AlignedMax>;

public:
    using Index = Eigen::Index; ///< counts rows

    GrowingColumn() : View(nullptr, 0) {}
    /// A copy has no more room than it needs.
    GrowingColumn(const GrowingColumn& other) : View(nullptr, 0), numbers_(other.numbers_) { rebind(); }
    /// Leaves the other empty.
    GrowingColumn(GrowingColumn&& other) noexcept : View(nullptr, 0) { swap(other); }
    /// The values of another; the room that is here stays.
    GrowingColumn& operator=(const GrowingColumn& other) {
        numbers_ = other.numbers_;
        rebind();
        return *this;
    }
    /// Exchanges both with their room.
    GrowingColumn& operator=(GrowingColumn&& other) noexcept {
        swap(other);
        return *this;
    }
    ~GrowingColumn() = default;
    /// Takes the length and the values of an expression.
    template <class E> GrowingColumn& operator=(const Eigen::DenseBase<E>& values) {
        resize(values.size());
        View::operator=(values.derived());
        return *this;
    }

    /// Makes room for so many rows.
    void reserve(std::size_t rows) {
        if (rows <= numbers_.capacity()) return;
        numbers_.reserve(rows);
        rebind();
    }
    /// Another length; what was there stays.
    void resize(Index rows) {
        if (rows == this->size()) return;
        numbers_.resize(std::size_t(rows));
        rebind();
    }
    /// So many zeros.
    void setZero(Index rows) {
        resize(rows);
        View::setZero();
    }
    /// Exchanges both with their room; nothing is copied.
    void swap(GrowingColumn& other) noexcept {
        numbers_.swap(other.numbers_);
        rebind();
        other.rebind();
    }

private:
    /// The way in which Eigen lets a Map be given another place.
    void rebind() noexcept { new (static_cast<View*>(this)) View(numbers_.data(), Index(numbers_.size())); }

    std::vector<Scalar, detail::CacheLineAllocator<Scalar>> numbers_;
};

} // namespace ansatz
