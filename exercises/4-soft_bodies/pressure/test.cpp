// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on pressure (notes 4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <array>
#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using Length3 = VectorQuantity<unit::Length, 3>;

struct Mesh {
    std::string name;
    exercise::Points points;
    exercise::Triangles triangles;
    double volume; // m^3

    Mesh moved(const Length3& by) const {
        Mesh there = *this;
        for (auto& x : there.points) x += by;
        return there;
    }
    Mesh inside_out() const {
        Mesh turned = *this;
        for (auto& t : turned.triangles) std::swap(t[1], t[2]);
        return turned;
    }
};
Mesh box(double a, double b, double c) {
    Mesh mesh;
    std::ostringstream text;
    text << "a box of " << a << " m by " << b << " m by " << c << " m";
    mesh.name = text.str();
    mesh.volume = a * b * c;
    for (int i = 0; i < 8; ++i)
        mesh.points.push_back(metres(0.2 + (i & 1 ? a : 0), -0.3 + (i & 2 ? b : 0), 0.4 + (i & 4 ? c : 0)));
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}
/// Two pyramids on one base, which lie askew; so much out of the middle that no two vertices are alike.
Mesh diamond() {
    Mesh mesh{
        "a diamond", {}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}, 0};
    mesh.points = {metres(1.1, 0, 0),  metres(0, 0.8, 0),      metres(-0.7, 0, 0),
                   metres(0, -1.3, 0), metres(0.2, -0.1, 0.9), metres(-0.3, 0.2, -0.5)};
    mesh.volume = 0.5 * 1.8 * 2.1 * (0.9 + 0.5) / 3; // base times height, a third
    return mesh;
}
const std::vector<Mesh>& meshes() {
    static const std::vector<Mesh> all = {box(2, 0.5, 1.2), diamond(), diamond().moved(metres(3, -2, 5))};
    return all;
}
/// The volume from the areas over the plane z = 0, column by column; in the units of SI.
double volume_of(const Mesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vector<double, 3> p = mesh.points[a].value(), q = mesh.points[b].value(), r = mesh.points[c].value();
        const double shadow = ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
        sum += shadow * (p[2] + q[2] + r[2]) / 3;
    }
    return sum;
}

const exercise::Gas gases[] = {{105000.0 * pascal, 0.02 * cubic_metre, 101325.0 * pascal},
                               {300000.0 * pascal, 0.7 * cubic_metre, 90000.0 * pascal}};
std::string said(const exercise::Gas& g, double part) {
    std::ostringstream text;
    text << "a gas of " << g.inside << " in " << g.filled << ", outside of it " << g.outside << ", now in " << part
         << " of that volume";
    return text.str();
}

const double pressures[] = {5000, 170}; // Pa
auto forces(const Mesh& mesh, double p) {
    auto all = exercise::forces(mesh.points, mesh.triangles, p * pascal);
    expect(all.size() == mesh.points.size(),
           mesh.name + ": there is one force for each vertex, and you return " + std::to_string(all.size()) + ".");
    return all;
}
std::string said(const Mesh& mesh, double p) {
    std::ostringstream text;
    text << mesh.name << ", " << p << " Pa more inside than outside";
    return text.str();
}

} // namespace

TEST_CASE("a box encloses the product of its sides, a diamond a third of base and height", "[task-1][volume]") {
    for (const Mesh& mesh : meshes())
        expect_near(mesh.name + ": its volume", exercise::volume(mesh.points, mesh.triangles),
                    mesh.volume * cubic_metre, 1e-12 * cubic_metre,
                    "From one point, each triangle is the base of a pyramid: a sixth of the triple product, with its "
                    "sign.");
}

TEST_CASE("turned inside out, the volume is negative", "[task-1][inside-out]") {
    for (const Mesh& mesh : meshes()) {
        const Mesh turned = mesh.inside_out();
        expect_near(mesh.name + " whose triangles run the other way round: its volume",
                    exercise::volume(turned.points, turned.triangles), -mesh.volume * cubic_metre, 1e-12 * cubic_metre,
                    "A ball that is turned inside out must know it, or it never finds back.");
    }
}

TEST_CASE("far from the origin it is the same", "[task-1][far]") {
    for (const Mesh& mesh : meshes()) {
        const Mesh there = mesh.moved(metres(1e6, -2e6, 3e6));
        expect_near(mesh.name + " that was moved by (1e6, -2e6, 3e6) m: its volume",
                    exercise::volume(there.points, there.triangles), mesh.volume * cubic_metre, 1e-6 * cubic_metre,
                    "Take all places from one of the vertices. The pyramids down to the origin are longer by a "
                    "million, and in their difference hardly a digit is left.");
    }
}

TEST_CASE("as filled, it presses by the difference", "[task-2][filled]") {
    for (const auto& g : gases)
        expect_near(said(g, 1) + ": the excess", exercise::pressure(g, g.filled), g.inside - g.outside, 1e-9 * pascal,
                    "What is outside presses back.");
}

TEST_CASE("pressure times volume stays", "[task-2][boyle]") {
    for (const auto& g : gases)
        for (const double part : {0.25, 0.9, 1.7, 6.0}) {
            const auto v = part * g.filled;
            expect_agree(said(g, part), "yours, inside, times the volume", (exercise::pressure(g, v) + g.outside) * v,
                         "as it was filled", g.inside * g.filled, 1e-9 * joule,
                         "In half of the room a gas has twice the pressure: all of its pressure, not what it has more "
                         "than the outside.");
        }
}

TEST_CASE("the force is the pressure times the gradient of the volume", "[task-3][gradient]") {
    for (const Mesh& mesh : meshes())
        for (const double p : pressures) {
            const auto all = forces(mesh, p);
            for (std::size_t i = 0; i < all.size(); ++i) {
                Vector<double, 3> right;
                for (int k = 0; k < 3; ++k) { // the volume is linear in each coordinate of one vertex
                    auto [to, from] = std::pair(mesh, mesh);
                    const Vector<double, 3> by = 0.5 * Vector<double, 3>::Unit(k);
                    to.points[i] += Length3::from_value(by);
                    from.points[i] -= Length3::from_value(by);
                    right[k] = p * (volume_of(to) - volume_of(from));
                }
                std::ostringstream text;
                text << said(mesh, p) << ": the force on vertex " << i;
                expect_near(text.str(), all[i], VectorQuantity<unit::Force, 3>::from_value(right), 1e-9 * p * newton,
                            "Move the vertex outwards, and the volume grows by a third of the areas around it: so much "
                            "work does the pressure for each metre.");
            }
        }
}

TEST_CASE("nobody lifts himself by his own air", "[task-3][sum]") {
    for (const Mesh& mesh : meshes())
        for (const double p : pressures) {
            auto sum = newtons(0, 0, 0);
            for (const auto& f : forces(mesh, p)) sum += f;
            expect_near(said(mesh, p) + ": the sum of your forces", sum, newtons(0, 0, 0), 1e-10 * p * newton,
                        "Whatever the surface: what is pressed to one side is pressed to the other.");
        }
}

TEST_CASE("and nobody turns himself", "[task-3][turn]") {
    for (const Mesh& mesh : meshes())
        for (const double p : pressures) {
            const auto all = forces(mesh, p);
            auto turn = newton_metres(0, 0, 0);
            for (std::size_t i = 0; i < all.size(); ++i) turn += cross(mesh.points[i], all[i]);
            expect_near(said(mesh, p) + ": the sum of your torques", turn, newton_metres(0, 0, 0),
                        1e-10 * p * newton_metre,
                        "Each corner of a triangle gets a third of its force, along its normal.");
        }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const Mesh& mesh : meshes())
            for (const Mesh& one : {mesh, mesh.inside_out(), mesh.moved(metres(1e6, -2e6, 3e6))})
                numbers.push_back(exercise::volume(one.points, one.triangles).value());
    if (task == 2)
        for (const auto& g : gases)
            for (const double part : {0.25, 1.0, 1.7})
                numbers.push_back(exercise::pressure(g, part * g.filled).value());
    if (task == 3)
        for (const Mesh& mesh : meshes())
            for (const double p : pressures)
                for (const auto& f : exercise::forces(mesh.points, mesh.triangles, p * pascal))
                    for (int k = 0; k < 3; ++k) numbers.push_back(f.value()[k]);
    return numbers;
}
