// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The scenes of `peers collision`: spheres that drift, and who finds which of their boxes touch.

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace peers {

/// Spheres on straight ways, by frames.
struct Spheres {
    double fastest = 0.05;                          // m a frame, on an axis
    int frames = 8;                                 // there, and back again in the next repeat
    std::vector<double> radius;                     // m
    std::vector<std::array<double, 3>> start, step; // m, and m a frame

    int size() const { return int(start.size()); }
    std::array<double, 3> at(std::size_t i, int frame) const {
        std::array<double, 3> x = start[i];
        for (std::size_t k = 0; k < 3; ++k) x[k] += step[i][k] * frame;
        return x;
    }
    /// A quarter of a body in each cube as wide as a body: about one touching pair for each.
    static Spheres uniform(int n, double fastest = 0.05, int frames = 8) {
        Spheres s{fastest, frames, {}, {}, {}};
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> place(0, std::cbrt(n / 0.25)), drift(-fastest, fastest);
        for (int i = 0; i < n; ++i)
            s.add({place(random), place(random), place(random)}, {drift(random), drift(random), drift(random)});
        return s;
    }
    /// Clusters of a hundred, normal with 1.5 m, in a world eight times as large: about two and a half pairs for each
    /// body.
    static Spheres clustered(int n, double fastest = 0.05, int frames = 8) {
        Spheres s{fastest, frames, {}, {}, {}};
        std::mt19937_64 random(2);
        std::uniform_real_distribution<double> place(0, 2 * std::cbrt(n / 0.25)), drift(-fastest, fastest);
        std::normal_distribution<double> beside(0, 1.5);
        std::array<double, 3> centre{};
        for (int i = 0; i < n; ++i) {
            if (i % 100 == 0) centre = {place(random), place(random), place(random)};
            s.add({centre[0] + beside(random), centre[1] + beside(random), centre[2] + beside(random)},
                  {drift(random), drift(random), drift(random)});
        }
        return s;
    }
    /// Radii from 0.05 to 5 m, as many of each magnitude, in a cube with edges of 2.5 m times the cube root of n.
    static Spheres mixed(int n, double fastest, int frames) {
        Spheres s{fastest, frames, {}, {}, {}};
        std::mt19937_64 random(4);
        std::uniform_real_distribution<double> place(0, 2.5 * std::cbrt(n)), drift(-fastest, fastest), power(0, 1);
        for (int i = 0; i < n; ++i) {
            s.add({place(random), place(random), place(random)}, {drift(random), drift(random), drift(random)});
            s.radius.back() = 0.05 * std::pow(100.0, power(random));
        }
        return s;
    }

private:
    void add(const std::array<double, 3>& x, const std::array<double, 3>& v) {
        radius.push_back(0.5);
        start.push_back(x);
        step.push_back(v);
    }
};

/// Takes the places of a frame and says how many pairs there are.
using Broadphase = std::function<std::size_t(const Spheres&, int frame)>;

/// \name Peers; each is compiled only where its library was found
/// @{
Broadphase cgal_box_intersection(const Spheres&);
Broadphase fcl_tree_array(const Spheres&);
Broadphase bullet_dbvt(const Spheres&);
/// @}

} // namespace peers
