// SPDX-License-Identifier: BSL-1.0
// `./workbook peers water`: columns beside a loop that only moves the same memory and beside loops written by hand, a
// sum of sines beside std::sin, shallow water of both orders beside loops written by hand. One thread; float, and
// double where a scene says so.

#include "tests/peers/contest.hpp"
#include "tests/peers/water/hand.hpp"
#include "tests/peers/water/hand_second_order.hpp"

#include <ansatz/water.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <type_traits>
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
template <class T>
void same(const std::string& who, std::span<const T> one, std::span<const T> other, double tolerance) {
    double most = 0;
    bool all = true; // false for one that is no number, too
    for (std::size_t n = 0; n < one.size(); ++n) {
        const double off = std::abs(double(one[n]) - double(other[n]));
        all = all && off <= tolerance;
        most = std::max(most, off);
    }
    if (all) return;
    std::cerr << who << " is " << most << " off; its time means nothing\n";
    std::exit(1);
}
template <class T> void hump(std::vector<T>& heights, std::size_t n) {
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const double x = (double(i) - 0.4 * double(n)) / 20, z = (double(j) - 0.6 * double(n)) / 20;
            heights[j * n + i] = T(1 + 0.2 * std::exp(-x * x - z * z));
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
    same<float>("the loop of two passes", water.heights(), two.height, 1e-5);
    same<float>("the loop of one pass", water.heights(), one.height, 1e-5);
    same<float>("the loop of sums", water.heights(), sums.height, 1e-4);
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
                  {"hand-written loop, one pass",
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

/// A hump of water over a hump of the bed, all of it wet.
template <class T> void begin(auto& hand, std::size_t n) {
    hump(hand.height, n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const double x = (double(i) - 0.7 * double(n)) / 30, z = (double(j) - 0.3 * double(n)) / 15;
            auto& bed = hand.bed[j * n + i] = T(0.3 * std::exp(-x * x - z * z));
            hand.height[j * n + i] -= bed;
        }
}
/// A surface that has taken the same 50 steps as a loop; ends the contest where they differ by more than rounding.
template <class Policy, class T, class Step>
auto played_by_both(const std::string& who, std::size_t n, auto& hand, Quantity<unit::Time> dt, Step step) {
    begin<T>(hand, n);
    Surface<Policy, T> water{Policy{}, ColumnGrid(n, n, 0.5 * metre), std::span<const T>(hand.bed), 1.0 * metre};
    water.set_heights(hand.height);
    for (int i = 0; i < 50; ++i) {
        water.step(dt);
        step();
    }
    const double rounding = 100 * double(std::numeric_limits<T>::epsilon());
    same<T>(who + ", heights", water.heights(), hand.height, rounding);
    same<T>(who + ", momentum along x", water.state().momentum_x, hand.hu, rounding);
    same<T>(who + ", momentum along z", water.state().momentum_z, hand.hw, rounding);
    return water;
}

/// Saint-Venant's equations of both orders, n by n.
template <class T> void shallow(Contest& contest, const std::string& scene, std::size_t n, int steps) {
    const T dt = T(0.02);
    const auto h = double(dt) * second;
    peers::HandShallow<T> one(n, n, T(0.5));
    peers::HandSecondOrder<T> two(n, n, T(0.5)), plain(n, n, T(0.5));
    auto first = played_by_both<ShallowWater, T>("the loop of first order", n, one, h, [&] { one.step(dt); });
    auto order2 =
        played_by_both<SecondOrderShallowWater, T>("the loop of second order", n, two, h, [&] { two.step(dt, true); });
    played_by_both<SecondOrderShallowWater, T>("the plain loop of second order", n, plain, h,
                                               [&] { plain.step(dt, false); });
    ShallowWater::In<T> loops(ShallowWater{}, first.grid(), 1.0 * metre);
    SecondOrderShallowWater::In<T> loops2(SecondOrderShallowWater{}, order2.grid(), 1.0 * metre);
    auto& lanes = detail::SurfaceLanes::of(first);
    auto& lanes2 = detail::SurfaceLanes::of(order2);
    auto times = [steps](auto step) {
        return [=] {
            for (int i = 0; i < steps; ++i) step();
        };
    };
    const bool kept = std::is_same_v<T, float>;
    const std::string keeps = kept ? "keeps the volume to 1e-5 (Kahan)" : "",
                      lacks = kept ? "adds without that correction" : "";
    const double columns = double(n) * double(n) * steps / 1000;
    contest.play(scene + ", first order", int(n), "ps a column", columns,
                 {{"ansatz ShallowWater", times([&] { first.step(h); }), "with the check of Courant's limit"},
                  {"ansatz ShallowWater, loops alone", times([&] { loops.advance(lanes, h); }), keeps},
                  {"hand-written loop", times([&] { one.step(dt); }), lacks}});
    contest.play(
        scene + ", second order", int(n), "ps a column", columns,
        {{"ansatz SecondOrderShallowWater", times([&] { order2.step(h); }), "with the check of Courant's limit"},
         {"ansatz SecondOrderShallowWater, loops alone", times([&] { loops2.advance(lanes2, h); }), keeps},
         {"hand-written loop", times([&] { two.step(dt, true); }), lacks},
         {"the same, a plain mean", times([&] { plain.step(dt, false); }),
          "no check of the limit of the second stage"}});
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
    shallow<float>(contest, "shallow water", 128, 20);
    shallow<double>(contest, "shallow water, double", 128, 20);
    contest.write(folder);
    return 0;
}
