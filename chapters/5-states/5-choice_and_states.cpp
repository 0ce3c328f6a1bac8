// SPDX-License-Identifier: BSL-1.0
// 5 Choice and states: what an entity is doing, and the conditions under which it does something else

// A finite state machine is a list of states and a list of transitions. A train between two stations has four states,
// each with one thing to do: it pulls, it rolls, it brakes, it stands. Between them there are conditions. They read the
// world, in its units, and the machine is asked once in every step of the same fixed clock. How long each state lasts
// follows from chapter 1, so that we can hold the machine against it.

#include "claims.hpp"
#include "graphviz.hpp"
#include "plot.hpp"

#include <ansatz/states.hpp>
#include <ansatz/world.hpp>

#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::states;

namespace {

const auto dt = 1.0 / 60 * second;
constexpr auto engine = 80000.0 * newton; // of a train of 100 t: 0.8 m/s^2
constexpr auto brakes = 100000.0 * newton;
constexpr auto top_speed = 20.0 * metre_per_second;
constexpr auto station = 1000.0 * metre;

//! [scene]
/// What the machine decides about: a train in its world.
struct Line {
    World<VelocityVerlet, AppliedForces> world{VelocityVerlet{}, AppliedForces{}};
    Handle train = world.add(mass(100000.0 * kilogram));
    int arrivals = 0;

    auto speed() const { return x(world.velocity(train)); }
    auto place() const { return x(world.position(train)); }
    /// The way to a standstill: s = v^2 / 2a, one of the SUVAT equations.
    auto braking_distance() const { return speed() * speed() / (2.0 * brakes / (100000.0 * kilogram)); }
    auto left() const { return station - place() - braking_distance(); }
    void push(Quantity<unit::Force> f) { world.apply_force(train, f * Vector<double, 3>(1, 0, 0)); }
};
//! [scene]

//! [machine]
struct Driver {
    using Context = Line;
    static constexpr auto machine = states::machine(
        state("stands", on_entry([](Line& l) { l.world.set_velocity(l.train, metres_per_second(0, 0, 0)); }),
              transition(when(after(5.0 * second) &&
                              asked("a station is ahead", [](const Line& l) { return l.arrivals == 0; })),
                         to("pulls"))),
        state("pulls", each_update([](Line& l) { l.push(engine); }),
              transition(when(value("speed", &Line::speed) >= top_speed), to("rolls"))),
        state("rolls",
              transition(when(value("what is left before the brakes", &Line::left) <= 0.0 * metre), to("brakes"))),
        state("brakes", each_update([](Line& l) { l.push(-brakes); }), on_exit([](Line& l) { ++l.arrivals; }),
              transition(when(falls_through(value("speed", &Line::speed), 0.0 * metre_per_second)), to("stands"))));
};
//! [machine]

} // namespace

int main() {
    workbook::Claims claim;
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Velocity>> speeds;
    struct Leg {
        std::string state;
        Quantity<unit::Time> begin;
    };
    std::vector<Leg> legs{{"stands", 0.0 * second}};

    //! [run]
    Line line;
    Machine<Driver, Switch> driver;
    driver.start(line);
    while (line.world.time() < 90.0 * second) {
        driver.update(line, dt); // decides
        line.world.step(dt);     // and the world goes on
        //! [run]
        if (legs.back().state != driver.active_name()) {
            legs.push_back({std::string(driver.active_name()), driver.time()});
            if (driver.is_in("rolls")) // its machine, as it is at that moment
                workbook::draw_graph("5-machine", to_dot(outline_of<Driver>(), driver.active_names()));
        }
        times.push_back(line.world.time());
        speeds.push_back(line.speed());
    }
    for (const auto& leg : legs) std::cout << std::setw(9) << leg.begin.value() << " s  " << leg.state << '\n';
    claim("it stands, pulls, rolls, brakes and stands",
          legs.size() == 5 && legs[2].state == "rolls" && driver.is_in("stands"));
    claim("it pulls for v/a = 25 s", abs(legs[2].begin - legs[1].begin - 25.0 * second) < 2.0 * dt);
    claim("it brakes for v/a = 20 s", abs(legs[4].begin - legs[3].begin - 20.0 * second) < 2.0 * dt);
    const auto off = line.place() - station;
    std::cout << "It came to a stand " << off << " from the mark\n";
    // A machine decides at its updates: the brakes are up to a step late.
    claim("less than the way of a step at 20 m/s, a third of a metre", abs(off) < top_speed * dt);
    claim("and there it stands", norm(line.world.velocity(line.train)) == 0.0 * metre_per_second);

    workbook::Plot plot("5", "Each state does one thing; the conditions between them read the world");
    plot.x("time").y("speed").y_range(0.0 * metre_per_second, 25.0 * metre_per_second).line("the train", times, speeds);
    for (std::size_t i = 1; i < legs.size(); ++i) plot.vertical(legs[i].begin, legs[i].state);
    plot.write();
    return claim.result();
}
