// SPDX-License-Identifier: BSL-1.0
// `./workbook peers paths`: A* beside boost::astar_search and a loop written by hand, a planner beside linear scans,
// and ways for groups and for long paths beside single searches.

#include "tests/paths/data.hpp"
#include "tests/peers/contest.hpp"
#include "tests/peers/paths/groups.hpp"
#include "tests/peers/paths/hand.hpp"
#include "tests/peers/paths/soldier.hpp"
#include "tests/peers/paths/textbook.hpp"
#include "tests/peers/versions.hpp"

#include <ansatz/paths.hpp>

#include <boost/version.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

std::string project_folder() { return ANSATZ_PROJECT_FOLDER; } // tests/main.cpp, which has it else, is not in this

static const peers::Version version("Boost.Graph", BOOST_LIB_VERSION);

using namespace ansatz;
using namespace ansatz::paths;
using peers::Contest;
using peers::Subject;

namespace {

struct Query {
    Cell start, goal;
};

/// Somebody who finds all the queries of a scene so many times over, and the sum of the lengths he found.
template <class Find>
Subject subject(const std::string& name, const std::vector<Query>& queries, int passes, double right, Find find,
                std::size_t expanded = 0) {
    double all = 0;
    for (const auto& q : queries) all += find(q);
    if (std::abs(all - right) > 1e-6 * right) {
        std::cerr << name << " walks " << all << " tiles where " << right << " are enough; its time means nothing\n";
        std::exit(1);
    }
    return {name,
            [&queries, passes, find]() mutable {
                static volatile double sum = 0; // so that nothing unused is left out
                for (int pass = 0; pass < passes; ++pass)
                    for (const auto& q : queries) sum = sum + find(q);
            },
            expanded == 0 ? "" : std::to_string(expanded) + " nodes a query"};
}

/// Everybody on one map.
class Field {
public:
    explicit Field(const Grid<>& map)
        : map_(map),
          heap_(map),
          buckets_(map, Buckets{}),
          doubles_(map, CostIn<double>{}),
          hand_heap_(map),
          hand_buckets_(map),
          textbook_(map),
          vectors_(map) {}

    /// \param passes of all queries in one repeat: with several, what a query reads may still lie in the cache, as
    /// it does
    ///               where many walkers ask in every frame
    void play(Contest& contest, const std::string& scene, const std::vector<Query>& queries, int passes) {
        double right = 0;
        std::size_t expanded[3]{};
        for (const auto& q : queries) {
            heap_.find(q.start, q.goal), buckets_.find(q.start, q.goal), hand_heap_.find(q.start, q.goal);
            right += map_.tiles(heap_.path());
            expanded[0] += heap_.expanded(), expanded[1] += buckets_.expanded(), expanded[2] += hand_heap_.expanded();
        }
        const std::size_t n = queries.size();
        auto by = [this](auto& search) {
            return [this, &search](const Query& q) {
                search.find(q.start, q.goal);
                return map_.tiles(search.path());
            };
        };
        auto by_hand = [](auto& search) {
            return [&search](const Query& q) {
                search.find(q.start, q.goal);
                return search.tiles();
            };
        };
        auto by_boost = [](auto& search) { return [&search](const Query& q) { return search.find(q.start, q.goal); }; };
        contest.play(scene, int(n), "us a query", 1e3 * double(n) * passes,
                     {subject("ansatz heap", queries, passes, right, by(heap_), expanded[0] / n),
                      subject("ansatz bucket", queries, passes, right, by(buckets_), expanded[1] / n),
                      subject("ansatz heap, double", queries, passes, right, by(doubles_)),
                      subject("hand-written loop, heap", queries, passes, right, by_hand(hand_heap_), expanded[2] / n),
                      subject("hand-written loop, bucket", queries, passes, right, by_hand(hand_buckets_)),
                      subject("boost astar_search", queries, passes, right, by_boost(textbook_)),
                      subject("boost astar_search, vecS directed", queries, passes, right, by_boost(vectors_))});
    }

private:
    const Grid<>& map_;
    AStar<Grid<>> heap_;
    AStar<Grid<>, Buckets> buckets_;
    AStar<Grid<>, CostIn<double>> doubles_;
    peers::HandHeap hand_heap_;
    peers::HandBuckets hand_buckets_;
    peers::Textbook<boost::listS, boost::undirectedS> textbook_;
    peers::Textbook<boost::vecS, boost::directedS> vectors_;
};

/// Rooms of 16 tiles whose walls have doors: what is played where there are no files.
Grid<> rooms(std::mt19937& random) {
    Grid map(512, 512);
    std::vector<std::uint8_t> free(map.size(), 1);
    for (std::size_t y = 0; y < 512; ++y)
        for (std::size_t x = 0; x < 512; ++x)
            if (x % 16 == 15 || y % 16 == 15) free[y * 512 + x] = 0;
    for (std::size_t y = 0; y < 32; ++y)
        for (std::size_t x = 0; x < 32; ++x) {
            if (x < 31 && random() % 8 != 0) free[(16 * y + random() % 15) * 512 + 16 * x + 15] = 1;
            if (y < 31 && random() % 8 != 0) free[(16 * y + 15) * 512 + 16 * x + random() % 15] = 1;
        }
    map.set_passable(free);
    return map;
}
/// \param reach 0 for any; else paths of half of it to all of it, in tiles
std::vector<Query> random_queries(const Grid<>& map, std::mt19937& random, std::size_t count, int reach) {
    std::vector<Query> queries;
    AStar search{map};
    while (queries.size() < count) {
        const int x = int(random() % map.width()), y = int(random() % map.height());
        const int u = reach == 0 ? int(random() % map.width()) : x + int(random() % unsigned(2 * reach + 1)) - reach;
        const int v = reach == 0 ? int(random() % map.height()) : y + int(random() % unsigned(2 * reach + 1)) - reach;
        if (u < 0 || v < 0 || u >= int(map.width()) || v >= int(map.height()) || (u == x && v == y)) continue;
        const Query q{{std::uint16_t(x), std::uint16_t(y)}, {std::uint16_t(u), std::uint16_t(v)}};
        if (search.find(q.start, q.goal) != Outcome::found) continue;
        if (const double tiles = map.tiles(search.path()); reach > 0 && (tiles < reach / 2 || tiles > reach)) continue;
        queries.push_back(q);
    }
    return queries;
}

void on_a_map(Contest& contest, const std::string& name, const Grid<>& map, const std::vector<Query>& far,
              std::mt19937& random) {
    const auto near = random_queries(map, random, 100, 16);
    Field field(map);
    field.play(contest, name, far, 1);
    field.play(contest, "near, " + name, near, 8);
}

/// The same near queries in a small map and in large ones: their time follows what they expand.
void sizes(Contest& contest) {
    for (const std::size_t side : {64, 512, 4096}) {
        const Grid map(side, side);
        AStar every{map};
        AStar jumping{map, JumpPoints{}};
        const auto find = [](auto& search) {
            return [&search] {
                for (std::uint16_t i = 0; i < 64; ++i)
                    search.find(Cell{std::uint16_t(i % 8), 2}, Cell{std::uint16_t(20 + i % 16), 30});
            };
        };
        contest.play("near, empty map, by its side", int(side), "us a query", 1e3 * 64,
                     {{"ansatz heap", find(every), "the same queries"},
                      {"ansatz heap, jump points", find(jumping), "no farther than twice the way to the goal"}});
    }
}

void soldier(Contest& contest) {
    const peers::Soldier s;
    goap::Planner planner{s.domain};
    goap::Planner greedy{s.domain, goap::Greedy{}};
    peers::LinearPlanner linear(s.domain);
    planner.plan(s.start, s.goal);
    greedy.plan(s.start, s.goal);
    const int cost = linear.plan(s.start.bits[0], s.goal.value.bits[0], s.goal.care.bits[0]);
    if (planner.cost() != cost || greedy.cost() != cost) {
        std::cerr << "the plans cost " << planner.cost() << ", " << greedy.cost() << " and " << cost
                  << "; their times mean nothing\n";
        std::exit(1);
    }
    constexpr int times = 1000;
    auto again = [](auto plan) {
        return [plan]() mutable {
            for (int i = 0; i < times; ++i) plan();
        };
    };
    contest.play("soldier", int(s.domain.actions()), "ns a plan", times,
                 {{"ansatz planner", again([&] { planner.plan(s.start, s.goal); }),
                   std::to_string(planner.expanded()) + " states"},
                  {"ansatz planner, greedy", again([&] { greedy.plan(s.start, s.goal); }),
                   std::to_string(greedy.expanded()) + " states"},
                  {"bitset planner, linear scans",
                   again([&] { linear.plan(s.start.bits[0], s.goal.value.bits[0], s.goal.care.bits[0]); }),
                   std::to_string(linear.expanded()) + " states"}});
}

} // namespace

/// usage: peers_paths <folder for paths.json> [repeats]
int main(int argc, char** argv) {
#ifdef __GLIBC__ // what a peer allocates for each search it gets again without a page fault
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
#endif
    const std::string folder = argc > 1 ? argv[1] : ".";
    Contest contest("paths", argc > 2 ? std::max(1, std::atoi(argv[2])) : 9);
    std::mt19937 random(1);
    soldier(contest);
    sizes(contest);
    const std::string data = paths_tests::data_folder();
    if (data.empty())
        std::cout << "left out: the maps of games (no folder shared/data beside the project, and ANSATZ_TEST_DATA "
                     "names none)\n";
    else
        for (const std::string name : {"AR0011SR", "brc202d"}) {
            const auto file = read_moving_ai_map(data + "/movingai/" + name + ".map");
            const auto map = file.grid();
            const auto scenarios = read_moving_ai_scenarios(data + "/movingai/" + name + ".map.scen");
            std::vector<Query> far;
            for (std::size_t i = 0; i < 40; ++i) {
                const auto& s = scenarios[(2 * i + 1) * scenarios.size() / 80];
                far.push_back({s.start, s.goal});
            }
            on_a_map(contest, "game map " + name, map, far, random);
            peers::gates(contest, "game map " + name, map, scenarios);
        }
    const auto map = rooms(random);
    const auto far = random_queries(map, random, 40, 0);
    on_a_map(contest, "rooms", map, far, random);
    // The goal of the longest query: in the part of the map that is not cut off.
    const auto goal = std::max_element(far.begin(), far.end(), [](const Query& a, const Query& b) {
                          const auto apart = [](const Query& q) {
                              return std::max(std::abs(q.start.x - q.goal.x), std::abs(q.start.y - q.goal.y));
                          };
                          return apart(a) < apart(b);
                      })->goal;
    peers::to_one_goal(contest, "rooms", map, goal, random);
    peers::tick(contest, map, goal, random);
    peers::weights(contest, "rooms", map, goal, random);
    peers::inconsistent(contest);
    contest.write(folder);
    return 0;
}
