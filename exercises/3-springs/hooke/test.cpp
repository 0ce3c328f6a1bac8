// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on Hooke's law (notes 3).

#include "tools/exercises/expect.hpp"

#include <ansatz/springs/hooke.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using Length = Quantity<unit::Length>;
using Stiffness = Quantity<unit::Stiffness>;

const double stiffnesses[] = {20, 300};           // N/m
const double displacements[] = {0.05, 0.3, 2, 7}; // m

std::string said(Stiffness k, Length x) {
    std::ostringstream text;
    text << "a spring of " << k << ", displaced by " << x;
    return text.str();
}
/// Calls `check(k, x, sentence)` for each stiffness and each displacement, which are positive.
template <class Check> void for_each_spring(Check&& check) {
    for (const double k : stiffnesses)
        for (const double x : displacements)
            check(k * newton_per_metre, x * metre, said(k * newton_per_metre, x * metre));
}

/// A spring on a line: stretched, pressed, long, short, on either side of the origin.
struct OnLine {
    Length first, second, rest_length;
    Stiffness stiffness;

    auto force_on_first() const { return exercise::force_on_first(first, second, rest_length, stiffness); }
    Length length() const { return abs(second - first); }
    OnLine moved(Length by) const { return {first + by, second + by, rest_length, stiffness}; }
    OnLine mirrored() const { return {-first, -second, rest_length, stiffness}; }
    OnLine exchanged() const { return {second, first, rest_length, stiffness}; }
};
const std::vector<OnLine>& springs_on_a_line() {
    static const std::vector<OnLine> all = {
        {0.5 * metre, 2.0 * metre, 1.0 * metre, 100.0 * newton_per_metre},
        {0.5 * metre, 0.75 * metre, 1.0 * metre, 100.0 * newton_per_metre},
        {-4.0 * metre, 3.0 * metre, 2.5 * metre, 40.0 * newton_per_metre},
        {3.0 * metre, -1.0 * metre, 5.0 * metre, 40.0 * newton_per_metre},
        {-2.0 * metre, -6.0 * metre, 1.5 * metre, 7.0 * newton_per_metre},
    };
    return all;
}
std::string said(const OnLine& s) {
    std::ostringstream text;
    text << "the force on the end at " << s.first << " of a spring whose other end is at " << s.second
         << ", rest length " << s.rest_length << ", " << s.stiffness;
    return text.str();
}

} // namespace

TEST_CASE("the force is against the displacement", "[task-1][against]") {
    for_each_spring([](Stiffness k, Length x, const std::string&) {
        for (const Length& displaced : {x, -x}) {
            const auto force = exercise::force(k, displaced);
            std::ostringstream text;
            text << said(k, displaced) << "\n    yours  " << force << "\nThe spring pulls back: its force is "
                 << (displaced > 0.0 * metre ? "negative" : "positive")
                 << " here. Whoever displaces it needs the opposite.";
            expect(is_finite(force) && force * displaced < 0.0 * joule, text.str());
        }
    });
}

TEST_CASE("a weight hangs where the spring carries it", "[task-1][weight]") {
    for (const double k : stiffnesses)
        for (const double kilograms : {0.25, 3.0}) {
            const auto stiffness = k * newton_per_metre;
            const auto weight = kilograms * kilogram * (9.81 * metre_per_second_squared);
            const Length hangs_at = -weight / stiffness;
            expect_near(said(stiffness, hangs_at) + " by a weight: the force of the spring, upwards",
                        exercise::force(stiffness, hangs_at), weight, 1e-12 * weight,
                        "The weight rests m g / k below, so that the spring must carry m g there: k times the "
                        "displacement, and upwards.");
        }
}

TEST_CASE("displaced twice as far, it pulls twice as much", "[task-1][twice]") {
    for_each_spring([](Stiffness k, Length x, const std::string& what) {
        const auto once = exercise::force(k, x);
        expect_agree(what + ": its force, and that of twice the displacement", "yours, two times the one", 2.0 * once,
                     "yours, of two times x", exercise::force(k, 2.0 * x), 1e-12 * abs(once),
                     "Hooke's law is a proportion: the stiffness says how many newtons each metre is.");
    });
}

TEST_CASE("to the other side it pulls back as much", "[task-1][other-side]") {
    for_each_spring([](Stiffness k, Length x, const std::string& what) {
        expect_agree(what + " to one side and to the other", "yours, of x, with the opposite sign",
                     -exercise::force(k, x), "yours, of -x", exercise::force(k, -x), 1e-12 * (k * x),
                     "A spring pulls when it is stretched and pushes when it is pressed.");
    });
}

TEST_CASE("the spring holds the work that was done on it", "[task-2][work]") {
    for_each_spring([](Stiffness k, Length x, const std::string& what) {
        // The force is linear, so that its value in the middle of each part is its mean there, exactly.
        auto work = 0.0 * joule;
        const int parts = 10;
        for (int i = 0; i < parts; ++i) work -= springs::force(k, (i + 0.5) / parts * x) * (x / double(parts));
        expect_near(what + ": what it holds", exercise::energy(k, x), work, 1e-12 * work,
                    "The work is force times way, and the force grows from zero to k x on that way: its mean is half "
                    "of that.");
    });
}

TEST_CASE("pressed or stretched, it holds the same", "[task-2][pressed]") {
    for_each_spring([](Stiffness k, Length x, const std::string& what) {
        expect_agree(what + " to one side and to the other: what it holds", "yours, of x", exercise::energy(k, x),
                     "yours, of -x", exercise::energy(k, -x), 1e-12 * (k * x * x),
                     "Either way somebody has done work, and the spring gives it back.");
    });
}

TEST_CASE("energy goes to and fro between the spring and the body", "[task-2][to-and-fro]") {
    const auto m = 0.4 * kilogram;
    for_each_spring([&](Stiffness k, Length x, const std::string& what) {
        // x cos(omega t), the motion of a body that was let go at x.
        const auto omega = springs::angular_frequency(k, m);
        const auto let_go = exercise::energy(k, x);
        for (const double angle : {0.7, 2.0, 4.0}) {
            const auto v = -x * omega * std::sin(angle);
            std::ostringstream when;
            when << what << " and let go with 0.4 kg: the energy of both";
            expect_agree(when.str(), "yours, when it is let go", let_go, "yours and m v^2 / 2, a while later",
                         exercise::energy(k, x * std::cos(angle)) + 0.5 * m * v * v, 1e-12 * (k * x * x),
                         "What the spring no longer holds, the body has.");
        }
    });
}

TEST_CASE("at its rest length it neither pulls nor pushes", "[task-3][rest]") {
    for (const auto& s : springs_on_a_line()) {
        OnLine resting = s;
        resting.rest_length = s.length();
        expect_near(said(resting), resting.force_on_first(), 0.0 * newton, 1e-12 * newton,
                    "The displacement of a spring is its length minus its rest length.");
    }
}

TEST_CASE("stretched it pulls its ends together, pressed it pushes them apart", "[task-3][stretched-or-pressed]") {
    for (const auto& s : springs_on_a_line()) {
        const auto pull = s.stiffness * (s.length() - s.rest_length);
        expect_near(said(s), s.force_on_first(), s.second > s.first ? pull : -pull, 1e-12 * abs(pull),
                    "It is k times the length beyond the rest length; towards the other end where it is stretched, "
                    "away from it where it is pressed.");
    }
}

TEST_CASE("where on the line it lies makes no difference", "[task-3][moved]") {
    for (const auto& s : springs_on_a_line())
        expect_agree(said(s) + ", and with both ends moved by 10 m", "yours, as it is", s.force_on_first(),
                     "yours, moved", s.moved(10.0 * metre).force_on_first(), 1e-11 * newton,
                     "Where the origin of the line is, no spring can know: only the difference of the two places "
                     "counts.");
}

TEST_CASE("seen in a mirror, the force points the other way", "[task-3][mirror]") {
    for (const auto& s : springs_on_a_line())
        expect_agree(said(s) + ", and with the opposite sign of both places", "yours, with the opposite sign",
                     -s.force_on_first(), "yours, in the mirror", s.mirrored().force_on_first(), 1e-12 * newton,
                     "A length is never negative, whichever of the ends has the larger coordinate.");
}

TEST_CASE("the other end feels the opposite", "[task-3][opposite]") {
    for (const auto& s : springs_on_a_line())
        expect_agree(said(s) + ", and with the two ends swapped", "yours, with the opposite sign", -s.force_on_first(),
                     "yours, with the ends swapped", s.exchanged().force_on_first(), 1e-12 * newton,
                     "What a spring does to one of its ends it does to the other with the opposite sign (notes 1.3).");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 3)
        for (const auto& s : springs_on_a_line()) numbers.push_back(s.force_on_first().value());
    else
        for_each_spring([&](Stiffness k, Length x, const std::string&) {
            for (const Length& displaced : {x, -x})
                numbers.push_back(task == 1 ? exercise::force(k, displaced).value()
                                            : exercise::energy(k, displaced).value());
        });
    return numbers;
}
