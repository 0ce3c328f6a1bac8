// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A world as the fuzzer sees it, whatever its type is: what scenes, laws, the shrinker and the printer need of it.
/// They are compiled once; a composition only has to be given these verbs (subject_of.hpp).

#include "tests/fuzz/operation.hpp"

#include <ansatz/world/bodies.hpp>
#include <ansatz/world/elements.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ansatz {
struct Spring;
}

namespace fuzz {

/// What is known of a composition: what its scenes may do, and what it promises.
struct Facts {
    std::string type = "World"; ///< what is built of them
    std::string text;           ///< its policies, as they are written in World{...}
    std::string other;          ///< the same with the broadphase that tests every pair
    int dimension = 3;          ///< 2 or 3
    double epsilon = 0;         ///< of its scalar
    bool collides = false;      ///< has a broadphase and a narrowphase
    bool restitution = false;   ///< stores it
    bool friction = false;      ///< stores it: all bodies with a shape have 0.5
    bool applied = false;       ///< takes forces from outside
    bool springs = false;       ///< takes springs
    bool rests = false;         ///< puts bodies to sleep
    bool history = false;       ///< its velocity is made of two places
    bool falls = false;         ///< has gravity
    bool closed = false;        ///< no force from outside acts: momentum is kept
    bool settles = false;       ///< what falls on something may come to rest there: contacts take its velocity
    bool stays = false;         ///< contacts are where the step left the bodies: nothing moves them apart afterwards
    bool keeps_energy = false;  ///< V3: no step has more kinetic energy than the one before
    bool soft = false;          ///< and that only as long as no body was put into another body
    bool bounded = false;       ///< nothing that is too stiff for a step can make its numbers grow without end
};

struct Pair {
    ansatz::Handle first, second;
};
/// The handles of a scene's bodies and springs, by their names. They are the same in every world that lives it.
struct Names {
    std::vector<ansatz::Handle> bodies;
    std::vector<ansatz::ElementHandle<ansatz::Spring>> springs;
};

class Subject {
public:
    virtual ~Subject() = default;
    virtual const Facts& facts() const = 0;
    virtual std::unique_ptr<Subject> fresh(bool other_broadphase) const = 0; ///< empty
    virtual std::unique_ptr<Subject> copy() const = 0;
    virtual void assign(const Subject& other) = 0;
    virtual std::string save() const = 0;
    virtual void load(const std::string& text) = 0;
    /// What changes bodies, springs and time; throws what the world throws.
    virtual void perform(const Operation& operation, Names& names) = 0;

    virtual bool contains(ansatz::Handle body) const = 0;
    virtual bool contains_spring(ansatz::ElementHandle<ansatz::Spring> spring) const = 0;
    virtual std::size_t size() const = 0;
    virtual ansatz::Motion motion(ansatz::Handle body) const = 0;
    virtual int datum(ansatz::Handle body) const = 0;
    virtual Numbers position(ansatz::Handle body) const = 0;
    virtual Numbers velocity(ansatz::Handle body) const = 0;
    virtual double mass(ansatz::Handle body) const = 0;        ///< kg; 0 where it is infinite
    virtual double restitution(ansatz::Handle body) const = 0; ///< 0 where it is not stored
    virtual std::vector<Pair> contacts() const = 0;
    virtual std::uint64_t hash() const = 0;
    virtual bool ok() const = 0;
};

/// The compositions of this program, by their numbers.
inline std::vector<std::pair<int, std::unique_ptr<Subject>>>& compositions() {
    static std::vector<std::pair<int, std::unique_ptr<Subject>>> all;
    return all;
}
/// Puts one there, in the order of the numbers.
struct Registered {
    Registered(int number, std::unique_ptr<Subject> subject) {
        auto& all = compositions();
        const auto later = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first > number; });
        all.emplace(later, number, std::move(subject));
    }
};

} // namespace fuzz
