// SPDX-License-Identifier: BSL-1.0
// What the solver costs: what is left after so many sweeps, and how heavy a body may be that lies on a light one

// Two views of one thing. First the passes alone, run as plain Gauss-Seidel: SoftContacts::relax goes through all
// contacts once and makes each of them right, which makes its neighbours a little wrong again. For a body of mass R m
// on one of mass m on the ground what is wrong falls by R / (R + 1) with each sweep, so that a digit takes 2.3 R of
// them: no number of sweeps that a game can pay solves a ratio of a thousand in one step. What does is memory, the
// impulses of the step before (warm start), as the second table shows. Then the response as it is used, SoftSubsteps:
// how far the light body is moved within ten seconds, and how deep the deepest contact is.

#include "what_it_costs.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include <array>
#include <iomanip>
#include <vector>

using namespace ansatz;
using namespace collision_costs;
using workbook::Axis;
using workbook::Outcome;

namespace {

constexpr double g = 9.81, h = 1.0 / 60; // m/s^2, s

// ---------------------------------------------------------------- the passes alone
/// Bodies on each other, the lowest on the ground, in the solver's own words: no world, no positions that change.
class Column {
public:
    explicit Column(const std::vector<double>& masses) {
        contacts_.bodies.push_back(body(0)); // the ground
        for (const double m : masses) contacts_.bodies.push_back(body(1 / m));
        for (std::uint32_t i = 1; i < contacts_.bodies.size(); ++i) {
            Contacts::Constraint c{};
            c.a = c.slot_a = i;
            c.b = c.slot_b = i - 1;
            c.normal = Eigen::Vector2d(0, 1);
            contacts_.all.push_back(c);
        }
        contacts_.weigh();
    }
    /// What gravity adds in a step, and what the impulses of the last one take away again.
    void begin_step(bool warm) {
        for (auto& b : contacts_.bodies) b.u = Eigen::Vector2d(0, b.weight > 0 ? -g * h : 0);
        if (warm) contacts_.warm_start();
        else
            for (auto& c : contacts_.all) c.impulse = 0;
    }
    void sweep() { contacts_.relax(h); }
    /// The largest velocity that is left, over g h: everything stands still, so that all of it is wrong.
    double residual() const {
        double worst = 0;
        for (const auto& b : contacts_.bodies) worst = std::max(worst, std::abs(b.u[1]) / (g * h));
        return worst;
    }

private:
    using S = Space<double, 2>;
    using Contacts = SoftContacts<S, false>;
    static Contacts::Body body(double weight) { return {Eigen::Vector2d(0, 0), Eigen::Vector2d(0, 0), weight}; }
    Contacts contacts_;
};

std::string with_ratio(double ratio) { return std::string("R = ").append(workbook::significant(ratio, 6)); }

void add_sweeps(Costs& costs) {
    const Axis axis{.name = "solver",
                    .error_norm = "max |v| / (g h) that is left",
                    .work_unit = "contacts solved",
                    .time_unit = "ns",
                    .has_order = false};
    for (const double ratio : {1.0, 10.0, 100.0, 1000.0})
        for (int sweeps = 1; sweeps <= 1024; sweeps *= 4) {
            const auto run = [=] {
                Column column({1, ratio});
                column.begin_step(false);
                for (int i = 0; i < sweeps; ++i) column.sweep();
                return column.residual();
            };
            costs.add(axis, {.choice = with_ratio(ratio),
                             .problem = "sweeps of one step, R m on m",
                             .parameter = {"sweeps", sweeps},
                             .n = 2,
                             .error_run = [=] { return Outcome{.error = run(), .work = 2 * sweeps}; },
                             .timed_run = run});
        }
    for (const double top : {100.0, 1000.0})
        for (const bool warm : {false, true})
            for (const int steps : {1, 10, 60, 300}) {
                const auto run = [=] {
                    std::vector<double> masses(10, 1.0);
                    masses.back() = top;
                    Column column(masses);
                    for (int s = 0; s < steps; ++s) {
                        column.begin_step(warm);
                        for (int i = 0; i < 10; ++i) column.sweep();
                    }
                    return column.residual();
                };
                costs.add(axis, {.choice = std::string(warm ? "warm start, " : "cold, ").append(with_ratio(top)),
                                 .problem = "ten bodies, the top R, 10 sweeps a step",
                                 .parameter = {"steps", steps},
                                 .n = 10,
                                 .error_run = [=] { return Outcome{.error = run(), .work = 10.0 * 10 * steps}; },
                                 .timed_run = run});
            }
}

// ---------------------------------------------------------------- the response as it is used
/// SoftSubsteps that forgets its impulses behind every step.
struct ColdStart : SoftSubsteps<> {
    template <class S> struct State : SoftContacts<S, false> {
        template <class Data, class Contacts> void take(const Data& data, const Contacts& contacts) {
            SoftContacts<S, false>::take(data, contacts);
            for (auto& c : this->all) c.impulse = 0;
        }
    };
    template <class S> struct In : SoftSubsteps<>::In<S> {
        explicit In(const ColdStart& cold) : SoftSubsteps<>::In<S>(cold) {}
    };
};
template <class Response> Response with(int parts, double hertz_) {
    Response response;
    response.parts = parts;
    response.frequency = hertz_ * hertz;
    return response;
}
constexpr double usual = 60; // 1/s, what SoftSubsteps has by itself
/// As stiff as its substeps can hold without a tremble: a contact that is to be right within eight of them.
double stiffest(int parts) { return parts / h / 4; }

struct Held {
    double moved = 0, deepest = 0,
           speed = 0; ///< m: the light one, and the deepest contact; m/s: the light one's, in the last second
    bool sound = true;
};
template <class Response> struct Pile {
    World<Space<>, SemiImplicitEuler, Gravity, BoundingBoxes, Narrowphase<Sphere, Plane>, Response> world;
    Handle light, heavy;
    Pile(double ratio, const Response& response)
        : world(Space<>{}, SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, response) {
        world.add(Plane::ground(), fixed);
        light = world.add(Sphere{0.5 * metre}, position(metres(0, 0.5, 0)), mass(1.0 * kilogram));
        heavy = world.add(Sphere{0.5 * metre}, position(metres(0, 1.5, 0)), mass(ratio * kilogram));
    }
};
template <class Response> Held hold(double ratio, const Response& response, int steps = 600) {
    Pile<Response> pile(ratio, response);
    Held held;
    for (int i = 0; i < steps; ++i) {
        pile.world.step(h * second);
        const double low = in(y(pile.world.position(pile.light)), metre),
                     high = in(y(pile.world.position(pile.heavy)), metre);
        held.sound = held.sound && std::isfinite(low) && std::isfinite(high) && high > low;
        held.moved = std::max(held.moved, std::abs(low - 0.5));
        held.deepest = std::max({held.deepest, 0.5 - low, 1 - (high - low)});
        if (i >= steps - 60)
            held.speed = std::max(held.speed, std::abs(in(y(pile.world.velocity(pile.light)), metre_per_second)));
    }
    return held;
}

template <class Response> void add_held(Costs& costs, const std::string& choice, const Response& response) {
    for (const bool depth : {false, true}) {
        const Axis axis{.name = "solver",
                        .error_norm = depth ? "the deepest contact (m)" : "how far the light body is moved (m)",
                        .work_unit = "passes over the contacts",
                        .time_unit = "ns per step",
                        .has_order = false};
        for (const double ratio : {1.0, 10.0, 60.0, 100.0, 300.0, 400.0, 1000.0})
            costs.add(axis,
                      {.choice = choice,
                       .problem = depth ? "SoftSubsteps, R kg on 1 kg: depth" : "SoftSubsteps, R kg on 1 kg: moved",
                       .parameter = {"R", ratio},
                       .n = 2,
                       .error_run =
                           [=] {
                               const auto held = hold(ratio, response);
                               return Outcome{.error = depth ? held.deepest : held.moved,
                                              .work = 600.0 * 2 * response.parts,
                                              .diverged = !held.sound};
                           },
                       .timed_run =
                           [=] {
                               Pile<Response> pile(ratio, response);
                               for (int i = 0; i < 600; ++i) pile.world.step(h * second);
                               return pile.world.position(pile.light);
                           },
                       .per = 600});
    }
}

// ---------------------------------------------------------------- what is made of it
void print_contraction(std::ostream& out) {
    out << "\nPlain Gauss-Seidel, R m on m: what is wrong falls with each sweep by\n";
    for (const double ratio : {10.0, 100.0, 1000.0, 10000.0}) {
        Column column({1, ratio});
        column.begin_step(false);
        for (int i = 0; i < 20; ++i) column.sweep();
        const double before = column.residual();
        column.sweep();
        const double factor = column.residual() / before;
        out << "  R = " << std::left << std::setw(6) << ratio << std::fixed << std::setprecision(6) << " " << factor
            << ", by the law R / (R + 1) " << ratio / (ratio + 1) << std::defaultfloat << std::setprecision(6)
            << (std::abs(factor - ratio / (ratio + 1)) < 1e-4 ? "" : "   NOT THE LAW") << '\n';
    }
}

/// What is left after each sweep: straight lines, the flatter the heavier.
void draw_sweeps(const std::filesystem::path& folder) {
    workbook::Plot plot("", "What is left of R m on m after so many sweeps, and the law (R / (R + 1))^n");
    plot.x("sweeps").y("max |v| / (g h)").log_y().y_range(1e-6, 1.5);
    for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) {
        Column column({1, ratio});
        column.begin_step(false);
        std::vector<double> n, left, law;
        for (int i = 1; i <= 100; ++i) {
            column.sweep();
            n.push_back(i);
            left.push_back(std::max(column.residual(), 1e-9));
            law.push_back(std::max(std::pow(ratio / (ratio + 1), i), 1e-9));
        }
        plot.line(with_ratio(ratio), n, left).reference(ratio == 1 ? "the law" : "", n, law);
    }
    collision_costs::write(plot, folder, "collision-solver-sweeps");
}

/// The largest ratio up to which a measure stays within a centimetre, by halving the logarithm; 0 where even 1:1 does
/// not.
template <class Measure> double supported(Measure&& measure) {
    constexpr double most = 1e4;
    if (!(measure(1) <= 0.01)) return 0;
    double low = 0, high = std::log(most);
    for (int i = 0; i < 12; ++i) (measure(std::exp(0.5 * (low + high))) <= 0.01 ? low : high) = 0.5 * (low + high);
    return std::exp(low);
}

void summarise(std::ostream& out, const std::filesystem::path& folder) {
    out << "\nThe largest R that is held within 1 cm for ten seconds, by the substeps of a step of 1/60 s\n"
        << "  " << std::left << std::setw(8) << "parts" << std::setw(44) << "frequency 60/s, what there is by itself"
        << "frequency parts/(4 dt)\n"
        << "  " << std::setw(8) << "" << std::setw(22) << "the light one moved" << std::setw(22) << "no contact deeper"
        << std::setw(22) << "the light one moved"
        << "no contact deeper\n";
    std::vector<double> parts;
    std::array<std::vector<double>, 4> ratios;
    for (const int n : {1, 2, 3, 4, 6, 8, 12, 16, 32}) {
        parts.push_back(n);
        out << "  " << std::left << std::setw(8) << n;
        for (std::size_t which = 0; which < 4; ++which) {
            const double frequency = which < 2 ? usual : stiffest(n);
            const double ratio = supported([&](double r) {
                const auto held = hold(r, with<SoftSubsteps<>>(n, frequency));
                return !held.sound ? 1 : which % 2 == 0 ? held.moved : held.deepest;
            });
            ratios[which].push_back(ratio);
            out << std::setw(which == 3 ? 0 : 22) << workbook::significant(ratio, 3);
        }
        out << '\n';
    }
    workbook::Plot plot("", "How heavy a body may lie on one of 1 kg, held within 1 cm");
    plot.x("substeps of a step").y("R").log_x().log_y();
    const std::array<const char*, 4> names{"60/s: light one moved", "60/s: deepest contact",
                                           "parts/(4 dt): light one moved", "parts/(4 dt): deepest contact"};
    for (std::size_t which = 0; which < 4; ++which) plot.linked_points(names[which], parts, ratios[which]);
    collision_costs::write(plot, folder, "collision-solver-supported-ratio");
}

} // namespace

void collision_costs::add_solver(Costs& costs) {
    add_sweeps(costs);
    for (const int parts : {1, 2, 4, 8, 16})
        add_held(costs, std::string("parts = ").append(std::to_string(parts)), with<SoftSubsteps<>>(parts, usual));
    add_held(costs, "parts = 8, 120/s", with<SoftSubsteps<>>(8, 120));
    add_held(costs, "parts = 4, cold", with<ColdStart>(4, usual));
    costs.add_summary([](std::ostream& out, const Rows& rows, const std::filesystem::path& folder) {
        if (rows_of(rows, "solver").empty()) return;
        print_contraction(out);
        draw_sweeps(folder);
        summarise(out, folder);
    });
}
