// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the programs of 2.1.1 share: balls that lie about, their boxes, and a count of what a partition does.
///
/// What a broadphase is: collision/broadphase/broadphase.hpp; what may test the inside of a cell, as `Counting` does
/// here: collision/broadphase/inside.hpp, on a Lot of boxes. How cells are divided is in
/// collision/broadphase/recursion.hpp, how a grid is laid out in collision/broadphase/uniform_grid_level.hpp.

#include <ansatz/collision/broadphase.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace scenes {

using namespace ansatz;

/// Balls of one radius; all of them may move.
struct Balls {
    double radius = 0.5; ///< m
    std::vector<Vector<double, 3>> centres;

    /// The box of a ball: its extremes on each axis.
    //! [boxes]
    Boxes<Space<>> boxes() const {
        Boxes<Space<>> all;
        const Vector<double, 3> half(radius, radius, radius);
        for (const auto& centre : centres) all.push_back((centre - half) * metre, (centre + half) * metre);
        all.set_active(all.size());
        return all;
    }
    //! [boxes]
    bool touch(std::size_t i, std::size_t j) const { return (centres[i] - centres[j]).norm() <= 2 * radius; }
};

/// The same numbers with every standard library.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double between(double low, double high) { return low + (high - low) * double(engine_() >> 11) * 0x1p-53; }
    Vector<double, 3> in_cube(double half) { // one after the other: the order of arguments is the compiler's
        Vector<double, 3> x;
        for (int k = 0; k < 3; ++k) x[k] = between(-half, half);
        return x;
    }

private:
    std::mt19937_64 engine_;
};

/// Anywhere in a cube, a quarter of a ball in each cubic metre.
inline Balls uniform(int n) {
    Dice dice(std::uint64_t(n) + 1);
    Balls balls;
    for (int i = 0; i < n; ++i) balls.centres.push_back(dice.in_cube(0.5 * std::cbrt(n / 0.25)));
    return balls;
}
/// In heaps of fifty, 4 m wide, in a world that is mostly empty.
inline Balls heaps(int n) {
    Dice dice(std::uint64_t(n) + 2);
    Balls balls;
    Vector<double, 3> heap = dice.in_cube(100);
    for (int i = 0; i < n; ++i) {
        if (i % 50 == 0) heap = dice.in_cube(100);
        balls.centres.push_back(heap + dice.in_cube(2));
    }
    return balls;
}

/// What a partition has asked of the test inside its cells.
struct Work {
    double tests = 0;   ///< pairs of boxes that were compared
    double members = 0; ///< bodies in the lists of cells, all lists together
};
/// BoundingBoxes that keep count: a broadphase of your own for the inside of a cell is no more than this.
struct Counting : BoundingBoxes {
    Work* work = nullptr;
    template <class S> class In : public BoundingBoxes::In<S> {
        using Base = BoundingBoxes::In<S>;

    public:
        explicit In(const Counting& counting) : Base(counting), work_(counting.work) {}
        void arrange(Lot<S>&, std::size_t first, std::size_t last) { work_->members += double(last - first); }
        template <class F> void among(const Lot<S>& lot, std::size_t first, std::size_t last, F&& touch) const {
            work_->tests += 0.5 * double(last - first) * double(last - first - 1);
            Base::among(lot, first, last, touch);
        }
        template <class F>
        void between(const Lot<S>& lot, std::size_t first, std::size_t last, std::size_t other_first,
                     std::size_t other_last, F&& touch) const {
            work_->tests += double(last - first) * double(other_last - other_first);
            Base::between(lot, first, last, other_first, other_last, touch);
        }

    private:
        Work* work_;
    };
};
/// A `Counting` that counts here.
inline Counting counted(Work& work) {
    Counting counting;
    counting.work = &work;
    return counting;
}

} // namespace scenes
