// SPDX-License-Identifier: BSL-1.0
// Bending: the angle and its gradient, the energy of a rolled sheet and the sag of a clamped one against plates, and
// every solver.
// Runs long with the sanitizers.

#include <ansatz/soft_bodies/bending.hpp>

#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs/stable_step.hpp>
#include <ansatz/world/save.hpp>

#include "tests/soft_bodies/support.hpp"

#include <random>
#include <sstream>

using namespace soft_tests;
using Catch::Matchers::ContainsSubstring;

namespace {

using Vec = Vector<double, 3>;
using Places = std::array<Vec, 4>;

template <class Scalar = double, class... Solver> auto sheets(const Solver&... solver) {
    return World{Space<Scalar, 3>{}, SemiImplicitEuler{}, Gravity{}, Springs<>{}, Bending{}, solver...};
}
auto implicit() { return World{ImplicitEuler{}, Gravity{}, Springs<>{}, Bending{}}; }

/// Two triangles along the x axis, folded by an angle: a ridge where it is positive.
Places folded(double angle) {
    return {Vec(0, 0, 0), Vec(0.5, 0, 0), Vec(0.1, 0.4 * std::cos(angle / 2), -0.4 * std::sin(angle / 2)),
            Vec(0.3, -0.3 * std::cos(angle / 2), -0.3 * std::sin(angle / 2))};
}
template <class World_>
std::vector<Handle> add_four(World_& world, const Places& x, const std::array<bool, 4>& held = {}) {
    std::vector<Handle> all;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto at = position(VectorQuantity<unit::Length>::from_value(x[i]));
        if (held[i]) all.push_back(world.add(at, fixed));
        else all.push_back(world.add(at, mass((0.1 + 0.05 * double(i)) * kilogram)));
    }
    return all;
}
Hinge hinge_of(const std::vector<Handle>& all, double k, double c = 0) {
    return {.edge = {all[0], all[1]},
            .wings = {all[2], all[3]},
            .stiffness = k * joule,
            .damping = c * joule * second,
            .rest = {}};
}
/// A sheet of n x m vertices, `side` apart, without springs; each of its places is put through `put`.
template <class F> Cloth plate(std::size_t n, std::size_t m, double side, double rigidity, F&& put) {
    const auto flat = TriangleMesh::grid(n, m, metres(side * double(n - 1), 0, 0), metres(0, side * double(m - 1), 0));
    std::vector<TriangleMesh::Point> places;
    for (const auto& x : flat.vertices()) places.push_back(put(x));
    return {.mesh = TriangleMesh(places, {flat.triangles().begin(), flat.triangles().end()}),
            .mass_per_area = 0.5 * kg_per_m2,
            .rigidity = rigidity * joule};
}

} // namespace

TEST_CASE("An angle is counted from flat, by the side that the normals point to", "[soft_bodies][bending]") {
    const HingeConstraint<Space<>> hinge{{}, 0, 1, 0};
    Places gradient;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const double angle : {0.0, 0.3, -0.3, 1.5, -2.9, 3.1}) {
        const Eigen::Quaterniond turn(number(random), number(random), number(random), number(random));
        auto x = folded(angle);
        for (Vec& one : x) one = turn.normalized() * one + Vec(3, -2, 7);
        CAPTURE(angle);
        CHECK(hinge.linearise(x, gradient) == Approx(angle).epsilon(1e-12).margin(1e-12));
    }
    // The shorter way round from the angle at rest.
    const HingeConstraint<Space<>> beyond{{}, 3, 1, 0};
    CHECK(beyond.linearise(folded(-3), gradient) == Approx(2 * 3.14159265358979 - 6).epsilon(1e-9));
}

TEST_CASE("Gradients of a hinge are its differences, and neither push nor turn", "[soft_bodies][bending]") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    const HingeConstraint<Space<>> hinge{{0, 1, 2, 3}, 0.2, 1, 0};
    Places gradient, ignored;
    for (int n = 0; n < 100; ++n) {
        Places x;
        for (Vec& one : x) one = Vec(number(random), number(random), number(random));
        hinge.linearise(x, gradient);
        Vec push = Vec::Zero(), turn = Vec::Zero();
        double largest = 1;
        for (std::size_t i = 0; i < 4; ++i) {
            push += gradient[i];
            turn += x[i].cross(gradient[i]);
            largest = std::max(largest, gradient[i].norm());
        }
        CHECK(push.norm() < 1e-13 * largest);
        CHECK(turn.norm() < 1e-13 * largest);
        for (std::size_t i = 0; i < 4; ++i)
            for (int d = 0; d < 3; ++d) {
                constexpr double step = 1e-6;
                auto there = x, back = x;
                there[i][d] += step;
                back[i][d] -= step;
                const double slope = (hinge.linearise(there, ignored) - hinge.linearise(back, ignored)) / (2 * step);
                CHECK(gradient[i][d] == Approx(slope).epsilon(1e-6).margin(1e-6 * largest));
            }
    }
}

TEST_CASE("A triangle without an area has no angle, and nothing becomes infinite", "[soft_bodies][bending]") {
    using Flat = Space<float, 3>;
    const HingeConstraint<Flat> hinge{{0, 1, 2, 3}, 0.5f, 1, 0};
    using F = Vector<float, 3>;
    std::array<F, 4> gradient;
    for (const F& wing : {F(0, 0, 0), F(0.5f, 0, 0), F(2, 0, 0)}) {
        CHECK(hinge.linearise({F(0, 0, 0), F(1, 0, 0), wing, F(0, -1, 0)}, gradient) == 0);
        for (const F& g : gradient) CHECK(g.isZero(0));
    }
    CHECK(hinge.linearise({F(1, 1, 1), F(1, 1, 1), F(0, 1, 0), F(0, -1, 0)}, gradient) == 0);
}

TEST_CASE("A sheet that is rolled up has the energy of a plate", "[soft_bodies][bending]") {
    // Along the lines each fold is the polygon's angle exactly; beside a circle the polygon is of second order.
    const double curvature = 2, rigidity = 3;
    const auto way = GENERATE(0, 1);
    std::vector<double> off;
    for (const std::size_t n : {9, 17, 33}) {
        const double side = 0.8 / double(n - 1), fold = 2 * std::asin(curvature * side / 2);
        World world{SemiImplicitEuler{}, Springs<>{}, Bending{}};
        const auto parts = add_cloth(world, plate(n, n, side, rigidity, [](const auto& x) { return x; }));
        CHECK(potential_energy(world).value() == 0);
        for (std::size_t v = 0; v < n * n; ++v) {
            const auto at = double(way == 0 ? v % n : v / n), along = side * double(way == 0 ? v / n : v % n);
            const double angle = fold * at, r = 1 / curvature;
            const Vec rolled(r * std::sin(angle), along, r * std::cos(angle) - r);
            world.set_position(parts.bodies[v], way == 0 ? metres(rolled[0], rolled[1], rolled[2])
                                                         : metres(rolled[1], rolled[0], rolled[2]));
        }
        const double folds = double(n - 2), line = side * double(n - 1);
        CHECK(potential_energy(world).value() ==
              Approx(0.5 * rigidity * fold * fold * folds * double(n - 1)).epsilon(1e-10));
        // The area between the first and the last fold, and half a cell beside each.
        off.push_back(potential_energy(world).value() / (0.5 * rigidity * curvature * curvature * folds * side * line) -
                      1);
    }
    CHECK(off[0] > 0);
    CHECK(off[0] / off[1] == Approx(4).epsilon(0.02));
    CHECK(off[1] / off[2] == Approx(4).epsilon(0.02));
}

TEST_CASE("Rolled up along the diagonals of its triangles it is a plate, too, and across them it is stiffer",
          "[soft_bodies][bending]") {
    const double curvature = 0.2, side = 0.05;
    const auto energy = [&](double across) { // the axis of the roll is the diagonal, or across it
        World world{SemiImplicitEuler{}, Springs<>{}, Bending{}};
        const std::size_t n = 9;
        const auto parts = add_cloth(world, plate(n, n, side, 1, [](const auto& x) { return x; }));
        for (std::size_t v = 0; v < n * n; ++v) {
            const double x = side * double(v % n), y = side * double(v / n);
            const double s = (x - across * y) / std::sqrt(2.0), t = (x + across * y) / std::sqrt(2.0);
            const Vec along(1 / std::sqrt(2.0), across / std::sqrt(2.0), 0),
                to(1 / std::sqrt(2.0), -across / std::sqrt(2.0), 0);
            const Vec at = t * along + std::sin(curvature * s) / curvature * to +
                           Vec(0, 0, (std::cos(curvature * s) - 1) / curvature);
            world.set_position(parts.bodies[v], metres(at[0], at[1], at[2]));
        }
        // Each diagonal is an inner edge, and each has a cell around it.
        return potential_energy(world).value() /
               (0.5 * curvature * curvature * side * side * double((n - 1) * (n - 1)));
    };
    CHECK(energy(1) == Approx(1).epsilon(1e-3));
    CHECK(energy(-1) > 1.5);
}

TEST_CASE("A clamped strip sags as its hinges say, one after the other", "[soft_bodies][bending]") {
    // A strip of one cell is statically determinate: each hinge gives way to the moment of what hangs beyond it, and
    // the tip sinks by all of that (the theorem of Castigliano).
    const std::size_t n = 12;
    const double side = 0.05, rigidity = 0.5;
    auto cloth = plate(n, 2, side, rigidity, [](const auto& x) { return x; });
    cloth.structural = {4000.0 * N_per_m, 4.0 * N_s_per_m};
    cloth.pins = {0, 1, std::uint32_t(n), std::uint32_t(n) + 1};
    auto world = implicit();
    world.set(Gravity{metres_per_second_squared(0, 0, -0.05)});
    const auto parts = add_cloth(world, cloth);
    run(world, 400, 0.5);
    CHECK(world.status().ok());
    const auto place = [&](std::size_t v) { return cloth.mesh.vertices()[v].value(); };
    const std::size_t tip = n - 1;
    double sag = 0;
    for (const auto& edge : cloth.mesh.inner_edges()) {
        const Vec from = place(edge.ends[0]), along = (place(edge.ends[1]) - from).normalized();
        const auto lever = [&](std::size_t v) { return along.cross(place(v) - from)[2]; };
        const double side_of_tip = lever(tip) > 0 ? 1 : -1;
        double moment = 0;
        for (std::size_t v = 0; v < 2 * n; ++v)
            if (side_of_tip * lever(v) > 0 && v % n > 1)
                moment += 0.05 * world.mass(parts.bodies[v]).value() * lever(v);
        // The cell between the pins cannot fold.
        if (edge.ends[1] % n <= 1 && edge.opposite[0] % n <= 1 && edge.opposite[1] % n <= 1) continue;
        const double along_line = (place(edge.ends[1]) - from).squaredNorm() / (side * side);
        sag += moment * lever(tip) / (rigidity * along_line);
    }
    const double length = side * (double(n) - 1.5); // from the middle of the first cell that bends
    const double beam = 0.05 * 0.5 * std::pow(length, 4) / (8 * rigidity);
    CHECK(-world.position(parts.bodies[tip]).value()[2] == Approx(sag).epsilon(1e-3));
    // Its diagonals fold, too, under half of the moment with twice the stiffness: a quarter more than a beam.
    CHECK(sag == Approx(1.25 * beam).epsilon(0.03));
}

TEST_CASE("Every solver brings a hinge to its angle", "[soft_bodies][bending]") {
    const auto settle = [](auto world) {
        world.set(Gravity{metres_per_second_squared(0, 0, 0)});
        const auto all = add_four(world, folded(-0.4), {true, true, true, false});
        for (const std::size_t end : {0, 1}) world.add(Spring{all[end], all[3], 500.0 * N_per_m, 3.0 * N_s_per_m});
        auto hinge = hinge_of(all, 2, 0.4);
        hinge.rest = 1.0 * radian;
        const auto which = world.add(hinge);
        run(world, 300, 1.0 / 60);
        CHECK(world.status().ok());
        return double(hinge_angle(world, which).value());
    };
    CHECK(settle(sheets()) == Approx(1).epsilon(1e-6));
    CHECK(settle(sheets<float>()) == Approx(1).epsilon(1e-4));
    CHECK(settle(sheets<double>(Xpbd{4, 1})) == Approx(1).epsilon(1e-6));
    CHECK(settle(sheets<double>(VertexBlockDescent{1, 10})) == Approx(1).epsilon(1e-6));
    CHECK(settle(implicit()) == Approx(1).epsilon(1e-6));
}

TEST_CASE("Iterated to the end, descent of a bending sheet is implicit Euler", "[soft_bodies][bending]") {
    auto descent = sheets<double>(VertexBlockDescent{1, 600});
    auto solved = implicit();
    solved.set(ImplicitEuler{.tolerance = 1e-13});
    auto cloth = plate(4, 4, 0.1, 0.02, [](const auto& x) { return x; });
    cloth.structural = cloth.shear = {50.0 * N_per_m, 0.1 * N_s_per_m};
    cloth.rigidity_damping = 0.01 * second;
    cloth.pins = {0, 3};
    const auto parts = add_cloth(descent, cloth);
    add_cloth(solved, cloth);
    descent.set(Gravity{metres_per_second_squared(0, 1, -9.81)});
    solved.set(Gravity{metres_per_second_squared(0, 1, -9.81)});
    for (int i = 0; i < 15; ++i) {
        descent.step(1.0 / 60 * second);
        solved.step(1.0 / 60 * second);
    }
    CHECK(solved.status().ok());
    CHECK(norm(solved.position(parts.bodies[9]) - cloth.mesh.vertices()[9]).value() > 0.05);
    for (const auto& body : parts.bodies) CHECK(norm(descent.position(body) - solved.position(body)).value() < 1e-10);
}

TEST_CASE("A bending sheet that is free keeps its momentum and its angular momentum", "[soft_bodies][bending]") {
    auto world = sheets();
    world.set(Gravity{metres_per_second_squared(0, 0, 0)});
    auto cloth =
        plate(6, 5, 0.1, 0.05, [](const auto& x) { return x + metres(0, 0, 0.3 * x.value()[0] * x.value()[1]); });
    cloth.structural = cloth.shear = {100.0 * N_per_m, 0.2 * N_s_per_m};
    cloth.rigidity_damping = 0.02 * second;
    const auto parts = add_cloth(world, cloth);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const auto& body : parts.bodies)
        world.set_velocity(body, metres_per_second(2 + number(random), number(random), number(random)));
    const auto momentum = total_momentum(world).value(), turning = total_angular_momentum(world).value();
    const double energy = total_energy(world).value();
    run(world, 2000, 1e-3);
    CHECK((total_momentum(world).value() - momentum).norm() < 1e-12 * momentum.norm());
    CHECK((total_angular_momentum(world).value() - turning).norm() < 1e-11 * turning.norm());
    CHECK(total_energy(world).value() < energy);
}

TEST_CASE("Undamped hinges keep energy, to the second order of the step", "[soft_bodies][bending]") {
    const auto lost = [](double dt) {
        World world{VelocityVerlet{}, Bending{}};
        const auto all = add_four(world, folded(0.7));
        auto hinge = hinge_of(all, 2);
        hinge.rest = 0.2 * radian;
        world.add(hinge);
        const double before = total_energy(world).value();
        double most = 0;
        for (double t = 0; t < 0.3; t += dt) {
            world.step(dt * second);
            most = std::max(most, std::abs(total_energy(world).value() - before));
        }
        return most;
    };
    const double coarse = lost(2e-3), fine = lost(1e-3);
    CHECK(coarse < 0.02 * 0.5 * 2 * 0.25);
    CHECK(coarse / fine == Approx(4).epsilon(0.1));
}

TEST_CASE("The stable step counts hinges: for one of them exactly, of many on the safe side",
          "[soft_bodies][bending]") {
    auto one = sheets();
    const auto x = folded(0.5);
    one.add(hinge_of(add_four(one, x), 3));
    Places gradient;
    HingeConstraint<Space<>>{{}, 0, 1, 0}.linearise(x, gradient);
    double exact = 0;
    for (std::size_t i = 0; i < 4; ++i) exact += 3 * gradient[i].squaredNorm() / (0.1 + 0.05 * double(i));
    CHECK(measured_stiffness(one).value() == Approx(exact).epsilon(1e-6));
    CHECK(stiffness_of(one).largest.value() >= exact);
    CHECK(stiffness_of(one).largest.value() < 2.5 * exact);

    auto sheet_ = sheets();
    sheet_.set(Gravity{metres_per_second_squared(0, 0, 0)});
    auto cloth =
        plate(6, 6, 0.1, 0.5, [](const auto& at) { return at + metres(0, 0, 0.5 * at.value()[0] * at.value()[0]); });
    const auto parts = add_cloth(sheet_, cloth);
    const auto bound = stiffness_of(sheet_).largest, measured = measured_stiffness(sheet_);
    CHECK(bound >= measured);
    CHECK(bound < 4.0 * measured);
    sheet_.set_position(parts.bodies[8], sheet_.position(parts.bodies[8]) + metres(0, 0, 1e-4));
    auto too_long = sheet_;
    run(sheet_, 3000, stable_step(sheet_).value());
    run(too_long, 3000, 1.1 * 2 / std::sqrt(measured.value()));
    CHECK(norm(sheet_.position(parts.bodies[8]) - cloth.mesh.vertices()[8]).value() < 1e-2);
    CHECK(!(norm(too_long.position(parts.bodies[8]) - cloth.mesh.vertices()[8]).value() < 0.1));
}

TEST_CASE("Hinges are copied, hashed, saved and loaded, and gone with any of their bodies", "[soft_bodies][bending]") {
    auto world = sheets<double>(Xpbd{3, 2});
    auto cloth = plate(5, 4, 0.1, 0.05, [](const auto& x) { return x; });
    cloth.structural = {100.0 * N_per_m, 0.2 * N_s_per_m};
    cloth.pins = {0};
    const auto parts = add_cloth(world, cloth);
    CHECK(parts.hinges.size() == cloth.mesh.inner_edges().size());
    run(world, 10, 1.0 / 60);
    const auto before = world.elements<Hinge>().size();
    world.remove(parts.bodies[7]);
    std::size_t gone = 0;
    for (std::size_t i = 0; i < parts.hinges.size(); ++i) {
        const auto& edge = cloth.mesh.inner_edges()[i];
        const bool held = edge.ends[0] == 7 || edge.ends[1] == 7 || edge.opposite[0] == 7 || edge.opposite[1] == 7;
        CHECK(world.elements<Hinge>().contains(parts.hinges[i]) == !held);
        gone += held ? 1 : 0;
    }
    CHECK(world.elements<Hinge>().size() == before - gone);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto loaded = sheets<double>(Xpbd{});
    load(loaded, file);
    for (auto* each : {&world, &copy, &loaded}) run(*each, 30, 1.0 / 60);
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
    const auto last = world.elements<Hinge>().handles().back();
    auto is = world.get(last);
    const auto hash = world.hash();
    world.set(last, is);
    CHECK(world.hash() == hash);
    is.stiffness = 2.0 * is.stiffness;
    world.set(last, is);
    CHECK(world.hash() != hash);
}

TEST_CASE("A hinge that is none is refused", "[soft_bodies][bending]") {
    auto world = sheets();
    const auto all = add_four(world, folded(0.3));
    const auto hash = world.hash();
    const auto says = [&](auto&& change) {
        auto bad = hinge_of(all, 1);
        change(bad);
        return refusal([&] { world.add(bad); });
    };
    CHECK(says([](Hinge& h) { h.stiffness = -1.0 * joule; }) ==
          "World::add: stiffness is -1 J; it must be finite and not negative");
    CHECK_THAT(says([](Hinge& h) { h.damping = NAN * joule * second; }), ContainsSubstring("damping is nan"));
    CHECK_THAT(says([](Hinge& h) { h.wings[0] = h.edge[1]; }), ContainsSubstring("four different"));
    CHECK_THAT(says([](Hinge& h) { h.rest = NAN * radian; }), ContainsSubstring("rest is nan"));
    CHECK_THAT(says([](Hinge& h) { h.rest = 4.0 * radian; }),
               ContainsSubstring("rest is 4 rad") && ContainsSubstring("between -pi and pi"));
    auto line = world;
    line.set_position(all[2], metres(2, 0, 0));
    CHECK_THAT(refusal([&] { line.add(hinge_of(all, 1)); }), ContainsSubstring("area of a triangle"));
    Cloth cloth = plate(3, 3, 0.1, -2, [](const auto& x) { return x; });
    CHECK(refusal([&] { add_cloth(world, cloth); }) ==
          "add_cloth: rigidity is -2 J; it must be finite and not negative");
    cloth.rigidity = 1.0 * joule;
    World without{SemiImplicitEuler{}, Springs<>{}};
    CHECK_THAT(refusal([&] { add_cloth(without, cloth); }), ContainsSubstring("add Bending{}"));
    CHECK(world.hash() == hash);
    CHECK(without.size() == 0);
    // Cells of 1 cm at 10^6 m, where a float has steps of 6 cm: there the corners coincide.
    auto far = sheets<float>();
    const auto nothing = far.hash();
    Cloth small = plate(3, 3, 0.01, 1, [](const auto& x) { return metres(1e6 + x.value()[0], x.value()[1], 0); });
    CHECK_THAT(refusal([&] { add_cloth(far, small); }), ContainsSubstring("add_cloth: the area of a triangle"));
    CHECK(far.size() == 0);
    CHECK(far.hash() == nothing);
}
