// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The plain model that a world is held against: which bodies exist, by name, how each was added, and which springs
/// hold it.

#include "tests/fuzz/geometry.hpp"
#include "tests/fuzz/subject.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace fuzz {

class Model {
public:
    struct Known {
        bool there = true;
        bool heavy = true; ///< its mass is finite
        bool laid = false; ///< asleep from the beginning, and not yet woken: nothing need hold it
        Shape shape = Shape::none;
        Kind kind = Kind::awake;
        int axis = 1;
        double size = 0; ///< m
    };
    using Ends = std::pair<int, int>; ///< of a spring; -1 is a point

    explicit Model(const Facts& facts) : facts_(facts) {}

    Names names;
    const std::map<int, Known>& bodies() const { return bodies_; }
    const std::map<int, Ends>& springs() const { return springs_; } ///< those that are there
    const std::set<int>& all_springs() const { return all_springs_; }

    bool is_there(int body) const {
        const auto found = bodies_.find(body);
        return found != bodies_.end() && found->second.there;
    }
    ansatz::Handle handle(int body) const { return names.bodies[std::size_t(body)]; }
    /// The name of a body that is there, or -1.
    int name_of(const ansatz::Handle& body) const {
        for (const auto& [name, known] : bodies_)
            if (known.there && handle(name) == body) return name;
        return -1;
    }
    /// Whether all that is there satisfies something.
    template <class F> bool all_of(F&& f) const {
        return std::all_of(bodies_.begin(), bodies_.end(),
                           [&](const auto& b) { return !b.second.there || f(b.second); });
    }
    bool is_anchored() const { // at a point
        return std::any_of(springs_.begin(), springs_.end(), [](const auto& s) { return s.second.second < 0; });
    }
    bool is_hung(int body) const {
        return std::any_of(springs_.begin(), springs_.end(),
                           [&](const auto& s) { return s.second.first == body || s.second.second == body; });
    }
    Body body_at(int body, const Subject& world) const {
        const auto& known = bodies_.at(body);
        return {known.shape, known.axis, known.size, world.position(handle(body))};
    }
    bool overlaps_another(int body, const Subject& world) const {
        for (const auto& [other, known] : bodies_)
            if (other != body && known.there &&
                depth_of(body_at(body, world), body_at(other, world), facts_.dimension) > -1e-6)
                return true;
        return false;
    }

    /// Whether an operation means anything here: a scene may have lost the line that made its body.
    bool is_usable(const Operation& o) const {
        const bool was = bodies_.contains(o.body); // one that is gone has a stale handle, which must be refused
        switch (o.verb) {
        case Verb::add: return !was;
        case Verb::set_restitution: return facts_.restitution && was;
        case Verb::apply_force: return facts_.applied && was;
        case Verb::add_spring:
            return facts_.springs && was && o.second != o.body && (o.second < 0 || bodies_.contains(o.second)) &&
                   !all_springs_.contains(o.spring);
        case Verb::remove_spring: return facts_.springs && all_springs_.contains(o.spring);
        case Verb::remove:
        case Verb::set_position:
        case Verb::set_velocity:
        case Verb::set_mass:
        case Verb::apply_impulse:
        case Verb::wake: return was;
        case Verb::copy:
        case Verb::load:
        case Verb::step:
        case Verb::again: break;
        }
        return true;
    }
    bool must_be_refused(const Operation& o) const {
        if (!acceptable(o, facts_.dimension)) return true;
        switch (o.verb) {
        case Verb::set_velocity: return !is_there(o.body) || bodies_.at(o.body).kind == Kind::fixed;
        case Verb::set_mass: return !is_there(o.body) || !bodies_.at(o.body).heavy;
        case Verb::remove:
        case Verb::set_position:
        case Verb::set_restitution:
        case Verb::apply_force:
        case Verb::apply_impulse:
        case Verb::wake: return !is_there(o.body);
        case Verb::add_spring: return !is_there(o.body) || (o.second >= 0 && !is_there(o.second));
        case Verb::remove_spring: return !springs_.contains(o.spring);
        case Verb::add:
        case Verb::copy:
        case Verb::load:
        case Verb::step:
        case Verb::again: break;
        }
        return false;
    }
    /// What is known after an operation that was taken.
    void follow(const Operation& o) {
        if (o.verb == Verb::add)
            bodies_[o.body] = {.heavy = o.kind == Kind::awake || o.kind == Kind::resting,
                               .laid = o.kind == Kind::resting,
                               .shape = o.shape,
                               .kind = o.kind,
                               .axis = o.axis,
                               .size = o.size};
        if (o.verb == Verb::remove) {
            bodies_.at(o.body).there = false;
            std::erase_if(springs_,
                          [&](const auto& s) { return s.second.first == o.body || s.second.second == o.body; });
        }
        if (o.verb == Verb::add_spring) springs_[o.spring] = {o.body, o.second}, all_springs_.insert(o.spring);
        if (o.verb == Verb::remove_spring) springs_.erase(o.spring);
    }
    void note_woken(const Subject& world) {
        for (auto& [body, known] : bodies_)
            if (known.there && world.motion(handle(body)) != ansatz::Motion::resting) known.laid = false;
    }

private:
    const Facts& facts_;
    std::map<int, Known> bodies_;
    std::map<int, Ends> springs_;
    std::set<int> all_springs_;
};

/// What is compared of a body.
struct Seen {
    Numbers place{}, velocity{};
    double mass = 0, restitution = 0;
    ansatz::Motion motion{};
    friend bool operator==(const Seen&, const Seen&) = default;
};
/// All that are there, as they are now, and what they amount to.
struct Sight {
    std::map<int, Seen> bodies;
    Numbers momentum{};    ///< kg m/s
    double energy = 0;     ///< J, kinetic
    double fastest = 0;    ///< m/s
    bool sleepers = false; ///< some body rests

    Sight(const Subject& world, const Model& model) {
        for (const auto& [body, known] : model.bodies()) {
            if (!known.there) continue;
            const auto h = model.handle(body);
            const Seen seen{world.position(h), world.velocity(h), world.mass(h), world.restitution(h), world.motion(h)};
            const double speed = norm(seen.velocity);
            for (std::size_t k = 0; k < 3; ++k) momentum[k] += seen.mass * seen.velocity[k];
            energy += seen.mass * speed * speed / 2;
            fastest = std::max(fastest, speed);
            sleepers = sleepers || seen.motion == ansatz::Motion::resting;
            bodies[body] = seen;
        }
    }
    /// What the roundings of a step may do to the momentum, kg m/s. A velocity that is made of two places has theirs.
    double rounding(const Facts& facts, double dt) const {
        double sum = 0;
        for (const auto& [body, is] : bodies)
            sum += is.mass * facts.epsilon * (norm(is.velocity) + (facts.history ? norm(is.place) / dt : 0));
        return sum;
    }
};

} // namespace fuzz
