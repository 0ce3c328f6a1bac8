// SPDX-License-Identifier: BSL-1.0
// 2.2.2 The penalty method: a spring while they touch, and what its damping does

// The notes set F = -kp - c N.(v_a - v_b) on both bodies. With their own normal, from the second body to the first, it
// must be +kp: the deeper, the stronger they are pushed apart. The second body gets -F, by Newton's third law, or two
// bodies at rest push each other off with momentum from nowhere. And "a higher value [of c] gives a more bouncy
// collision" is the other way round: they separate with e = exp(-pi zeta / sqrt(1 - zeta^2)), with
// zeta = c / (2 sqrt(k mu)), which falls as c grows. k decides how deep and how long they touch.

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {

struct Met {
    double e, deepest, momentum; // 1, m, kg m/s
};
//! [meet]
/// Two bodies of 1 kg meet at 1 m/s each.
Met meet(double k, double zeta) {
    const double mu = 0.5, omega = std::sqrt(k / mu);
    const Penalty penalty{k * newton_per_metre, 2 * zeta * std::sqrt(k * mu) * newton_second_per_metre};
    World world{VelocityVerlet{}, BoundingBoxes{}, Narrowphase<Sphere>{}, penalty};
    const auto a = world.add(Sphere{0.5 * metre}, velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    const auto b = world.add(Sphere{0.5 * metre}, position(metres(1, 0, 0)), velocity(metres_per_second(-1, 0, 0)),
                             mass(1.0 * kilogram));
    //! [meet]
    double deepest = 0;
    for (int i = 0; i < 1000; ++i) {
        world.step(M_PI / omega / 200 * second);
        deepest = std::max<double>(deepest, 1 - in(x(world.position(b)) - x(world.position(a)), metre));
    }
    const double va = in(x(world.velocity(a)), metre_per_second), vb = in(x(world.velocity(b)), metre_per_second);
    return {(vb - va) / 2, deepest, va + vb};
}

struct Freed {
    double distance, momentum; // m, kg m/s
};
/// A way to write the force: the sign of k p, the sign of F on the second body, and whether N takes part.
struct Form {
    double of_kp = 1, on_second = -1;
    bool along_normal = true;
};
//! [signs]
/// Two spheres of 1 kg, 1 m across, begin at rest and 0.1 m deep in each other: where are they after 0.1 s?
Freed let_go(const Form& form) {
    const double k = 1e4, dt = 1e-5;
    double a = 0, b = 0.9, va = 0, vb = 0; // a is on the left
    for (int step = 0; step < 10000; ++step) {
        const double normal = a < b ? -1 : 1, p = 1 - std::abs(b - a); // N points from b to a
        const double f = p > 0 ? form.of_kp * k * p * (form.along_normal ? normal : 1) : 0;
        va += f * dt, vb += form.on_second * f * dt;
        a += va * dt, b += vb * dt;
    }
    return {b - a, va + vb};
}
//! [signs]

} // namespace

int main() {
    workbook::Claims claim;
    const auto apart = let_go({}), second_plus = let_go({.on_second = 1}), minus_kp = let_go({.of_kp = -1}),
               no_normal = let_go({.along_normal = false});
    std::cout << "From rest, b 0.9 m to the right of a and 0.1 m deep in it, after 0.1 s:\n"
              << "  +kp N and its opposite: b - a = " << apart.distance << " m, momentum " << apart.momentum
              << " kg m/s\n"
              << "  +F on both: b - a = " << second_plus.distance << " m, momentum " << second_plus.momentum
              << " kg m/s\n"
              << "  -kp N and its opposite: b - a = " << minus_kp.distance << " m, momentum " << minus_kp.momentum
              << " kg m/s\n"
              << "  kp without N: b - a = " << no_normal.distance << " m, momentum " << no_normal.momentum
              << " kg m/s\n";
    claim("with +kp N and its opposite they separate, and momentum stays zero",
          apart.distance > 1 && std::abs(apart.momentum) < 1e-12);
    claim("+F on both separates nothing and adds 2 k p t of momentum",
          std::abs(std::abs(second_plus.momentum) - 2 * 1e4 * 0.1 * 0.1) < 1e-6 &&
              std::abs(second_plus.distance - 0.9) < 1e-9);
    claim("-kp N pulls them into each other and never lets go", std::abs(minus_kp.distance) < 0.9);
    claim("kp without N drives them through each other, if the first is on the left", no_normal.distance < -1);

    std::vector<double> ratios, measured, formula;
    for (double zeta = 0; zeta < 0.95; zeta += 0.05) {
        ratios.push_back(zeta);
        measured.push_back(meet(1e4, zeta).e);
        formula.push_back(std::exp(-M_PI * zeta / std::sqrt(1 - zeta * zeta)));
    }
    std::cout << "zeta 0, 0.1, 0.5: e = " << measured[0] << ", " << measured[2] << ", " << measured[10] << '\n';
    claim("without damping they separate as fast as they met", std::abs(measured[0] - 1) < 0.01);
    claim("the more damping, the less they bounce", std::is_sorted(measured.rbegin(), measured.rend()));
    claim("a contact that never pulls gives back a little more than the formula",
          measured[10] > formula[10] && measured[2] - formula[2] < 0.03);

    const auto soft = meet(1e4, 0.1), hard = meet(1e6, 0.1);
    std::cout << "k = 1e4 N/m: " << soft.deepest << " m deep; k = 1e6 N/m: " << hard.deepest << " m deep\n";
    claim("k does not change the bounce", std::abs(soft.e - hard.e) < 0.01);
    claim("a hundred times k is a tenth of the depth", std::abs(soft.deepest / hard.deepest - 10) < 0.2);
    claim("F on one and -F on the other: momentum stays", std::abs(soft.momentum) < 1e-12);

    workbook::Plot plot("2.2.2", "More damping is less bounce");
    plot.x("damping ratio").y("restitution").line("exp(-pi zeta / sqrt(1 - zeta^2))", ratios, formula);
    plot.linked_points("measured", ratios, measured).write();
    return claim.result();
}
