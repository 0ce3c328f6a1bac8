// SPDX-License-Identifier: BSL-1.0
// What accuracy costs in chapter 4: a sheet that swings from two corners, soft and stiff, by explicit steps, an
// implicit one, and solvers

// Read the rows like this: the error is how far the vertices are, at half a second, from where a fine Runge-Kutta run
// has them; the time is that of a frame of 1/60 s. The second table has what an eye sees of the same runs: the largest
// strain on the way, and how much energy there is at the end beside the fine run's, as a fraction of what the sheet's
// weight does in half a metre. Explicit steps are the most exact, soft or stiff, as soon as they are short enough for
// there to be a row at all: 16 a frame of the soft sheet, 128 to 256 of the stiff one. What is cheaper is Xpbd, whose
// sheet is longer than its springs say, the more the fewer its substeps; what takes long steps without stretching is
// ImplicitEuler, which pays with energy.

#include "costs.hpp"

#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

using namespace ansatz;
using workbook::Axis;
using workbook::Costs;
using workbook::Outcome;

namespace {

constexpr std::size_t side = 20;
constexpr int frames = 30;
constexpr double mass_per_area = 0.15;

/// A sheet of 1 m x 1 m that lies flat and is held at two corners of one side.
struct Sheet {
    std::string name;
    double stiffness; ///< N/m, of the springs along it

    template <class World_> std::vector<Handle> add_to(World_& world) const {
        const auto springs = [&](double part) {
            return SpringConstants{.stiffness = part * stiffness * newton_per_metre,
                                   .damping = part * 0.02 * newton_second_per_metre};
        };
        return add_cloth(world, {.mesh = TriangleMesh::grid(side, side, metres(1, 0, 0), metres(0, 0, 1)),
                                 .mass_per_area = mass_per_area * kilogram / square_metre,
                                 .structural = springs(1),
                                 .shear = springs(0.5),
                                 .bend = springs(0.1),
                                 .pins = {0, side - 1},
                                 .lumping = Lumping::equal})
            .bodies;
    }
};

/// What came of a run.
struct Swing {
    std::vector<Vector<double, 3>> places; ///< m, at the end
    double strain = 0;                     ///< the largest at the end of any frame
    double energy = 0;                     ///< J, at the end
};
template <class World_> Swing swing(World_ world, const Sheet& sheet, int steps) {
    const auto bodies = sheet.add_to(world);
    Swing result;
    for (int frame = 0; frame < frames; ++frame) {
        for (int i = 0; i < steps; ++i) world.step(1.0 / 60 / steps * second);
        typename Springs<>::template In<typename World_::S>(world.template get<Springs<>>())
            .tensions(world.template view<Springs<>>(), [&](std::uint32_t, const auto&, double strain) {
                result.strain = std::isfinite(strain) ? std::max(result.strain, strain) : INFINITY;
            });
    }
    for (const Handle body : bodies) result.places.push_back(world.position(body).value());
    result.energy = total_energy(world).value();
    return result;
}
/// The fine run, once for each sheet.
const Swing& fine(const Sheet& sheet) {
    static std::map<std::string, Swing> known;
    const auto found = known.find(sheet.name);
    if (found != known.end()) return found->second;
    const int steps = sheet.stiffness > 1000 ? 1536 : 512;
    return known[sheet.name] = swing(World{RungeKutta4{}, Gravity{}, Springs{}}, sheet, steps);
}

/// What is printed below: of each row that was run.
struct Seen {
    std::string choice, sheet;
    int steps;
    double strain, energy;
};

/// \param world with a solver or without
/// \param steps that it takes in a frame
/// \param work  and its passes over all springs in them
template <class World_>
void add_row(Costs& costs, const Axis& axis, const std::shared_ptr<std::vector<Seen>>& seen, const std::string& choice,
             const Sheet& sheet, const World_& world, int steps, int passes) {
    costs.add(axis,
              {.choice = choice,
               .problem = sheet.name,
               .parameter = {"dt", 1.0 / 60 / passes * second},
               .n = double(side * side),
               .known_order = {},
               .error_run =
                   [=] {
                       const auto& truth = fine(sheet);
                       const auto run = swing(world, sheet, steps);
                       double sum = 0;
                       for (std::size_t i = 0; i < truth.places.size(); ++i)
                           sum += (run.places[i] - truth.places[i]).squaredNorm();
                       const double weight = mass_per_area * 9.81 * 0.5;
                       seen->push_back({choice, sheet.name, passes, run.strain, (run.energy - truth.energy) / weight});
                       const double error = std::sqrt(sum / double(truth.places.size()));
                       return Outcome{.error = error, .work = double(passes), .diverged = !(error < 2)};
                   },
               .timed_run =
                   [=] {
                       World_ one = world;
                       const auto bodies = sheet.add_to(one);
                       for (int i = 0; i < frames * steps; ++i) one.step(1.0 / 60 / steps * second);
                       return one.position(bodies.back());
                   },
               .per = double(frames)});
}

void print(std::ostream& out, const Seen& one) {
    out << "    " << std::left << std::setw(36) << one.choice << std::right << std::setw(5) << one.steps;
    if (std::isfinite(one.strain) && std::isfinite(one.energy))
        out << std::setw(12) << one.strain << std::setw(12) << one.energy << '\n';
    else out << std::setw(12) << "diverged" << '\n';
}

void add_sheet(Costs& costs, const Axis& axis, const std::shared_ptr<std::vector<Seen>>& seen, const Sheet& sheet) {
    const bool stiff = sheet.stiffness > 1000;
    for (const int steps : stiff ? std::vector{128, 256, 512} : std::vector{8, 16, 32, 64, 128}) {
        add_row(costs, axis, seen, "SemiImplicitEuler", sheet, World{SemiImplicitEuler{}, Gravity{}, Springs{}}, steps,
                steps);
        add_row(costs, axis, seen, "VelocityVerlet", sheet, World{VelocityVerlet{}, Gravity{}, Springs{}}, steps,
                steps);
        add_row(costs, axis, seen, "RungeKutta4", sheet, World{RungeKutta4{}, Gravity{}, Springs{}}, steps, steps);
    }
    for (const int steps : {1, 2, 4, 8, 16})
        add_row(costs, axis, seen, "ImplicitEuler", sheet,
                World{ImplicitEuler{.tolerance = 0.01, .most_iterations = 10}, Gravity{}, Springs{}}, steps, steps);
    for (const int substeps : {5, 10, 20, 40, 80})
        add_row(costs, axis, seen, "Xpbd, 1 iteration", sheet,
                World{SemiImplicitEuler{}, Gravity{}, Springs{}, Xpbd{.substeps = substeps, .iterations = 1}}, 1,
                substeps);
    for (const int substeps : {5, 10, 20, 40, 80})
        add_row(
            costs, axis, seen, "VertexBlockDescent, 1 iteration", sheet,
            World{SemiImplicitEuler{}, Gravity{}, Springs{}, VertexBlockDescent{.substeps = substeps, .iterations = 1}},
            1, substeps);
    for (const int times : {5, 20})
        add_row(
            costs, axis, seen, "VertexBlockDescent, " + std::to_string(times) + " iterations", sheet,
            World{SemiImplicitEuler{}, Gravity{}, Springs{}, VertexBlockDescent{.substeps = 5, .iterations = times}}, 1,
            5);
}

} // namespace

int main(int argc, char** argv) {
    Costs costs("soft_bodies", argc, argv);
    const Axis cloth{.name = "cloth",
                     .error_norm = "rms |x - fine run| (m)",
                     .work_unit = "steps a frame",
                     .time_unit = "ns a frame",
                     .has_order = false};
    const auto seen = std::make_shared<std::vector<Seen>>();
    const std::vector<Sheet> sheets{{"soft, 200 N/m", 200}, {"stiff, 20,000 N/m", 20000}};
    for (const Sheet& sheet : sheets) add_sheet(costs, cloth, seen, sheet);
    costs.add_below([=](std::ostream& out) {
        out << "\nWhat an eye sees: the largest strain, and energy beside the fine run's, as a fraction of the weight "
               "times 0.5 m\n";
        for (const Sheet& sheet : sheets) {
            const auto& truth = fine(sheet);
            out << "  " << sheet.name << "; the fine run: largest strain " << std::setprecision(3) << truth.strain
                << '\n';
            for (const auto& one : *seen)
                if (one.sheet == sheet.name) print(out, one);
        }
    });
    return costs.run();
}
