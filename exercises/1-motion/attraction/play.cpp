// SPDX-License-Identifier: BSL-1.0
// Two stars and a planet that attract each other, by your force and by the library's Attraction, in a World.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

const auto G = 1.0 * (cubic_metre / (kilogram * second * second));
const auto softening = 0.05 * metre;

/// Your force, as a policy that couples bodies.
struct YourAttraction {
    using role = roles::Force;
    using reads = Columns<Position, InverseMass>;
    static constexpr bool couples_bodies = true;
    static constexpr std::string_view name = "YourAttraction";
    static void parameters(auto&, auto&&) {}
    template <class S> struct In {
        explicit In(const YourAttraction&) {}
        void couple(auto& view, const auto&) const {
            view.for_each([&](std::size_t i) {
                view.for_each([&](std::size_t j) {
                    if (i < j)
                        view.add_force_pair(i, j, exercise::force_on_first(body(view, i), body(view, j), G, softening));
                });
            });
        }
        typename S::Energy potential_energy(const auto& view) const {
            typename S::Energy sum{};
            view.for_each([&](std::size_t i) {
                view.for_each([&](std::size_t j) {
                    if (i < j) sum += exercise::potential_energy(body(view, i), body(view, j), G, softening);
                });
            });
            return sum;
        }

    private:
        static exercise::Body body(const auto& view, std::size_t i) {
            return {1.0 / view.template get<InverseMass>(i), view.template get<Position>(i)};
        }
    };
};

template <class Force> void show(const char* who, Force force, workbook::Play& table) {
    World sky{VelocityVerlet{}, force};
    sky.add(position(metres(-0.5, 0, 0)), velocity(metres_per_second(0, -0.5, 0)), mass(0.5 * kilogram));
    sky.add(position(metres(0.5, 0, 0)), velocity(metres_per_second(0, 0.5, 0)), mass(0.5 * kilogram));
    const auto planet =
        sky.add(position(metres(4, 0, 0)), velocity(metres_per_second(0, 0.5, 0)), mass(1e-3 * kilogram));
    const auto energy = total_energy(sky);
    for (int i = 0; i < 5000; ++i) sky.step(0.005 * second);
    table.row(who,
              {double(total_energy(sky) / energy), x(sky.position(planet)).value(), y(sky.position(planet)).value()}, 3,
              [sky]() mutable { sky.step(0.005 * second); });
}

int main() {
    workbook::Play table("A planet about two stars, 25 s: a World with your attraction, and with the library's.",
                         {"energy, of the beginning", "planet's x, m", "planet's y, m"});
    show("yours", YourAttraction{}, table);
    show("library", Attraction{G, softening}, table);
    return table.print();
}
