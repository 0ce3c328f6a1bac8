// SPDX-License-Identifier: BSL-1.0
// 7.3 Functional approach: a sea as a sum of sines, whose periods follow from their lengths, with round and with sharp
// crests

// No column is stored and no step is made: the height at a place and a time is a formula, a few cosines on top of each
// other. A wave's length is free; its period is not, omega^2 = g k tanh(k d), and a sea that ignores it looks like
// cloth. Sharp crests move the points of the surface towards each other, and then the height "at x" has to be solved
// for: with the height of the point that rests at x a boat floats beside the water.

#include "claims.hpp"
#include "columns.hpp"
#include "film.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/water.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>
#include <span>
#include <tuple>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

namespace {
/// The sea that a wind of some speed has raised where it has blown for long (Pierson and Moskowitz, 1964), as `count`
/// waves of equal energy. Each stands for an equal part of the spectrum, so that the long ones lie close together.
//! [spectrum]
std::vector<Wave> sea_of_wind(Quantity<unit::Velocity> wind, int count, unsigned seed) {
    const double g = 9.81, alpha = 8.1e-3, beta = 0.74, slowest = g / wind.value();
    const double variance = alpha * std::pow(g / (slowest * slowest), 2) / (4 * beta); // of the height, m^2
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) { return low + (high - low) * double(random()) / 4294967296.0; };
    std::vector<Wave> waves;
    for (int n = 0; n < count; ++n) {
        // Up to omega lies the part exp(-beta (slowest / omega)^4) of the energy.
        const double part = (n + 0.5) / count, omega = slowest * std::pow(-beta / std::log(part), 0.25);
        const auto length = 2 * std::numbers::pi * g / (omega * omega) * metre; // over deep water
        const double direction = between(-0.6, 0.6), phase = between(0, 2 * std::numbers::pi);
        waves.push_back({length, std::sqrt(2 * variance / count) * metre, direction, phase});
    }
    return waves;
}
//! [spectrum]
} // namespace

int main() {
    workbook::Claims claim;

    workbook::Columns speeds({"a wave of", "runs over deep water at", "and where it is 2 m deep"});
    //! [dispersion]
    for (const double metres_long : {1.0, 10.0, 100.0})
        speeds.row(workbook::printed(metres_long, " m"), water::phase_speed(metres_long * metre),
                   water::phase_speed(metres_long * metre, 2.0 * metre));
    //! [dispersion]
    std::cout << speeds;
    const auto period = water::period(10.0 * metre);
    std::cout << "10 m long, it passes in " << period << '\n';
    claim("k is 2 pi / lambda: 2.53079 s; with 2 / lambda it would be 4.49 s",
          abs(period - 2.53079 * second) < 1e-5 * second);
    claim("long waves do not know how long they are",
          abs(water::phase_speed(1e5 * metre, 2.0 * metre) - std::sqrt(9.81 * 2) * metre_per_second) <
              1e-6 * metre_per_second);

    //! [sea]
    const Waves sea({{20.0 * metre, 0.40 * metre, 0.0},
                     {13.0 * metre, 0.25 * metre, 0.6},
                     {7.00 * metre, 0.12 * metre, -0.5, 1.0},
                     {3.10 * metre, 0.05 * metre, 1.1, 2.0}});
    const auto t = 42.0 * second;
    const auto map = sea.height_map<float>(256, 256, 0.25 * metre, 0.25 * metre, t);
    //! [sea]
    double most = 0;
    for (std::size_t j = 0; j < 256; j += 5)
        for (std::size_t i = 0; i < 256; ++i)
            most = std::max(most, std::abs(double(map(i, j).value()) - sea.height(map.x(i), map.z(j), t).value()));
    claim("a map of 256 x 256 points in float is right to 1.3e-6 of the sum of amplitudes", most < 1.3e-6 * 0.82);

    const Waves storm(sea_of_wind(12.0 * metre_per_second, 64, 3));
    double square = 0;
    int samples = 0;
    for (double at = 0; at < 20000; at += 7.7, ++samples)
        square += std::pow(storm.height(at * metre, 0.3 * at * metre, at * second).value(), 2);
    const double significant = 4 * std::sqrt(square / samples); // about the mean of the highest third
    std::cout << "After a wind of 12 m/s waves are " << significant << " m high, from trough to crest\n";
    claim("as high as the spectrum says, 0.209 U^2 / g: 3.07 m", std::abs(significant / 3.07 - 1) < 0.03);

    //! [sharp]
    const GerstnerWaves sharp(Waves({{10.0 * metre, 0.5 * metre}}), 0.9);
    const auto place = 1.0 * metre, zero = 0.0 * metre;
    const auto right = sharp.height(place, zero, 0.0 * second);
    const auto naive = y(sharp.position(place, zero, 0.0 * second)); // of the point that rests at 1 m, and is not there
    //! [sharp]
    workbook::say() << "At 1 m a sharp crest is " << right << " high; the point that rests there is at "
                    << x(sharp.position(place, zero, 0.0 * second)) << ", " << naive << " high\n";
    const auto found = sharp.position(x(sharp.rest(place, zero, 0.0 * second)), zero, 0.0 * second);
    claim("the height at x is that of the point that is at x",
          abs(x(found) - place) < 1e-9 * metre && abs(y(found) - right) < 1e-9 * metre);
    claim("not solving for it is more than half of the amplitude off", abs(naive - right) > 0.25 * metre);

    //! [drift]
    // Something that floats goes with the water: to and fro below a crest and a trough.
    const Waves swell({{10.0 * metre, 0.3 * metre}});
    const auto crest = swell.velocity(0.0 * metre, zero, zero, 0.0 * second),
               trough = swell.velocity(5.0 * metre, zero, zero, 0.0 * second),
               deep = swell.velocity(0.0 * metre, -5.0 * metre, zero, 0.0 * second);
    //! [drift]
    workbook::say() << "Under a crest the water runs at " << x(crest) << ", under a trough at " << x(trough)
                    << ", and 5 m below the crest at " << x(deep) << '\n';
    claim("with the wave under a crest, against it under a trough",
          x(crest) == -x(trough) && x(crest) > 0.0 * metre_per_second);
    claim("half a wavelength down, exp(-pi) of it is left",
          std::abs(double(x(deep) / x(crest)) - std::exp(-3.14159265)) < 1e-8);

    std::vector<Length> places, sines, circles;
    const Waves round({{10.0 * metre, 0.5 * metre}});
    for (double at = -10; at <= 10; at += 0.05) {
        places.push_back(at * metre);
        sines.push_back(round.height(at * metre, zero, 0.0 * second));
        circles.push_back(sharp.height(at * metre, zero, 0.0 * second));
    }
    // A sea that repeats itself: deep water, waves whose periods divide six seconds, so that the film has no seam.
    //! [loop]
    std::vector<Wave> waves;
    for (const auto& [times, amplitude, direction] :
         {std::tuple{1, 0.45, 0.2}, {2, 0.30, -0.3}, {3, 0.14, 0.7}, {4, 0.06, -0.9}})
        waves.push_back(
            {9.81 * 6 * 6 / (2 * std::numbers::pi * times * times) * metre, amplitude * metre, direction, 0.7 * times});
    const Waves loop(waves);
    //! [loop]
    double seam = 0;
    for (double at = 0; at < 40; at += 0.5)
        seam = std::max(
            seam,
            std::abs(
                (loop.height(at * metre, zero, 6.0 * second) - loop.height(at * metre, zero, 0.0 * second)).value()));
    claim("a sea of waves whose periods divide six seconds is after six seconds what it was", seam < 1e-9);
    workbook::Film film(
        "7.3", "A sea: four cosines for each height",
        "Rows of water with long and short waves that run to the right and across; a buoy goes up and down with "
        "them. It repeats itself after six seconds.",
        {.middle = metres(20, -0.2, 12), .width = 41.0 * metre, .height = 15.5 * metre, .above = degrees(24)});
    for (int n = 0; n < 72; ++n) {
        const auto now = n / 12.0 * second;
        std::vector<VectorQuantity<unit::Length>> surface;
        for (int j = 0; j < 11; ++j)
            for (int i = 0; i <= 32; ++i)
                surface.push_back(
                    metres(1.25 * i, loop.height(1.25 * i * metre, 2.4 * j * metre, now).value(), 2.4 * j));
        const auto buoy = loop.height(24.0 * metre, 15.0 * metre, now).value();
        film.frame(now)
            .rows(surface, 33, -2.6 * metre, workbook::paints::sea)
            .ball(metres(24, buoy + 0.3, 15), 0.7 * metre, workbook::paints::ball);
    }
    film.rate(12).hold(0).write();

    workbook::Plot plot("7.3", "The same wave with its points on lines and on circles");
    plot.x("x").y("height");
    plot.line("sum of sines", places, sines).line("Gerstner, steepness 0.9", places, circles).write();
    return claim.result();
}
