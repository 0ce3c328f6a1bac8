// SPDX-License-Identifier: BSL-1.0
// The scene of section 2.2.1 with your impulse in it: a shot into a row of balls of all masses.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

const auto threshold = 0.25 * metre_per_second;

/// A response of a world that changes velocities as you say.
struct Yours {
    using role = roles::Response;
    static constexpr Level level = Level::velocities;
    using reads = Columns<Restitution>;
    using writes = Columns<Velocity>;
    static constexpr std::string_view name = "Yours";
    template <class S> struct In {
        explicit In(const Yours&) {}
        void respond(const auto& touch, auto& a, auto& b, const auto&) const {
            exercise::Body first{a.template get<Velocity>(), a.template get<InverseMass>()};
            exercise::Body second{b.template get<Velocity>(), b.template get<InverseMass>()};
            const auto parting = exercise::parting_speed(first.velocity, second.velocity, touch.normal);
            const double e = exercise::bounce(double(a.template get<Restitution>()),
                                              double(b.template get<Restitution>()), parting, threshold);
            exercise::apply(first, second, touch.normal,
                            exercise::impulse(parting, first.inverse_mass, second.inverse_mass, e));
            a.template get<Velocity>() = first.velocity;
            b.template get<Velocity>() = second.velocity;
        }
    };
};

template <class Response> void show(const char* who, Response response, workbook::Play& table) {
    World world{SemiImplicitEuler{}, UniformGrid{}, Narrowphase<Sphere>{}, response};
    world.add(Sphere{0.5 * metre}, position(metres(-5, 0.2, 0.1)), velocity(metres_per_second(30, 0, 0)),
              mass(5.0 * kilogram), restitution(0.9));
    for (int i = 0; i < 125; ++i)
        world.add(Sphere{0.5 * metre}, position(metres(1.01 * (i / 25), 1.01 * (i % 5 - 2), 1.01 * (i / 5 % 5 - 2))),
                  mass((1 + i % 4) * kilogram), restitution(i % 3 ? 0.9 : 0.6));
    const auto momentum = total_momentum(world);
    const auto energy = kinetic_energy(world);
    double contacts = 0;
    for (int i = 0; i < 240; ++i) {
        world.step(1.0 / 240 * second);
        contacts += double(world.contacts().size());
    }
    table.row(who, {contacts, norm(total_momentum(world) - momentum).value(), double(kinetic_energy(world) / energy)},
              126, [world]() mutable { world.step(1.0 / 240 * second); });
}

int main() {
    workbook::Play table("A ball of 5 kg is shot at 30 m/s into 125 balls of 1 to 4 kg with e = 0.6 and 0.9; nothing "
                         "moves them apart; 1 s",
                         {"contacts in all", "momentum off by, kg m/s", "energy left"});
    show("yours", Yours{}, table);
    show("library", Impulse<>{threshold}, table);
    return table.print();
}
