// SPDX-License-Identifier: BSL-1.0
// 4.4 Solvers: what is too stiff for forces is held by positions, and what that costs

// The notes warn that a soft body whose damping is badly tuned explodes. The deeper reason is the step: springs that
// are stiff enough to look like cloth want steps too short to pay for. A solver does not ask what a spring pulls with
// now, but where its ends must be: it never explodes. Its price is accuracy: a body is softer than its springs say, and
// how much softer depends on how the work is spent. (A part of section 4, which the notes do not divide.)

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {

constexpr int links = 20;
constexpr auto frame = 1.0 / 60 * second;

/// A chain that hangs from a nail, and how far it is stretched when it hangs still, beside mgN(N+1)/2k.
template <class World_> double stretch(World_ world, Quantity<unit::Stiffness> k, int frames = 3000) {
    auto last = world.add(position(metres(0, 0, 0)), fixed);
    for (int n = 1; n <= links; ++n) {
        const auto next = world.add(position(metres(0, -0.1 * n, 0)), mass(0.05 * kilogram));
        world.add(Spring{last, next, k, 5.0 * newton_second_per_metre});
        last = next;
    }
    for (int i = 0; i < frames; ++i) world.step(frame);
    const auto hangs = 0.05 * kilogram * 9.81 * metre_per_second_squared * (0.5 * links * (links + 1));
    const double way = -y(world.position(last)) / metre - 0.1 * links;
    return way / (hangs / k / metre);
}

} // namespace

int main() {
    workbook::Claims claim;

    // What a force does with a step that is too long for it, and what a solver does with it.
    //! [worlds]
    World pulled{SemiImplicitEuler{}, Gravity{}, Springs{}};       // springs are forces
    World held{SemiImplicitEuler{}, Gravity{}, Springs{}, Xpbd{}}; // the same springs are constraints
    //! [worlds]
    const auto stiff = 1e5 * newton_per_metre, soft = 1000.0 * newton_per_metre;
    const double as_force = stretch(pulled, stiff, 60);
    claim("a stiff chain explodes at 60 steps a second, where its springs are forces", !(std::abs(as_force) < 1e3));
    claim("a solver holds it in the same step", stretch(held, stiff) < 10);

    // Where the work goes: 32 passes over the springs a frame.
    std::cout << "   substeps x iterations   stretched, beside Hooke's law\n"
              << "                           k = 1000 N/m    k = 100000 N/m\n";
    std::vector<double> counts, excess;
    double worst = 0;
    for (int substeps = 1; substeps <= 32; substeps *= 2) {
        //! [budget]
        const Xpbd solver{.substeps = substeps, .iterations = 32 / substeps};
        //! [budget]
        const World world{SemiImplicitEuler{}, Gravity{}, Springs{}, solver};
        const double of_soft = stretch(world, soft), of_stiff = stretch(world, stiff);
        std::cout << std::setw(14) << substeps << " x " << std::left << std::setw(2) << 32 / substeps << std::right
                  << std::fixed << std::setprecision(3) << std::setw(18) << of_soft << std::setw(18) << of_stiff
                  << '\n';
        worst = std::max(worst, std::abs(of_soft - 1));
        counts.push_back(substeps);
        excess.push_back(of_stiff - 1);
    }
    claim("a chain of 1000 N/m hangs as Hooke says, within 6 %, however the work is spent", worst < 0.06);
    bool falls = true;
    for (std::size_t i = 1; i < excess.size(); ++i) falls = falls && excess[i] < excess[i - 1];
    claim("for one price the error falls, the more of it are substeps", falls);
    claim("32 substeps are 20 times as accurate as 32 iterations, at least", excess.front() > 20 * excess.back());

    // One body after the other: implicit Euler, when it has converged.
    const World few{SemiImplicitEuler{}, Gravity{}, Springs{}, VertexBlockDescent{.iterations = 4}};
    const World many{SemiImplicitEuler{}, Gravity{}, Springs{}, VertexBlockDescent{.iterations = 300}};
    const double after_few = stretch(few, soft, 3000), after_many = stretch(many, soft, 3000);
    workbook::say() << "   one body after the other: stretched by " << after_few << " after 4 iterations a frame, by "
                    << after_many << " after 300\n";
    claim("block descent is Hooke's law after many iterations", std::abs(after_many - 1) < 1e-3);
    claim("and not after few", std::abs(after_few - 1) > 0.01);

    workbook::Plot plot("4.4", "Where 32 passes over the springs of a stiff chain go");
    plot.x("substeps a frame").y("stretched too far, beside Hooke's law").log_x().log_y();
    plot.line("20 links of 100000 N/m", counts, excess).write();
    return claim.result();
}
