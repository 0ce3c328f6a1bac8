// SPDX-License-Identifier: BSL-1.0
// The scene of section 4.2 with your rule in it: a sheet is moved at a corner, and the rings are counted; beside it, a
// world in which it is really moved.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/soft_bodies.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

const std::size_t side = 10;
const TriangleMesh mesh = TriangleMesh::grid(side, side, metres(1, 0, 0), metres(0, 0.2, 1));

std::vector<int> yours() {
    exercise::Net net;
    net.held.assign(side * side, false);
    for (std::size_t n = 0; n < side * side; ++n) {
        if (n % side + 1 < side) net.springs.emplace_back(n, n + 1);
        if (n / side + 1 < side) net.springs.emplace_back(n, n + side);
    }
    return exercise::first_steps(net, 0);
}
std::vector<int> library() {
    World world{SemiImplicitEuler{}, Springs{}};
    const auto sheet = add_cloth(world, {.mesh = mesh,
                                         .mass_per_area = 1.0 * kilogram / square_metre,
                                         .structural = {200.0 * newton_per_metre},
                                         .lumping = Lumping::equal});
    std::vector<int> first(side * side, -1);
    std::vector<VectorQuantity<unit::Length, 3>> places;
    for (const Handle& body : sheet.bodies) places.push_back(world.position(body));
    world.set_position(sheet.bodies[0], places[0] + metres(-0.03, 0.02, -0.05));
    for (int step = 0; step < 40; ++step) {
        for (std::size_t i = 0; i < first.size(); ++i)
            if (first[i] < 0 && world.position(sheet.bodies[i]) != places[i]) first[i] = step;
        world.step(0.005 * second);
    }
    return first;
}

int main() {
    workbook::Play table("A sheet of 10 x 10 bodies is moved at a corner. In which step do the others move?",
                         {"along the side", "in the middle", "far corner"});
    table.timed("ns a body");
    workbook::Plot plot("play-soft_bodies.who_moves_first", "How many bodies have moved: yours and the library's");
    plot.x("steps", "").y("bodies", "");
    auto show = [&](const char* who, const std::vector<int>& first, auto&& once) {
        std::vector<double> steps, moved;
        for (int step = 0; step <= 20; ++step) {
            steps.push_back(step);
            moved.push_back(0);
            for (const int each : first) moved.back() += each >= 0 && each <= step ? 1 : 0;
        }
        plot.line(who, steps, moved);
        table.row(who, {double(first[9]), double(first[45]), double(first[99])}, int(side * side), once);
    };
    show("yours", yours(), [] {
        static volatile int sink = 0;
        sink = yours()[99];
    });
    show("library", library(), [] {
        static volatile int sink = 0;
        sink = library()[99];
    });
    plot.write();
    return table.print();
}
