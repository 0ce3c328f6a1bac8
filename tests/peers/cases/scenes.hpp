// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the scenes of `peers cases` share: a box for a heap, balls in rows, and depths by centres alone.

#include "tests/peers/cases/engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace peers {

inline constexpr double frame = 1.0 / 60, g = 9.81;                     // s, m/s^2
inline constexpr double lost = std::numeric_limits<double>::infinity(); ///< of an outcome that is no number

inline Vector at(double x, double y = 0, double z = 0) { return {x, y, z}; }
inline const Vector up = at(0, 1);

/// The larger of two, and "lost" where either is no number.
inline double worse(double a, double b) { return std::isfinite(a) && std::isfinite(b) ? std::max(a, b) : lost; }

/// Half as wide as this to every side, open above; in a flat engine without the walls that it cannot see.
inline void walls(Engine& world, const Contestant& who, double half, double bounce = 0, double friction = 0) {
    world.plane(up, 0, bounce, friction);
    for (const double side : {1.0, -1.0}) {
        world.plane(at(side), -half, bounce, friction);
        if (!who.flat) world.plane(at(0, 0, side), -half, bounce, friction);
    }
}
/// Numbers in [-1, 1), the same on every machine.
class Dice {
public:
    explicit Dice(unsigned seed) : random_(seed) {}
    double operator()() { return double(random_()) / 2147483648.0 - 1; }

private:
    std::mt19937 random_;
};
/// How deep two of these, of one radius, lie in each other at most, or in the ground and the walls.
inline double deepest(const Engine& world, const std::vector<int>& balls, double radius, double half = 1e300) {
    std::vector<Vector> x;
    for (const int i : balls) x.push_back(world.x(i));
    for (const Vector& one : x)
        if (!one.allFinite()) return lost;
    std::sort(x.begin(), x.end(), [](const Vector& a, const Vector& b) { return a[0] < b[0]; });
    double most = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        most = std::max({most, radius - x[i][1], radius - half + std::abs(x[i][0]), radius - half + std::abs(x[i][2])});
        for (std::size_t j = i + 1; j < x.size() && x[j][0] - x[i][0] < 2 * radius; ++j)
            most = std::max(most, 2 * radius - (x[i] - x[j]).norm());
    }
    return most;
}
inline double fastest(const Engine& world, const std::vector<int>& balls) {
    double most = 0;
    for (const int i : balls) most = worse(most, world.v(i).norm());
    return most;
}
/// Rows of balls, a little beside their places; `count` of them, in two dimensions in a square.
inline std::vector<Vector> grid(const Contestant& who, int count, double apart, double low, double beside, Dice& dice) {
    const int row = std::max(1, int(std::lround(who.flat ? std::sqrt(double(count)) : std::cbrt(double(count)))));
    std::vector<Vector> all;
    for (int i = 0; i < count; ++i) {
        const int x = i % row, z = who.flat ? 0 : i / row % row, y = who.flat ? i / row : i / (row * row);
        const double dx = beside * dice(), dz = beside * dice();
        all.push_back(
            at(apart * (x - 0.5 * (row - 1)) + dx, low + apart * y, who.flat ? 0 : apart * (z - 0.5 * (row - 1)) + dz));
    }
    return all;
}
/// How wide half a box for such a grid is.
inline double half_of(const Contestant& who, int count, double apart) {
    return 0.5 * apart * std::lround(who.flat ? std::sqrt(double(count)) : std::cbrt(double(count))) + 0.3;
}

} // namespace peers
