// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a hanging chain (notes 3).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <numbers>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Chain;
using Length = Quantity<unit::Length>;
using Force = Quantity<unit::Force>;

constexpr double pi = std::numbers::pi;

Chain chain(int links, double mass, double stiffness, double rest_length) {
    return {links, mass * kilogram, stiffness * newton_per_metre, rest_length * metre};
}
const std::vector<Chain> chains{chain(20, 0.05, 500, 0.1), chain(3, 2, 40, 0.5), chain(7, 0.25, 900, 0.02)};
struct Ground {
    const char* name;
    double g; // m/s^2
};
const std::vector<Ground> grounds{{"on the earth", 9.81}, {"on the moon", 1.62}};
Length yours(int body, const Chain& c, double g) { return exercise::hangs_at(body, c, g * metre_per_second_squared); }
std::string said(const Chain& c) {
    std::ostringstream text;
    text << "a chain of " << c.links << (c.links == 1 ? " body" : " bodies") << " of " << c.mass << " on links of "
         << c.stiffness << ", each " << c.rest_length << " long at rest";
    return text.str();
}
std::string said(int body, const Chain& c, const Ground& p) {
    std::ostringstream text;
    text << said(c) << ", " << p.name << ": how far below the hook body " << body << " hangs";
    return text.str();
}
double stretch_of_one(const Chain& c, double g) { return c.mass.value() * g / c.stiffness.value(); }

using Numbers = std::vector<double>;
/// How far bodies are moved, in m.
const std::vector<Numbers> moves{{0.25}, {0.5, -0.125}, {0.1, 0.3, -0.2, 0.7}, {-1.5, 0.25, 2, 0.0625, -0.75, 3}};
const double k = 40; // N/m
Numbers felt(const Numbers& moved) {
    std::vector<Length> lengths;
    for (const double u : moved) lengths.push_back(u * metre);
    Numbers numbers;
    for (const Force& f : exercise::forces(lengths, k * newton_per_metre)) numbers.push_back(f.value());
    std::ostringstream text;
    text << moved.size() << " bodies are moved, and you say what " << numbers.size()
         << " of them feel.\nThere is one force for each.";
    expect(numbers.size() == moved.size(), text.str());
    return numbers;
}
std::string row(const Numbers& numbers) {
    std::ostringstream text;
    text << "(";
    for (const char* between = ""; const double number : numbers) text << between << number, between = ", ";
    text << ")";
    return text.str();
}
std::string said(const Numbers& moved) {
    std::ostringstream text;
    text << "links of " << k << " N/m, bodies moved down by " << row(moved) << " m: ";
    return text.str();
}
std::string on_body(std::size_t i) { return "the force on body " + std::to_string(i + 1) + " in N, downwards"; }

struct Wave {
    double angle;
    const char* name;
};
const std::vector<Wave> waves{{0.2, "long"}, {1, "shorter"}, {2.25, "short"}, {3, "the shortest"}};
double omega(double angle, const Chain& c) { return exercise::angular_frequency(angle, c).value(); }
double speed(double angle, const Chain& c) { return exercise::group_speed(angle, c).value(); }
double root(const Chain& c) { return std::sqrt(c.stiffness.value() / c.mass.value()); }
std::string said(const Chain& c, double angle) {
    std::ostringstream text;
    text << "bodies of " << c.mass << ", links of " << c.stiffness << ", kappa = " << angle;
    return text.str();
}
/// A step of an endless chain, here a ring of many bodies, by velocity Verlet.
struct Ring {
    Numbers u, v;
    double k_over_m;
    double pull(std::size_t i) const {
        const std::size_t n = u.size();
        return k_over_m * (u[(i + 1) % n] - 2 * u[i] + u[(i + n - 1) % n]);
    }
    void kick(double dt) {
        for (std::size_t i = 0; i < u.size(); ++i) v[i] += pull(i) * dt;
    }
    void step(double dt) {
        kick(dt / 2);
        for (std::size_t i = 0; i < u.size(); ++i) u[i] += v[i] * dt;
        kick(dt / 2);
    }
    /// Where its energy is in the mean, as a body's number.
    double middle() const {
        double sum = 0, at = 0;
        for (std::size_t i = 0; i + 1 < u.size(); ++i) {
            const double stretch = u[i + 1] - u[i];
            const double moving = v[i] * v[i] / 2, held = k_over_m * stretch * stretch / 2;
            sum += moving + held, at += moving * double(i) + held * (double(i) + 0.5);
        }
        return at / sum;
    }
};

} // namespace

TEST_CASE("one body on one link is a mass on a spring", "[task-1][one]") {
    for (const Chain& c : chains)
        for (const Ground& p : grounds) {
            Chain one = c;
            one.links = 1;
            const double right = c.rest_length.value() + stretch_of_one(c, p.g);
            expect_near(said(1, one, p), yours(1, one, p.g), right * metre, 1e-9 * right * metre,
                        "The rest length, and m g / k: so far the spring must be stretched to hold it up.");
        }
}

TEST_CASE("the last link carries one body, the first one all of them", "[task-1][carries]") {
    for (const Chain& c : chains)
        for (const Ground& p : grounds)
            for (const int link : {1, 2, c.links}) {
                const Length above = link == 1 ? 0.0 * metre : yours(link - 1, c, p.g);
                std::ostringstream what;
                what << said(c) << ", " << p.name << ": the length of link " << link
                     << ", by where the bodies at its two ends hang";
                const int carries = c.links - link + 1;
                std::ostringstream why;
                why << "It carries " << carries << (carries == 1 ? " body: " : " bodies: ")
                    << "its own lower end and what hangs below that.";
                const double right = c.rest_length.value() + carries * stretch_of_one(c, p.g);
                expect_near(what.str(), yours(link, c, p.g) - above, right * metre, 1e-9 * right * metre, why.str());
            }
}

TEST_CASE("the whole chain is stretched by m g N (N + 1) / 2k", "[task-1][whole]") {
    for (const Chain& c : chains)
        for (const Ground& p : grounds) {
            const double right =
                c.links * c.rest_length.value() + 0.5 * c.links * (c.links + 1) * stretch_of_one(c, p.g);
            expect_near(said(c.links, c, p), yours(c.links, c, p.g), right * metre, 1e-9 * right * metre,
                        "N rest lengths, and 1 + 2 + ... + N times m g / k.");
        }
}

TEST_CASE("every body hangs in balance", "[task-1][balance]") {
    for (const Chain& c : chains)
        for (const Ground& p : grounds)
            for (int body = 1; body < c.links; ++body) {
                const Length here = yours(body, c, p.g);
                const Length up = here - (body == 1 ? 0.0 * metre : yours(body - 1, c, p.g));
                const Length down = yours(body + 1, c, p.g) - here;
                std::ostringstream what;
                what << said(c) << ", " << p.name << ": what the link above body " << body
                     << " pulls with more than the one below it, by your lengths of them";
                const Force weight = c.mass * (p.g * metre_per_second_squared);
                expect_near(what.str(), Force(c.stiffness * (up - down)), weight, 1e-6 * weight,
                            "Right is its own weight, m g: nothing else is there to hold it up.");
            }
}

TEST_CASE("where all are moved alike, only the first link pulls", "[task-2][together]") {
    for (const std::size_t bodies : {std::size_t(1), std::size_t(2), std::size_t(5)}) {
        const Numbers moved(bodies, 0.5), on = felt(moved);
        for (std::size_t i = 0; i < bodies; ++i)
            expect_near(
                said(moved) + on_body(i), on[i], i == 0 ? -k * 0.5 : 0.0, 1e-9,
                "No link but the first has become longer. That one is tied to the hook, which stands still, and "
                "pulls its body up with k u.");
    }
}

TEST_CASE("a body alone is pulled back by its links, its neighbours after it", "[task-2][alone]") {
    for (const std::size_t who : {std::size_t(0), std::size_t(2), std::size_t(4)}) {
        Numbers moved(5, 0.0);
        moved[who] = 0.25;
        const Numbers on = felt(moved);
        for (std::size_t i = 0; i < 5; ++i) {
            const bool last = i == 4, neighbour = i + 1 == who || i == who + 1;
            expect_near(
                said(moved) + on_body(i), on[i], i == who ? -(last ? 1 : 2) * k * 0.25 : (neighbour ? k * 0.25 : 0.0),
                1e-9,
                "Its link above is longer and pulls it up; its link below, if there is one, is shorter and pushes "
                "it up as hard. At their other ends they do the opposite; the others feel nothing yet.");
        }
    }
}

TEST_CASE("together they feel what the hook holds more", "[task-2][hook]") {
    for (const Numbers& moved : moves) {
        double sum = 0;
        for (const double f : felt(moved)) sum += f;
        expect_near(
            said(moved) + "all forces together, in N", sum, -k * moved[0], 1e-9,
            "Between two bodies a link does the same to both, in opposite directions, so that the sum knows nothing "
            "of it. The first link is what is left: the other end of it is the hook.");
    }
}

TEST_CASE("the forces are how fast the energy of the links falls", "[task-2][energy-falls]") {
    auto energy = [](const Numbers& moved) {
        double sum = 0;
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const double longer = moved[i] - (i == 0 ? 0 : moved[i - 1]);
            sum += k * longer * longer / 2;
        }
        return sum;
    };
    for (const Numbers& moved : moves) {
        const Numbers on = felt(moved);
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const double by = 1e-4;
            Numbers down = moved, up = moved;
            down[i] += by, up[i] -= by;
            expect_near(
                said(moved) + on_body(i), on[i], -(energy(down) - energy(up)) / (2 * by), 1e-6,
                "Right was found by moving this body a little down and up, and computing what k x^2 / 2 of all links "
                "loses.");
        }
    }
}

TEST_CASE("a wave satisfies the law of motion", "[task-3][law]") {
    for (const Chain& c : chains)
        for (const Wave& w : waves) {
            const double k_over_m = c.stiffness.value() / c.mass.value(), phase = 0.3;
            const double here = std::cos(phase);
            const double a =
                k_over_m * (std::cos(phase + w.angle) - here) - k_over_m * (here - std::cos(phase - w.angle));
            const double right = std::sqrt(-a / here);
            expect_near(
                said(c, w.angle) + ": omega in 1/s", omega(w.angle, c), right, 1e-9 * right,
                "Right was found by taking u_j = cos(kappa j - omega t) for three neighbours: the acceleration of the "
                "middle one, k/m times what its two links pull with, is -omega^2 u.");
        }
}

TEST_CASE("a long wave runs at sqrt(k/m) links a second", "[task-3][long]") {
    for (const Chain& c : chains)
        for (const double angle : {1e-3, 1e-6, 1e-9, 1e-12})
            expect_near(
                said(c, angle) + ": omega / kappa in links a second", omega(angle, c) / angle, root(c), 1e-6 * root(c),
                "Beside a long wave a link is short, and the chain is like a smooth one. For the smallest angles "
                "take care that no difference of two nearly equal numbers loses its digits.");
}

TEST_CASE("at pi it is the highest frequency of the chain", "[task-3][highest]") {
    for (const Chain& c : chains)
        expect_near(
            said(c, pi) + ": omega in 1/s", omega(pi, c), 2 * root(c), 1e-9 * root(c),
            "Every body moves against both of its neighbours. The middle of each link stands still, so that a body "
            "hangs at two half links, each of 2 k: omega^2 = 4 k / m.");
}

TEST_CASE("a group runs by the slope of omega", "[task-4][slope]") {
    for (const Chain& c : chains)
        for (const Wave& w : waves) {
            auto right_omega = [&](double angle) { return root(c) * std::sqrt(2 - 2 * std::cos(angle)); };
            const double by = 1e-4;
            const double right = (right_omega(w.angle + by) - right_omega(w.angle - by)) / (2 * by);
            expect_near(said(c, w.angle) + ": links a second", speed(w.angle, c), right, 1e-6 * root(c),
                        "Right is how fast the omega of task 3 changes with kappa, by two angles beside this one.");
        }
}

TEST_CASE("where neighbours swing against each other nothing moves on", "[task-4][stands]") {
    for (const Chain& c : chains)
        expect_near(
            said(c, pi) + ": links a second", speed(pi, c), 0.0, 1e-9 * root(c),
            "At the highest frequency there is no slope: every body swings, and no energy passes the middle of a "
            "link, which stands still.");
}

TEST_CASE("a group that is followed is there when you say", "[task-4][followed]") {
    const Chain& c = chains[0];
    for (const double angle : {0.6, 1.2, 2.0}) {
        // A wave within a wide bell; its velocities are those that make it run to larger numbers.
        Ring ring{Numbers(600), Numbers(600), root(c) * root(c)};
        const double w = 2 * root(c) * std::sin(angle / 2);
        for (std::size_t i = 0; i < ring.u.size(); ++i) {
            const double from = double(i) - 200, bell = std::exp(-from * from / (2 * 40 * 40));
            ring.u[i] = bell * std::cos(angle * from);
            ring.v[i] = bell * w * std::sin(angle * from) +
                        from / (40 * 40) * bell * root(c) * std::cos(angle / 2) * std::cos(angle * from);
        }
        const double dt = 0.1 / root(c), before = ring.middle();
        const int steps = 1500;
        for (int i = 0; i < steps; ++i) ring.step(dt);
        const double right = (ring.middle() - before) / (steps * dt);
        std::ostringstream what;
        what << said(c, angle) << ", in a group of some 80 links that is followed for " << steps * dt
             << " s: links a second";
        expect_near(
            what.str(), speed(angle, c), right, 0.01 * root(c),
            "Right is how far its energy has come. Within the group single crests run faster; they begin at its tail "
            "and end at its head.");
    }
}

std::vector<double> probe(int task) {
    Numbers numbers;
    if (task == 1)
        for (const Chain& c : chains)
            for (const int body : {1, 2, 3}) numbers.push_back(yours(body, c, 9.81).value());
    if (task == 2)
        for (const Numbers& moved : moves)
            for (const double f : felt(moved)) numbers.push_back(f);
    for (const Chain& c : chains)
        for (const Wave& w : waves) {
            if (task == 3) numbers.push_back(omega(w.angle, c) / w.angle), numbers.push_back(omega(1e-9, c) / 1e-9);
            if (task == 4) numbers.push_back(speed(w.angle, c));
        }
    return numbers;
}
