// SPDX-License-Identifier: BSL-1.0
// Verbs on a living world (hard case V1): whatever is done to one body of a sleeping pile is done to that body and to
// no other.
//
// Waking moves bodies to other slots, so a verb that looks a slot up before it wakes somebody acts on another body.
// Random verbs are held against a plain model that keeps bodies by their handles (who is there, datum, mass and columns
// exactly; where the others are, to the bit), and against a world of the same bodies that never sleeps (places within
// slop).
//
// Loops that everybody writes (V6): who removes bodies while he walks over contacts, events or handles skips nobody.
// Runs long with the sanitizers.

#include "tests/collision/support.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world/save.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <sstream>

using namespace collision_tests;

namespace {

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

    int on_sleepers = 0; ///< verbs while somebody slept
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
                    world.template write<Friction>(h, Number(0.6)); // wakes who lies on it
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
    /// Against the model, and against the world before the verb: who is not meant is where he was.
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

} // namespace

TEST_CASE("V1: verbs act on the body that is meant: Impulse with friction, Projection", "[collision][verbs][V1]") {
    live(resting_world<Space<>>(SemiImplicitEuler{}, Impulse<Friction>{.sweeps = 20}, Projection{1e-3 * metre}), 60,
         5e-3); // measured 3.1e-3: each of five in a column may be a slop deeper;
}
TEST_CASE("V1: verbs act on the body that is meant: Impulse alone, in float and two dimensions",
          "[collision][verbs][V1]") {
    // Whoever does not sleep sinks for ever (notes 2.2.1), so places are not compared.
    live(resting_world<Space<float, 2>>(SemiImplicitEuler{}, Impulse<>{}, AppliedForces{}), 60, HUGE_VAL);
}
TEST_CASE("V1: verbs act on the body that is meant: SoftSubsteps with friction, and one on a spring",
          "[collision][verbs][V1]") {
    live(resting_world<Space<>>(SemiImplicitEuler{}, SoftSubsteps<Friction>{}, Springs<Breaking>{}, AppliedForces{}),
         60, 5e-3); // measured 2.3e-4
}
TEST_CASE("V1: verbs act on the body that is meant: Penalty, of a history", "[collision][verbs][V1]") {
    live(resting_world<Space<>>(Verlet{}, Penalty{2e4 * newton_per_metre, 80.0 * newton_second_per_metre},
                                AppliedForces{}),
         240, 5e-3);
}

namespace {

/// A hail of bullets (ids above 100) that lie in a floor of boxes, some in two of them.
auto hail() {
    auto world =
        resting_world<Space<>>(SemiImplicitEuler{}, SoftSubsteps<Friction>{}, Springs<Breaking>{}, AppliedForces{});
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < 100; ++i)
        world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(i % 10, 0.5, i / 10)), mass(5.0 * kilogram));
    std::mt19937_64 engine(7);
    auto number = [&] { return 9 * double(engine() >> 11) * 0x1p-53; };
    for (int i = 0; i < 60; ++i)
        world.add(Box{metres(0.1, 0.1, 0.1)}, position(metres(number(), 1.05, number())), mass(0.1 * kilogram),
                  datum(i));
    world.step(1.0 / 240 * second);
    return world;
}
using Hail = decltype(hail());
bool is_bullet(const Handle& h) { return h.id > 100; }

/// The contacts of the bullets, counted before anything is removed.
std::size_t of_bullets(const Hail& world) {
    return std::size_t(std::count_if(world.contacts().begin(), world.contacts().end(),
                                     [](const auto& c) { return is_bullet(c.first) || is_bullet(c.second); }));
}

} // namespace

TEST_CASE("V6: who removes bodies while he walks over contacts() meets every contact once", "[collision][verbs][V6]") {
    auto world = hail();
    const auto all = std::vector(world.contacts().begin(), world.contacts().end());
    const auto expected = of_bullets(world);
    REQUIRE(expected > 60); // some lie in two boxes
    std::size_t seen = 0, removed = 0, hits = 0;
    for (const auto& contact : world.contacts()) {
        REQUIRE(seen < all.size());
        CHECK((contact.first == all[seen].first && contact.second == all[seen].second &&
               contact.depth == all[seen].depth));
        ++seen;
        hits += is_bullet(contact.first) || is_bullet(contact.second);
        for (const auto& body : {contact.first, contact.second}) {
            if (!is_bullet(body)) continue;
            if (!world.contains(body)) continue; // it was in another contact, too
            world.remove(body);
            ++removed;
            if (removed % 2 == 0)
                world.add(Box{metres(0.1, 0.1, 0.1)}, position(metres(0, 100.0 + double(removed), 0)),
                          mass(0.1 * kilogram)); // takes the id
        }
    }
    CHECK(seen == all.size());
    CHECK(hits == expected);
    CHECK(removed == 60);
    CHECK(of_bullets(world) == expected); // what it was, until the next step

    // A copy and a loaded world go on in the same way.
    auto copy = world, loaded = world;
    std::stringstream file;
    save(world, file);
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
    CHECK(of_bullets(loaded) == 0); // a file does not know bodies that are gone
    for (auto* w : {&world, &copy, &loaded}) w->step(1.0 / 240 * second);
    CHECK((copy.hash() == world.hash() && loaded.hash() == world.hash()));
    CHECK(of_bullets(world) == 0);
    std::size_t ended = 0;
    for (const auto& end : world.contacts_ended()) {
        const bool of_bullet = is_bullet(end.first) || is_bullet(end.second);
        ended += of_bullet;
        CHECK((!of_bullet || !world.contains(is_bullet(end.first) ? end.first : end.second)));
    }
    CHECK(ended == expected);
    world.step(1.0 / 240 * second);
    CHECK(world.contacts_ended().size() < expected); // told once
}

TEST_CASE("V6: a contact of a removed body wakes nobody and holds nobody, also when its id is given again",
          "[collision][verbs][V6]") {
    auto world =
        resting_world<Space<>>(SemiImplicitEuler{}, SoftSubsteps<Friction>{}, Springs<Breaking>{}, AppliedForces{});
    const auto ground = world.add(Plane::ground(), fixed);
    const auto lower = world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(0, 0.5, 0)), mass(1.0 * kilogram));
    const auto upper = world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(0, 1.5, 0)), mass(1.0 * kilogram));
    run(world, 240, 1.0 / 60);
    REQUIRE(world.count(Motion::resting) == 2);
    world.remove(upper);
    const auto other = world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(9, 0.5, 0)), mass(1.0 * kilogram));
    REQUIRE(other.id == upper.id);
    run(world, 240, 1.0 / 60);
    REQUIRE((world.motion(lower) == Motion::resting && world.motion(other) == Motion::resting));
    world.remove(lower);
    world.wake(other); // they never met
    world.remove(ground);
    CHECK(world.contacts().size() == 2);
    run(world, 15, 1.0 / 60);
    CHECK(world.contacts().empty());
    CHECK(height_of(world, other) < 0.5 - 0.99 * 0.5 * 9.81 * 0.0625);
}

TEST_CASE("V6: who removes bodies while he walks over contacts_ended(), events(), handles() and elements skips nobody",
          "[collision][verbs][V6]") {
    auto world = hail();
    SECTION("handles") {
        std::size_t seen = 0;
        for (const auto& body : world.handles()) {
            ++seen;
            if (is_bullet(body)) world.remove(body);
        }
        CHECK(seen == 161);
        CHECK(world.size() == 101);
    }
    SECTION("contacts that ended") {
        for (const auto& body : world.handles())
            if (is_bullet(body)) world.set_position(body, metres(2 * double(body.id), 500, 0));
        world.step(1.0 / 240 * second);
        const auto expected = world.contacts_ended().size();
        REQUIRE(expected >= 60);
        std::size_t seen = 0;
        for (const auto& end : world.contacts_ended()) {
            ++seen;
            for (const auto& body : {end.first, end.second})
                if (is_bullet(body) && world.contains(body)) world.remove(body);
        }
        CHECK(seen == expected);
        CHECK(world.size() == 101);
    }
    SECTION("events") {
        std::set<std::uint32_t> asleep;
        for (int i = 0; i < 2000 && asleep.empty(); ++i) {
            world.step(1.0 / 240 * second);
            const auto before = std::vector(world.events().begin(), world.events().end());
            std::size_t seen = 0;
            for (const auto& event : world.events()) {
                REQUIRE(event == before[seen++]);
                if (event.kind != Event::Kind::slept) continue;
                asleep.insert(event.body.id);
                world.remove(event.body); // wakes its neighbours, which is an event, too
            }
            CHECK(seen == before.size());
        }
        REQUIRE(asleep.size() > 10);
        CHECK(world.size() == 161 - asleep.size());
    }
    SECTION("elements, and those that broke") {
        const auto bodies = world.handles();
        for (std::size_t i = 101; i + 1 < bodies.size(); ++i)
            world.add(Spring{bodies[i], bodies[i + 1], (i % 2 == 0 ? 1.0 : 1e3) * newton_per_metre,
                             0.0 * newton_second_per_metre, 1e-3 * metre},
                      breaks_at(50.0 * newton));
        const auto springs = world.elements<Spring>().handles();
        REQUIRE(springs.size() == 59);
        world.step(1.0 / 240 * second);
        const auto broken = world.elements<Spring>().broken().size();
        REQUIRE(broken > 5);
        REQUIRE(broken < 40);
        std::size_t seen = 0, gone = 0;
        for (const auto& spring : world.elements<Spring>().broken()) {
            ++seen;
            if (world.contains(spring.first.body()))
                world.remove(spring.first.body()), ++gone; // takes its other springs with it
        }
        CHECK(seen == broken);
        CHECK(world.size() == 161 - gone);
        seen = 0;
        for (const auto& spring : world.elements<Spring>().handles()) {
            ++seen;
            CHECK(world.contains(spring));
            world.remove(spring);
        }
        CHECK(seen < springs.size() - broken);
        CHECK(world.elements<Spring>().size() == 0);
    }
}
