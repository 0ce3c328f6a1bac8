// SPDX-License-Identifier: BSL-1.0
// Rows G: which pairs of boxes a broadphase tells, against two loops. All numbers are ones that a float holds.

#include "tests/peers/cases/rows.hpp"
#include "tests/peers/cases/scenes.hpp"

#include <algorithm>
#include <iterator>

namespace peers {

namespace {

/// What is missing of the true pairs, and how many it told for each of them.
struct Told {
    double missing = 0, pairs = 0, of = 0;
};
Pairs by_two_loops(const std::vector<BoxOf>& boxes) {
    Pairs pairs;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            if ((boxes[i].low.array() <= boxes[j].high.array()).all() &&
                (boxes[j].low.array() <= boxes[i].high.array()).all())
                pairs.emplace_back(int(i), int(j));
    return pairs;
}
Told compare(const Contestant& who, const std::vector<BoxOf>& boxes) {
    Pairs right = by_two_loops(boxes), told = who.pairs(boxes), missing;
    const double of = double(right.size()), pairs = double(told.size());
    std::sort(told.begin(), told.end());
    const bool twice = std::adjacent_find(told.begin(), told.end()) != told.end();
    std::set_difference(right.begin(), right.end(), told.begin(), told.end(), std::back_inserter(missing));
    return {double(missing.size()) + twice, pairs, of};
}
/// Boxes of about a metre, on sixteenths, all in one layer, so that a flat engine sees the same.
std::vector<BoxOf> scattered(int n, double width, Dice& dice, const Vector& away = Vector::Zero()) {
    std::vector<BoxOf> boxes;
    for (int i = 0; i < n; ++i) {
        const Vector x(std::round(16 * width * dice()) / 16, std::round(16 * width * dice()) / 16, 0);
        const Vector half(std::round(16 * (0.5 + 0.25 * dice())) / 16, std::round(16 * (0.5 + 0.25 * dice())) / 16,
                          0.5);
        boxes.push_back({away + x - half, away + x + half});
    }
    return boxes;
}
Told random_scenes(const Contestant& who) {
    Told all;
    Dice dice(11);
    for (int scene = 0; scene < 200; ++scene)
        for (const int n : {0, 1, 2, 17, 400}) {
            const Told one = compare(who, scattered(n, 2 + 0.1 * scene, dice));
            all.missing += one.missing, all.pairs += one.pairs, all.of += one.of;
        }
    return all;
}

} // namespace

double g1_random(const Contestant& who) { return random_scenes(who).missing; }
double g1_told(const Contestant& who) {
    const Told all = random_scenes(who);
    return 100 * std::max(0.0, all.pairs / all.of - 1);
}
double g3_touching(const Contestant& who) {
    std::vector<BoxOf> boxes; // of a chessboard: each shares a side or a corner with its neighbours
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) boxes.push_back({at(i - 10, j - 10, -0.5), at(i - 9, j - 9, 0.5)});
    return compare(who, boxes).missing;
}
double g4_one_place(const Contestant& who) {
    return compare(who, std::vector<BoxOf>(1000, BoxOf{at(-0.5, -0.5, -0.5), at(0.5, 0.5, 0.5)})).missing;
}
double g5_large(const Contestant& who) {
    Dice dice(12);
    auto boxes = scattered(400, 20, dice);
    boxes.push_back({at(-1000, -1000, -0.5), at(1000, 1000, 0.5)}); // around everybody
    boxes.push_back({at(-100, 2, -0.5), at(100, 3, 0.5)});          // through them
    boxes.push_back({at(5000, 5000, -0.5), at(5001, 5001, 0.5)});   // outside
    return compare(who, boxes).missing;
}
double g14_far(const Contestant& who) {
    Dice dice(13);
    auto boxes = scattered(100, 10, dice);
    const double far = 1 << 30; // m; a float's places are 128 m apart there
    for (int i = 0; i < 100; ++i)
        boxes.push_back({at(far + 128 * (i % 7), 128.0 * i, -0.5), at(far + 128 * (i % 7 + 1), 128.0 * (i + 1), 0.5)});
    return compare(who, boxes).missing;
}

} // namespace peers
