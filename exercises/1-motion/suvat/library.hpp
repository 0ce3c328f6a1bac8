// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/world.hpp>

#include <stdexcept>
#include <vector>

namespace exercise {

struct End {
    ansatz::Quantity<ansatz::unit::Length> s;
    ansatz::Quantity<ansatz::unit::Velocity> v;
};

inline End after(ansatz::Quantity<ansatz::unit::Velocity> u, ansatz::Quantity<ansatz::unit::Acceleration> a,
                 ansatz::Quantity<ansatz::unit::Time> t) {
    namespace suvat = ansatz::suvat;
    const auto motion = suvat::solve(suvat::initial_velocity(u), suvat::acceleration(a), suvat::time(t)).front();
    return {motion.s, motion.v};
}

inline ansatz::Quantity<ansatz::unit::Length> displacement_until(ansatz::Quantity<ansatz::unit::Velocity> v,
                                                                 ansatz::Quantity<ansatz::unit::Acceleration> a,
                                                                 ansatz::Quantity<ansatz::unit::Time> t) {
    namespace suvat = ansatz::suvat;
    return suvat::solve(suvat::final_velocity(v), suvat::acceleration(a), suvat::time(t)).front().s;
}

inline std::vector<ansatz::Quantity<ansatz::unit::Time>> times_at(ansatz::Quantity<ansatz::unit::Length> s,
                                                                  ansatz::Quantity<ansatz::unit::Velocity> u,
                                                                  ansatz::Quantity<ansatz::unit::Acceleration> a) {
    namespace suvat = ansatz::suvat;
    std::vector<ansatz::Quantity<ansatz::unit::Time>> times;
    try {
        for (const auto& motion :
             suvat::solve(suvat::displacement(s), suvat::initial_velocity(u), suvat::acceleration(a)))
            times.push_back(motion.t);
    } catch (const std::invalid_argument&) {
        // The library says why it is out of reach; the exercise asks for an empty list.
    }
    return times;
}

} // namespace exercise
