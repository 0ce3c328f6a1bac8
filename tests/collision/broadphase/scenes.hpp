// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the tests of the broadphases share: seeded scenes, every policy by name, and an oracle that compares numbers
/// alone.

#include <ansatz/collision/broadphase.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace broadphase_tests {

using namespace ansatz;
using Pairs = std::vector<IndexPair>;

/// A box as plain numbers.
struct PlainBox {
    std::array<double, 3> lower{}, upper{};
};
struct Scene {
    std::string name;
    std::vector<PlainBox> boxes;
    std::size_t active = 0;
};

/// Numbers that are the same with every standard library.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ull + 1) {}
    std::uint64_t bits() { // splitmix64 (Steele, Lea and Flood, 2014)
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    double uniform(double low, double high) { return low + (high - low) * double(bits() >> 11) * 0x1p-53; }
    double bell() { return uniform(-1, 1) + uniform(-1, 1) + uniform(-1, 1); } // near enough to a normal one
    std::size_t below(std::size_t n) { return std::size_t(bits() % n); }

private:
    std::uint64_t state_;
};

inline PlainBox box_around(const std::array<double, 3>& centre, double radius) {
    PlainBox box;
    for (std::size_t k = 0; k < 3; ++k) box.lower[k] = centre[k] - radius, box.upper[k] = centre[k] + radius;
    return box;
}

/// Scenes of five kinds and of 0, 1, 2, 17 and 400 bodies, some of which do not move.
inline Scene seeded_scene(std::uint64_t seed) {
    static constexpr std::array<std::size_t, 5> sizes{0, 1, 2, 17, 400};
    static constexpr std::array<const char*, 5> kinds{"uniform", "clustered", "column", "mixed radii 1:100",
                                                      "touching lattice"};
    const std::size_t n = sizes[seed % 5], kind = seed / 5 % 5;
    Random random(seed);
    Scene scene{std::string(kinds[kind]) + ", seed " + std::to_string(seed), {}, 0};
    const double side = std::max(2.0, std::cbrt(double(n)) * random.uniform(0.8, 3));
    std::vector<std::array<double, 3>> clusters(1 + n / 40);
    for (auto& c : clusters)
        c = {random.uniform(-side, side) * 5, random.uniform(-side, side) * 5, random.uniform(-side, side) * 5};
    for (std::size_t i = 0; i < n; ++i) {
        double radius = 0.5;
        std::array<double, 3> centre{};
        const auto& cluster = clusters[random.below(clusters.size())];
        for (std::size_t k = 0; k < 3; ++k) {
            switch (kind) {
            case 1: centre[k] = cluster[k] + random.bell(); break;
            case 2: centre[k] = k == 1 ? random.uniform(0, double(n)) : random.uniform(-1, 1); break;
            case 4: centre[k] = double(random.below(8)) - 4; break; // closed boxes that share faces, edges, corners
            default: centre[k] = random.uniform(-side, side); break;
            }
        }
        if (kind == 3) radius = 0.05 * std::pow(100.0, random.uniform(0, 1));
        scene.boxes.push_back(box_around(centre, radius));
    }
    scene.active = seed % 3 == 0 ? n : seed % 3 == 1 ? n / 2 : random.below(n + 1);
    return scene;
}

/// The boxes in a space, rounded to its scalar.
template <class S> Boxes<S> boxes_of(const Scene& scene) {
    Boxes<S> boxes;
    for (const PlainBox& plain : scene.boxes) {
        Vector<typename S::Scalar, S::dimension> low, high;
        for (int k = 0; k < S::dimension; ++k)
            low[k] = typename S::Scalar(plain.lower[std::size_t(k)]),
            high[k] = typename S::Scalar(plain.upper[std::size_t(k)]);
        boxes.push_back(S::Position::from_value(low), S::Position::from_value(high));
    }
    boxes.set_active(scene.active);
    return boxes;
}

/// By two loops and the definition.
template <class S> Pairs oracle(const Boxes<S>& boxes) {
    Pairs pairs;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            bool apart = i >= boxes.active();
            for (int k = 0; k < S::dimension && !apart; ++k)
                apart = boxes.upper(k)[i] < boxes.lower(k)[j] || boxes.upper(k)[j] < boxes.lower(k)[i];
            if (!apart) pairs.emplace_back(i, j);
        }
    return pairs;
}

/// What a bound broadphase tells that is searched in pieces: a few at a time, the last of them first, and its loops the
/// same way, as threads may come to them in any order.
template <class Bound, class S> Pairs told_in_pieces(Bound& bound, const Boxes<S>& boxes, std::size_t few) {
    bound.prepare(boxes, [few](std::size_t count, std::size_t, const auto& loop) {
        for (std::size_t end = count; end > 0;) {
            const std::size_t begin = end > few ? end - few : 0;
            loop(begin, end);
            end = begin;
        }
    });
    std::vector<Pairs> of_each;
    const Bound& prepared = bound;
    const std::size_t pieces = prepared.pieces();
    for (std::size_t last = pieces; last > 0;) {
        const std::size_t first = last > few ? last - few : 0;
        of_each.emplace_back();
        prepared.find(boxes, first, last, [&](std::size_t i, std::size_t j) { of_each.back().emplace_back(i, j); });
        last = first;
    }
    Pairs told;
    for (std::size_t n = of_each.size(); n-- > 0;) told.insert(told.end(), of_each[n].begin(), of_each[n].end());
    if constexpr (requires { bound.finish(told.size()); }) bound.finish(told.size());
    return told;
}

/// What is wrong with what a bound broadphase tells, or nothing.
template <class Bound, class S> std::string fault_of(Bound& bound, const Boxes<S>& boxes, const Pairs& right) {
    [[maybe_unused]] Bound divided = bound; // what it kept of earlier calls, too
    Pairs told;
    bound.find(boxes, [&](std::size_t i, std::size_t j) { told.emplace_back(i, j); });
    if constexpr (requires(const Bound& prepared) { prepared.find(boxes, 0, 0, detail::PairProbe()); })
        if (told_in_pieces(divided, boxes, 1 + boxes.size() % 7) != told)
            return "other pairs in pieces, or another order";
    const auto shown = [](const IndexPair& p) {
        return "(" + std::to_string(p.first) + ", " + std::to_string(p.second) + ")";
    };
    for (const IndexPair& p : told) {
        if (p.first >= p.second) return "self, or not in order: " + shown(p);
        if (p.first >= boxes.active()) return "neither moves: " + shown(p);
    }
    std::sort(told.begin(), told.end());
    const auto twice = std::adjacent_find(told.begin(), told.end());
    if (twice != told.end()) return "told twice: " + shown(*twice);
    Pairs missing, surplus;
    std::set_difference(right.begin(), right.end(), told.begin(), told.end(), std::back_inserter(missing));
    std::set_difference(told.begin(), told.end(), right.begin(), right.end(), std::back_inserter(surplus));
    if (!missing.empty()) return std::to_string(missing.size()) + " missing, the first " + shown(missing[0]);
    if (!surplus.empty()) return std::to_string(surplus.size()) + " do not touch, the first " + shown(surplus[0]);
    return {};
}

/// Calls `f(name, policy)` for each broadphase that tests boxes.
template <class F> void each_policy(F&& f) {
    const SortAndSweep in_cells{Sorting::in_cells};
    f("BoundingBoxes", BoundingBoxes{});
    f("SortAndSweep", SortAndSweep{});
    f("UniformGrid", UniformGrid{});
    f("UniformGrid of cells of 0.3 m", UniformGrid{0.3 * metre});
    f("UniformGrid of cells of 50 m", UniformGrid{50.0 * metre});
    f("UniformGrid<SortAndSweep>", UniformGrid<SortAndSweep>{});
    f("UniformGrid<SortAndSweep>, in cells", UniformGrid<SortAndSweep>{{}, in_cells});
    f("Octree", Octree{});
    f("Octree of 1 a cell", Octree<>{1, 12, {}});
    f("Octree not divided", Octree<>{24, 0, {}});
    f("Octree<SortAndSweep>", Octree<SortAndSweep>{});
    f("Octree<SortAndSweep>, in cells", Octree<SortAndSweep>{4, 12, in_cells});
    f("BinarySplit", BinarySplit{});
    f("BinarySplit of 1 a cell", BinarySplit<>{1, 40, {}});
    f("BinarySplit<SortAndSweep>", BinarySplit<SortAndSweep>{});
    f("BinarySplit<SortAndSweep>, in cells", BinarySplit<SortAndSweep>{4, 40, in_cells});
    f("Coherent", Coherent{});
    f("Coherent<Octree<SortAndSweep>>", Coherent<Octree<SortAndSweep>>{});
}

/// Every broadphase anew: "<which>: <what is wrong>", or nothing.
template <class S> std::string fault_of_any(const Boxes<S>& boxes) {
    const Pairs right = oracle(boxes);
    std::string fault;
    each_policy([&](const char* name, const auto& policy) {
        typename std::remove_cvref_t<decltype(policy)>::template In<S> bound(policy);
        const std::string of_this = fault_of(bound, boxes, right);
        if (fault.empty() && !of_this.empty()) fault = std::string(name) + ": " + of_this;
    });
    return fault;
}
template <class S> std::string fault_of_any(const Scene& scene) { return fault_of_any(boxes_of<S>(scene)); }

} // namespace broadphase_tests
