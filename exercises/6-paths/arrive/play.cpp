// SPDX-License-Identifier: BSL-1.0
// Somebody goes to a place with your verbs and with the library's.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/walking/steering.hpp>

using namespace ansatz;

struct Walk {
    double farthest = 0, left = 0; // beyond the place, m; from it after 20 s, m
};
template <class Steered, class Speed> Walk walk(const Steered& steered, const Speed& arrival_speed) {
    const auto acceleration = 2.0 * metre / second / second;
    const auto dt = 0.1 * second;
    auto x = metres(0, 0);
    auto v = metres_per_second(0, 0);
    const auto place = metres(12, 5);
    Walk result;
    for (int i = 0; i < 200; ++i) {
        const auto way = place - x;
        const auto left = norm(way);
        const auto speed = min(4.0 * metre / second, arrival_speed(left, acceleration, dt));
        v = steered(v, left.value() > 0 ? (speed.value() / left.value()) * (way / (1.0 * second)) : 0.0 * v,
                    acceleration, dt);
        x = x + v * dt;
        const double beyond = (x - place).value().dot(Eigen::Vector2d(12, 5).normalized());
        result.farthest = std::max(result.farthest, beyond);
    }
    result.left = norm(place - x).value();
    return result;
}

int main() {
    workbook::Play table("13 m to a place, with 4 m/s and 2 m/s^2 at most, in steps of 0.1 s; 20 s.",
                         {"beyond it, m", "from it at the end, m"});
    table.timed("ns a walk");
    const auto yours = [] {
        return walk([](const auto& v, const auto& w, auto a, auto dt) { return exercise::steered(v, w, a, dt); },
                    [](auto d, auto a, auto dt) { return exercise::arrival_speed(d, a, dt); });
    };
    const auto library = [] {
        return walk([](const auto& v, const auto& w, auto a, auto dt) { return paths::steered(v, w, a, dt); },
                    [](auto d, auto a, auto dt) { return paths::arrival_speed(d, a, dt); });
    };
    const Walk one = yours(), other = library();
    table.row("yours", {one.farthest, one.left}, 1, [&] { yours(); });
    table.row("library", {other.farthest, other.left}, 1, [&] { library(); });
    return table.print();
}
