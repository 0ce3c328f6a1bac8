// SPDX-License-Identifier: BSL-1.0
// 3.3 A hanging chain: every link carries what hangs below it, and a disturbance travels

// Link i of N carries the N - i + 1 masses below it, so the chain is longer by m g N (N + 1) / 2k. Pull at its lower
// end and the upper one knows nothing of it: a disturbance runs along the chain at sqrt(k/m) links a second. A chain is
// the simplest world in which every body depends on every other, one link at a time. (A part of section 3, which the
// notes do not divide.)

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;

int main() {
    workbook::Claims claim;
    const int links = 20;
    const auto m = 0.05 * kilogram;
    const auto k = 500.0 * newton_per_metre;
    const auto length = 0.1 * metre;

    //! [chain]
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Drag{2.0 / second}}; // in honey, so that it hangs still soon
    std::vector<Handle> chain;
    SpringEnd above = metres(0, 0, 0);
    for (int i = 1; i <= links; ++i) {
        chain.push_back(world.add(position(-double(i) * length * Vector<double, 3>(0, 1, 0)), mass(m)));
        world.add(Spring{above, chain.back(), k, 0.3 * newton_second_per_metre, length});
        above = chain.back();
    }
    //! [chain]
    const auto stable = stable_step(world);
    std::cout << "The largest stable step is at least " << stable << '\n';
    const auto dt = 0.002 * second;
    claim("2 ms are well below it", dt < stable);

    //! [still]
    while (world.time() < 20.0 * second) world.step(dt);
    world.set(Drag{0.0 / second}); // and out of it
    //! [still]
    const auto stretch = -y(world.position(chain.back())) - double(links) * length;
    const auto expected = m * (9.81 * metre_per_second_squared) * double(links * (links + 1)) / (2.0 * k);
    std::cout << "Hung out, it is longer by " << stretch << "; m g N (N + 1) / 2k is " << expected << '\n';
    claim("every link carries what hangs below it", abs(stretch - expected) < 1e-5 * metre);
    const auto first = -y(world.position(chain[0])) - length,
               last = y(world.position(chain[18])) - y(world.position(chain[19])) - length;
    std::cout << "The first link is stretched by " << first << ", the last by " << last << '\n';
    claim("the first twenty times as much as the last", std::abs(double(first / last) - 20) < 1e-2);

    // A tap at the lower end.
    //! [tap]
    const auto quiet = world;
    world.apply_impulse(chain.back(), newton_seconds(0, -0.02, 0));
    //! [tap]
    std::vector<Quantity<unit::Time>> arrival;
    std::vector<double> link;
    std::vector<bool> reached(chain.size());
    const auto start = world.time();
    while (world.time() - start < 0.4 * second) {
        world.step(dt);
        for (std::size_t i = 0; i < chain.size(); ++i)
            if (!reached[i] && norm(world.position(chain[i]) - quiet.position(chain[i])) > 2e-4 * metre) {
                reached[i] = true;
                arrival.push_back(world.time() - start);
                link.push_back(double(links) - double(i) - 1);
            }
    }
    // By the slope between two links, because what "reached" means shifts all of them alike.
    const double speed = (link[16] - link[4]) / in(arrival[16] - arrival[4], second),
                 expected_speed = in(springs::angular_frequency(k, m), hertz);
    std::cout << "The tap runs up at " << speed << " links a second; sqrt(k/m) is " << expected_speed << "/s\n";
    claim("a disturbance travels at sqrt(k/m) links a second", std::abs(speed / expected_speed - 1) < 0.1);
    claim("and the links are reached one after the other",
          std::is_sorted(arrival.begin(), arrival.end()) && link.size() == chain.size());

    workbook::Plot plot("3.3", "A tap at the lower end runs up the chain");
    plot.x("links from the end").y("time when it arrives");
    plot.reference("at sqrt(k/m) links a second", link, [&](double n) { return n / expected_speed * second; })
        .points("measured", link, arrival)
        .write();
    return claim.result();
}
