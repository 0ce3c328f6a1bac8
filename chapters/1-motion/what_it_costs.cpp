// SPDX-License-Identifier: BSL-1.0
// What accuracy costs in chapter 1: every integrator on four problems, and every scalar on one

// Read the rows like this: for each problem, find the error that you can live with, then the cheapest row that has it.
// The error falls with the time to the power of the order, so that a line of time over error is the flatter the higher
// the order is: such a method costs more for each step and less for each correct digit. Two things that a single table
// would hide: on the stiff spring the explicit methods have no row at all above omega dt = 2, they diverge; and after a
// hundred seconds of Henon and Heiles the *energy* of the symplectic ones is still as good as at the beginning,
// although their trajectories are long wrong.
//
// Errors come from an untimed run of one body; the time is that of a hundred bodies, for each body.

#include "costs.hpp"
#include "problems.hpp"

#include <ansatz/motion/integrators/odeint.hpp>
#include <ansatz/world.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <numbers>
#include <string>
#include <utility>

using namespace ansatz;
using workbook::Axis;
using workbook::Costs;
using workbook::Outcome;

using Fehlberg78 = Odeint<boost::numeric::odeint::runge_kutta_fehlberg78<std::array<double, 6>>>;
/// 50 digits: what float and double are measured against.
using Reference =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

constexpr int bodies = 100;

/// A force that does nothing but count how often the forces were asked.
struct Count {
    using role = roles::Force;
    using reads = Columns<>;
    std::uint64_t* counter = nullptr;
    template <class S> struct In {
        std::uint64_t* counter;
        explicit In(const Count& c) : counter(c.counter) {}
        typename S::Acceleration acceleration(const auto&) const {
            ++*counter;
            return typename S::Acceleration();
        }
    };
};

/// A problem: a law, a start, how long, and how far off a run is.
template <class Law> struct Problem {
    std::string name;
    std::string error_norm;
    Law law;
    problems::InAPlane start;
    Quantity<unit::Time> duration;
    /// the error of a world that has run, from its body; called at every step with `last` false and at the end with
    /// true
    double (*error)(const problems::InAPlane& now, const problems::InAPlane& start, double duration);
    bool at_every_step = false;
};

double norm_in_metres(const VectorQuantity<unit::Length, 2>& x) { return in(norm(x), metre); }

template <class World_> problems::InAPlane in_a_plane(const World_& world, Handle body) {
    const auto r = world.position(body);
    const auto v = world.velocity(body);
    return {metres(static_cast<double>(r.value()[0]), static_cast<double>(r.value()[1])),
            metres_per_second(static_cast<double>(v.value()[0]), static_cast<double>(v.value()[1]))};
}

template <class World_> Handle add_at(World_& world, const problems::InAPlane& start) {
    const auto& r = start.x.value();
    const auto& v = start.v.value();
    if constexpr (World_::S::dimension == 2)
        return world.add(position(metres(r[0], r[1])), velocity(metres_per_second(v[0], v[1])));
    else return world.add(position(metres(r[0], r[1], 0)), velocity(metres_per_second(v[0], v[1], 0)));
}

template <class Integrator, class Law> Outcome run_once(const Problem<Law>& problem, int steps) {
    std::uint64_t evaluations = 0;
    World world{Integrator{}, problem.law, Count{&evaluations}};
    const auto body = add_at(world, problem.start);
    double error = 0;
    std::uint64_t asked = 0;
    for (int i = 0; i < steps; ++i) {
        world.step(problem.duration / double(steps));
        asked += std::exchange(evaluations, 0); // what a query asks afterwards does not count
        const bool last = i + 1 == steps;
        if (!last && !problem.at_every_step) continue;
        const double now = problem.error(in_a_plane(world, body), problem.start, in(problem.duration, second));
        error = std::isfinite(now) ? std::max(error, now) : INFINITY;
        evaluations = 0;
    }
    // A step whose equation could not be solved is no result either, however near it came.
    return {.error = error, .work = double(asked), .diverged = !(error < 1e3) || !world.status().ok()};
}

template <class Integrator, class Law>
void add_rows(Costs& costs, const char* choice, double order, const Problem<Law>& problem, int coarsest, int halvings) {
    const Axis axis{.name = "integrator",
                    .error_norm = problem.error_norm,
                    .work_unit = "force evaluations",
                    .time_unit = "ns per simulated second per body"};
    for (int k = 0; k <= halvings; ++k) {
        const int steps = coarsest << k;
        costs.add(axis, {.choice = choice,
                         .problem = problem.name,
                         .parameter = {"dt", problem.duration / double(steps)},
                         .n = bodies,
                         .known_order = order,
                         .error_run = [=] { return run_once<Integrator>(problem, steps); },
                         .timed_run =
                             [=] {
                                 World world{Integrator{}, problem.law};
                                 for (int i = 0; i < bodies; ++i) add_at(world, problem.start);
                                 for (int i = 0; i < steps; ++i) world.step(problem.duration / double(steps));
                                 return in_a_plane(world, world.body_at(0)).x;
                             },
                         .per = in(problem.duration, second) * bodies});
    }
}

/// Every integrator on one problem.
/// \param order_of_rk4 4, except where the error is that of the energy: there the leading term of Runge-Kutta 4 is one
///                     of phase, and what it loses goes with dt^5
template <class Law>
void add_problem(Costs& costs, const Problem<Law>& problem, int coarsest, int halvings, double order_of_rk4 = 4) {
    add_rows<ExplicitEuler>(costs, "ExplicitEuler", 1, problem, coarsest, halvings);
    add_rows<SemiImplicitEuler>(costs, "SemiImplicitEuler", 1, problem, coarsest, halvings);
    add_rows<ImplicitEuler>(costs, "ImplicitEuler", 1, problem, coarsest, halvings);
    add_rows<Verlet>(costs, "Verlet", 2, problem, coarsest, halvings);
    add_rows<VelocityVerlet>(costs, "VelocityVerlet", 2, problem, coarsest, halvings);
    add_rows<RungeKutta4>(costs, "RungeKutta4", order_of_rk4, problem, coarsest, halvings);
    add_rows<Fehlberg78>(costs, "Odeint<runge_kutta_fehlberg78>", 8, problem, coarsest, halvings);
}

/// Kepler's problem with Runge-Kutta 4 in one scalar: where rounding takes over from the method.
template <class Scalar> void add_scalar(Costs& costs, const char* choice, int halvings) {
    const Axis axis{.name = "scalar",
                    .error_norm = "final |x - exact| (m)",
                    .work_unit = "force evaluations",
                    .time_unit = "ns per simulated second per body"};
    const double orbit = 2 * std::numbers::pi;
    for (int k = 0; k <= halvings; ++k) {
        const int steps = 250 << k;
        const auto run = [=] {
            World world{Space<Scalar, 2>{}, RungeKutta4{}, problems::CentralGravity{}};
            const auto body = add_at(world, problems::kepler(0.6));
            for (int i = 0; i < steps; ++i) world.step(orbit / steps * second);
            return in_a_plane(world, body);
        };
        costs.add(axis, {.choice = choice,
                         .problem = "Kepler e = 0.6, one orbit, RungeKutta4",
                         .parameter = {"dt", orbit / steps * second},
                         .n = 1,
                         .known_order = 4,
                         .error_run =
                             [=] {
                                 const double error = norm_in_metres(run().x - problems::kepler(0.6, orbit).x);
                                 return Outcome{.error = error, .work = 4.0 * steps};
                             },
                         .timed_run = run,
                         .per = orbit});
    }
}

/// Only the effects called for: what a body takes in the lanes of some worlds.
void print_bytes(std::ostream& out) {
    auto row = [&]<class... P>(const char* what, const World<P...>&) {
        out << std::setw(6) << World<P...>::bytes_per_body << "  " << what << '\n';
    };
    const Space<float, 2> plane;
    out << "\nBytes of a body, by what its world is composed of (its handle takes 16 more in every world):\n";
    row("SemiImplicitEuler", World{SemiImplicitEuler{}});
    row("SemiImplicitEuler, Space<float, 2>", World{plane, SemiImplicitEuler{}});
    row("SemiImplicitEuler, Gravity, Drag", World{SemiImplicitEuler{}, Gravity{}, Drag{}});
    row("SemiImplicitEuler, Gravity, QuadraticDrag      the mass",
        World{SemiImplicitEuler{}, Gravity{}, QuadraticDrag{}});
    row("SemiImplicitEuler, Gravity, Rest               how long it has been slow",
        World{SemiImplicitEuler{}, Gravity{}, Rest{}});
    row("SemiImplicitEuler, Gravity, Interpolation      where it was",
        World{SemiImplicitEuler{}, Gravity{}, Interpolation{}});
    row("SemiImplicitEuler, AppliedForces               the mass, the force",
        World{SemiImplicitEuler{}, AppliedForces{}});
    row("Verlet, Gravity", World{Verlet{}, Gravity{}});
    row("RungeKutta4, Gravity                           its stages live in registers", World{RungeKutta4{}, Gravity{}});
    row("RungeKutta4, Attraction                        bodies are coupled: stages become columns",
        World{RungeKutta4{}, Attraction{}});
}

int main(int argc, char** argv) {
    Costs costs("motion", argc, argv);
    costs.add_below(print_bytes);

    const problems::InAPlane swing{metres(1, 0), metres_per_second(0.5, 0)};
    const auto oscillator_error = [](const problems::InAPlane& now, const problems::InAPlane&, double t) {
        return std::abs(in(
            x(now.x) - problems::oscillator(1.0 / second, {1.0 * metre, 0.5 * metre_per_second}, t * second).x, metre));
    };
    add_problem(costs,
                Problem<problems::Oscillator>{"oscillator, omega = 1/s, 10 s",
                                              "final |x - exact| (m)",
                                              {1.0 / second},
                                              swing,
                                              10.0 * second,
                                              oscillator_error},
                50, 6);

    // From a point between the nearest and the farthest, for a time that is no whole orbit: over a symmetric path even
    // semi-implicit Euler looks as if it were of second order.
    const auto kepler_error = [](const problems::InAPlane& now, const problems::InAPlane&, double t) {
        return norm_in_metres(now.x - problems::kepler(0.6, 0.5 + t).x);
    };
    add_problem(
        costs,
        Problem<problems::CentralGravity>{
            "Kepler e = 0.6, 8 s", "final |x - exact| (m)", {}, problems::kepler(0.6, 0.5), 8.0 * second, kepler_error},
        500, 6);

    const auto energy_error = [](const problems::InAPlane& now, const problems::InAPlane& start, double) {
        auto energy = [](const problems::InAPlane& s) {
            const double a = s.x.value()[0], b = s.x.value()[1], u = s.v.value()[0], w = s.v.value()[1];
            return 0.5 * (u * u + w * w + a * a + b * b) + a * a * b - b * b * b / 3;
        };
        return std::abs(energy(now) - energy(start));
    };
    add_problem(costs,
                Problem<problems::HenonHeiles>{"Henon-Heiles, E = 0.13, 100 s",
                                               "max |E - E_0| (m^2/s^2)",
                                               {},
                                               {metres(0.1, 0), metres_per_second(0, 0.5)},
                                               100.0 * second,
                                               energy_error,
                                               true},
                500, 5, 5);

    const auto stiff_error = [](const problems::InAPlane& now, const problems::InAPlane&, double t) {
        return std::abs(
            in(x(now.x) - problems::oscillator(1000.0 / second, {1.0 * metre, 0.0 * metre_per_second}, t * second).x,
               metre));
    };
    add_problem(costs,
                Problem<problems::Oscillator>{"stiff spring, omega = 1000/s, 0.1 s",
                                              "final |x - exact| (m)",
                                              {1000.0 / second},
                                              {metres(1, 0), metres_per_second(0, 0)},
                                              0.1 * second,
                                              stiff_error},
                12, 11);

    add_scalar<float>(costs, "float", 6);
    add_scalar<double>(costs, "double", 6);
    add_scalar<Reference>(costs, "cpp_bin_float<50>", 3);
    return costs.run();
}
