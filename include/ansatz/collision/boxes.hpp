// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Boxes`: the bounding boxes of many bodies, in lanes: what every broadphase works on (notes 2.1.1).
///
/// A bounding box holds all of a body between two corners, axis by axis. Two bodies whose boxes do not touch cannot
/// touch; that is all a broadphase relies on. Boxes are closed: two that share a face, an edge or a corner touch. The
/// first `active` of them belong to bodies that move; the others (fixed, at rest) are met by those, and never by each
/// other.
///
/// Use them without a World, too: fill them from the bodies of your own engine, and give them to a broadphase's
/// `In<S>`.

#include <ansatz/core/error.hpp>
#include <ansatz/units.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace ansatz {

/// The boxes of many bodies.
/// \tparam S the space
template <class S> class Boxes {
public:
    using Scalar = typename S::Scalar;             ///< of the space
    static constexpr int dimension = S::dimension; ///< of the space
    using Corner = typename S::Position;           ///< m

    /// How many.
    std::size_t size() const { return lower_[0].size(); }
    /// How many of the first belong to bodies that move.
    std::size_t active() const { return active_; }
    /// Says which: the first `n`.
    void set_active(std::size_t n) { active_ = n; }
    /// None any more; the room for them stays.
    void clear() {
        for (auto& lane : lower_) lane.clear();
        for (auto& lane : upper_) lane.clear();
        active_ = 0;
    }
    /// Room for so many.
    void reserve(std::size_t n) {
        for (auto& lane : lower_) lane.reserve(n);
        for (auto& lane : upper_) lane.reserve(n);
    }
    /// So many, of which the new ones are at the origin.
    void resize(std::size_t n) {
        for (auto& lane : lower_) lane.resize(n);
        for (auto& lane : upper_) lane.resize(n);
    }
    /// Another box.
    void push_back(const Corner& lower, const Corner& upper) {
        for (int k = 0; k < dimension; ++k) {
            lower_[std::size_t(k)].push_back(lower.value()[k]);
            upper_[std::size_t(k)].push_back(upper.value()[k]);
        }
    }
    /// Puts a box elsewhere.
    void set(std::size_t i, const Corner& lower, const Corner& upper) {
        for (int k = 0; k < dimension; ++k) {
            lower_[std::size_t(k)][i] = lower.value()[k];
            upper_[std::size_t(k)][i] = upper.value()[k];
        }
    }
    /// The lower corner of one, m.
    Vector<Scalar, dimension> lower_corner(std::size_t i) const { return corner(lower_, i); }
    /// The upper one.
    Vector<Scalar, dimension> upper_corner(std::size_t i) const { return corner(upper_, i); }
    /// The lower corners' coordinates on an axis, m.
    const Scalar* lower(int axis) const { return lower_[std::size_t(axis)].data(); }
    /// The upper corners'.
    const Scalar* upper(int axis) const { return upper_[std::size_t(axis)].data(); }

    /// Whether two boxes touch: they overlap, or share at least a point.
    [[gnu::always_inline]] bool touch(std::size_t i, std::size_t j) const {
        bool all = true;
        for (int k = 0; k < dimension; ++k) all &= lower(k)[i] <= upper(k)[j] && lower(k)[j] <= upper(k)[i];
        return all;
    }
    /// \throws std::invalid_argument for a box with an infinite corner, or one that is not a number, or whose lower
    /// corner is
    ///         above its upper one: no order of such boxes means anything
    void check(const char* where) const {
        for (std::size_t i = 0; i < size(); ++i)
            for (int k = 0; k < dimension; ++k) {
                const Scalar low = lower(k)[i], high = upper(k)[i];
                if (low <= high && low >= std::numeric_limits<Scalar>::lowest() &&
                    high <= std::numeric_limits<Scalar>::max())
                    continue;
                refuse_value(where, "box " + std::to_string(i) + " on axis " + std::to_string(k),
                             describe(S::Length::from_value(low)) + " to " + describe(S::Length::from_value(high)),
                             "both ends are finite, and the lower is not above the upper");
            }
    }

private:
    using Lanes_ = std::array<std::vector<Scalar>, std::size_t(S::dimension)>;
    static Vector<Scalar, dimension> corner(const Lanes_& lanes, std::size_t i) {
        Vector<Scalar, dimension> all;
        for (int k = 0; k < dimension; ++k) all[k] = lanes[std::size_t(k)][i];
        return all;
    }
    Lanes_ lower_, upper_;
    std::size_t active_ = 0;
};

} // namespace ansatz
