// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: a world in which somebody moves, and who else has moved then.
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace exercise {

struct Net {
    std::vector<bool> held;
    std::vector<std::pair<std::size_t, std::size_t>> springs;
};

/// A world with such bodies, at places of which no three lie in a line.
struct Sheet {
    ansatz::World<ansatz::SemiImplicitEuler, ansatz::Springs<>> world{ansatz::SemiImplicitEuler{}, ansatz::Springs<>{}};
    std::vector<ansatz::Handle> bodies;

    static auto place(std::size_t i) {
        const double n = double(i);
        return ansatz::metres(std::cos(2.4 * n) * std::sqrt(n + 1), std::sin(2.4 * n) * std::sqrt(n + 1), 0.1 * n);
    }
    explicit Sheet(const Net& net) {
        using namespace ansatz;
        for (std::size_t i = 0; i < net.held.size(); ++i)
            bodies.push_back(net.held[i] ? world.add(position(place(i)), fixed)
                                         : world.add(position(place(i)), mass(1.0 * kilogram)));
        for (const auto& [a, b] : net.springs)
            world.add(Spring{.first = bodies[a], .second = bodies[b], .stiffness = 2000.0 * newton_per_metre});
    }
    void move(std::size_t i) {
        const double n = double(i);
        world.set_position(bodies[i],
                           place(i) + ansatz::metres(0.2 + 0.01 * std::sin(n), 0.3 + 0.01 * std::cos(n), -0.1));
    }
    void step() { world.step(0.01 * ansatz::second); }
    bool moved(std::size_t i) const { return world.position(bodies[i]) != place(i); }
};

inline std::vector<bool> one_step(const Net& net, const std::vector<bool>& moved) {
    Sheet sheet(net);
    for (std::size_t i = 0; i < moved.size(); ++i)
        if (moved[i]) sheet.move(i);
    sheet.step();
    std::vector<bool> all;
    for (std::size_t i = 0; i < moved.size(); ++i) all.push_back(sheet.moved(i));
    return all;
}

inline std::vector<int> first_steps(const Net& net, std::size_t from) {
    Sheet sheet(net);
    sheet.move(from);
    std::vector<int> first(net.held.size(), -1);
    for (int step = 0; step <= int(first.size()); ++step) {
        for (std::size_t i = 0; i < first.size(); ++i)
            if (first[i] < 0 && sheet.moved(i)) first[i] = step;
        sheet.step();
    }
    return first;
}

} // namespace exercise
