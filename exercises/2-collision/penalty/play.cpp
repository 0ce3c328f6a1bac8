// SPDX-License-Identifier: BSL-1.0
// The scene of section 2.2.2 with your contacts in it: a ball that is dropped, with more and more damping.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/springs/stable_step.hpp>
#include <ansatz/world.hpp>

#include <algorithm>

using namespace ansatz;

/// A response of a world whose forces are yours. It keeps the contacts of a step as the library's does, for the next
/// one.
struct Yours : Penalty {
    static constexpr std::string_view name = "Yours";
    template <class S> struct In : Penalty::In<S> {
        explicit In(const Yours& yours) : Penalty::In<S>(yours) {}
        void couple(auto& view, const auto&) const {
            for (const auto& pair : view.state().pairs()) {
                Vector<double, 3> normal;
                const auto depth = PenaltyContacts<S>::depth(
                    pair, view.template get<Position>(pair.a) - view.template get<Position>(pair.b), normal);
                const auto parting =
                    dot(view.template get<Velocity>(pair.a) - view.template get<Velocity>(pair.b), normal);
                const auto pressed = exercise::pressing(depth, parting, this->k, this->c);
                // Per kilogram it is the force itself; the world divides by the masses.
                const auto on_first = exercise::accelerations(normal, pressed, 1.0 / kilogram, 1.0 / kilogram).first;
                view.add_force_pair(pair.a, pair.b, typename S::Force(1.0 * kilogram * on_first));
            }
        }
    };
};

const auto k = 2000.0 * newton_per_metre;

/// How high a ball comes that is dropped from 1 m, as the ground is damped.
template <class Response>
void show(const char* who, Quantity<unit::Time> limit, workbook::Play& table, workbook::Plot& plot) {
    std::vector<double> numbers;
    for (const double c : {0.0, 5.0, 20.0}) {
        Response response{};
        response.stiffness = k, response.damping = c * newton_second_per_metre;
        World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, response};
        world.add(Plane::ground(), fixed);
        const auto ball = world.add(Sphere{0.1 * metre}, position(metres(0, 1.1, 0)), mass(1.0 * kilogram));
        std::vector<Quantity<unit::Time>> times;
        std::vector<Quantity<unit::Length>> heights;
        double highest = 0;
        bool was_down = false;
        for (int i = 0; i < 1000; ++i) {
            times.push_back(world.time()), heights.push_back(y(world.position(ball)) - 0.1 * metre);
            was_down = was_down || heights.back() < 0.0 * metre;
            if (was_down) highest = std::max(highest, heights.back().value());
            world.step(1e-3 * second);
        }
        numbers.push_back(highest);
        if (c == 5) plot.line(who, times, heights);
    }
    numbers.push_back(1000 * limit.value());
    World pair{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Response{}};
    for (int i = 0; i < 64; ++i) pair.add(Sphere{0.5 * metre}, position(metres(0.9 * i, 0, 0)), mass(1.0 * kilogram));
    table.row(who, numbers, 64, [pair]() mutable { pair.step(1e-4 * second); });
}

int main() {
    workbook::Play table(
        "A ball of 1 kg falls by 1 m on ground of 2000 N/m with more and more damping: how high it comes again",
        {"c = 0, m", "c = 5 N s/m, m", "c = 20 N s/m, m", "largest step, ms"});
    workbook::Plot plot("play-collision.penalty", "A ball on damped ground: yours and the library's");
    plot.x("time").y("height");
    show<Yours>("yours", exercise::largest_step(k, 1.0 / kilogram, 0.0 / kilogram), table, plot);

    // The library is asked for a ball that lies in its ground.
    World resting{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, Penalty{k}};
    resting.add(Plane::ground(), fixed);
    resting.add(Sphere{0.1 * metre}, position(metres(0, 0.05, 0)), mass(1.0 * kilogram));
    resting.step(1e-9 * second);
    show<Penalty>("library", stable_step(resting), table, plot);
    plot.write();
    return table.print();
}
