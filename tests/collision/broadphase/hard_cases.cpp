// SPDX-License-Identifier: BSL-1.0
// HARD_CASES.md, rows G, by name. (G1 is in same_pairs.cpp, G9 in hostile.cpp.)
// Compiled with optimisation: it measures a time.
// Runs long with the sanitizers.

#include "tests/collision/broadphase/scenes.hpp"

#include "tests/catch.hpp"

#include <ctime>
#include <limits>
#include <numeric>

using namespace broadphase_tests;

namespace {

Scene all_moving(std::string name, std::vector<PlainBox> boxes) {
    Scene scene{std::move(name), std::move(boxes), 0};
    scene.active = scene.boxes.size();
    return scene;
}
void check_everywhere(const Scene& scene) {
    INFO(scene.name);
    CHECK(fault_of_any<Space<double, 3>>(scene) == "");
    CHECK(fault_of_any<Space<float, 3>>(scene) == "");
    CHECK(fault_of_any<Space<double, 2>>(scene) == "");
    CHECK(fault_of_any<Space<float, 2>>(scene) == "");
}
/// Told in this order, and as what: one number.
template <class Bound, class S> std::uint64_t hash_of(Bound& bound, const Boxes<S>& boxes) {
    std::uint64_t hash = 1469598103934665603ull;
    bound.find(boxes, [&](std::size_t i, std::size_t j) {
        for (const std::size_t index : {i, j}) hash = (hash ^ index) * 1099511628211ull; // Fowler, Noll and Vo
    });
    return hash;
}

} // namespace

TEST_CASE("G2: on both sides of the origin, cells are found by floor", "[broadphase][hard]") {
    Random random(2);
    std::vector<PlainBox> boxes;
    for (int i = 0; i < 400; ++i)
        boxes.push_back(box_around({random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)}, 0.5));
    check_everywhere(all_moving("400 in +-5", boxes));
    // Pairs that touch across the origin and across -1, cells of any width.
    std::vector<PlainBox> across;
    for (const double x : {-1.0, -0.999, -0.001, 0.0, 0.001, 1.0})
        for (const double y : {-1.0, 0.0}) across.push_back(box_around({x, y, -x}, 0.0005));
    for (const double cell : {0.0011, 0.1, 1.0, 3.0}) {
        const auto plain = boxes_of<Space<>>(all_moving("across the origin", across));
        CHECK(find_pairs(UniformGrid{cell * metre}, plain) == oracle(plain));
    }
    check_everywhere(all_moving("across the origin", across));
}

TEST_CASE("G3: boxes that share a face, an edge or a corner touch, for every policy", "[broadphase][hard]") {
    std::vector<PlainBox> lattice;
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z)
                lattice.push_back(box_around({double(x), double(y), double(z)}, 0.5)); // exact in binary
    const Scene scene = all_moving("a lattice of cubes", lattice);
    // Each axis has 5 places: 5 of the same, 4 neighbours, so 13 ordered neighbours or same: (13^3 - 125) / 2 pairs.
    CHECK(oracle(boxes_of<Space<>>(scene)).size() == (13 * 13 * 13 - 125) / 2);
    check_everywhere(scene);
    // One bit further and they do not.
    Boxes<Space<>> boxes;
    boxes.push_back(metres(0, 0, 0), metres(1, 1, 1));
    boxes.push_back(metres(std::nextafter(1.0, 2.0), 0, 0), metres(2, 1, 1));
    boxes.set_active(2);
    CHECK(oracle(boxes).empty());
    CHECK(fault_of_any(boxes) == "");
}

TEST_CASE("G4: 1000 bodies in one place are 499 500 pairs, soon", "[broadphase][hard]") {
    for (const double at : {0.0, 12.75}) { // on the planes of every division, and beside them
        std::vector<PlainBox> same(1000, box_around({at, at, at}, 0.5));
        same.push_back(box_around({-20, -20, -20}, 0.5)); // so that the middle of the world is not theirs
        same.push_back(box_around({20, 20, 20}, 0.5));
        const auto boxes = boxes_of<Space<>>(all_moving("coincident", same));
        each_policy([&](const char* name, const auto& policy) {
            typename std::remove_cvref_t<decltype(policy)>::template In<Space<>> bound(policy);
            std::size_t pairs = 0;
            const auto start = std::clock(); // the processor's time: another program's is none of this test's
            bound.find(boxes, [&](std::size_t, std::size_t) { ++pairs; });
            const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
            INFO(name << " at " << at << ": " << seconds << " s");
            CHECK(pairs == 499500);
            CHECK(seconds < 2); // 50 ms optimised on a quiet machine; what this is to find takes minutes
        });
    }
}

TEST_CASE("G5: a body of 100 cells, one larger than the world, one outside of it", "[broadphase][hard]") {
    Random random(5);
    std::vector<PlainBox> boxes;
    for (int i = 0; i < 300; ++i)
        boxes.push_back(box_around({random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-20, 20)}, 0.5));
    for (const double radius : {50.0, 500.0, 3.0, 12.0}) boxes.push_back(box_around({1, 2, 3}, radius));
    boxes.push_back(box_around({5000, 0, 0}, 0.5));
    boxes.push_back(box_around({-5000, 1, 1}, 4990));
    boxes.push_back(box_around({5000.5, 0.5, 0}, 0.5));
    check_everywhere(all_moving("large among small", boxes));
    std::reverse(boxes.begin(), boxes.end());
    check_everywhere(all_moving("large among small, the large first", boxes));
}

TEST_CASE("G6: bodies on the planes of an octree are told once", "[broadphase][hard]") {
    // A world of 64 m whose planes are at whole numbers, and bodies in their middle, at every depth.
    std::vector<PlainBox> boxes{box_around({-32, -32, -32}, 0), box_around({32, 32, 32}, 0)};
    for (double plane = -32; plane <= 32; plane += 4)
        for (const double beside : {0.0, 0.25, -0.25}) {
            boxes.push_back(box_around({plane, plane, plane}, 0.5));
            boxes.push_back(box_around({plane + beside, plane, -plane}, 0.5));
            boxes.push_back(box_around({plane + 0.5, beside, 0}, 0.5));
        }
    check_everywhere(all_moving("on the planes", boxes));
}

TEST_CASE("G7: equal keys, and keys one bit apart, make the same pairs in the same order", "[broadphase][hard]") {
    std::vector<PlainBox> boxes;
    for (int i = 0; i < 200; ++i) boxes.push_back(box_around({0, double(i % 7), double(i % 11)}, 0.5));
    Scene scene = all_moving("equal keys", boxes);
    check_everywhere(scene);
    Random random(7);
    SortAndSweep::In<Space<>> kept(SortAndSweep{});
    for (int step = 0; step < 50; ++step) {
        for (PlainBox& box : scene.boxes) {
            const double low = box.lower[0];
            box.lower[0] = std::nextafter(low, random.below(2) ? 1.0 : -1.0);
        }
        const auto now = boxes_of<Space<>>(scene);
        SortAndSweep::In<Space<>> fresh(SortAndSweep{});
        CHECK(fault_of(kept, now, oracle(now)) == "");
        CHECK(hash_of(kept, now) == hash_of(fresh, now)); // in the same order, too
    }
    // From the opposite order to one where all begin in one place: an order that remembers would tell them backwards.
    Scene falling = scene, level = scene;
    for (std::size_t i = 0; i < falling.boxes.size(); ++i) {
        const double at = 1000.0 - 10.0 * double(i);
        falling.boxes[i].lower[0] = at, falling.boxes[i].upper[0] = at + 1;
        level.boxes[i] = box_around({0, 30 * double(i % 2), 20 * double(i % 3)}, 0.5);
        level.boxes[i].upper[0] += 1000; // along x, by far
    }
    level.boxes.back() = box_around({5000, 0, 0}, 0.5);
    const auto before = boxes_of<Space<>>(falling), after = boxes_of<Space<>>(level);
    SortAndSweep::In<Space<>> fresh(SortAndSweep{});
    kept.find(before, [](std::size_t, std::size_t) {});
    CHECK(hash_of(kept, after) == hash_of(fresh, after));
    CHECK((kept.axis() == 0 && fresh.axis() == 0));
}

TEST_CASE("G10: a broadphase that is kept for 1000 steps of a random walk tells what a new one tells",
          "[broadphase][hard]") {
    each_policy([](const char* name, const auto& policy) {
        using Policy = std::remove_cvref_t<decltype(policy)>;
        typename Policy::template In<Space<>> kept(policy);
        Scene scene = seeded_scene(24);
        scene.boxes.resize(60); // of 400
        Random random(10);
        for (int step = 0; step < 1000; ++step) {
            const double far = step % 100 == 99 ? 5 : 0.1; // now and then nothing stays where it was
            for (PlainBox& box : scene.boxes)
                for (std::size_t k = 0; k < 3; ++k) {
                    const double by = random.uniform(-far, far);
                    box.lower[k] += by, box.upper[k] += by;
                }
            scene.active = random.below(61);
            const auto boxes = boxes_of<Space<>>(scene);
            typename Policy::template In<Space<>> fresh(policy);
            const std::string fault = fault_of(kept, boxes, oracle(boxes));
            if (!fault.empty()) FAIL_CHECK(name << ", step " << step << ": " << fault);
            if (hash_of(kept, boxes) != hash_of(fresh, boxes))
                FAIL_CHECK(name << ", step " << step << ": another order than a new one's");
        }
    });
}

TEST_CASE("G11: bodies in another order are the same pairs of bodies", "[broadphase][hard]") {
    const Scene scene = all_moving("as they are", seeded_scene(9).boxes);
    const auto right = oracle(boxes_of<Space<>>(scene));
    std::vector<std::size_t> shuffled(scene.boxes.size());
    std::iota(shuffled.begin(), shuffled.end(), std::size_t(0));
    Random random(11);
    for (std::size_t i = shuffled.size(); i > 1; --i) std::swap(shuffled[i - 1], shuffled[random.below(i)]);
    Scene other = scene;
    for (std::size_t i = 0; i < shuffled.size(); ++i) other.boxes[i] = scene.boxes[shuffled[i]];
    const auto boxes = boxes_of<Space<>>(other);
    each_policy([&](const char* name, const auto& policy) {
        Pairs back;
        for (const auto& [i, j] : find_pairs(policy, boxes)) back.push_back(std::minmax(shuffled[i], shuffled[j]));
        std::sort(back.begin(), back.end());
        INFO(name);
        CHECK(back == right);
    });
}

TEST_CASE("G12: boxes of the whole way of a step miss no body that is met within it", "[broadphase][hard]") {
    Random random(12);
    const double dt = 1.0 / 60, speed = 100;
    std::vector<std::array<double, 3>> from, v;
    std::vector<PlainBox> ways;
    for (int i = 0; i < 200; ++i) {
        from.push_back({random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)});
        v.push_back({random.uniform(-speed, speed), random.uniform(-speed, speed), random.uniform(-speed, speed)});
        PlainBox way = box_around(from.back(), 0.25);
        for (std::size_t k = 0; k < 3; ++k) {
            way.lower[k] += std::min(0.0, v.back()[k] * dt);
            way.upper[k] += std::max(0.0, v.back()[k] * dt);
        }
        ways.push_back(way);
    }
    std::vector<IndexPair> met;
    for (std::size_t i = 0; i < from.size(); ++i)
        for (std::size_t j = i + 1; j < from.size(); ++j)
            for (int part = 0; part <= 200; ++part) {
                double squared = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    const double apart = from[i][k] - from[j][k] + (v[i][k] - v[j][k]) * dt * part / 200;
                    squared += apart * apart;
                }
                if (squared > 0.4999 * 0.4999) continue;
                met.emplace_back(i, j);
                break;
            }
    CHECK(met.size() > 20);
    const Scene scene = all_moving("ways", ways);
    check_everywhere(scene);
    each_policy([&](const char* name, const auto& policy) {
        const auto pairs = find_pairs(policy, boxes_of<Space<>>(scene));
        INFO(name);
        CHECK(std::includes(pairs.begin(), pairs.end(), met.begin(), met.end()));
    });
}

TEST_CASE("G14: at 1e9 m and far beyond no cell overflows", "[broadphase][hard]") {
    for (const double at : {1e9, -1e9, 3e15, 1e30, -1e300, 1e-300}) {
        std::vector<PlainBox> boxes;
        const double step = std::max(std::abs(at) * 1e-15, 0.25);
        for (int i = 0; i < 60; ++i) boxes.push_back(box_around({at + i * step, -at, double(i)}, step));
        for (int i = 0; i < 60; ++i)
            boxes.push_back(box_around({double(i) / 3, 0, double(i)}, 0.5)); // and some at home
        for (int i = 0; i < 30; ++i)
            boxes.push_back(box_around({at * (i % 3), at * (i % 2), 0}, 0)); // of no size, so that no cell is too small
        const Scene scene = all_moving("at " + std::to_string(at), boxes);
        INFO(scene.name);
        CHECK(fault_of_any<Space<double, 3>>(scene) == "");
        CHECK(fault_of_any<Space<double, 2>>(scene) == "");
        if (std::abs(at) < 1e38) CHECK(fault_of_any<Space<float, 3>>(scene) == "");
        const auto plain = boxes_of<Space<>>(scene);
        CHECK(find_pairs(UniformGrid{0.5 * metre}, plain) == oracle(plain));
    }
}
