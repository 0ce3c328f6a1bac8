// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a rope that breaks (notes 3).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <optional>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using Force = Quantity<unit::Force>;
using Length = Quantity<unit::Length>;
using Velocity = Quantity<unit::Velocity>;

const auto k = 150.0 * newton_per_metre;
const auto c = 20.0 * newton_second_per_metre;
const auto rest_length = 4.0 * metre;
const auto none = 0.0 * newton;
const double rates[] = {-30, -2.5, -0.5, 0, 0.75, 3, 40}; // m/s
const double slack_lengths[] = {0.25, 2, 3.5, 3.95};      // m
const double taut_lengths[] = {4.03125, 4.25, 5, 7.5};    // m

Force yours(double length, double rate) {
    return exercise::pull(length * metre, rest_length, rate * metre_per_second, k, c);
}
std::string said(double length, double rate) {
    std::ostringstream text;
    text << "a rope of 4 m, 150 N/m and 20 N s/m, " << length << " m long, "
         << (rate < 0 ? "shortening by " : "lengthening by ") << std::abs(rate) << " m/s: its pull";
    return text.str();
}

struct Load {
    double mass, speed, stiffness; // kg, m/s, N/m
};
const std::vector<Load> loads{{80, 8.86, 1500}, {80, 8.86, 40000}, {3, 0.5, 700}, {120, 2, 90}, {0.25, 12, 60}};
const auto g = 9.81 * metre_per_second_squared;
Force peak(const Load& l) {
    return exercise::peak_pull(l.mass * kilogram, g, l.speed * metre_per_second, l.stiffness * newton_per_metre);
}
std::string said(const Load& l) {
    std::ostringstream text;
    text << "a load of " << l.mass << " kg, falling with " << l.speed << " m/s when its rope of " << l.stiffness
         << " N/m becomes taut";
    return text.str();
}
/// The hardest pull on the way down, found by following it in small steps (velocity Verlet).
double followed(double mass, double speed, double stiffness) {
    const double dt = 1e-3 * std::sqrt(mass / stiffness);
    double x = 0, v = speed, most = 0;
    auto a = [&] { return 9.81 - stiffness / mass * x; };
    do {
        v += a() * dt / 2, x += v * dt, v += a() * dt / 2;
        most = std::max(most, stiffness * x);
    } while (v > 0);
    return most;
}

struct Rigged {
    double mass, length, per_strain, strength; // kg, m, N, N
};
const std::vector<Rigged> ropes{
    {80, 4, 160000, 12000}, {80, 20, 30000, 9000}, {65, 2.5, 25000, 3000}, {10, 7, 900, 450}};
std::optional<Length> highest(const Rigged& r, double times = 1) {
    return exercise::highest_fall(r.mass * kilogram, g, times * r.length * metre, r.per_strain * newton,
                                  r.strength * newton);
}
std::string said(const Rigged& r) {
    std::ostringstream text;
    text << "a load of " << r.mass << " kg on " << r.length << " m of a rope that " << r.per_strain
         << " N would stretch to twice its length and that holds " << r.strength << " N";
    return text.str();
}
Length there(const Rigged& r, double times = 1) {
    const auto height = highest(r, times);
    expect(height.has_value(), said(r) + ": yours holds no fall at all.\nIt holds more than twice the weight.");
    return *height;
}

} // namespace

TEST_CASE("a slack rope does nothing", "[task-1][slack]") {
    for (const double length : slack_lengths)
        for (const double rate : rates)
            expect_near(
                said(length, rate), yours(length, rate), none, 1e-12 * newton,
                "It is shorter than its rest length, and hangs. There is nothing in it that could pull, push or "
                "damp, however fast its ends move.");
}

TEST_CASE("a taut rope pulls like a spring with a damper", "[task-1][taut]") {
    for (const double length : taut_lengths)
        for (const double rate : rates) {
            const Force right = Force(k * (length * metre - rest_length) + c * (rate * metre_per_second));
            if (right > none)
                expect_near(said(length, rate), yours(length, rate), right, 1e-9 * newton,
                            "k times the stretch, and c times how fast it lengthens: less while it shortens.");
        }
}

TEST_CASE("no rope ever pushes", "[task-1][never-pushes]") {
    for (const double length : taut_lengths)
        for (const double rate : rates) {
            std::ostringstream text;
            text << said(length, rate) << "\n    yours  " << yours(length, rate)
                 << "\nA pull of less than nothing is a push. Where the damper would like to push, the rope does "
                    "nothing.";
            expect(yours(length, rate) >= none, text.str());
        }
}

TEST_CASE("stretched and let back, a rope keeps some of the work", "[task-1][takes-energy]") {
    for (const double length : taut_lengths)
        for (const double rate : {0.125, 0.75, 3.0, 40.0}) {
            std::ostringstream text;
            text << "a rope of 4 m that is " << length << " m long pulls with " << yours(length, rate)
                 << " while it is stretched by " << rate << " m/s, and with " << yours(length, -rate)
                 << " while it goes back as fast.\nThe first is what is put in, the second what comes out again. A "
                    "damper "
                    "takes energy; it never gives any.";
            expect(yours(length, rate) > yours(length, -rate), text.str());
        }
}

TEST_CASE("at the lowest point the rope holds all of the energy", "[task-2][energy]") {
    for (const Load& l : loads) {
        const double x = peak(l).value() / l.stiffness, fall = 0.5 * l.mass * l.speed * l.speed;
        std::ostringstream what;
        what << said(l) << ": by your peak, " << peak(l) << ", it is stretched by " << x
             << " m at the lowest point. What the rope holds then";
        expect_near(what.str(), 0.5 * l.stiffness * x * x, fall + l.mass * 9.81 * x, 1e-9 * (fall + l.mass * 9.81 * x),
                    "In J. Right is what the load has lost: m v^2 / 2, and the weight times the way that the rope "
                    "stretched.");
        expect(x > 0, what.str() + ": negative.\nOf the two roots the rope has the one with which it pulls.");
    }
}

TEST_CASE("a load that is let go pulls twice its weight", "[task-2][let-go]") {
    for (const Load& l : loads)
        expect_near(said(Load{l.mass, 0, l.stiffness}) + ": the peak", peak(Load{l.mass, 0, l.stiffness}),
                    2 * l.mass * 9.81 * newton, 1e-9 * newton,
                    "It swings about the place where it would hang, from where the rope pulls with nothing to where it "
                    "pulls with 2 m g.");
}

TEST_CASE("the peak is what a load that is followed down feels", "[task-2][followed]") {
    for (const Load& l : loads)
        expect_near(said(l) + ": the peak", peak(l), followed(l.mass, l.speed, l.stiffness) * newton, 1e-5 * peak(l),
                    "Right is what small steps found.");
}

TEST_CASE("a fall from there pulls with just what the rope holds", "[task-3][just-held]") {
    for (const Rigged& r : ropes) {
        const double height = there(r).value();
        std::ostringstream what;
        what << said(r) << ": your highest fall is " << height << " m. The peak after it";
        expect_near(what.str(),
                    followed(r.mass, std::sqrt(2 * 9.81 * std::max(0.0, height)), r.per_strain / r.length) * newton,
                    r.strength * newton, 1e-5 * r.strength * newton,
                    "Yours is what small steps found for a fall from that height: v^2 = 2 g h, k = K / L. From higher "
                    "the rope would break.");
    }
}

TEST_CASE("twice the rope holds twice the fall", "[task-3][fall-factor]") {
    for (const Rigged& r : ropes)
        for (const double times : {0.5, 2.0, 10.0})
            expect_near(
                said(r) + "; of " + std::to_string(times) + " times as much rope: the highest fall", there(r, times),
                times * there(r), 1e-9 * there(r),
                "Its metres are springs behind each other, so that a longer rope gives more: the height through "
                "the length is what counts, the fall factor.");
}

TEST_CASE("what cannot hold twice the weight holds no fall", "[task-3][twice-the-weight]") {
    for (const double weights : {0.5, 1.5, 1.95}) {
        const Rigged r{80, 4, 160000, weights * 80 * 9.81};
        const auto height = highest(r);
        std::ostringstream text;
        text << said(r) << ", " << weights << " times the weight: yours is ";
        if (height) text << *height;
        text << ".\nEven a load that is let go where the rope becomes taut pulls with twice its weight.";
        expect(!height.has_value(), text.str());
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const double rate : rates) {
            for (const double length : slack_lengths) numbers.push_back(yours(length, rate).value());
            for (const double length : taut_lengths) numbers.push_back(yours(length, rate).value());
        }
    if (task == 2)
        for (const Load& l : loads) numbers.push_back(peak(l).value());
    if (task == 3) {
        auto add = [&](const Rigged& r, double times) {
            const auto height = highest(r, times);
            numbers.push_back(height ? height->value() : -1000);
        };
        for (const Rigged& r : ropes) add(r, 1), add(r, 3);
        for (const double weights : {0.5, 1.5, 1.95}) add({80, 4, 160000, weights * 80 * 9.81}, 1);
    }
    return numbers;
}
