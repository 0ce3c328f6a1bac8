// SPDX-License-Identifier: BSL-1.0
// What a response costs: every integrator with every response, on a ball that should come back to its height for ever

// A ball of radius 0.5 m and 1 kg is dropped from 10 m onto the ground with e = 1 and bounces twenty times. Two errors:
// how far any apex is from the first height, which is the energy that was won or lost, and how deep the ball is in the
// ground at the end of a step. Integrator and response are right or wrong as a pair: the formula of notes 2.2.1 alone
// is exact with one integrator and loses half of the energy with another.
//
// An apex is that of the parabola through the three highest places of a flight, so that the step's length adds nothing
// to it.

#include "what_it_costs.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/world.hpp>

#include <cstdint>
#include <iomanip>
#include <sstream>

using namespace ansatz;
using namespace collision_costs;
using workbook::Axis;
using workbook::Outcome;

namespace {

/// The formula of notes 2.2.1 and nothing else: the velocity that the integrator keeps is turned round.
struct PlainFormula {
    using role = roles::Response;
    static constexpr Level level = Level::velocities;
    using reads = Columns<Restitution>;
    using writes = Columns<Velocity>;
    static constexpr std::string_view name = "PlainFormula";
    static void parameters(auto&, auto&&) {}
    template <class S> struct In {
        explicit In(const PlainFormula&) {}
        void respond(const auto& touch, auto& a, auto& b, const auto&) const {
            auto& va = a.template get<Velocity>();
            auto& vb = b.template get<Velocity>();
            const auto wa = a.template get<InverseMass>(), wb = b.template get<InverseMass>();
            const auto e = max(a.template get<Restitution>(), b.template get<Restitution>()).value();
            const auto j = collision_impulse(va, vb, wa, wb, touch.normal, e);
            va += (wa * j) * touch.normal;
            vb -= (wb * j) * touch.normal;
        }
    };
};

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

constexpr double height = 10, radius = 0.5, first_apex = height - radius, longest = 100; // m, m, m above the ground, s
constexpr int bounces_wanted = 20;

/// The ball and its world: the same kind for the count and for the clock, because each of these worlds takes a compiler
/// seconds.
template <class Integrator, class... Response> struct Drop {
    std::uint64_t asked = 0;
    World<Space<>, Integrator, Gravity, Count, BoundingBoxes, Narrowphase<Sphere, Plane>, Response...> world;
    Handle ball;
    explicit Drop(const Response&... response)
        : world(Space<>{}, Integrator{}, Gravity{}, Count{&asked}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{},
                response...) {
        world.add(Plane::ground(), fixed);
        if constexpr (decltype(world)::composition::template stores<Restitution>)
            ball =
                world.add(Sphere{radius * metre}, position(metres(0, height, 0)), mass(1.0 * kilogram), restitution(1));
        else ball = world.add(Sphere{radius * metre}, position(metres(0, height, 0)), mass(1.0 * kilogram));
    }
    Drop(const Drop&) = delete; // its counter is where it is
    Drop& operator=(const Drop&) = delete;
};

struct Bounces {
    double worst = 0; ///< max |apex / first - 1|
    double last = 0;  ///< the last apex over the first height
    double depth = 0; ///< m
    int count = 0;
    double asked = 0;  ///< evaluations of the forces
    double time = 0;   ///< simulated, s
    bool sound = true; ///< every number is one
};

template <class Integrator, class... Response> Bounces bounce(double dt, const Response&... response) {
    Drop<Integrator, Response...> drop(response...);
    auto& world = drop.world;
    Bounces result;
    double before = height, now = height;
    bool fell = true; // the first apex is where it starts
    while (result.count < bounces_wanted && result.time < longest) {
        drop.asked = 0;
        world.step(dt * second);
        result.asked += double(drop.asked);
        result.time += dt;
        const double next = in(y(world.position(drop.ball)), metre);
        if (!std::isfinite(next)) {
            result.sound = false;
            return result;
        }
        result.depth = std::max(result.depth, radius - next);
        if (next < now) fell = true;
        // Behind a fall, the first place from which it does not rise any more is the next apex. Within the ground there
        // is none.
        const double bend = 2 * now - before - next;
        if (result.time > 0.5 && now > before && next <= now && now > radius + 0.1 && fell) {
            const double apex = now + (next - before) * (next - before) / (8 * bend) - radius;
            result.last = apex / first_apex;
            result.worst = std::max(result.worst, std::abs(result.last - 1));
            ++result.count;
            fell = false;
        }
        before = now;
        now = next;
    }
    if (result.count < bounces_wanted) result.worst = std::max(result.worst, 1.0); // it has not come back: an apex of 0
    result.sound = world.status().ok();
    return result;
}

const Axis apex_axis{.name = "response",
                     .error_norm = "max |apex / first height - 1| of 20 bounces",
                     .work_unit = "force evaluations",
                     .time_unit = "ns per simulated second",
                     .has_order = false};
const Axis depth_axis{.name = "response",
                      .error_norm = "max depth at the end of a step (m)",
                      .work_unit = "force evaluations",
                      .time_unit = "ns per simulated second",
                      .has_order = false};

template <class Integrator, class... Response>
void add_rows(Costs& costs, const char* choice, const std::string& problem, const Response&... response) {
    for (const bool depth : {false, true})
        for (const double rate : {30.0, 60.0, 120.0, 240.0, 960.0}) {
            costs.add(depth ? depth_axis : apex_axis, {.choice = choice,
                                                       .problem = problem + (depth ? ": depth" : ": apex"),
                                                       .parameter = {"dt", 1 / rate * second},
                                                       .n = 1,
                                                       .error_run =
                                                           [=] {
                                                               const auto b = bounce<Integrator>(1 / rate, response...);
                                                               // Ten times the first height is no bounce any more.
                                                               return Outcome{.error = depth ? b.depth : b.worst,
                                                                              .work = b.asked,
                                                                              .diverged = !b.sound || b.worst > 10};
                                                           },
                                                       .timed_run =
                                                           [=] {
                                                               Drop<Integrator, Response...> drop(response...);
                                                               for (int i = 0; i < 10 * rate; ++i)
                                                                   drop.world.step(1 / rate * second);
                                                               return drop.world.position(drop.ball);
                                                           },
                                                       .per = 10.0});
        }
}

template <class... Response>
void add_response_rows(Costs& costs, const std::string& problem, const Response&... response) {
    add_rows<ExplicitEuler>(costs, "ExplicitEuler", problem, response...);
    add_rows<SemiImplicitEuler>(costs, "SemiImplicitEuler", problem, response...);
    add_rows<ImplicitEuler>(costs, "ImplicitEuler", problem, response...);
    add_rows<Verlet>(costs, "Verlet", problem, response...);
    add_rows<VelocityVerlet>(costs, "VelocityVerlet", problem, response...);
    add_rows<RungeKutta4>(costs, "RungeKutta4", problem, response...);
}

/// "0.9998, 12 cm", of the rows with 60 steps a second.
std::string cell(const workbook::Row& apex, const workbook::Row& depth) {
    if (apex.diverged || !apex.error || !depth.error) return "diverged";
    char text[64];
    std::snprintf(text, sizeof text, "%.1e %5.1f cm", *apex.error, 100 * *depth.error);
    return text;
}

void summarise(std::ostream& out, const Rows& all, const std::filesystem::path&) {
    const Rows rows = rows_of(all, apex_axis.name);
    if (rows.empty()) return;
    out << "\nThe grid of integrators and responses, 60 steps a second: max |apex / first height - 1| of 20 bounces, "
           "and the depth\n";
    std::vector<std::string> responses;
    for (const auto& problem : workbook::different(rows, &workbook::Row::problem))
        if (const auto at = problem.rfind(": apex"); at != std::string::npos)
            responses.push_back(problem.substr(0, at));
    const auto at_60 = [&](const std::string& problem, const std::string& choice) {
        for (const workbook::Row& row : rows_of(rows, apex_axis.name, problem, choice))
            if (row.parameter.value && std::abs(*row.parameter.value - 1.0 / 60) < 1e-9) return row;
        return workbook::Row{};
    };
    out << "  " << std::left << std::setw(20) << "";
    for (std::size_t n = 0; n < responses.size(); ++n)
        out << std::setw(n + 1 < responses.size() ? 24 : 0) << responses[n];
    out << '\n';
    for (const auto& integrator : workbook::different(rows, &workbook::Row::choice)) {
        std::ostringstream line;
        line << "  " << std::left << std::setw(20) << integrator;
        for (const auto& response : responses)
            line << std::setw(24)
                 << cell(at_60(response + ": apex", integrator), at_60(response + ": depth", integrator));
        std::string text = line.str();
        text.erase(text.find_last_not_of(' ') + 1);
        out << text << '\n';
    }
}

} // namespace

void collision_costs::add_response(Costs& costs) {
    add_response_rows(costs, "formula alone", PlainFormula{});
    add_response_rows(costs, "formula, Projection", PlainFormula{}, Projection{});
    add_response_rows(costs, "Projection", Projection{});
    add_response_rows(costs, "Impulse", Impulse<>{});
    add_response_rows(costs, "Impulse, Projection", Impulse<>{}, Projection{});
    add_response_rows(costs, "Penalty", Penalty{});
    add_response_rows(costs, "SoftSubsteps", SoftSubsteps<>{});
    costs.add_summary(summarise);
}
