// SPDX-License-Identifier: BSL-1.0
// The scene of section 2.2 with your projection in it: a heap of balls that are in each other, light ones and heavy
// ones.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include <algorithm>

using namespace ansatz;

const auto slop = 0.002 * metre;
const double share = 0.5;

/// A response of a world that moves bodies as you say.
struct Yours {
    using role = roles::Response;
    static constexpr Level level = Level::positions;
    using reads = Columns<>;
    using writes = Columns<Position>;
    static constexpr std::string_view name = "Yours";
    template <class S> struct In {
        explicit In(const Yours&) {}
        void respond(const auto& touch, auto& a, auto& b, const auto&) const {
            exercise::Body first{a.template get<Position>(), a.template get<InverseMass>()};
            exercise::Body second{b.template get<Position>(), b.template get<InverseMass>()};
            exercise::push_apart(first, second, touch.normal, exercise::correction(touch.depth, slop, share));
            a.template get<Position>() = first.position;
            b.template get<Position>() = second.position;
        }
    };
};

template <class Response> void show(const char* who, Response response, workbook::Play& table) {
    World world{SemiImplicitEuler{}, UniformGrid{}, Narrowphase<Sphere>{}, response, Keep<InverseMass>{}};
    std::vector<Handle> balls;
    auto mass_of = [](int i) { return i % 7 == 0 ? 20.0 : 1.0; };
    for (int i = 0; i < 125; ++i)
        balls.push_back(world.add(Sphere{0.5 * metre},
                                  position(metres(0.7 * (i % 5), 0.8 * (i / 5 % 5), 0.75 * (i / 25))),
                                  mass(mass_of(i) * kilogram)));
    auto centre = [&] {
        Vector<double, 3> sum = Vector<double, 3>::Zero();
        double all = 0;
        for (int i = 0; i < 125; ++i) sum += mass_of(i) * world.position(balls[i]).value(), all += mass_of(i);
        return Vector<double, 3>(sum / all);
    };
    const auto before = centre();
    world.step(1.0 / 60 * second);
    const double contacts = double(world.contacts().size());
    for (int i = 0; i < 100; ++i) world.step(1.0 / 60 * second);
    double deepest = 0;
    for (const auto& contact : world.contacts()) deepest = std::max(deepest, contact.depth.value());
    table.row(who, {contacts, deepest, (centre() - before).norm()}, 125,
              [world]() mutable { world.step(1.0 / 60 * second); });
}

int main() {
    workbook::Play table("125 balls in each other, every seventh of 20 kg, the others of 1 kg; half of what is deeper "
                         "than 2 mm goes in a step; 100 steps",
                         {"contacts at first", "deepest at last, m", "centre of mass off by, m"});
    show("yours", Yours{}, table);
    show("library", Projection{slop, share}, table);
    return table.print();
}
