// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a limit of strain (notes 4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <random>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::End;
using Way = VectorQuantity<unit::Length, 3>;
using Motion3 = VectorQuantity<unit::Velocity, 3>;

const auto held = 0.0 / kilogram;
const Motion3 still = metres_per_second(0, 0, 0);
const Motion3 out[] = {metres_per_second(-1.2, 0.4, 0.3), metres_per_second(2.3, -0.7, 1.1)};

std::string shown(double x) {
    std::ostringstream text;
    text << std::setprecision(16) << x;
    return text.str();
}
std::string said(Quantity<unit::InverseMass> w) {
    return w == held ? "one that is held" : "one of " + shown(1 / w.value()) + " kg";
}
std::string pair(const End& a, const End& b) { return said(a.inverse_mass) + " and " + said(b.inverse_mass); }
/// Two ends that are 2.6 m apart, along no axis.
std::vector<std::pair<End, End>> pairs(const Motion3& v = still, const Motion3& w = still) {
    const Way a = metres(0.4, -1.1, 0.3), b = a + metres(2.4, 0.6, -0.8);
    std::vector<std::pair<End, End>> all;
    for (const auto& [one, other] : {std::pair(1.0, 1.0), std::pair(0.25, 3.0), std::pair(2.0, 0.1)})
        all.push_back({{a, v, one / kilogram}, {b, w, other / kilogram}});
    return all;
}
std::vector<std::pair<End, End>> with_one_held(const Motion3& v = still, const Motion3& w = still) {
    auto all = pairs(v, w);
    all.pop_back();
    all[0].first.inverse_mass = held;
    all[1].second.inverse_mass = held;
    return all;
}
double weighed(const End& e) { return 1 / e.inverse_mass.value(); }
/// Along the line between both, how fast the second goes away from the first, m/s.
double apart(const End& a, const End& b) {
    const Eigen::Vector3d axis = (b.position - a.position).value().normalized();
    return (b.velocity - a.velocity).value().dot(axis);
}
double energy(const End& e) { return weighed(e) * e.velocity.value().squaredNorm() / 2; }

/// A sheet of a random shape with springs of a metre between neighbours of a row, and some across, of which most are
/// too long.
exercise::Sheet tangle(unsigned seed, bool with_held) {
    std::mt19937 random(seed);
    auto number = [&](double from, double to) { return from + (to - from) * double(random()) / 4294967296.0; };
    exercise::Sheet sheet;
    for (int i = 0; i < 7; ++i)
        sheet.ends.push_back({metres(number(-2, 2) + i, number(-1, 1), number(-1, 1)),
                              metres_per_second(number(-3, 3), number(-3, 3), number(-3, 3)),
                              with_held && i == 0 ? held : number(0.2, 4) / kilogram});
    if (with_held) sheet.ends[0].velocity = still;
    for (std::size_t i = 0; i + 1 < 7; ++i) sheet.threads.push_back({i, i + 1, 0.8 * metre});
    sheet.threads.push_back({0, 3, 2.0 * metre});
    sheet.threads.push_back({6, 2, 2.4 * metre});
    return sheet;
}
/// Three ends in a row, from one that is held, and two springs of a metre that may be twice as long.
exercise::Sheet chain(double middle, double last) {
    return {{{metres(0, 0, 0), still, held},
             {metres(middle, 0, 0), still, 1.0 / kilogram},
             {metres(last, 0, 0), still, 1.0 / kilogram}},
            {{0, 1, 1.0 * metre}, {1, 2, 1.0 * metre}}};
}
double longest_strain(const exercise::Sheet& sheet) {
    double most = -1;
    for (const auto& [a, b, rest] : sheet.threads)
        most = std::max(most, norm(sheet.ends[b].position - sheet.ends[a].position).value() / rest.value() - 1);
    return most;
}

} // namespace

TEST_CASE("as long as it may be", "[task-1][length]") {
    for (auto both : {pairs(), with_one_held()})
        for (auto [a, b] : both) {
            const Eigen::Vector3d axis = (b.position - a.position).value().normalized();
            const auto who = pair(a, b);
            const bool moved = exercise::shorten(a, b, 1.7 * metre);
            expect_near("the way from " + who + ", 2.6 m apart, that was shortened to 1.7 m", b.position - a.position,
                        Way::from_value(1.7 * axis), 1e-9 * metre,
                        "They meet the limit, on the line on which they were.");
            expect(moved, "shorten says that it moved nobody, and it did.");
        }
}

TEST_CASE("each goes its share", "[task-1][shares]") {
    for (auto [a, b] : pairs()) {
        const auto middle = weighed(a) * a.position + weighed(b) * b.position;
        const auto who = pair(a, b);
        exercise::shorten(a, b, 1.7 * metre);
        expect_near("the centre of mass of " + who + ", after they were brought together",
                    (weighed(a) * a.position + weighed(b) * b.position) / (weighed(a) + weighed(b)),
                    middle / (weighed(a) + weighed(b)), 1e-9 * metre,
                    "It stays: the heavier one goes the shorter way, by the ratio of the inverse masses.");
    }
}

TEST_CASE("who is held stays", "[task-1][held]") {
    for (auto [a, b] : with_one_held()) {
        const bool first = a.inverse_mass == held;
        const auto before = first ? a.position : b.position;
        exercise::shorten(a, b, 1.7 * metre);
        expect_near("the place of the end that is held", first ? a.position : b.position, before, 0.0 * metre,
                    "Its inverse mass is zero: the other goes all of the way.");
    }
    auto [a, b] = pairs()[0];
    a.inverse_mass = b.inverse_mass = held;
    const auto before = b.position - a.position;
    const bool moved = exercise::shorten(a, b, 1.7 * metre);
    expect_near("the way between two that are held", b.position - a.position, before, 0.0 * metre,
                "Nobody can be moved, and nothing may be divided by the sum of their inverse masses.");
    expect(!moved, "shorten says that it moved one of two that are held.");
}

TEST_CASE("what is not too long is left alone", "[task-1][slack]") {
    for (const double longest : {2.6, 2.6 * (1 - 1e-15), 2.7, 40.0})
        for (auto [a, b] : pairs()) {
            const auto before = b.position - a.position;
            const bool moved = exercise::shorten(a, b, longest * metre);
            expect_near("the way between two, 2.6 m apart, that may be " + shown(longest) + " m apart",
                        b.position - a.position, before, 1e-12 * metre, "A limit holds, it does not push.");
            expect(!moved, "shorten says that it moved one of two that are 2.6 m apart and may be " + shown(longest) +
                               " m apart. What is too much by rounding alone does not count.");
        }
}

TEST_CASE("they go away from each other no more", "[task-2][apart]") {
    for (auto both : {pairs(out[0], out[1]), with_one_held(out[0], out[1])})
        for (auto [a, b] : both) {
            const auto who = pair(a, b);
            exercise::stop(a, b);
            expect_near("how fast " + who + " go away from each other along the line between them, after the stop",
                        apart(a, b) * metre_per_second, 0.0 * metre_per_second, 1e-9 * metre_per_second,
                        "All of it is gone, and no more than that.");
        }
}

TEST_CASE("momentum is kept, and energy is taken", "[task-2][momentum]") {
    for (auto [a, b] : pairs(out[0], out[1])) {
        const auto sum = weighed(a) * a.velocity + weighed(b) * b.velocity;
        const double before = energy(a) + energy(b), gone = apart(a, b);
        const double reduced = 1 / (a.inverse_mass + b.inverse_mass).value();
        const auto who = pair(a, b);
        exercise::stop(a, b);
        expect_near("the momentum of " + who + " after the stop, by their mass",
                    (weighed(a) * a.velocity + weighed(b) * b.velocity) / (weighed(a) + weighed(b)),
                    sum / (weighed(a) + weighed(b)), 1e-9 * metre_per_second,
                    "What one gets the other loses: each by its inverse mass.");
        expect_near("the energy of motion that is left to " + who, (energy(a) + energy(b)) * joule,
                    (before - reduced * gone * gone / 2) * joule, 1e-9 * joule,
                    "Gone is that of the motion apart: half of the reduced mass, 1 / (w1 + w2), times its square.");
    }
}

TEST_CASE("across the line nothing changes", "[task-2][across]") {
    for (auto both : {pairs(out[0], out[1]), with_one_held(out[0], out[1])})
        for (auto [a, b] : both) {
            const Eigen::Vector3d axis = (b.position - a.position).value().normalized();
            auto across = [&](const End& e) {
                return Motion3::from_value(e.velocity.value() - axis * axis.dot(e.velocity.value()));
            };
            const Motion3 first = across(a), second = across(b);
            const auto who = pair(a, b);
            exercise::stop(a, b);
            expect_near("the first's velocity across the line between " + who, across(a), first,
                        1e-9 * metre_per_second, "A rope pulls along itself only.");
            expect_near("the second's velocity across the line between " + who, across(b), second,
                        1e-9 * metre_per_second, "A rope pulls along itself only.");
        }
}

TEST_CASE("who come together go on", "[task-2][together]") {
    for (auto both : {pairs(out[1], out[0]), with_one_held(out[1], out[0])})
        for (auto [a, b] : both) {
            const auto who = pair(a, b);
            exercise::stop(a, b);
            expect_near("the first's velocity, of " + who + " that come together", a.velocity, out[1],
                        0.0 * metre_per_second, "A rope does not push.");
            expect_near("the second's velocity, of " + who + " that come together", b.velocity, out[0],
                        0.0 * metre_per_second, "A rope does not push.");
        }
}

TEST_CASE("who is held keeps its velocity", "[task-2][dragged]") {
    for (auto [a, b] : with_one_held(out[0], out[1])) {
        const bool first = a.inverse_mass == held;
        exercise::stop(a, b);
        expect_near("the velocity of an end that is dragged", first ? a.velocity : b.velocity, out[first ? 0 : 1],
                    0.0 * metre_per_second, "Its inverse mass is zero: the other gets all of the change.");
    }
    auto [a, b] = pairs(out[0], out[1])[0];
    a.inverse_mass = b.inverse_mass = held;
    exercise::stop(a, b);
    expect_near("the velocity of one of two that are dragged", a.velocity, out[0], 0.0 * metre_per_second,
                "Nothing may be divided by the sum of their inverse masses.");
}

TEST_CASE("a spring that is too long is shortened and stopped", "[task-3][one]") {
    exercise::Sheet sheet{
        {{metres(0, 0, 0), still, held}, {metres(3, 0, 0), metres_per_second(2, 1, 0), 4.0 / kilogram}},
        {{0, 1, 2.0 * metre}}};
    const int made = exercise::limit(sheet, 0.25, 10);
    expect_near("a load on a rope of 2 m that may be longer by a quarter, and was 3 m long", sheet.ends[1].position,
                metres(2.5, 0, 0), 1e-9 * metre, "The longest that it may be is its rest length times 1.25.");
    expect_near("its velocity", sheet.ends[1].velocity, metres_per_second(0, 1, 0), 1e-9 * metre_per_second,
                "What it had along the rope is gone.");
    expect(made == 2, "limit made " + std::to_string(made) +
                          " passes for one spring that was too long. It makes two: the second finds nothing.");
}

TEST_CASE("what is within its limit is not touched", "[task-3][within]") {
    auto sheet = chain(1.9, 3.7);
    for (std::size_t i : {1, 2}) sheet.ends[i].velocity = metres_per_second(5.0 * double(i), 0, 1);
    const auto before = sheet;
    const int made = exercise::limit(sheet, 1, 10);
    for (std::size_t i : {1, 2}) {
        expect_near("the place of end " + std::to_string(i) + " of a chain whose springs may be longer than they are",
                    sheet.ends[i].position, before.ends[i].position, 1e-12 * metre, "None of its springs is too long.");
        expect_near("the velocity of end " + std::to_string(i) + " of it", sheet.ends[i].velocity,
                    before.ends[i].velocity, 0.0 * metre_per_second,
                    "It is stopped where it has reached its limit, and not before.");
    }
    expect(made == 1, "limit made " + std::to_string(made) + " passes, and the first one found nothing.");
}

TEST_CASE("to and fro", "[task-3][fro]") {
    // The first pass leaves the second spring at its limit and the first one too long by half of what was too much; the
    // second, from behind, mends the first one, and leaves half of that to the second.
    for (const auto& [passes, middle, last] :
         {std::tuple(1, 2.5, 4.5), std::tuple(2, 2.0, 4.5), std::tuple(3, 2.25, 4.25), std::tuple(4, 2.0, 4.25)}) {
        auto sheet = chain(2, 5);
        const int made = exercise::limit(sheet, 1, passes);
        const std::string after = " of a chain of two springs, held at 0 m, after " + std::to_string(passes) +
                                  (passes == 1 ? " pass" : " passes");
        const std::string why =
            "Its ends were at 2 m and 5 m, and each spring may be 2 m long. In odd passes the one at "
            "the first end comes first, in even ones the other.";
        expect_near("the middle end" + after, sheet.ends[1].position, metres(middle, 0, 0), 1e-9 * metre, why);
        expect_near("the last end" + after, sheet.ends[2].position, metres(last, 0, 0), 1e-9 * metre, why);
        expect(made == passes, "limit made " + std::to_string(made) + " passes where it may make " +
                                   std::to_string(passes) + " and needs more.");
    }
}

TEST_CASE("until none is too long", "[task-3][enough]") {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        auto sheet = tangle(seed, seed % 2 == 0);
        const int made = exercise::limit(sheet, 0.1, 100000);
        expect(longest_strain(sheet) <= 0.1 + 1e-9,
               "Of a sheet with time enough, 100000 passes, a spring is stretched by " + shown(longest_strain(sheet)) +
                   " of its length, where 0.1 is the most. A pass in which one "
                   "spring was shortened is not the last one: others may have become too long by that.");
        const auto before = sheet;
        const int again = exercise::limit(sheet, 0.1, 100000);
        expect(made < 100000 && again == 1,
               "limit made " + std::to_string(made) + " passes, and then " + std::to_string(again) +
                   " over a sheet that is within its limit. It ends behind the pass that found nothing.");
    }
}

TEST_CASE("momentum stays, and energy does not grow", "[task-3][sheet]") {
    for (unsigned seed = 1; seed <= 4; ++seed)
        for (const int passes : {1, 2, 7}) {
            auto sheet = tangle(seed, false);
            auto of_centre = [&] {
                Eigen::Vector3d sum = Eigen::Vector3d::Zero();
                double mass = 0;
                for (const End& e : sheet.ends) {
                    sum += weighed(e) * e.velocity.value();
                    mass += weighed(e);
                }
                return Motion3::from_value(sum / mass);
            };
            auto all = [&] {
                double sum = 0;
                for (const End& e : sheet.ends) sum += energy(e);
                return sum;
            };
            const auto before = of_centre();
            const double had = all();
            exercise::limit(sheet, 0.1, passes);
            const std::string after =
                " of a sheet that nobody holds, after " + std::to_string(passes) + (passes == 1 ? " pass" : " passes");
            expect_near("the velocity of the centre of mass" + after, of_centre(), before, 1e-9 * metre_per_second,
                        "Each spring keeps the momentum, so that all together do.");
            expect(all() < had, "The energy of motion" + after + " is " + shown(all()) + " J, and was " + shown(had) +
                                    " J. A limit takes energy, it gives none.");
        }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    auto add = [&](const End& e) {
        for (int k = 0; k < 3; ++k) numbers.push_back(task == 2 ? e.velocity.value()[k] : e.position.value()[k]);
        if (task == 3)
            for (int k = 0; k < 3; ++k) numbers.push_back(e.velocity.value()[k]);
    };
    if (task == 1) {
        auto nailed = pairs();
        for (auto& [a, b] : nailed) a.inverse_mass = b.inverse_mass = held;
        for (auto both : {pairs(), with_one_held(), nailed})
            for (auto [a, b] : both)
                for (const double longest : {1.7, 2.6 * (1 - 1e-15), 3.1}) {
                    auto first = a, second = b;
                    numbers.push_back(exercise::shorten(first, second, longest * metre));
                    add(first), add(second);
                }
    }
    if (task == 2) {
        auto dragged = pairs(out[0], out[1]);
        for (auto& [a, b] : dragged) a.inverse_mass = b.inverse_mass = held;
        for (auto both : {pairs(out[0], out[1]), with_one_held(out[0], out[1]), pairs(out[1], out[0]), dragged})
            for (auto [a, b] : both) {
                exercise::stop(a, b);
                add(a), add(b);
            }
    }
    if (task == 3) {
        auto slack = chain(1.9, 3.7);
        slack.ends[2].velocity = out[1];
        numbers.push_back(exercise::limit(slack, 1, 10));
        add(slack.ends[2]);
        for (unsigned seed = 1; seed <= 3; ++seed)
            for (const int passes : {1, 2, 3, 10000}) {
                auto sheet = tangle(seed, seed == 2);
                numbers.push_back(exercise::limit(sheet, 0.1, passes));
                for (const End& e : sheet.ends) add(e);
            }
    }
    return numbers;
}
