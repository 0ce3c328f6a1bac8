// SPDX-License-Identifier: BSL-1.0
// A crowd in a room, one planned after the other around your reservations and around the library's.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/prioritised.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace ansatz;
using exercise::Place;
using exercise::Plan;

constexpr int width = 14, height = 9;

exercise::Room room() {
    exercise::Room rows(height, std::string(width, '.'));
    for (int y = 0; y < height; ++y)
        if (y % 4 != 1) rows[std::size_t(y)][6] = '#'; // a wall with two doors
    return rows;
}
struct Errand {
    Place start, goal;
};
/// From one side to the other, and back.
std::vector<Errand> errands(std::size_t count) {
    std::vector<Errand> all;
    for (int i = 0; i < int(count); ++i) {
        const Place west{i / height, i % height}, east{width - 1 - i / height, (4 * i + 2) % height};
        all.push_back(i % 2 == 0 ? Errand{west, east} : Errand{east, west});
    }
    return all;
}
/// Breadth first in space and time, over the edges that you give it.
Plan find(const exercise::Room& rows, const std::vector<Plan>& reserved, const Errand& errand, double& looked_at) {
    struct Node {
        Place at;
        std::size_t step, parent;
    };
    std::vector<Node> nodes{{errand.start, 0, 0}};
    std::map<std::tuple<std::size_t, int, int>, bool> known;
    for (std::size_t i = 0; i < nodes.size() && nodes[i].step < 100; ++i) {
        const Node node = nodes[i];
        ++looked_at;
        if (node.at == errand.goal && exercise::can_stay(reserved, node.at, node.step)) {
            Plan plan{node.at};
            for (std::size_t k = i; k != 0; k = nodes[k].parent) plan.push_back(nodes[nodes[k].parent].at);
            std::reverse(plan.begin(), plan.end());
            return plan;
        }
        for (const Place next : exercise::next_places(rows, reserved, node.at, node.step))
            if (!std::exchange(known[{node.step + 1, next.x, next.y}], true)) nodes.push_back({next, node.step + 1, i});
    }
    return {};
}

struct Crowd {
    double arrive = 0, steps = 0, meetings = 0;
};
/// How often two are in one tile, or change places.
double meetings(const std::vector<Plan>& plans) {
    const auto at = [](const Plan& plan, std::size_t step) { return plan[std::min(step, plan.size() - 1)]; };
    double count = 0;
    for (std::size_t i = 0; i < plans.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            for (std::size_t step = 0; step < std::max(plans[i].size(), plans[k].size()); ++step)
                if (at(plans[i], step) == at(plans[k], step) ||
                    (at(plans[i], step) == at(plans[k], step + 1) && at(plans[i], step + 1) == at(plans[k], step)))
                    ++count;
    return count;
}
Crowd with_yours(const std::vector<Errand>& all) {
    const auto rows = room();
    std::vector<Plan> plans;
    Crowd crowd;
    double looked_at = 0;
    for (const Errand& errand : all) {
        const Plan plan = find(rows, plans, errand, looked_at);
        if (plan.empty()) continue;
        plans.push_back(plan);
        ++crowd.arrive;
        crowd.steps = std::max(crowd.steps, double(plan.size() - 1));
    }
    crowd.meetings = meetings(plans);
    return crowd;
}
Crowd with_the_librarys(const std::vector<Errand>& all) {
    using namespace paths;
    const auto rows = room();
    const auto cell = [](Place p) { return Cell{std::uint16_t(p.x), std::uint16_t(p.y)}; };
    Grid<Four> map(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) map.set_passable(cell({x, y}), rows[std::size_t(y)][std::size_t(x)] == '.');
    std::vector<paths::Errand> theirs;
    for (const auto& errand : all) theirs.push_back({cell(errand.start), cell(errand.goal)});
    Prioritised search{map};
    Crowd crowd;
    crowd.arrive = search.find(theirs) ? double(all.size()) : double(search.failed());
    crowd.steps = double(search.steps());
    std::vector<Plan> plans;
    for (std::size_t i = 0; i < std::size_t(crowd.arrive); ++i) {
        Plan plan;
        for (const Cell c : search.plan(i)) plan.push_back({c.x, c.y});
        plans.push_back(plan);
    }
    crowd.meetings = meetings(plans);
    return crowd;
}

int main() {
    const auto all = errands(8);
    workbook::Play table("Eight in a room of 14 x 9 tiles, from side to side through a wall with two doors.",
                         {"have a plan", "steps until all stand", "meetings"});
    table.timed("ns a crowd");
    const Crowd yours = with_yours(all), library = with_the_librarys(all);
    table.row("yours", {yours.arrive, yours.steps, yours.meetings}, 1, [&] { with_yours(all); });
    table.row("library", {library.arrive, library.steps, library.meetings}, 1, [&] { with_the_librarys(all); });
    return table.print();
}
