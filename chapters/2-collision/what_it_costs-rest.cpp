// SPDX-License-Identifier: BSL-1.0
// What rest costs: how far a world is from one in which no body falls asleep, and what it saves

// The reference is the same world without Rest. A body that falls asleep stops where it is. As long as every body that
// sleeps would have lain still anyway, nothing differs; the first one that is put to sleep although it would have
// rolled on makes an error as large as its way. So the error is a step: almost nothing, and then all of it. Where the
// step is, the threshold of the velocity says.
//
// Towers and rollers: what stands, stands; what rolls does so for ever, without friction, from 1 mm/s to 1 m/s. A pile:
// three hundred balls with friction that are dropped into a pit.

#include "what_it_costs.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;
using namespace collision_costs;
using workbook::Axis;
using workbook::Outcome;

namespace {

constexpr double dt = 1.0 / 60; // s
using Places = std::vector<Eigen::Vector3d>;

struct TowersAndRollers {
    static constexpr const char* name = "40 towers of 5 and 40 rollers, 10 s";
    static constexpr int steps = 600;
    using Response = SoftSubsteps<>;
    template <class World_> static void add(World_& world) {
        world.add(Plane::ground(), fixed);
        for (int i = 0; i < 40; ++i)
            for (int k = 0; k < 5; ++k)
                world.add(Sphere{0.5 * metre}, position(metres(3 * i, 0.5 + k, 0)), mass(1.0 * kilogram));
        for (int i = 0; i < 40; ++i) {
            const double speed = std::pow(10.0, -3 + 3 * i / 39.0);
            world.add(Sphere{0.5 * metre}, position(metres(3 * i, 0.5, 20)), velocity(metres_per_second(0, 0, speed)),
                      mass(1.0 * kilogram));
        }
    }
};
struct Pit {
    static constexpr const char* name = "a pile of 300 in a pit, with friction, 20 s";
    static constexpr int steps = 1200;
    using Response = SoftSubsteps<Friction>;
    template <class World_> static void add(World_& world) {
        const auto wall = [&](double x, double z) {
            world.add(Plane{Eigen::Vector3d(x, 0, z), -1.5 * metre}, fixed, friction(0.3));
        };
        world.add(Plane::ground(), fixed, friction(0.3));
        wall(1, 0);
        wall(-1, 0);
        wall(0, 1);
        wall(0, -1);
        for (int i = 0; i < 300; ++i)
            world.add(Sphere{0.2 * metre},
                      position(metres(-1.2 + 0.45 * (i % 6) + 0.01 * (i % 7), 0.5 + 0.45 * (i / 36),
                                      -1.2 + 0.45 * (i / 6 % 6) + 0.01 * (i % 5))),
                      mass(1.0 * kilogram), friction(0.3));
    }
};

template <class Scene, class... Resting> auto world_of(const Resting&... rest) {
    World world{SemiImplicitEuler{},        Gravity{}, UniformGrid{}, Narrowphase<Sphere, Plane>{},
                typename Scene::Response{}, rest...};
    Scene::add(world);
    return world;
}
template <class World_> Places places(const World_& world) {
    Places all;
    for (const auto body : world.handles()) all.push_back(world.position(body).value());
    return all;
}
/// Where bodies are without Rest; found once.
template <class Scene> const Places& reference() {
    static const Places places_ = [] {
        auto world = world_of<Scene>();
        for (int i = 0; i < Scene::steps; ++i) world.step(dt * second);
        return places(world);
    }();
    return places_;
}

const Axis axis{.name = "rest",
                .error_norm = "max |x - x without Rest| at the end (m)",
                .work_unit = "steps of awake bodies",
                .time_unit = "ns per body and step",
                .has_order = false};

template <class Scene, class... Resting>
void add_row(Costs& costs, const std::string& choice, const workbook::Parameter& parameter, const Resting&... rest) {
    const int bodies = int(world_of<Scene>().count(Motion::awake));
    costs.add(axis, {.choice = choice,
                     .problem = Scene::name,
                     .parameter = parameter,
                     .n = bodies,
                     .error_run =
                         [=] {
                             auto world = world_of<Scene>(rest...);
                             double awake = 0, worst = 0;
                             for (int i = 0; i < Scene::steps; ++i) {
                                 awake += double(world.count(Motion::awake));
                                 world.step(dt * second);
                             }
                             const auto now = places(world);
                             const auto& right = reference<Scene>();
                             for (std::size_t i = 0; i < now.size(); ++i)
                                 worst = std::max(worst, (now[i] - right[i]).norm());
                             return Outcome{.error = worst, .work = awake, .diverged = !world.status().ok()};
                         },
                     .timed_run =
                         [=] {
                             auto world = world_of<Scene>(rest...);
                             for (int i = 0; i < Scene::steps; ++i) world.step(dt * second);
                             return world.position(world.handles().back());
                         },
                     .per = double(bodies) * Scene::steps});
}

template <class Scene> void add_rows(Costs& costs) {
    add_row<Scene>(costs, "without Rest", {});
    for (const double time : {0.1, 0.5, 2.0})
        for (const double threshold : {0.001, 0.005, 0.02, 0.05, 0.2, 1.0}) {
            const std::string choice = std::string("Rest, ").append(workbook::significant(time, 2)).append(" s");
            add_row<Scene>(costs, choice, {"threshold", threshold * metre_per_second},
                           Rest{threshold * metre_per_second, time * second});
        }
}

/// What each row saves of the time without Rest.
void summarise(std::ostream& out, const Rows& all, const std::filesystem::path&) {
    for (const auto& problem : workbook::different(rows_of(all, axis.name), &workbook::Row::problem)) {
        const Rows rows = rows_of(all, axis.name, problem);
        const Rows without = rows_of(rows, axis.name, problem, "without Rest");
        if (without.empty() || !without.front().time) continue;
        out << "\nTime saved by Rest, and the largest deviation: " << problem << '\n';
        for (const auto& row : rows) {
            if (row.choice == "without Rest" || !row.time || !row.error) continue;
            char text[160];
            std::snprintf(text, sizeof text, "  %-14s %-26s %4.0f %%   %.1e m\n", row.choice.c_str(),
                          row.parameter.text().c_str(), 100 * (1 - *row.time / *without.front().time), *row.error);
            out << text;
        }
    }
}

} // namespace

void collision_costs::add_rest(Costs& costs) {
    add_rows<TowersAndRollers>(costs);
    add_rows<Pit>(costs);
    costs.add_summary(summarise);
}
