// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on who moves first (notes 4).

#include "tools/exercises/expect.hpp"

#include <algorithm>
#include <cstdlib>

using namespace ansatz::workbook;

namespace {

using Spring = std::pair<std::size_t, std::size_t>;

struct Scene {
    std::string name;
    exercise::Net net;
    std::size_t from;
};
/// Of columns by rows bodies, tied along its lines; every other spring is named from its far end.
exercise::Net grid(std::size_t columns, std::size_t rows) {
    exercise::Net net;
    net.held.assign(columns * rows, false);
    auto add = [&](std::size_t a, std::size_t b) {
        net.springs.push_back(net.springs.size() % 2 == 0 ? Spring(a, b) : Spring(b, a));
    };
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i) {
            const std::size_t here = i + columns * j;
            if (i + 1 < columns) add(here, here + 1);
            if (j + 1 < rows) add(here, here + columns);
        }
    return net;
}
exercise::Net chain(std::size_t count, bool backwards) {
    exercise::Net net;
    net.held.assign(count, false);
    for (std::size_t i = 0; i + 1 < count; ++i) net.springs.push_back(backwards ? Spring(i + 1, i) : Spring(i, i + 1));
    return net;
}
exercise::Net holding(exercise::Net net, const std::vector<std::size_t>& held) {
    for (const std::size_t i : held) net.held[i] = true;
    return net;
}
std::vector<Scene> scenes() {
    return {{"a row of six bodies, moved at its first", chain(6, false), 0},
            {"a row of six bodies, moved at its third", chain(6, true), 2},
            {"a sheet of 4 x 3 bodies, moved at a corner", grid(4, 3), 0},
            {"a sheet of 4 x 4 bodies, moved inside", grid(4, 4), 5}};
}
/// With pins: around which news must go, or which let none through.
std::vector<Scene> pinned() {
    return {{"a row of six bodies, the fourth of them held, moved at its first", holding(chain(6, false), {3}), 0},
            {"a sheet of 4 x 3 bodies, held at 1 and 5, moved at a corner", holding(grid(4, 3), {1, 5}), 0},
            {"a sheet of 3 x 4 bodies, a whole row of it held, moved at a corner", holding(grid(3, 4), {6, 7, 8}), 0}};
}
/// By the rule alone: the shortest way from the moved body that does not lead over one that is held.
std::vector<int> ways(const Scene& s) {
    std::vector<int> way(s.net.held.size(), -1);
    std::vector<std::size_t> queue{s.from};
    way[s.from] = 0;
    for (std::size_t next = 0; next < queue.size(); ++next)
        for (const auto& [a, b] : s.net.springs)
            for (const auto& [here, there] : {Spring(a, b), Spring(b, a)})
                if (here == queue[next] && way[there] < 0 && !s.net.held[there]) {
                    way[there] = way[here] + 1;
                    queue.push_back(there);
                }
    return way;
}
std::vector<bool> moved_by(const Scene& s, int step) {
    std::vector<bool> all;
    for (const int way : ways(s)) all.push_back(way >= 0 && way <= step);
    return all;
}
void expect_moved(const Scene& s, int step, const std::string& why) {
    const auto mine = exercise::one_step(s.net, moved_by(s, step - 1)), right = moved_by(s, step);
    expect(mine.size() == right.size(),
           s.name + ": there is one answer for each body, and you return " + std::to_string(mine.size()) + ".");
    for (std::size_t i = 0; i < right.size(); ++i)
        expect(mine[i] == right[i], s.name + ", after step " + std::to_string(step) + ": body " + std::to_string(i) +
                                        (mine[i] ? " has moved in yours, and should not have.\n"
                                                 : " has not moved in yours, and should have.\n") +
                                        why);
}
void expect_first(const Scene& s, const std::string& why) {
    const auto mine = exercise::first_steps(s.net, s.from);
    const auto right = ways(s);
    expect(mine.size() == right.size(),
           s.name + ": there is one answer for each body, and you return " + std::to_string(mine.size()) + ".");
    for (std::size_t i = 0; i < right.size(); ++i)
        expect_near(s.name + ": the first step of body " + std::to_string(i), double(mine[i]), double(right[i]), 0.0,
                    why);
}

} // namespace

TEST_CASE("in the first step its neighbours move, and no one else", "[task-1][neighbours]") {
    for (const Scene& s : scenes())
        expect_moved(s, 1,
                     "Only springs with an end that has moved are longer or shorter than they should be; they pull at "
                     "both of their ends, whichever was named first.");
}

TEST_CASE("in each step one ring more", "[task-1][ring]") {
    for (const Scene& s : scenes())
        for (int step = 2; step <= 5; ++step)
            expect_moved(s, step,
                         "Who has moved stays moved, and its neighbours come in. All springs are asked before anybody "
                         "moves: nobody gets two rings at once.");
}

TEST_CASE("who is held does not move", "[task-1][held]") {
    for (const Scene& s : pinned())
        for (int step = 1; step <= 4; ++step) expect_moved(s, step, "A spring may pull at it as it likes.");
}

TEST_CASE("a body moves first after as many steps as springs are between", "[task-2][ways]") {
    for (const Scene& s : scenes())
        expect_first(s, "Count springs along the shortest way; the one that was moved has 0.");
}

TEST_CASE("news goes around pins, and not through them", "[task-2][pins]") {
    for (const Scene& s : pinned())
        expect_first(s,
                     "The way must not lead over a body that is held, since that one passes nothing on. Where there is "
                     "no other, and for the held one itself, it is never: -1.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    for (const auto& all : {scenes(), pinned()})
        for (const Scene& s : all)
            if (task == 2)
                for (const int first : exercise::first_steps(s.net, s.from)) numbers.push_back(first + 10);
            else
                for (int step = 0; step < 4; ++step)
                    for (const bool one : exercise::one_step(s.net, moved_by(s, step))) numbers.push_back(one ? 3 : 2);
    return numbers;
}
