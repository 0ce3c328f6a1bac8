// SPDX-License-Identifier: BSL-1.0
// What accuracy costs in chapter 3: every integrator on a soft, a stiff and a mixed chain, and what becomes of the
// energy

// Read the rows like this: on the soft chain every method has its rows, and the higher the order the cheaper the digit.
// On the stiff one (1e6 N/m) the explicit methods have none at all above 1 ms: they diverge, and the rows say so.
// ImplicitEuler never does; what it pays is in the second table, the energy: a chain that should swing for ever has
// stopped. The mixed chain is the usual case, a soft spring between stiff ones: only the slow motion is of interest,
// and every explicit method must follow the fast one to get there.
//
// The chains swing along themselves, where the springs are linear, so that the exact motion is a sum of modes.

#include "costs.hpp"

#include <ansatz/motion/integrators/cholesky.hpp>
#include <ansatz/motion/integrators/odeint.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using namespace ansatz;
using workbook::Axis;
using workbook::Costs;
using workbook::Outcome;

using Fehlberg78 = Odeint<boost::numeric::odeint::runge_kutta_fehlberg78<std::array<double, 6>>>;

/// A force between bodies that does nothing but count how often it was asked.
struct Count {
    using role = roles::Force;
    using reads = Columns<>;
    static constexpr bool couples_bodies = true;
    std::uint64_t* counter = nullptr;
    template <class S> struct In {
        std::uint64_t* counter;
        explicit In(const Count& c) : counter(c.counter) {}
        void couple(auto&, const auto&) const { ++*counter; }
        static void jacobian(const auto&, const auto&, auto&&) {}
        static void stiffnesses(const auto&, auto&&) {}
    };
};

/// A chain along the first axis, hung at the origin: link i joins body i - 1 and body i, 1 kg each, 1 m apart.
struct Chain {
    std::string name;
    std::vector<double> stiffness; ///< N/m, of each link
    std::vector<double> start;     ///< m, where each body is beside its rest

    std::size_t size() const { return stiffness.size(); }

    template <class World_> std::vector<Handle> add_to(World_& world) const {
        std::vector<Handle> bodies;
        SpringEnd before = metres(0, 0);
        for (std::size_t i = 0; i < size(); ++i) {
            bodies.push_back(world.add(position(metres(double(i) + 1 + start[i], 0)), mass(1.0 * kilogram)));
            world.add(Spring{before, bodies.back(), stiffness[i] * newton_per_metre, {}, 1.0 * metre});
            before = bodies.back();
        }
        return bodies;
    }
    /// The displacements after `t` seconds: each mode swings by itself.
    Eigen::VectorXd exact(double t) const {
        const auto n = Eigen::Index(size());
        Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const double k = stiffness[std::size_t(i)];
            K(i, i) += k;
            if (i == 0) continue;
            K(i - 1, i - 1) += k;
            K(i, i - 1) -= k;
            K(i - 1, i) -= k;
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(K);
        Eigen::VectorXd amplitude =
            modes.eigenvectors().transpose() * Eigen::Map<const Eigen::VectorXd>(start.data(), n);
        for (Eigen::Index i = 0; i < n; ++i)
            amplitude[i] *= std::cos(std::sqrt(std::max(modes.eigenvalues()[i], 0.0)) * t);
        return modes.eigenvectors() * amplitude;
    }
};

template <class Integrator> Outcome run_once(const Chain& chain, double duration, int steps, bool energy) {
    std::uint64_t asked = 0;
    World world{Space<double, 2>{}, Integrator{}, Springs<Undamped>{}, Count{&asked}};
    const auto bodies = chain.add_to(world);
    const double before = total_energy(world).value();
    asked = 0;
    double error = 0;
    for (int i = 0; i < steps; ++i) {
        world.step(duration / steps * second);
        if (!energy) continue;
        const auto work = asked;
        const double now = std::abs(total_energy(world).value() / before - 1);
        asked = work; // what a query asks does not count
        error = std::isfinite(now) ? std::max(error, now) : INFINITY;
    }
    const auto work = asked;
    if (!energy) {
        const auto truth = chain.exact(duration);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const double off = std::abs(x(world.position(bodies[i])).value() - double(i) - 1 - truth[Eigen::Index(i)]);
            error = std::isfinite(off) ? std::max(error, off) : INFINITY;
        }
    }
    return {.error = error, .work = double(work), .diverged = !(error < 10) || !world.status().ok()};
}

/// \param order of the error that the axis shows
template <class Integrator>
void add_rows(Costs& costs, const Axis& axis, const char* choice, double order, const Chain& chain, double duration,
              int coarsest, int halvings) {
    const bool energy = axis.name == "energy";
    for (int k = 0; k <= halvings; ++k) {
        const int steps = coarsest << k;
        costs.add(axis, {.choice = choice,
                         .problem = chain.name,
                         .parameter = {"dt", duration / steps * second},
                         .n = int(chain.size()),
                         .known_order = order,
                         .error_run = [=] { return run_once<Integrator>(chain, duration, steps, energy); },
                         .timed_run =
                             [=] {
                                 World world{Space<double, 2>{}, Integrator{}, Springs<Undamped>{}};
                                 const auto bodies = chain.add_to(world);
                                 for (int i = 0; i < steps; ++i) world.step(duration / steps * second);
                                 return world.position(bodies.back());
                             },
                         .per = duration * double(chain.size())});
    }
}

/// Every integrator on one chain: where the bodies are, or what became of the energy.
void add_chain(Costs& costs, const Axis& axis, const Chain& chain, double duration, int coarsest, int halvings) {
    const bool energy = axis.name == "energy";
    add_rows<ExplicitEuler>(costs, axis, "ExplicitEuler", 1, chain, duration, coarsest, halvings);
    add_rows<SemiImplicitEuler>(costs, axis, "SemiImplicitEuler", 1, chain, duration, coarsest, halvings);
    add_rows<ImplicitEuler>(costs, axis, "ImplicitEuler", 1, chain, duration, coarsest, halvings);
    add_rows<ImplicitEulerBy<Cholesky>>(costs, axis, "ImplicitEulerBy<Cholesky>", 1, chain, duration, coarsest,
                                        halvings);
    add_rows<Verlet>(costs, axis, "Verlet", 2, chain, duration, coarsest, halvings);
    add_rows<VelocityVerlet>(costs, axis, "VelocityVerlet", 2, chain, duration, coarsest, halvings);
    add_rows<RungeKutta4>(costs, axis, "RungeKutta4", energy ? 5 : 4, chain, duration, coarsest, halvings);
    if (!energy)
        add_rows<Fehlberg78>(costs, axis, "Odeint<runge_kutta_fehlberg78>", 8, chain, duration, coarsest, halvings);
}

int main(int argc, char** argv) {
    Costs costs("springs", argc, argv);
    const std::vector<double> bent{0.01, 0.03, 0.02, -0.01, -0.03, 0.0, 0.02, 0.04, 0.01, -0.02};
    const Chain soft{"soft chain, 100 N/m", std::vector<double>(10, 100.0), bent};
    const Chain stiff{"stiff chain, 1e6 N/m", std::vector<double>(10, 1e6), bent};
    // Two blocks of stiff links, a soft one before each: at rest within themselves, so that only the slow motion is
    // there.
    const Chain mixed{"mixed chain, 100 and 1e6 N/m",
                      {100, 1e6, 1e6, 1e6, 1e6, 100, 1e6, 1e6, 1e6, 1e6},
                      {.02, .02, .02, .02, .02, .05, .05, .05, .05, .05}};

    const Axis where{.name = "integrator",
                     .error_norm = "final max |x - exact| (m)",
                     .work_unit = "force evaluations",
                     .time_unit = "ns per simulated second per body"};
    add_chain(costs, where, soft, 1.0, 16, 7);
    add_chain(costs, where, stiff, 0.01, 4, 8);
    add_chain(costs, where, mixed, 0.5, 16, 9);

    const Axis energy{.name = "energy",
                      .error_norm = "max |E / E_0 - 1|",
                      .work_unit = "force evaluations",
                      .time_unit = "ns per simulated second per body"};
    add_chain(costs, energy, soft, 4.0, 64, 6);
    add_chain(costs, energy, stiff, 0.04, 16, 7);
    return costs.run();
}
