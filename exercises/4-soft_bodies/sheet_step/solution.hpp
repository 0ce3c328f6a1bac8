// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace ansatz;

namespace exercise {

/// Bodies on a line, and the springs between them.
struct Net {
    struct Spring {
        std::size_t a, b; ///< its two bodies, by number
        Quantity<unit::Stiffness> stiffness;
    };
    std::vector<Quantity<unit::InverseMass>> weights; ///< 1/m of each body, zero where it is held
    std::vector<Spring> springs;
};

/// No omega^2 of the net is larger; in 1/s^2.
inline Quantity<unit::FrequencySquared> bound(const Net& net) {
    // task 1: return todo(1);
    std::vector<Quantity<unit::Stiffness>> sums(net.weights.size(), 0.0 * newton_per_metre);
    for (const auto& spring : net.springs) {
        sums[spring.a] += spring.stiffness;
        sums[spring.b] += spring.stiffness;
    }
    Quantity<unit::FrequencySquared> largest = 0.0 * hertz * hertz;
    for (const auto& [a, b, stiffness] : net.springs)
        largest = max(largest, sums[a] * net.weights[a] + sums[b] * net.weights[b]);
    return largest;
    // end of task 1
}

/// The largest omega^2 of the net; in 1/s^2.
inline Quantity<unit::FrequencySquared> measured(const Net& net) {
    // task 2: return todo(2);
    std::vector<double> x;
    for (std::size_t i = 0; i < net.weights.size(); ++i)
        x.push_back(net.weights[i].value() > 0 ? std::cos(3.0 * double(i)) : 0.0);
    double omega_squared = 0;
    for (int n = 0; n < 2000; ++n) {
        std::vector<double> next(x.size(), 0.0);
        for (const auto& [a, b, stiffness] : net.springs) {
            const double pull = stiffness.value() * (x[a] - x[b]);
            next[a] += net.weights[a].value() * pull;
            next[b] -= net.weights[b].value() * pull;
        }
        double size = 0;
        for (const double each : next) size = std::max(size, std::abs(each));
        omega_squared = size;
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = next[i] / size;
    }
    return omega_squared * hertz * hertz;
    // end of task 2
}

/// The longest step that semi-implicit Euler takes at that omega^2; in s.
inline Quantity<unit::Time> longest_step(Quantity<unit::FrequencySquared> omega_squared) {
    // task 3: return todo(3);
    return 2.0 / sqrt(omega_squared);
    // end of task 3
}

} // namespace exercise
