// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: what its StrainLimit does in a step that is too short for anything else.
#include <ansatz/soft_bodies/strain_limit.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace exercise {

struct End {
    ansatz::VectorQuantity<ansatz::unit::Length, 3> position;
    ansatz::VectorQuantity<ansatz::unit::Velocity, 3> velocity;
    ansatz::Quantity<ansatz::unit::InverseMass> inverse_mass;
};
struct Thread {
    std::size_t first, second;
    ansatz::Quantity<ansatz::unit::Length> rest_length;
};
struct Sheet {
    std::vector<End> ends;
    std::vector<Thread> threads;
};
constexpr double rounding = 1e-12;

/// The ends of a sheet after so many passes.
inline std::vector<End> after(const Sheet& sheet, double most, int passes) {
    using namespace ansatz;
    if (passes < 1) return sheet.ends;
    World world{SemiImplicitEuler{}, Springs{}, StrainLimit{.most = most, .passes = passes}};
    std::vector<Handle> bodies;
    for (const auto& [at, v, inverse] : sheet.ends)
        bodies.push_back(inverse.value() > 0 ? world.add(position(at), velocity(v), mass(1.0 / inverse))
                                             : world.add(position(at), velocity(v), moving));
    for (const auto& [first, second, rest] : sheet.threads)
        world.add(Spring{.first = bodies[first], .second = bodies[second], .rest_length = rest});
    world.step(1e-30 * second);
    std::vector<End> ends;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        ends.push_back({world.position(bodies[i]), world.velocity(bodies[i]), sheet.ends[i].inverse_mass});
    return ends;
}
/// Whether an end was moved, by more than it goes in that step.
inline bool moved(const End& from, const End& to) { return (to.position - from.position).value().norm() > 1e-20; }

inline bool shorten(End& first, End& second, ansatz::Quantity<ansatz::unit::Length> longest) {
    const auto ends = after({{first, second}, {{0, 1, longest / 2.0}}}, 1, 1);
    const bool shortened = moved(first, ends[0]) || moved(second, ends[1]);
    first.position = ends[0].position;
    second.position = ends[1].position;
    return shortened;
}

inline void stop(End& first, End& second) {
    const auto length = ansatz::norm(second.position - first.position);
    const auto ends = after({{first, second}, {{0, 1, length / 4.0}}}, 1, 1);
    first.velocity = ends[0].velocity;
    second.velocity = ends[1].velocity;
}

inline int limit(Sheet& sheet, double most, int passes) {
    auto before = sheet.ends;
    for (int pass = 1; pass <= passes; ++pass) {
        const auto ends = after(sheet, most, pass);
        bool found = false;
        for (std::size_t i = 0; i < ends.size(); ++i) found = found || moved(before[i], ends[i]);
        before = ends;
        if (!found || pass == passes) {
            sheet.ends = ends;
            return pass;
        }
    }
    return passes;
}

} // namespace exercise
