// SPDX-License-Identifier: BSL-1.0
// `./workbook peers water`: columns beside a loop that only moves the same memory and beside loops written by hand, a
// sum of sines beside std::sin, shallow water beside a loop written by hand. Float, one thread.

#include "tests/peers/contest.hpp"
#include "tests/peers/water/hand.hpp"

#include <ansatz/water.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <vector>

using namespace ansatz;
using peers::Contest;
using peers::Subject;

namespace {

std::string remark(const std::string& what, double number) {
    std::ostringstream text;
    text << what << number;
    return text.str();
}
/// Ends the contest where two who should do the same do not.
void same(const std::string& who, std::span<const float> one, std::span<const float> other, double tolerance) {
    double most = 0;
    for (std::size_t n = 0; n < one.size(); ++n) most = std::max(most, std::abs(double(one[n]) - double(other[n])));
    if (most <= tolerance) return;
    std::cerr << who << " is " << most << " off; its time means nothing\n";
    std::exit(1);
}
void hump(std::vector<float>& heights, std::size_t n) {
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const double x = (double(i) - 0.4 * double(n)) / 20, z = (double(j) - 0.6 * double(n)) / 20;
            heights[j * n + i] = float(1 + 0.2 * std::exp(-x * x - z * z));
        }
}

/// The notes' columns, n by n.
void columns(Contest& contest, std::size_t n, int steps) {
    const float dt = 0.004F, strength = 9 * dt / (0.1F * 0.1F); // 3 m/s, columns of 0.1 m
    auto start = [&](auto& heights) { hump(heights, n); };
    peers::HandColumns two(n, n), one(n, n), sums(n, n);
    start(two.height);
    one.height = sums.height = two.height;
    Surface<WaterColumns, float> water{{3.0 * metre_per_second}, ColumnGrid(n, n, 0.1 * metre), 1.0 * metre};
    water.set_heights(two.height);
    const auto h = double(dt) * second;
    for (int i = 0; i < 20; ++i) {
        water.step(h);
        two.two_passes<peers::RowOfDifferences>(strength, dt);
        one.one_sweep<peers::RowOfDifferences>(strength, dt);
        sums.one_sweep<peers::RowOfSums>(strength, dt);
    }
    same("the loop of two passes", water.heights(), two.height, 1e-5);
    same("the loop of one sweep", water.heights(), one.height, 1e-5);
    same("the loop of sums", water.heights(), sums.height, 1e-4);
    std::vector<float> moved = two.height, rates(n * n, 0.0F);
    const double all = double(n) * double(n) * steps;
    contest.play("columns", int(n), "ps a column", all / 1000,
                 {{"ansatz WaterColumns",
                   [&] {
                       for (int i = 0; i < steps; ++i) water.step(h);
                   }},
                  {"in-place probe",
                   [&] {
                       for (int i = 0; i < steps; ++i) peers::probe(moved, rates, 1e-3F, 1e-3F);
                   },
                   "reads and writes both lanes, no neighbours"},
                  {"hand-written loop, one sweep",
                   [&] {
                       for (int i = 0; i < steps; ++i) one.one_sweep<peers::RowOfDifferences>(strength, dt);
                   }},
                  {"the same, sum less four times",
                   [&] {
                       for (int i = 0; i < steps; ++i) sums.one_sweep<peers::RowOfSums>(strength, dt);
                   },
                   "rounds low waves away"},
                  {"hand-written loop, two passes", [&] {
                       for (int i = 0; i < steps; ++i) two.two_passes<peers::RowOfDifferences>(strength, dt);
                   }}});
}

/// Sixteen sines over 512 by 512 points.
void sum_of_sines(Contest& contest) {
    constexpr std::size_t n = 512;
    const double dx = 0.25, time = 7.3;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> part(0, 1);
    std::vector<Wave> waves;
    for (int k = 0; k < 16; ++k)
        waves.push_back({(2 + 30 * part(random)) * metre, 0.1 * metre, 6.28 * part(random), 6.28 * part(random)});
    const Waves sum(waves);
    std::vector<peers::HandWave> by_hand;
    double amplitudes = 0;
    for (const auto& w : sum.terms()) {
        const double turned = w.phase - w.omega * time, two_pi = 2 * std::numbers::pi;
        by_hand.push_back(
            {float(w.amplitude), float(w.kx), float(w.kz), float(turned - two_pi * std::round(turned / two_pi))});
        amplitudes += w.amplitude;
    }
    std::vector<float> ours(n * n), theirs(n * n);
    auto fill = [&] {
        sum.fill(std::span<float>(ours), n, n, 0.0 * metre, 0.0 * metre, dx * metre, dx * metre, time * second);
    };
    auto hand = [&] { peers::sines(by_hand, n, float(dx), theirs, [](float phase) { return std::cos(phase); }); };
    auto off = [&](const std::vector<float>& heights) {
        double most = 0;
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t i = 0; i < n; ++i)
                most = std::max(
                    most, std::abs(double(heights[j * n + i]) -
                                   sum.height(double(i) * dx * metre, double(j) * dx * metre, time * second).value()));
        return most / amplitudes;
    };
    fill();
    hand();
    const double ours_off = off(ours), theirs_off = off(theirs);
    if (ours_off > 1.3e-6) {
        std::cerr << "the rotation is " << ours_off << " of all amplitudes off; its time means nothing\n";
        std::exit(1);
    }
    contest.play("16 sines", int(n), "ns a point", double(n * n),
                 {{"ansatz Waves, rotation", fill, remark("off by ", ours_off)},
                  {"hand-written loop, std::cos", hand, remark("off by ", theirs_off)}});
}

/// Saint-Venant's equations, n by n.
void shallow(Contest& contest, std::size_t n, int steps) {
    peers::HandShallow hand(n, n, 0.5F);
    hump(hand.height, n);
    Surface<ShallowWater, float> water{ShallowWater{}, ColumnGrid(n, n, 0.5 * metre), 1.0 * metre};
    water.set_heights(hand.height);
    const float dt = 0.02F;
    const auto h = double(dt) * second;
    auto& lanes = detail::SurfaceLanes::of(water);
    typename ShallowWater::In<float> loops(ShallowWater{}, water.grid(), 1.0 * metre);
    for (int i = 0; i < 50; ++i) {
        water.step(h);
        hand.step(dt);
    }
    same("the hand-written loop", water.heights(), hand.height, 1e-4);
    const double all = double(n) * double(n) * steps;
    contest.play("shallow water", int(n), "ps a column", all / 1000,
                 {{"ansatz ShallowWater",
                   [&] {
                       for (int i = 0; i < steps; ++i) water.step(h);
                   },
                   "with the look at Courant's limit"},
                  {"ansatz ShallowWater, the loops alone",
                   [&] {
                       for (int i = 0; i < steps; ++i) loops.advance(lanes, h);
                   },
                   "keeps the volume to 1e-5 in float (Kahan)"},
                  {"hand-written loop",
                   [&] {
                       for (int i = 0; i < steps; ++i) hand.step(dt);
                   },
                   "does not"}});
}

} // namespace

/// usage: peers_water <folder for water.json> [repeats]
int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : ".";
    Contest contest("water", argc > 2 ? std::max(1, std::atoi(argv[2])) : 15);
    columns(contest, 4096, 1); // 128 MB: in no cache
    columns(contest, 2048, 2);
    columns(contest, 512, 20);
    sum_of_sines(contest);
    shallow(contest, 128, 20);
    contest.write(folder);
    return 0;
}
