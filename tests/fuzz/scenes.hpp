// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Random scenes: bodies close enough to meet, and verbs on them between steps of several lengths.

#include "tests/dice.hpp"
#include "tests/fuzz/subject.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace fuzz {

/// \param facts what the composition can do
class Scenes {
public:
    Scenes(const Facts& facts, std::uint64_t seed) : facts_(facts), dice_(seed) {}

    Scene scene() {
        Scene all;
        // A gas of equals, a heap on the ground, or anything: each keeps other laws alive.
        style_ = dice_.below(3);
        usual_dt_ = dice_.one_in(3) ? 1.0 / 240 : 1.0 / 60;
        const int bodies = 1 + dice_.below(8);
        if (style_ == 1 && facts_.collides) all.push_back(plane());
        for (int i = 0; i < bodies; ++i) all.push_back(add());
        const int verbs = 5 + dice_.below(25);
        for (int i = 0; i < verbs; ++i) {
            Operation o = verb();
            if (dice_.one_in(12)) spoil(o);
            all.push_back(o);
            if (dice_.one_in(2)) all.push_back(step());
        }
        all.push_back(step());
        return all;
    }

private:
    double rough(double from, double to) {
        const double x = dice_.number(from, to);
        return dice_.one_in(2) ? std::round(4 * x) / 4 : x; // edges that touch, times that are equal
    }
    Numbers numbers(double size) {
        Numbers n{};
        for (auto& one : n) one = rough(-size, size);
        return n;
    }
    int any() { return bodies_ == 0 ? 0 : dice_.below(bodies_); }

    Operation plane() {
        Operation o;
        o.verb = Verb::add, o.body = bodies_++, o.shape = Shape::plane, o.kind = Kind::fixed;
        o.axis = 1, o.size = 0;
        return o;
    }
    Operation add() {
        Operation o;
        o.verb = Verb::add;
        o.body = bodies_++;
        o.shape = std::array{Shape::sphere, Shape::sphere, Shape::box,
                             Shape::none}[std::size_t(dice_.below(style_ == 0 ? 3 : 4))];
        const int kind = dice_.below(10);
        if (style_ != 0)
            o.kind = kind == 0                   ? Kind::fixed
                     : kind == 1                 ? Kind::moving
                     : kind == 2 && facts_.rests ? Kind::resting
                                                 : Kind::awake;
        if (o.kind == Kind::moving || o.kind == Kind::resting)
            if (o.shape != Shape::none) o.shape = Shape::sphere;
        if (o.shape == Shape::none) o.kind = Kind::awake;
        o.size = dice_.one_in(2) ? 0.5 : rough(0.25, 1);
        o.place = numbers(3);
        if (style_ == 1) { // in a column that will come to rest
            o.place = {1.5 * dice_.below(3), o.size + double(o.body), 0};
            if (dice_.one_in(2)) o.place[1] = o.size;
        }
        if (style_ != 1 || dice_.one_in(4)) o.vector = numbers(dice_.one_in(4) ? 60 : 3);
        o.mass = dice_.one_in(4) ? rough(0.25, 50) + 0.1 : 1;
        o.restitution = dice_.one_in(2) ? 0 : std::abs(rough(0, 1));
        return o;
    }
    Operation step() {
        Operation o;
        o.verb = Verb::step;
        o.dt = dice_.one_in(8) ? dice_.number(1e-3, 0.05) : usual_dt_;
        o.times = dice_.one_in(3) ? 1 + dice_.below(style_ == 1 ? 120 : 20) : 1;
        return o;
    }
    Operation verb() {
        Operation o;
        o.body = any();
        switch (dice_.below(16)) {
        case 0: return add();
        case 1: o.verb = Verb::remove; break;
        case 2: o.verb = Verb::set_position, o.place = numbers(3); break;
        case 3: o.verb = Verb::set_velocity, o.vector = numbers(3); break;
        case 4: o.verb = Verb::set_mass, o.mass = rough(0.25, 20) + 0.1; break;
        case 5: o.verb = Verb::set_restitution, o.restitution = std::abs(rough(0, 1)); break;
        case 6: o.verb = Verb::apply_force, o.vector = numbers(20); break;
        case 7: o.verb = Verb::apply_impulse, o.vector = numbers(2); break;
        case 8: o.verb = Verb::wake; break;
        case 9:
        case 10:
            o.verb = Verb::add_spring;
            o.spring = springs_++;
            o.second = dice_.one_in(3) ? -1 : any();
            o.place = numbers(3);
            o.stiffness = rough(0, 100) + 1;
            o.damping = dice_.one_in(2) ? 0 : rough(0, 2);
            break;
        case 11: o.verb = Verb::remove_spring, o.spring = springs_ == 0 ? 0 : dice_.below(springs_); break;
        case 12: o.verb = Verb::copy; break;
        case 13: o.verb = Verb::load; break;
        case 14: o.verb = Verb::again, o.dt = usual_dt_; break;
        default: return step();
        }
        return o;
    }
    /// Makes one of its numbers such that no world could accept it.
    void spoil(Operation& o) {
        const auto all = numbers_of(o, facts_.dimension);
        if (all.empty()) return;
        o.times = 1;
        double* number = all[std::size_t(dice_.below(int(all.size())))];
        if (number == &o.restitution && o.verb == Verb::add && (!facts_.restitution || o.shape == Shape::none)) return;
        const bool positive = number == &o.mass || number == &o.size;
        const bool signless =
            number == &o.dt || number == &o.restitution || number == &o.stiffness || number == &o.damping;
        const double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
        switch (dice_.below(positive ? 4 : signless ? 3 : 2)) {
        case 0: *number = nan; break;
        case 1: *number = dice_.one_in(2) ? infinite : -infinite; break;
        case 2: *number = -1; break;
        default: *number = 0;
        }
    }

    const Facts& facts_;
    ansatz::test::Dice dice_;
    int bodies_ = 0, springs_ = 0, style_ = 0;
    double usual_dt_ = 1.0 / 60;
};

} // namespace fuzz
