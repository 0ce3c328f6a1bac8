// SPDX-License-Identifier: BSL-1.0
// 7.2.5 Dam break: water that runs over dry ground, against the closed form, by the equations of shallow water

// Waves that pull at each other and flows through pipes know no fronts. A dam that breaks is nothing else: Ritter found
// in 1892 that over dry ground the water behind sinks as a parabola, whose foot runs ahead at 2 sqrt(g h). Depth and
// momentum, carried along together, follow it. (Beyond 7.2.)

#include "claims.hpp"
#include "film.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/water.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <span>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

namespace {
constexpr double g = 9.81, high = 1.0, after = 1.0; // m/s^2, m, s

Length ritter(Length x, double time = after) {
    const double c = std::sqrt(g * high), xi = (x.value() - 10) / time;
    const double h = xi <= -c ? high : xi >= 2 * c ? 0 : 4 / (9 * g) * (c - xi / 2) * (c - xi / 2);
    return h * metre;
}
/// A dam of a metre in the middle of 20 m of dry channel, a second after it broke.
//! [dam]
template <class Policy> Surface<Policy> broken(const Policy& policy, std::size_t count) {
    Surface water{policy, ColumnGrid(count, 1, 20.0 / double(count) * metre, 1.0 * metre), 0.0 * metre};
    for (std::size_t i = 0; i < count / 2; ++i) water.set_height(i, 0, high * metre);
    for (double t = 0; t < after;) {
        const auto dt = std::min(water.longest_step(), (after - t) * second);
        water.step(dt);
        t += dt.value();
    }
    return water;
}
//! [dam]
template <class Policy> double error(const Surface<Policy>& water) {
    double wrong = 0, all = 0;
    for (std::size_t i = 0; i < water.grid().columns_x(); ++i) {
        const Length exact = ritter(water.grid().centre_x(i));
        wrong += abs(water.height(i, 0) - exact).value();
        all += exact.value();
    }
    return wrong / all;
}
} // namespace

int main() {
    workbook::Claims claim;
    std::vector<double> errors;
    for (const std::size_t count : {50U, 100U, 200U, 400U, 800U}) {
        errors.push_back(error(broken(ShallowWater{}, count)));
        std::cout << "  " << count << " columns: " << 100 * errors.back() << " % off Ritter's closed form\n";
    }
    const double order = std::log2(errors[3] / errors[4]);
    workbook::say() << "Twice the columns leave " << std::exp2(-order) << " of it: order " << order
                    << ". The scheme is of order 1 where water is smooth, and the foot and the shoulder are not\n";
    claim("it converges, a bit slower than to first order", order > 0.55 && order < 1);

    const auto water = broken(ShallowWater{}, 200);
    const auto pipes = broken(Pipes{}, 200);
    const auto lowest = *std::min_element(water.heights().begin(), water.heights().end());
    claim("no height is negative, and no water is lost",
          lowest >= 0 && std::abs(water.volume().value() / 10 - 1) < 1e-13);
    std::cout << "Pipes, which carry no momentum along, are " << 100 * error(pipes) << " % off with 200 columns\n";
    claim("that is much better than what pipes do", error(pipes) > 3 * errors[2]);

    std::vector<Length> places, exact, found, piped;
    for (std::size_t i = 0; i < 200; ++i) {
        places.push_back(water.grid().centre_x(i));
        exact.push_back(ritter(places.back()));
        found.push_back(water.height(i, 0));
        piped.push_back(pipes.height(i, 0));
    }
    workbook::Film film(
        "7.2.5", "A dam breaks over dry ground (heights five times as large)",
        "A wall of water of a metre falls; a thin front runs to the right over dry ground, and a dip runs back into "
        "the water. A thin line, the closed form, lies on it throughout.",
        {.middle = metres(10, 2.5, 0), .width = 20.4 * metre, .height = 6.0 * metre});
    Surface seen{ShallowWater{}, ColumnGrid(200, 1, 0.1 * metre, 1.0 * metre), 0.0 * metre};
    for (std::size_t i = 0; i < 100; ++i) seen.set_height(i, 0, high * metre);
    for (int n = 0; n <= 48; ++n) {
        const double time = n / 50.0; // s
        for (double t = std::max(0.0, time - 0.02); t < time;) {
            const auto dt = std::min(seen.longest_step(), (time - t) * second);
            seen.step(dt);
            t += dt.value();
        }
        std::vector<VectorQuantity<unit::Length>> surface, closed;
        for (std::size_t i = 0; i < 200; ++i) {
            const auto x = seen.grid().centre_x(i);
            surface.push_back(metres(x.value(), 5 * seen.height(i, 0).value(), 0));
            closed.push_back(metres(x.value(), 5 * ritter(x, std::max(time, 1e-9)).value(), 0));
        }
        film.frame(time * second)
            .filled(surface, 0.0 * metre, workbook::paints::sea)
            .line(closed, workbook::paints::wire);
    }
    film.rate(20).write();

    workbook::Plot plot("7.2.5", "A dam of 1 m at 10 m, a second after it broke");
    plot.x("x").y("height");
    plot.reference("Ritter", places, exact).line("ShallowWater", places, found).line("Pipes", places, piped).write();
    return claim.result();
}
