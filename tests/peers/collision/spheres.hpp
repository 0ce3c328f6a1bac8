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

/// Spheres of one radius on straight ways, by frames.
struct Spheres {
    static constexpr double radius = 0.5, fastest = 0.05; // m, and m a frame
    static constexpr int frames = 8;                      // there, and back again in the next repeat
    std::vector<std::array<double, 3>> start, step;

    int size() const { return int(start.size()); }
    std::array<double, 3> at(std::size_t i, int frame) const {
        std::array<double, 3> x = start[i];
        for (std::size_t k = 0; k < 3; ++k) x[k] += step[i][k] * frame;
        return x;
    }
    /// A quarter of a body in each cube as wide as a body: about one touching pair for each.
    static Spheres uniform(int n) {
        Spheres s;
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> place(0, std::cbrt(n / 0.25)), drift(-fastest, fastest);
        for (int i = 0; i < n; ++i)
            s.add({place(random), place(random), place(random)}, {drift(random), drift(random), drift(random)});
        return s;
    }
    /// Clusters of a hundred, normal with 1.5 m, in a world eight times as large: about two and a half pairs for each
    /// body.
    static Spheres clustered(int n) {
        Spheres s;
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

private:
    void add(const std::array<double, 3>& x, const std::array<double, 3>& v) {
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
