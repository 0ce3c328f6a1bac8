// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The second kind of scene of `peers collision`: frictionless spheres that are dropped into an open box, stepped at 60
/// Hz.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <vector>

namespace peers {

/// What is dropped, and into what. Every number is a multiple of what a float holds.
struct Pile {
    static constexpr double radius = 0.5, gravity = 9.81, dt = 1.0 / 60; // m, m/s^2, s
    static constexpr double mass = 1;                                    // kg
    double half_side;                         // m, of the box's square floor, whose middle is the origin
    std::vector<std::array<double, 3>> start; // y is up

    /// Layers of a square grid, a quarter of a metre apart, each sphere a little beside its place.
    static Pile of(int n) {
        const int row = std::max(1, int(std::lround(std::cbrt(double(n)))));
        Pile pile{row * 1.25 / 2, {}};
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> beside(-0.1, 0.1);
        for (int i = 0; i < n; ++i) {
            const int x = i % row, z = i / row % row, y = i / (row * row);
            const double bx = beside(random), bz = beside(random);
            pile.start.push_back(
                {(x + 0.5) * 1.25 - pile.half_side + bx, y * 1.25 + 1, (z + 0.5) * 1.25 - pile.half_side + bz});
        }
        return pile;
    }
};

/// A library that plays it.
struct PileOf {
    virtual ~PileOf() = default;
    virtual void step() = 0;
    virtual std::array<double, 3> at(std::size_t i) const = 0; ///< the centre of a sphere, m
};

/// \name Peers; each is compiled only where its library was found
/// @{
std::unique_ptr<PileOf> bullet_pile(const Pile&);
std::unique_ptr<PileOf> ode_pile(const Pile&);
/// @}

/// How deep things lie in each other, by the centres alone: one measure for everybody.
struct Depths {
    double mean = 0;    ///< over the pairs that intersect, m
    double largest = 0; ///< m
    std::size_t pairs = 0;

    static Depths of(const Pile& pile, const PileOf& played) {
        Depths d;
        double sum = 0;
        auto add = [&](double depth) {
            if (!(depth > 0)) return;
            sum += depth;
            d.largest = std::max(d.largest, depth);
            ++d.pairs;
        };
        const std::size_t n = pile.start.size();
        std::vector<std::array<double, 3>> x(n);
        for (std::size_t i = 0; i < n; ++i) x[i] = played.at(i);
        std::sort(x.begin(), x.end());
        for (std::size_t i = 0; i < n; ++i) {
            add(Pile::radius - x[i][1]);
            for (const std::size_t k : {0, 2}) add(Pile::radius - pile.half_side + std::abs(x[i][k]));
            for (std::size_t j = i + 1; j < n && x[j][0] - x[i][0] < 2 * Pile::radius; ++j)
                add(2 * Pile::radius - std::hypot(x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]));
        }
        d.mean = d.pairs > 0 ? sum / double(d.pairs) : 0;
        return d;
    }
};

class Contest;
/// Drops n spheres by each library in turn, and writes how long a step took and how deep they lay.
void play_piles(Contest&, int n);

} // namespace peers
