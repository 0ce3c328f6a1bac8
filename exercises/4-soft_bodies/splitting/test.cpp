// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a vertex that splits (notes 4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Corners;
using exercise::Edge;
using exercise::Sheet;
using exercise::Vertex;
using Triangles = std::vector<Corners>;
using Fans = std::vector<std::vector<std::size_t>>;

template <class List> std::string said(const List& list) {
    std::string text;
    for (const auto& one : list) {
        if (!text.empty()) text += ", ";
        if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(one)>>) text += std::to_string(one);
        else text += "{" + said(one) + "}";
    }
    return text;
}
void expect_same(const std::string& what, const auto& yours, const auto& right, const std::string& why) {
    expect(yours == right, what + "\n    yours  {" + said(yours) + "}\n    right  {" + said(right) + "}\n" + why);
}
/// The triangles of a wheel around vertex 0, whose rim has six vertices from 1 on: spoke k leads to vertex k + 1.
Corners slice(std::uint32_t k) { return {0, k % 6 + 1, (k + 1) % 6 + 1}; }
Triangles slices(std::initializer_list<std::uint32_t> which) {
    Triangles all;
    for (const auto k : which) all.push_back(slice(k));
    return all;
}
/// A wheel in space that is not round, so that all areas differ, and each vertex moves.
Sheet wheel(const Triangles& triangles) {
    Sheet sheet;
    for (int i = 0; i < 8; ++i) {
        const double angle = i * std::acos(-1) / 3, r = i == 0 ? 0 : 1 + 0.2 * i;
        sheet.vertices.push_back({metres(r * std::cos(angle), r * std::sin(angle), 0.1 * i * i),
                                  metres_per_second(0.3 * i, 1 - 0.2 * i, 0.7), (1.5 + 0.25 * i) * kilogram});
    }
    sheet.triangles = triangles;
    return sheet;
}
double area(const Sheet& sheet, const Corners& t) {
    const Eigen::Vector3d from = sheet.vertices[t[0]].place.value(), u = sheet.vertices[t[1]].place.value() - from,
                          v = sheet.vertices[t[2]].place.value() - from;
    return std::sqrt(u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v)) / 2;
}
std::string around(const Triangles& triangles) {
    return "the fans around vertex 0 of triangles {" + said(triangles) + "}";
}
void expect_fans(const Triangles& triangles, const Fans& right, const std::string& why) {
    expect_same(around(triangles), exercise::fans(triangles, 0), right, why);
}
/// Three fans, listed in turns.
const Triangles three = slices({4, 0, 2});
/// Two fans of two and three triangles, listed in turns.
const Triangles two{slice(3), slice(0), {0, 5, 7}, slice(1), slice(4)};
bool equal(const Vertex& one, const Vertex& other) {
    return (one.place - other.place).value().norm() < 1e-12 && (one.velocity - other.velocity).value().norm() < 1e-12 &&
           std::abs((one.mass - other.mass).value()) < 1e-12;
}
std::vector<std::vector<std::uint32_t>> plain(const std::vector<Edge>& edges) {
    std::vector<std::vector<std::uint32_t>> all;
    for (const auto& [a, b] : edges) all.push_back({a, b});
    return all;
}
/// Two fans at vertex 0 and two at vertex 3, with one triangle between both, as they are before and behind both splits.
const Triangles before{{0, 1, 2}, {0, 3, 4}, {3, 5, 6}, {0, 4, 7}}, now{{0, 1, 2}, {9, 3, 4}, {10, 5, 6}, {9, 4, 7}};

} // namespace

TEST_CASE("a whole wheel is one fan", "[task-1][ring]") {
    expect_fans(slices({0, 1, 2, 3, 4, 5}), {{0, 1, 2, 3, 4, 5}}, "Each triangle shares an edge with the next.");
    expect_fans(slices({0, 1, 2, 3, 4}), {{0, 1, 2, 3, 4}}, "One that is missing opens the ring; it is still one fan.");
}

TEST_CASE("what hangs together by the vertex alone is in two", "[task-1][two]") {
    expect_fans(slices({0, 1, 3, 4}), {{0, 1}, {2, 3}},
                "Triangles 1 and 2 have vertex 0 in common and no edge: one torn triangle lies on each side.");
    expect_fans(three, {{0}, {1}, {2}}, "Of six triangles every second one is there: no two share an edge.");
}

TEST_CASE("in any order of the triangles", "[task-1][turns]") {
    expect_fans(two, {{0, 2, 4}, {1, 3}},
                "A triangle may lie beside one that is listed much later. The fans stand by their first triangles.");
    expect_fans({slice(4), slice(1), slice(0), slice(3)}, {{0, 3}, {1, 2}}, "The fans stand by their first triangles.");
}

TEST_CASE("a late triangle may join two", "[task-1][late]") {
    expect_fans(slices({0, 2, 1}), {{0, 1, 2}}, "Triangle 2 shares an edge with both of the others.");
    expect_fans(slices({1, 2, 0}), {{0, 1, 2}}, "Triangle 2 lies beside 0.");
    expect_fans(slices({5, 3, 1, 4}), {{0, 1, 3}, {2}}, "Triangle 3 lies between 0 and 1. Triangle 2 is alone.");
    expect_fans(slices({1, 3, 5, 2, 0}), {{0, 1, 2, 3, 4}}, "All of them lie side by side.");
}

TEST_CASE("whichever way round they run", "[task-1][turned]") {
    expect_fans({{0, 2, 1}, {3, 0, 2}, {5, 4, 0}}, {{0, 1}, {2}}, "An edge is shared whichever way it runs in both.");
}

TEST_CASE("triangles elsewhere do not count", "[task-1][elsewhere]") {
    expect_fans({{1, 2, 7}, slice(0), {2, 3, 7}, slice(2)}, {{1}, {3}},
                "Only those around the vertex do. Triangle 2 lies beside both, and does not touch the vertex.");
    expect_fans({{1, 2, 3}, {2, 3, 4}}, {}, "No triangle has vertex 0: there is no fan.");
}

TEST_CASE("each fan but the first gets a vertex", "[task-2][corners]") {
    auto sheet = wheel(two);
    expect_same("the new vertices where {" + said(two) + "} splits at vertex 0", exercise::split(sheet, 0),
                std::vector<std::uint32_t>{8}, "There are eight vertices, from 0, and two fans.");
    expect_same("the triangles afterwards", sheet.triangles,
                Triangles{slice(3), {8, 1, 2}, {0, 5, 7}, {8, 2, 3}, slice(4)},
                "Those of the second fan have vertex 8 where they had vertex 0, and nothing else has changed.");
    auto third = wheel(three);
    expect_same("the new vertices where {" + said(three) + "} splits at vertex 0", exercise::split(third, 0),
                std::vector<std::uint32_t>{8, 9}, "There are eight vertices, from 0, and three fans.");
    expect_same("the triangles afterwards", third.triangles, Triangles{slice(4), {8, 1, 2}, {9, 3, 4}},
                "The first fan keeps vertex 0, the second gets 8, the third 9.");
    expect(sheet.vertices.size() == 9 && third.vertices.size() == 10,
           "The sheets have " + std::to_string(sheet.vertices.size()) + " and " +
               std::to_string(third.vertices.size()) +
               " vertices afterwards, and should have 9 and 10: the new ones stand behind the others.");
}

TEST_CASE("in one place, and as fast", "[task-2][place]") {
    const auto was = wheel(three);
    auto sheet = was;
    for (const auto i : exercise::split(sheet, 0)) {
        expect_near("the place of new vertex " + std::to_string(i), sheet.vertices[i].place, was.vertices[0].place,
                    1e-12 * metre, "That of the vertex that split.");
        expect_near("its velocity", sheet.vertices[i].velocity, was.vertices[0].velocity, 1e-12 * metre_per_second,
                    "That of the vertex that split: so no momentum and no energy comes or goes.");
    }
}

TEST_CASE("the mass goes with the area", "[task-2][mass]") {
    for (const auto& [triangles, parts] :
         {std::pair(two, Fans{{0, 2, 4}, {1, 3}}), std::pair(three, Fans{{0}, {1}, {2}})}) {
        const auto was = wheel(triangles);
        double total = 0;
        for (const Corners& t : triangles) total += area(was, t);
        auto sheet = was;
        std::vector<std::uint32_t> now{0};
        for (const auto i : exercise::split(sheet, 0)) now.push_back(i);
        auto sum = 0.0 * kilogram;
        for (const auto i : now) sum += sheet.vertices[i].mass;
        expect_near("the mass of all vertices that are where vertex 0 was, in {" + said(triangles) + "}", sum,
                    was.vertices[0].mass, 1e-12 * kilogram,
                    "None comes and none is lost: what the new ones get the old one gives.");
        for (std::size_t f = 0; f < now.size(); ++f) {
            double own = 0;
            for (const auto t : parts[f]) own += area(was, triangles[t]);
            expect_near("the mass of vertex " + std::to_string(now[f]), sheet.vertices[now[f]].mass,
                        own / total * was.vertices[0].mass, 1e-9 * kilogram,
                        "Of all triangles around the vertex its fan has " + std::to_string(own / total) +
                            " of the area.");
        }
    }
}

TEST_CASE("the others keep what they have", "[task-2][others]") {
    const auto was = wheel(two);
    auto sheet = was;
    exercise::split(sheet, 0);
    for (std::size_t i = 1; i < was.vertices.size(); ++i)
        expect(equal(sheet.vertices[i], was.vertices[i]),
               "Vertex " + std::to_string(i) + " has changed, and it was vertex 0 that split.");
}

TEST_CASE("where there is one fan nothing splits", "[task-2][one]") {
    for (const Triangles& triangles : {slices({0, 1, 2}), Triangles{{1, 2, 3}}}) {
        const auto was = wheel(triangles);
        auto sheet = was;
        expect_same("the new vertices of {" + said(triangles) + "} at vertex 0", exercise::split(sheet, 0),
                    std::vector<std::uint32_t>{}, "It has one fan, or none.");
        expect(sheet.triangles == triangles && sheet.vertices.size() == 8 && equal(sheet.vertices[0], was.vertices[0]),
               "The sheet has changed, and nothing of it splits at vertex 0.");
    }
}

TEST_CASE("a spring goes with its triangle", "[task-3][edges]") {
    std::vector<Edge> springs{{0, 1}, {0, 3}, {4, 3}, {5, 3}, {2, 1}, {7, 0}, {4, 0}};
    exercise::hand_on(springs, before, now);
    expect_same(
        "springs {0, 1}, {0, 3}, {4, 3}, {5, 3}, {2, 1}, {7, 0} and {4, 0}, behind a split at 0 and at 3, where "
        "triangles {" +
            said(before) + "} became {" + said(now) + "}",
        plain(springs),
        std::vector<std::vector<std::uint32_t>>{{0, 1}, {9, 3}, {4, 3}, {5, 10}, {2, 1}, {7, 9}, {4, 9}},
        "Its ends are the corners that they were, by the numbers that these have now.");
}

TEST_CASE("the last thread stays", "[task-3][thread]") {
    std::vector<Edge> springs{{0, 8}, {3, 8}, {0, 3}, {1, 4}};
    exercise::hand_on(springs, before, now);
    expect_same("springs {0, 8}, {3, 8}, {0, 3} and {1, 4}, where triangles {" + said(before) + "} became {" +
                    said(now) + "}",
                plain(springs), std::vector<std::vector<std::uint32_t>>{{0, 8}, {3, 8}, {9, 3}, {1, 4}},
                "No triangle has the two ends of the others: they stay where they were, and are still there.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const Triangles& triangles :
             {slices({0, 1, 2, 3, 4, 5}), slices({0, 1, 3, 4}), three, two, slices({0, 2, 1}), slices({1, 2, 0}),
              slices({5, 3, 1, 4}), Triangles{{0, 2, 1}, {3, 0, 2}, {5, 4, 0}},
              Triangles{{1, 2, 7}, slice(0), {2, 3, 7}, slice(2)}})
            for (const auto& fan : exercise::fans(triangles, 0)) {
                for (const auto t : fan) numbers.push_back(double(t) + 1);
                numbers.push_back(-1);
            }
    if (task == 2)
        for (const Triangles& triangles : {two, three, slices({0, 1, 2})}) {
            auto sheet = wheel(triangles);
            for (const auto i : exercise::split(sheet, 0)) numbers.push_back(i);
            for (const Corners& t : sheet.triangles) numbers.insert(numbers.end(), t.begin(), t.end());
            for (const auto& [place, velocity, mass] : sheet.vertices) {
                numbers.push_back(mass.value());
                for (int k = 0; k < 3; ++k) numbers.insert(numbers.end(), {place.value()[k], velocity.value()[k]});
            }
        }
    if (task == 3) {
        std::vector<Edge> springs{{0, 1}, {0, 3}, {4, 3}, {5, 3}, {2, 1}, {7, 0}, {4, 0}, {0, 8}, {3, 8}, {1, 4}};
        exercise::hand_on(springs, before, now);
        for (const auto& [a, b] : springs) numbers.insert(numbers.end(), {double(a), double(b)});
    }
    return numbers;
}
