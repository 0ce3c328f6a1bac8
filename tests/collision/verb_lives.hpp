// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Two worlds of the same bodies, one of which never sleeps, and a plain model of both (hard case V1).

#include "tests/collision/support.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world/save.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <sstream>

namespace collision_tests {

/// A column of the user's own that no policy reads.
struct Colour {
    using Unit = unit::Dimensionless;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "colour";
};
using Number = Quantity<unit::Dimensionless>;

constexpr double distance_of_columns = 3; // m
constexpr int columns = 5;

/// What is known of a body by its handle.
struct Known {
    Handle handle;
    bool there = true;
    int datum = 0;
    double mass = 1, colour = 0; // kg, 1
};

/// Two worlds of the same bodies, of which one never sleeps, and the model of both.
template <class W> class Lives {
public:
    using S = typename W::S;

    Lives(W sleepy, double rate, std::uint64_t seed)
        : sleepy_(std::move(sleepy)), restless_(sleepy_), rate_(rate), engine_(seed) {
        restless_.set(Rest{0.05 * metre_per_second, 1e6 * second});
        both([&](W& world) { world.add(Plane::ground(), fixed); });
        // One column stands on a platform, which could move.
        both([&](W& world) { world.add(box(), at<S>(0, 0.5), going<S>(0), moving); });
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < columns; ++column) add(column);
        if constexpr (hangs) hang();
        settle(3);
    }

    /// One verb, at random, and time for what it does.
    void act() {
        const int verb = int(engine_() % 11), target = alive();
        INFO("verb " << verb << " on body " << (target < 0 ? -1 : int(known_[std::size_t(target)].handle.id)));
        if (sleepy_.count(Motion::resting) > 0) ++on_sleepers;
        const auto before = sleepy_;
        if (target < 0 || (verb == 0 && there() < 30)) {
            add(column_of_chance());
            check(before, known_.back().handle);
        } else {
            auto& body = known_[std::size_t(target)];
            perform(verb, body);
            check(before, body.handle);
        }
        settle(engine_() % 3 == 0 ? 0.05 : 3);
        if (quiet_) compare();
    }

    int on_sleepers = 0; ///< verbs while some body slept
    int compared = 0;    ///< places that were held against the other world's
    double farthest = 0; ///< m, apart

private:
    static constexpr bool hangs = requires(W& world, Handle h) {
        world.add(Spring{h, h, 1.0 * newton_per_metre});
    } && W::composition::element_keepers::size > 0;

    static Box box() {
        if constexpr (S::dimension == 3) return Box{metres(0.5, 0.5, 0.5)};
        else return Box{metres(0.5, 0.5)};
    }
    template <class F> void both(F&& f) { f(sleepy_), f(restless_); }
    int column_of_chance() { return int(engine_() % columns); }
    int there() const {
        return int(std::count_if(known_.begin(), known_.end(), [](const Known& k) { return k.there; }));
    }
    int alive() {
        const int n = there();
        if (n == 0) return -1;
        int k = int(engine_() % std::uint64_t(n));
        for (std::size_t i = 0; i < known_.size(); ++i)
            if (known_[i].there && k-- == 0) return int(i);
        return -1;
    }
    /// A place above everything in a column.
    auto above(int column, Handle but = {}) {
        double top = 0;
        sleepy_.for_each([&](Handle h) {
            if (h == but || h.id == 0 || std::abs(x_of(sleepy_, h) - distance_of_columns * column) > 1.5) return;
            top = std::max(top, height_of(sleepy_, h) + 0.5);
        });
        return vector_in<S, unit::Length>(distance_of_columns * column, top + 0.505);
    }
    void add(int column) {
        Known body;
        body.datum = int(known_.size()) + 1;
        body.colour = double(body.datum) / 8;
        body.mass = 1 + double(engine_() % 3);
        const auto place = above(column);
        both([&](W& world) {
            body.handle = world.add(box(), position(place), mass(body.mass * kilogram),
                                    with<Colour>(Number(body.colour)), datum(body.datum));
            if constexpr (W::composition::template stores<Friction>)
                world.template write<Friction>(body.handle, Number(0.5));
        });
        known_.push_back(body);
    }
    /// A body on a damped spring.
    void hang() {
        const auto hook = vector_in<S, unit::Length>(-6, 12), place = vector_in<S, unit::Length>(-6, 10);
        Known body;
        body.datum = 1000;
        both([&](W& world) {
            const auto point = world.add(shapeless, position(hook), fixed);
            body.handle = world.add(box(), position(place), mass(1.0 * kilogram), datum(body.datum));
            world.add(Spring{body.handle, point, 40.0 * newton_per_metre, 8.0 * newton_second_per_metre});
        });
        known_.push_back(body);
    }
    void perform(int verb, Known& body) {
        const auto h = body.handle;
        const auto up = vector_in<S, unit::Velocity>(0, 0.5);
        switch (verb) {
        case 1:
        case 2:
            both([&](W& world) { world.remove(h); });
            body.there = false;
            break;
        case 3:
        case 4: {
            const auto place = above(column_of_chance(), h);
            both([&](W& world) { world.set_position(h, place); });
            CHECK(sleepy_.position(h) == place);
            break;
        }
        case 5:
            both([&](W& world) { world.set_velocity(h, up); });
            CHECK(norm(typename S::Velocity(sleepy_.velocity(h) - up)).value() <= rounding<S>(4));
            break;
        case 6:
            body.mass = 1 + double(engine_() % 4);
            both([&](W& world) { world.set_mass(h, body.mass * kilogram); });
            break;
        case 7:
            body.colour = double(engine_() % 64) / 8;
            both([&](W& world) { world.template write<Colour>(h, Number(body.colour)); });
            break;
        case 8: both([&](W& world) { world.apply_impulse(h, vector_in<S, unit::Momentum>(0, 0.3)); }); break;
        case 9:
            both([&](W& world) {
                if constexpr (W::composition::template stores<Friction>)
                    world.template write<Friction>(h, Number(0.6)); // wakes bodies that lie on it
                else if constexpr (W::composition::template stores<AppliedForce>)
                    world.apply_force(h, vector_in<S, unit::Force>(0, 30));
                else world.wake(h);
            });
            break;
        default:
            body.datum = int(engine_() % 1000);
            both([&](W& world) { world.wake(h), world.datum(h) = body.datum; });
        }
    }
    /// Against the model, and against the world before the verb: a body that is not meant is where it was.
    void check(const W& before, Handle meant) const {
        for (const Known& body : known_) {
            INFO("body " << body.handle.id << " of generation " << body.handle.generation);
            for (const W* world : {&sleepy_, &restless_}) {
                REQUIRE(world->contains(body.handle) == body.there);
                if (!body.there) continue;
                CHECK(world->datum(body.handle) == body.datum);
                CHECK(std::abs(double(world->mass(body.handle).value()) - body.mass) <= rounding<S>(body.mass));
                CHECK(double(world->template read<Colour>(body.handle).value()) == body.colour);
            }
            if (!body.there || body.handle == meant) continue;
            CHECK(sleepy_.position(body.handle) == before.position(body.handle));
            CHECK(norm(typename S::Velocity(sleepy_.velocity(body.handle) - before.velocity(body.handle))).value() <=
                  (W::composition::history ? 1e-4 : 0));
        }
        CHECK(sleepy_.size() == restless_.size());
    }
    void settle(double seconds) {
        for (int i = 0; i < int(seconds * rate_); ++i) both([&](W& world) { world.step(1 / rate_ * second); });
        quiet_ = seconds > 1;
    }
    void compare() {
        for (const Known& body : known_) {
            if (!body.there) continue;
            const double apart = double(
                norm(typename S::Position(sleepy_.position(body.handle) - restless_.position(body.handle))).value());
            farthest = std::max(farthest, apart);
            ++compared;
        }
    }

    W sleepy_, restless_;
    double rate_; // steps a second
    std::mt19937_64 engine_;
    std::vector<Known> known_;
    bool quiet_ = false;
};

/// \param rate steps a second
/// \param slop m, how far a body of the one world may be from the same of the other
template <class W> void live(const W& world, double rate, double slop) {
    constexpr int verbs = 60;
    int slept = 0, compared = 0;
    double farthest = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        INFO("seed " << seed);
        Lives<W> lives(world, rate, seed);
        for (int i = 0; i < verbs; ++i) {
            INFO("act " << i);
            lives.act();
        }
        slept += lives.on_sleepers;
        compared += lives.compared;
        farthest = std::max(farthest, lives.farthest);
    }
    CAPTURE(slept, compared, farthest);
    CHECK(slept > verbs); // the case has not lost its point: of three lives
    CHECK(compared > 100);
    CHECK(farthest <= slop);
}

template <class S, class... P> auto resting_world(P... policies) {
    return World{S{},          SortAndSweep{}, Narrowphase<Box, Plane>{},
                 Gravity{},    Rest{},         Keep<Colour, InverseMass>{},
                 Datum<int>{}, policies...};
}

} // namespace collision_tests
