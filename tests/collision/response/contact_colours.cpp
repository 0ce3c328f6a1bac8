// SPDX-License-Identifier: BSL-1.0
// SoftSubsteps<Coloured>: the same formulas in the order of colours, to the bit those of contacts that are solved one
// by one in that order; what a world is promised of the response holds for it, too.
// Runs long with the sanitizers.

#include "tests/collision/support.hpp"

#include <ansatz/collision/response/coloured_soft_contacts.hpp>
#include <ansatz/collision/response/contact_colours.hpp>
#include <ansatz/world/save.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>
#include <vector>

using namespace collision_tests;

namespace {
constexpr double dt = 1.0 / 60; // s

/// The oracle: contacts one by one, as SoftContacts solves them, in the order of their groups and colours. A colour is
/// the first that no contact of the group before has given to one of the bodies, found by looking at all of them; a
/// stage the same of groups and blocks.
template <class... Options> struct InColours : SoftSubsteps<Options...> {
    template <class S> struct State : SoftContacts<S, SoftSubsteps<Options...>::rubs> {
        using Base = SoftContacts<S, SoftSubsteps<Options...>::rubs>;
        using typename Base::Raw;
        using typename Base::Scalar;
        std::vector<std::uint32_t> order{};

        template <class Data, class FrictionOf> void begin(const Data& data, const FrictionOf& friction) {
            Base::begin(data, friction);
            std::size_t width = 1024; // of a block of ids
            while (32 * width < data.bodies.ids()) width *= 2;
            const auto moved = [&](std::uint32_t n) {
                std::vector<std::uint32_t> ids;
                const auto& c = this->all[n];
                for (const auto& [id, slot] : {std::pair(c.a, c.slot_a), std::pair(c.b, c.slot_b)})
                    if (this->bodies[slot].weight > 0) ids.push_back(id);
                return ids;
            };
            const auto blocks = [&](std::uint32_t n) {
                const auto ids = moved(n);
                const std::size_t a = ids.front() / width, b = ids.back() / width;
                return std::pair(std::max(a, b) - std::min(a, b), std::min(a, b)); // those near each other come first
            };
            std::map<std::pair<std::size_t, std::size_t>, int> stage_of;
            for (const auto n : this->acting_) stage_of[blocks(n)] = 0;
            std::map<std::size_t, std::set<int>> busy; // by block
            for (auto& [where, stage] : stage_of) {
                const auto [apart, block] = where;
                if (apart > 0) stage = 1;
                while (busy[block].count(stage) + busy[block + apart].count(stage) > 0) ++stage;
                busy[block].insert(stage), busy[block + apart].insert(stage);
            }
            using Group = std::pair<std::size_t, std::size_t>;
            std::map<std::pair<Group, std::uint32_t>, std::set<int>> given; // by body
            std::vector<std::pair<std::tuple<int, Group, int>, std::uint32_t>> coloured;
            for (const auto n : this->acting_) {
                const auto group = blocks(n);
                std::set<int> there;
                for (const auto id : moved(n)) there.insert(given[{group, id}].begin(), given[{group, id}].end());
                int colour = 0;
                while (colour < 64 && there.count(colour) > 0) ++colour;
                if (colour < 64)
                    for (const auto id : moved(n)) given[{group, id}].insert(colour);
                coloured.emplace_back(std::tuple(stage_of[group], group, colour), n);
            }
            std::stable_sort(coloured.begin(), coloured.end(), [](auto& x, auto& y) { return x.first < y.first; });
            order.clear();
            for (const auto& [colour, n] : coloured) order.push_back(n);
        }
        /// In that order; with friction, a contact computes both impulses from the same velocities.
        void pass(auto&& by_base, auto&& bias_of) {
            if constexpr (Base::rubs) {
                for (const auto n : order) {
                    auto& c = this->all[n];
                    const auto how = bias_of(c);
                    if (how.skip) continue;
                    const Raw going = this->bodies[c.slot_a].u - this->bodies[c.slot_b].u;
                    const Scalar along = dot(going, c.normal);
                    const Scalar j = -c.mass * how.mass * (along + how.bias) - how.impulse * c.impulse;
                    const Scalar now = std::max(c.impulse + j, Scalar(0));
                    Raw rubbing = c.rubbing - c.mass * (going - along * c.normal);
                    const Scalar size = norm(rubbing), most = c.friction * now;
                    if (!(most > Scalar(0))) rubbing.setZero(); // of the smallest numbers the square is zero
                    else if (size > most) rubbing *= most / size;
                    this->push(c, Raw((now - c.impulse) * c.normal + (rubbing - c.rubbing)));
                    c.impulse = now;
                    c.rubbing = rubbing;
                }
            } else {
                this->acting_.swap(order);
                by_base();
                this->acting_.swap(order);
            }
        }
        struct How {
            Scalar bias{}, mass{1}, impulse{0};
            bool skip = false;
        };
        void warm_start() {
            if constexpr (Base::rubs)
                for (const auto n : order) this->push(this->all[n], this->whole(this->all[n]));
            else pass([&] { Base::warm_start(); }, 0);
        }
        void solve(Scalar h, const Softness<Scalar>& soft, const Softness<Scalar>& held, Scalar slop, Scalar out) {
            pass([&] { Base::solve(h, soft, held, slop, out); },
                 [&](const auto& c) {
                     const Scalar s = this->apart(c), per_h = 1 / h;
                     if (s > Scalar(0)) return How{s * per_h};
                     const bool both = this->bodies[c.slot_a].weight > 0 && this->bodies[c.slot_b].weight > 0;
                     const auto& how = both ? soft : held;
                     return How{std::max(how.rate * std::min(s + slop, Scalar(0)), -out), how.mass, how.impulse};
                 });
        }
        void relax(Scalar h) {
            pass([&] { Base::relax(h); },
                 [&](const auto& c) {
                     const Scalar s = this->apart(c), per_h = 1 / h;
                     return How{s > Scalar(0) ? s * per_h : Scalar(0), 1, 0, s > Scalar(0) && !(c.impulse > 0)};
                 });
        }
        void unload(const auto& before) {
            if (this->loads_.take_off(*this, before)) warm_start();
        }
    };
    template <class S> struct In : SoftSubsteps<Options...>::template In<S> {
        explicit In(const InColours& from) : SoftSubsteps<Options...>::template In<S>(from) {}
    };
};

/// Spheres and boxes of unlike masses that fall into a box, so that some bounce, some press and some sleep.
/// \param holes so many ids are free between those of two bodies
template <class S, class Response, class... P>
auto dropped(int count, Response response, unsigned seed, int holes, P... policies) {
    World world{
        S{}, SemiImplicitEuler{}, Gravity{}, response, policies..., UniformGrid{}, Narrowphase<Sphere, Plane, Box>{}};
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> between(-1, 1);
    const double half = 1.5;
    const auto rough = [&](Handle body, double mu) {
        if constexpr (decltype(world)::composition::template stores<Friction>)
            world.template write<Friction>(body, Quantity<unit::Dimensionless>(mu));
        return body;
    };
    rough(world.add(Plane::ground(), fixed), 0.5);
    for (int k = 0; k < S::dimension; ++k)
        for (const double side : {-1.0, 1.0}) {
            if (k == 1) continue;
            rough(world.add(Plane{Eigen::Vector3d(side * Eigen::Vector3d::Unit(k)), -half * metre}, fixed), 0.5);
        }
    std::vector<Handle> gone;
    for (int i = 0; i < count; ++i) {
        for (int hole = 0; hole < holes; ++hole)
            gone.push_back(world.add(Sphere{0.1 * metre}, at<S>(50, 50, 50), fixed));
        if (holes > 0 && i == count / 2) rough(world.add(Sphere{0.5 * metre}, at<S>(0.2, 0.3, 0.1), fixed), 0.5);
        const double r = 0.2 + 0.05 * between(random);
        const auto where = at<S>(half * 0.7 * between(random), 0.5 + 0.45 * i / (S::dimension == 3 ? 4 : 2),
                                 half * 0.7 * between(random));
        const auto m = mass(std::pow(2.0, 2 * between(random)) * kilogram);
        const auto e = restitution(i % 5 == 0 ? 0.5 : 0);
        if (i % 4 == 3 && S::dimension == 3) {
            rough(world.add(Box{metres(r, r, r)}, where, m, e), 0.3 + 0.3 * between(random));
        } else rough(world.add(Sphere{r * metre}, where, m, e), 0.3 + 0.3 * between(random));
    }
    for (const auto hole : gone) world.remove(hole);
    return world;
}

/// \param holes so many ids are free between those of two bodies
template <class S, class... Options> void check_same_bits(int count, int steps, int holes, auto... policies) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        auto wide = dropped<S>(count, SoftSubsteps<Coloured, Options...>{}, seed, holes, policies...);
        auto plain = dropped<S>(count, InColours<Options...>{}, seed, holes, policies...);
        for (int n = 0; n < steps; ++n) {
            if (n % 90 == 89) { // what sleeps and is pulled at from there wakes within the step
                wide.set_velocity(wide.handles().back(), vector_in<S, unit::Velocity>(0, 2, 0));
                plain.set_velocity(plain.handles().back(), vector_in<S, unit::Velocity>(0, 2, 0));
            }
            wide.step(dt * second);
            plain.step(dt * second);
            INFO("step " << n << " of " << steps << ", seed " << seed << ", " << S::dimension << " dimensions, "
                         << wide.contacts().size() << " contacts");
            REQUIRE(wide.hash() == plain.hash());
        }
    }
}
} // namespace

TEST_CASE("Contacts by colours: the same bits as one by one in the same order", "[collision][soft]") {
    check_same_bits<Space<>>(120, 150, 0);
    check_same_bits<Space<float, 3>>(120, 150, 0);
    check_same_bits<Space<double, 2>>(60, 150, 0);
    check_same_bits<Space<float, 2>>(60, 150, 0);
}

TEST_CASE("Contacts by colours: the same bits where bodies sleep and are woken", "[collision][soft]") {
    const Rest soon{0.3 * metre_per_second, 0.15 * second};
    check_same_bits<Space<>>(80, 500, 0, soon);
    check_same_bits<Space<>>(30, 700, 0, soon, Attraction{Quantity<unit::GravitationalConstant>::from_value(1e-5)});
}

TEST_CASE("Contacts by colours: the same bits in groups", "[collision][soft]") {
    // One in 60 ids is a body: blocks of 17 bodies, and contacts within and between all of them.
    check_same_bits<Space<>>(120, 150, 60);
    check_same_bits<Space<float, 3>, Friction>(120, 150, 60);
    check_same_bits<Space<float, 2>>(60, 150, 700); // of more than a thousand ids each
    check_same_bits<Space<>>(80, 500, 100, Rest{0.3 * metre_per_second, 0.15 * second});
}

TEST_CASE("Contacts by colours: a body with more contacts than there are colours", "[collision][soft]") {
    // A heavy ball in a nest of ninety small ones, all around it.
    const auto nest = [](auto response) {
        World world{SemiImplicitEuler{}, response, UniformGrid{}, Narrowphase<Sphere, Plane, Box>{}};
        world.add(Sphere{1.0 * metre}, at<Space<>>(0, 0, 0), mass(20.0 * kilogram));
        for (int i = 0; i < 90; ++i) { // along a spiral upon the ball
            const double y = -0.99 + 1.98 * i / 89, around = 2.399963 * i, out = std::sqrt(1 - y * y);
            const double far = 1.09;
            world.add(Sphere{0.1 * metre},
                      at<Space<>>(far * out * std::cos(around), far * y, far * out * std::sin(around)),
                      mass(0.1 * kilogram));
        }
        return world;
    };
    auto wide = nest(SoftSubsteps<Coloured>{});
    auto plain = nest(InColours<>{});
    for (int n = 0; n < 30; ++n) {
        wide.step(dt * second);
        plain.step(dt * second);
        if (n == 0) REQUIRE(wide.contacts().size() >= 90);
        REQUIRE(wide.hash() == plain.hash());
    }
}

TEST_CASE("Contacts by colours: the same bits with friction", "[collision][soft]") {
    check_same_bits<Space<>, Friction>(120, 150, 0);
    check_same_bits<Space<float, 2>, Friction>(60, 150, 0);
}

TEST_CASE("Contacts by colours: a pass does what one by one does, but for rounding", "[collision][soft]") {
    // Of one contact, and of many that share no body: there is no order between them.
    using One = SoftContacts<Space<>, true>;
    using Many = ColouredSoftContacts<Space<>, true>;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> between(-1, 1);
    const auto any = [&] { return Eigen::Vector3d(between(random), between(random), between(random)); };
    for (const std::uint32_t pairs : {1u, 3u, 64u, 65u, 200u}) {
        One one;
        Many many;
        for (std::uint32_t n = 0; n < pairs; ++n) {
            for (const int side : {0, 1})
                one.bodies.push_back({any(), side * Eigen::Vector3d::UnitY() + 0.1 * any(),
                                      side == 1 && n % 3 == 0 ? 0 : 1 + 0.9 * between(random)});
            One::Constraint c;
            c.a = c.slot_a = 2 * n;
            c.b = c.slot_b = 2 * n + 1;
            c.normal = any().normalized();
            c.touching =
                c.normal.dot(one.bodies[c.slot_a].position - one.bodies[c.slot_b].position) + 0.01 * between(random);
            c.impulse = std::max(between(random), 0.0);
            c.rubbing = c.impulse * any();
            c.rubbing -= c.rubbing.dot(c.normal) * c.normal;
            c.friction = n % 5 == 0 ? 0 : 0.5;
            if (n % 5 == 0) c.rubbing.setZero();
            one.all.push_back(c);
        }
        many.all = one.all;
        many.bodies = one.bodies;
        one.weigh();
        many.weigh();
        const double h = 1.0 / 240;
        const auto soft = Softness<double>::of(60, 5, h), held = Softness<double>::of(120, 5, h);
        const auto compare = [&](const char* after) {
            many.finish(); // impulses are where `all` is
            for (std::size_t n = 0; n < one.all.size(); ++n) {
                INFO(pairs << " contacts, after " << after << ", contact " << n);
                CHECK(std::abs(one.all[n].impulse - many.all[n].impulse) <= 1e-13);
                CHECK((one.all[n].rubbing - many.all[n].rubbing).norm() <= 1e-13);
            }
            for (std::size_t n = 0; n < one.bodies.size(); ++n) {
                CHECK((one.bodies[n].u - many.bodies[n].u).norm() <= 1e-12);
                CHECK(one.bodies[n].weight == many.bodies[n].weight);
                CHECK(one.bodies[n].position == many.bodies[n].position);
            }
        };
        one.warm_start(), many.warm_start();
        compare("warm start");
        one.warm_start(), many.warm_start(); // the colours are made anew
        one.solve(h, soft, held, 0.001, 1.5), many.solve(h, soft, held, 0.001, 1.5);
        compare("solve");
        one.warm_start(), many.warm_start();
        one.relax(h), many.relax(h);
        compare("relax");
    }
}

TEST_CASE("Contacts by colours: impulses belong to their contacts where sleepers' contacts come between them",
          "[collision][soft]") {
    // Behind a pass those of the colours are the newer ones, and then the places of the contacts change.
    using Many = ColouredSoftContacts<Space<>, false>;
    Many many;
    for (std::uint32_t n = 0; n < 3; ++n) {
        for (const int side : {0, 1})
            many.bodies.push_back({Eigen::Vector3d(side == 0 ? -1.0 - n : 0.0, 0, 0), Eigen::Vector3d::Zero(), 1.0});
        Many::Constraint c;
        c.a = c.slot_a = 2 * n;
        c.b = c.slot_b = 2 * n + 1;
        c.normal = Eigen::Vector3d::UnitX();
        c.touching = 0;
        many.all.push_back(c);
    }
    many.make_room_to_sleep(1, 6);
    many.put_to_sleep([](const auto& c) { return c.a == 0; });
    REQUIRE(many.all.size() == 2);
    many.weigh();
    many.warm_start();
    many.relax(1.0 / 240);
    many.make_room_to_wake();
    many.leave(0);
    many.wake_contacts();
    many.finish();
    REQUIRE(many.all.size() == 3);
    // A plastic impact of two of 1 kg takes half of their approach.
    for (const std::uint32_t n : {0u, 1u, 2u}) CHECK(many.all[n].impulse == (n == 0 ? 0 : 0.5 * (1 + n)));
}
