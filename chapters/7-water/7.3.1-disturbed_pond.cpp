// SPDX-License-Identifier: BSL-1.0
// 7.3.1 A disturbed pond: a state machine knows when somebody stirs the water, and begins the rings

// "... or applied using a finite state machine to simulate the water being disturbed by a player." Calm, stirred and
// settling: while somebody wades, a ring begins at each stride; when nobody does any more, the rings are left to fade,
// and once the last is gone the pond is calm and costs nothing. Crests run through their ring, twice as fast as it. (A
// part of 7.3.)

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/states.hpp>
#include <ansatz/water.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::states;

namespace {
const auto dt = 0.05 * second;

//! [pond]
/// What the machine decides about: a pond, and somebody who crosses it at 1 m/s, from second 2 to second 8.
struct Pond {
    Ripples rings{16};
    Quantity<unit::Time> now{}, last_stride{};
    bool somebody_wades() const { return now >= 2.0 * second && now < 8.0 * second; }
    Quantity<unit::Length> place() const { return (now - 2.0 * second) * (1.0 * metre_per_second); }
    void stride() {
        rings.begin({.x = place(), .z = 0.0 * metre, .begun = now, .damping = 1.5 * hertz});
        last_stride = now;
    }
    void wade() {
        if (now - last_stride >= 0.6 * second) stride();
    }
};

struct Water {
    using Context = Pond;
    static constexpr auto machine = states::machine(
        state("calm", transition(when(asked("somebody wades", &Pond::somebody_wades)), to("stirred"))),
        state("stirred", on_entry(&Pond::stride), each_update(&Pond::wade),
              transition(when(!asked("somebody wades", &Pond::somebody_wades)), to("settling"))),
        state("settling", each_update([](Pond& p) { p.rings.forget_faded(p.now); }),
              transition(when(asked("somebody wades", &Pond::somebody_wades)), to("stirred")),
              transition(when(asked("the rings are gone", [](const Pond& p) { return p.rings.size() == 0; })),
                         to("calm"))));
};
//! [pond]
} // namespace

int main() {
    workbook::Claims claim;
    Pond pond;
    Machine<Water, Switch> machine;
    machine.start(pond);
    std::vector<std::string> states{"calm"};
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> heights;
    std::size_t most = 0;
    double before = 0;
    //! [run]
    for (int n = 0; n < 400; ++n) {
        pond.now = double(n) * dt;
        machine.update(pond, dt);
        //! [run]
        if (states.back() != machine.active_name()) {
            states.emplace_back(machine.active_name());
            std::cout << "  at " << pond.now << ": " << states.back() << ", "
                      << "rings: " << pond.rings.size() << '\n';
        }
        most = std::max(most, pond.rings.size());
        times.push_back(pond.now);
        heights.push_back(pond.rings.height(3.0 * metre, 1.0 * metre, pond.now));
        if (pond.now < 1.9 * second) before = std::max(before, std::abs(heights.back().value()));
    }
    claim("calm, stirred, settling, calm", states == std::vector<std::string>{"calm", "stirred", "settling", "calm"});
    claim("a ring for each stride", most == 10);
    claim("before anybody comes the pond is flat, and after the rings are gone again",
          before == 0 && heights.back() == 0.0 * metre);
    const auto highest = *std::max_element(heights.begin(), heights.end());
    std::cout << "A metre beside the way it rises by as much as " << highest << '\n';
    claim("while somebody wades it is not", highest > 0.005 * metre);

    workbook::Plot plot("7.3.1", "A metre beside the way of somebody who wades past, from second 2 to second 8");
    plot.x("time").y("height").line("the pond", times, heights).write();
    return claim.result();
}
