// SPDX-License-Identifier: BSL-1.0
// The chain of section 3.3, hung where you say that it hangs, by your forces and by the library's Springs; then a tap.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

using Length = Quantity<unit::Length>;
using Time = Quantity<unit::Time>;

const exercise::Chain chain{20, 0.05 * kilogram, 500.0 * newton_per_metre, 0.1 * metre};
const auto g = 9.81 * metre_per_second_squared;
const auto dt = 1.0 / 2000 * second;

/// Bodies that hang still where you say, the last one tapped.
template <class World> std::vector<Handle> hang(World& world) {
    std::vector<Handle> bodies;
    for (int i = 1; i <= chain.links; ++i)
        bodies.push_back(world.add(position(metres(0, -exercise::hangs_at(i, chain, g).value(), 0)), mass(chain.mass)));
    world.apply_impulse(bodies.back(), newton_seconds(0, -0.02, 0));
    return bodies;
}
Length moved(const auto& world, const std::vector<Handle>& bodies, int i) {
    return -y(world.position(bodies[std::size_t(i - 1)])) - exercise::hangs_at(i, chain, g);
}

int main() {
    // Yours: what holds the weight is left out, since your forces leave it out.
    World yours{SemiImplicitEuler{}, Keep<InverseMass>{}};
    const auto bodies = hang(yours);
    auto step = [bodies](auto& world) {
        std::vector<Length> by;
        for (int i = 1; i <= chain.links; ++i) by.push_back(moved(world, bodies, i));
        const auto on = exercise::forces(by, chain.stiffness);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            world.apply_impulse(bodies[i], newtons(0, -on[i].value(), 0) * dt);
        world.step(dt);
    };
    World library{SemiImplicitEuler{}, Gravity{}, Springs<Undamped>{}};
    const auto its = hang(library);
    SpringEnd above = metres(0, 0, 0);
    for (const Handle& body : its) {
        library.add(Spring{above, body, chain.stiffness, {}, chain.rest_length});
        above = body;
    }

    std::vector<Time> times;
    std::vector<Length> of_yours, of_the_library;
    for (int i = 0; i <= 800; ++i) {
        if (i > 0) step(yours), library.step(dt);
        times.push_back(double(i) * dt);
        of_yours.push_back(moved(yours, bodies, 10)), of_the_library.push_back(moved(library, its, 10));
    }
    workbook::Play table(
        "A chain of 20 bodies hung where you say, and tapped at its end, after 0.4 s: by your forces, and "
        "by Springs",
        {"body 10 moved by, mm", "body 20, mm"});
    table.timed("ns a step");
    table.row("yours", {1000 * of_yours.back().value(), 1000 * moved(yours, bodies, 20).value()}, 1,
              [yours, step]() mutable { step(yours); });
    table.row("library", {1000 * of_the_library.back().value(), 1000 * moved(library, its, 20).value()}, 1,
              [library]() mutable { library.step(dt); });
    workbook::Plot plot("play-springs.hanging_chain", "Body 10 of 20 after a tap at the lower end");
    plot.x("time").y("moved down by");
    plot.line("yours", times, of_yours).reference("library", times, of_the_library);
    plot.write();
    const double longest = exercise::group_speed(1e-3, chain).value();
    const int status = table.print();
    std::cout << "By your group speed the first of the tap has run the ten links to body 10 after " << 10 / longest
              << " s.\n";
    return status;
}
