// SPDX-License-Identifier: BSL-1.0
// Pressure: volumes against closed forms, the law against the motion that follows from it, and every solver against
// the balance of forces.
// Runs long with the sanitizers.

#include <ansatz/soft_bodies/enclosure.hpp>
#include <ansatz/soft_bodies/pressure.hpp>

#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/soft_bodies/closed_meshes.hpp>
#include <ansatz/soft_bodies/soft_ball.hpp>
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

constexpr Filling gas{.inside = 300.0 * pascal, .outside = 100.0 * pascal};
constexpr Filling firm{.stiffness = 2000.0 * pascal, .damping = 3.0 * pascal_second};
constexpr Filling stiff_gas{.inside = 300.0 * pascal, .stiffness = 400.0 * pascal};
constexpr Filling both{
    .inside = 300.0 * pascal, .outside = 120.0 * pascal, .stiffness = 700.0 * pascal, .damping = 5.0 * pascal_second};

auto free_world() { return World{RungeKutta4{}, Springs<>{}, Pressure{}}; }
template <class Scalar, class... Solver> auto solved(const Solver&... solver) {
    return World{Space<Scalar, 3>{}, SemiImplicitEuler{}, Springs<>{}, Pressure{}, solver...};
}

/// The bodies of a mesh, of unequal masses from `lightest` on, without springs.
template <class World_>
std::vector<Handle> add_bodies(World_& world, const TriangleMesh& mesh, double lightest = 0.1, double more = 0.01) {
    std::vector<Handle> all;
    for (const auto& x : mesh.vertices())
        all.push_back(world.add(position(x), mass((lightest + more * double(all.size())) * kilogram)));
    return all;
}
/// An octahedron of equal masses on the axes, with springs along its edges.
template <class World_>
ElementHandle<Enclosure> add_balloon(World_& world, const Filling& filling, double k, double c, double radius = 0.5) {
    const auto mesh = ball_mesh(radius * metre, 0);
    const auto all = add_bodies(world, mesh, 0.2, 0);
    for (const auto& [a, b] : mesh.edges())
        world.add(Spring{all[a], all[b], k * newton_per_metre, c * newton_second_per_metre});
    return world.add(Enclosure::of(all, mesh, filling));
}
/// A ball with its vertices out of their places, so that nothing is symmetric.
TriangleMesh potato(int divisions = 1) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-0.08, 0.08);
    const auto ball = ball_mesh(0.5 * metre, divisions);
    std::vector<TriangleMesh::Point> places(ball.vertices().begin(), ball.vertices().end());
    for (auto& x : places) x += metres(number(random), number(random), number(random));
    return {places, {ball.triangles().begin(), ball.triangles().end()}};
}
double radius_of(const auto& world) { return double(norm(world.position(world.handles()[0])).value()); }

/// The balance of an octahedron: what presses a vertex outwards, p dV/dr / 6, is what its four springs pull inwards.
double radius_at_rest(const Filling& f, double k, double r0 = 0.5) {
    const double v0 = 4.0 / 3 * r0 * r0 * r0, root = std::sqrt(2.0);
    const auto outwards = [&](double r) {
        const double v = 4.0 / 3 * r * r * r;
        const double p = f.inside.value() * v0 / v - f.outside.value() + f.stiffness.value() * (1 - v / v0);
        return p * 4 * r * r / 6 - 4 * k * (root * r - root * r0) / root;
    };
    double low = r0 / 2, high = 3 * r0;
    for (int i = 0; i < 200; ++i) (outwards((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    return (low + high) / 2;
}

} // namespace

TEST_CASE("A box and an octahedron enclose what the closed forms say, wherever they are", "[soft_bodies][pressure]") {
    const auto far = GENERATE(metres(0, 0, 0), metres(3, -4, 5), metres(1000, 2000, -500));
    auto world = free_world();
    const auto add = [&](const TriangleMesh& mesh) {
        const auto there = mesh.moved(far);
        return world.add(Enclosure::of(add_bodies(world, there), there, gas));
    };
    // Powers of two, so that no place is rounded when it is moved.
    const auto box = add(box_mesh(metres(2, 0.5, 4), 4, 2, 8));
    const auto octahedron = add(ball_mesh(0.75 * metre, 0));
    const auto apart = add(ball_mesh(0.5 * metre, 3));
    CHECK(enclosed_volume(world, box).value() == Approx(4).epsilon(1e-12));
    CHECK(enclosed_volume(world, octahedron).value() == Approx(4.0 / 3 * 0.75 * 0.75 * 0.75).epsilon(1e-12));
    CHECK(enclosed_volume(world, apart).value() == Approx(ball_mesh(0.5 * metre, 3).volume().value()).epsilon(1e-12));
}

TEST_CASE("The law of a filling: a gas, a stiffness, and its tangent where it is pressed to nothing",
          "[soft_bodies][pressure]") {
    const detail::FillingLaw<double> law{300, 120, 700, 0.2};
    CHECK(law.excess(0.2) == Approx(180));
    CHECK(law.excess(0.1) == Approx(600 - 120 + 350));
    CHECK(law.energy(0.2) == 0);
    for (const double v : {-0.1, 0.0, 0.001, 0.0019, 0.0021, 0.05, 0.2, 1.7}) {
        const double d = 1e-7;
        CAPTURE(v);
        CHECK(law.excess(v) == Approx(-(law.energy(v + d) - law.energy(v - d)) / (2 * d)).epsilon(1e-6));
        CHECK(law.slope(v) == Approx(-(law.excess(v + d) - law.excess(v - d)) / (2 * d)).epsilon(1e-6));
        CHECK(law.slope(v) > 0);
    }
}

TEST_CASE("The forces of a filling are minus the slope of its energy", "[soft_bodies][pressure]") {
    const auto filling = GENERATE(gas, firm, both);
    auto world = World{SemiImplicitEuler{}, Pressure{}};
    const auto mesh = potato();
    const auto all = add_bodies(world, mesh);
    world.add(Enclosure::of(all, mesh, filling));
    world.set_position(all[3], world.position(all[3]) + metres(0.1, 0.02, -0.05)); // no longer V_0
    const auto energy = [&](std::size_t i, int axis, double by) {
        auto there = world;
        auto x = there.position(all[i]).value();
        x[axis] += by;
        there.set_position(all[i], Space<>::Position::from_value(x));
        return potential_energy(there).value();
    };
    auto stepped = world;
    const double dt = 1e-3;
    stepped.step(dt * second);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const double force = stepped.velocity(all[i]).value()[axis] / dt / world.inverse_mass(all[i]).value();
            const double slope = (energy(i, axis, 1e-5) - energy(i, axis, -1e-5)) / 2e-5;
            CHECK(force == Approx(-slope).epsilon(1e-6).margin(1e-6));
        }
}

TEST_CASE("A damped filling takes energy by the square of the volume's rate", "[soft_bodies][pressure]") {
    auto world = World{SemiImplicitEuler{}, Pressure{}};
    const auto mesh = potato();
    const auto all = add_bodies(world, mesh);
    const auto which =
        world.add(Enclosure::of(all, mesh, {.stiffness = 1e-9 * pascal, .damping = 4.0 * pascal_second}));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const auto& body : all)
        world.set_velocity(body, metres_per_second(7 + number(random), number(random), number(random)));
    auto stepped = world;
    const double dt = 1e-6, before = enclosed_volume(world, which).value();
    stepped.step(dt * second);
    const double rate = (enclosed_volume(stepped, which).value() - before) / dt;
    const double power = (kinetic_energy(stepped).value() - kinetic_energy(world).value()) / dt;
    CHECK(std::abs(rate) > 0.01);
    CHECK(power == Approx(-4 / before * rate * rate).epsilon(1e-3));
}

TEST_CASE("A filling pushes nothing away and turns nothing", "[soft_bodies][pressure]") {
    auto world = solved<double>(); // a method that keeps both, whatever the step
    const auto mesh = potato(2).moved(metres(2, -3, 1));
    const auto all = add_bodies(world, mesh);
    for (const auto& [a, b] : mesh.edges())
        world.add(Spring{all[a], all[b], 200.0 * newton_per_metre, 0.5 * newton_second_per_metre});
    world.add(Enclosure::of(all, mesh, both));
    for (std::size_t i = 0; i < all.size(); ++i) world.set_velocity(all[i], metres_per_second(1, double(i % 3), -2));
    const auto momentum = total_momentum(world).value(), turning = total_angular_momentum(world).value();
    run(world, 500, 1.0 / 240);
    CHECK((total_momentum(world).value() - momentum).norm() < 1e-11 * momentum.norm());
    CHECK((total_angular_momentum(world).value() - turning).norm() < 1e-11 * turning.norm());
}

TEST_CASE("An octahedron breathes as the equation of its radius says", "[soft_bodies][pressure]") {
    // m r'' = p(V) dV/dr / 6 with V = 4/3 r^3, by the same method in the same steps.
    const auto filling = GENERATE(gas, stiff_gas);
    auto world = free_world();
    const auto which = add_balloon(world, filling, 0, 0);
    const detail::FillingLaw<double> law{filling.inside.value(), filling.outside.value(), filling.stiffness.value(),
                                         4.0 / 3 * 0.125};
    const auto a = [&](double r) { return law.excess(4.0 / 3 * r * r * r) * 4 * r * r / 6 / 0.2; };
    double r = 0.5, v = 0;
    const double h = 1e-3, energy = total_energy(world).value();
    for (int i = 0; i < 40; ++i) {
        world.step(h * second);
        const double v1 = v, a1 = a(r), v2 = v + h / 2 * a1, a2 = a(r + h / 2 * v1);
        const double v3 = v + h / 2 * a2, a3 = a(r + h / 2 * v2), v4 = v + h * a3, a4 = a(r + h * v3);
        r += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
        v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    CHECK(r > 0.55);
    CHECK(radius_of(world) == Approx(r).epsilon(1e-12));
    CHECK(enclosed_volume(world, which).value() == Approx(4.0 / 3 * r * r * r).epsilon(1e-12));
    CHECK(total_energy(world).value() == Approx(energy).epsilon(0).margin(1e-6 * kinetic_energy(world).value()));
}

TEST_CASE("Every solver comes to the balance of skin and filling", "[soft_bodies][pressure]") {
    const auto filling = GENERATE(gas, both);
    const double k = 150, rest = radius_at_rest(filling, k);
    CHECK(rest > 0.515);
    const auto settle = [&](auto world) {
        add_balloon(world, filling, k, 4);
        run(world, 300, 1.0 / 60);
        CHECK(world.status().ok());
        return radius_of(world);
    };
    CHECK(settle(free_world()) == Approx(rest).epsilon(1e-9));
    CHECK(settle(solved<double>(VertexBlockDescent{2, 40})) == Approx(rest).epsilon(1e-6));
    CHECK(settle(World{ImplicitEuler{}, Springs<>{}, Pressure{}}) == Approx(rest).epsilon(1e-9));
    CHECK(settle(solved<float>(Xpbd{16, 10})) == Approx(rest).epsilon(1e-4));
    // What moves in an iteration turns the gradients of who comes next: an error of the second order in the substep.
    const double eight = std::abs(settle(solved<double>(Xpbd{8, 20})) - rest);
    const double sixteen = std::abs(settle(solved<double>(Xpbd{16, 20})) - rest);
    CHECK(eight < 1e-4 * rest);
    CHECK(sixteen < eight / 3); // 3.2 where the two pressures nearly cancel, 3.9 for the gas
}

TEST_CASE("One substep of Xpbd with a filling alone is the paper's formula", "[soft_bodies][pressure]") {
    auto world = solved<double>(Xpbd{1, 1});
    const auto which = add_balloon(world, firm, 0, 0);
    auto larger = world.get(which);
    larger.volume = 0.3 * cubic_metre;
    world.set(which, larger);
    for (const auto& body : world.handles())
        world.set_velocity(body, Space<>::Velocity::from_value(2 * world.position(body).value() / 0.5));
    const double h = 1.0 / 60, w = 1 / 0.2, r = 0.5 + h * 2, g = 4 * r * r / 6, k = 2000 / 0.3, c = 3 / 0.3;
    const double value = 4.0 / 3 * r * r * r - 0.3;
    const double change = -(h * h * k * value + h * c * h * 6 * g * 2) / (1 + (h * h * k + h * c) * 6 * w * g * g);
    world.step(h * second);
    CHECK(std::abs(w * g * change) > 1e-3);
    CHECK(radius_of(world) == Approx(r + w * g * change).epsilon(1e-12));
    CHECK(double(norm(world.velocity(world.handles()[3])).value()) == Approx(2 + w * g * change / h).epsilon(1e-12));
}

TEST_CASE("Iterated to the end, descent is implicit Euler for a filling that is a stiffness",
          "[soft_bodies][pressure]") {
    auto descent = solved<double>(VertexBlockDescent{1, 800});
    World implicit{ImplicitEuler{.tolerance = 1e-13}, Springs<>{}, Pressure{}};
    const auto fill = [](auto& world) {
        const auto mesh = potato(1);
        const auto all = add_bodies(world, mesh);
        for (const auto& [a, b] : mesh.edges()) world.add(Spring{all[a], all[b], 60.0 * newton_per_metre});
        world.add(Enclosure::of(all, mesh, firm));
        world.set_velocity(all[0], metres_per_second(1, -2, 0.5));
        world.set_velocity(all[5], metres_per_second(-3, 1, 0));
        return all;
    };
    const auto all = fill(descent);
    fill(implicit);
    for (int i = 0; i < 10; ++i) {
        descent.step(1.0 / 60 * second);
        implicit.step(1.0 / 60 * second);
    }
    CHECK(implicit.status().ok());
    for (const auto& body : all) CHECK(norm(descent.position(body) - implicit.position(body)).value() < 1e-10);
}

TEST_CASE("The derivative that an implicit step gets is that of the forces", "[soft_bodies][pressure]") {
    // Where the filling presses nothing, the part that is left out is none.
    World world{ImplicitEuler{}, Springs<>{}, Pressure{}};
    const auto mesh = potato(2); // more vertices than are looked at at once
    const auto all = add_bodies(world, mesh);
    world.add(Enclosure::of(all, mesh, firm));
    const auto n = Eigen::Index(3 * all.size());
    Eigen::MatrixXd by_x = Eigen::MatrixXd::Zero(n, n), by_v = by_x;
    const Pressure::In<Space<>> law(Pressure{});
    const auto view = world.view<Pressure>();
    law.jacobian(view, world.context().restricted<false>(),
                 [&](std::size_t a, std::size_t b, const auto& x, const auto& v) {
                     const auto put = [&](Eigen::MatrixXd& into, const Eigen::Matrix3d& block) {
                         into.block<3, 3>(Eigen::Index(3 * a), Eigen::Index(3 * a)) += block;
                         if (b == view.size()) return;
                         into.block<3, 3>(Eigen::Index(3 * b), Eigen::Index(3 * b)) += block;
                         into.block<3, 3>(Eigen::Index(3 * a), Eigen::Index(3 * b)) -= block;
                         into.block<3, 3>(Eigen::Index(3 * b), Eigen::Index(3 * a)) -= block.transpose();
                     };
                     put(by_x, x);
                     put(by_v, v);
                 });
    Eigen::VectorXd gradient(n);
    const auto volume = [&](std::size_t i, int axis, double by) {
        auto places = std::vector<TriangleMesh::Point>(mesh.vertices().begin(), mesh.vertices().end());
        auto x = places[i].value();
        x[axis] += by;
        places[i] = TriangleMesh::Point::from_value(x);
        return TriangleMesh(places, {mesh.triangles().begin(), mesh.triangles().end()}).volume().value();
    };
    for (std::size_t i = 0; i < all.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            gradient[Eigen::Index(3 * i) + axis] = (volume(i, axis, 1e-5) - volume(i, axis, -1e-5)) / 2e-5;
    const double v0 = mesh.volume().value();
    const Eigen::MatrixXd outer = gradient * gradient.transpose();
    CHECK((by_x + 2000 / v0 * outer).cwiseAbs().maxCoeff() < 1e-6);
    CHECK((by_v + 3 / v0 * outer).cwiseAbs().maxCoeff() < 1e-6);
}

TEST_CASE("A filling counts in the stable step, on the safe side", "[soft_bodies][pressure]") {
    auto world = World{SemiImplicitEuler{}, Pressure{}};
    const auto mesh = potato(1);
    const auto all = add_bodies(world, mesh);
    world.add(Enclosure::of(all, mesh, {.stiffness = 2000.0 * pascal}));
    double sum = 0; // of w |g|^2: the only stiffness that is not zero, times k
    for (std::size_t i = 0; i < all.size(); ++i) {
        Vector<double, 3> g = Vector<double, 3>::Zero();
        for (const auto& [a, b, c] : mesh.triangles())
            if (a == i || b == i || c == i)
                g +=
                    cross(mesh.vertices()[b] - mesh.vertices()[a], mesh.vertices()[c] - mesh.vertices()[a]).value() / 6;
        sum += world.inverse_mass(all[i]).value() * g.squaredNorm();
    }
    const double exact = 2000 / mesh.volume().value() * sum;
    CHECK(measured_stiffness(world).value() == Approx(exact).epsilon(1e-6));
    CHECK(stiffness_of(world).largest.value() >= exact);
    CHECK(stiffness_of(world).largest.value() < 4 * exact);
}

TEST_CASE("A ball that is turned inside out comes out again", "[soft_bodies][pressure]") {
    auto world = solved<double>(Xpbd{10, 2});
    const auto which = add_balloon(world, gas, 150, 4);
    for (const auto& body : world.handles()) {
        const auto x = world.position(body);
        world.set_position(body, -0.3 * x + metres(0.001, 0, 0));
    }
    CHECK(enclosed_volume(world, which).value() < 0);
    run(world, 400, 1.0 / 60);
    CHECK(world.status().ok());
    for (const auto& body : world.handles()) CHECK(is_finite(world.position(body)));
    CHECK(enclosed_volume(world, which).value() > 0.1);
}

TEST_CASE("An enclosure is copied, hashed, saved and loaded, and gone with any of its bodies",
          "[soft_bodies][pressure]") {
    auto world = solved<double>(Xpbd{3, 2});
    const auto first = add_balloon(world, gas, 100, 1), second_ = add_balloon(world, both, 80, 1, 0.25);
    world.set_velocity(world.handles()[2], metres_per_second(1, 2, 3));
    run(world, 10, 1.0 / 60);
    world.remove(world.handles()[1]);
    CHECK(world.elements<Enclosure>().size() == 1);
    CHECK_THROWS_AS(enclosed_volume(world, first), std::out_of_range);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto loaded = solved<double>(Xpbd{3, 2});
    load(loaded, file);
    for (auto* each : {&world, &copy, &loaded}) run(*each, 30, 1.0 / 60);
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
    CHECK(enclosed_volume(loaded, second_) == enclosed_volume(world, second_));
    const auto is = world.get(second_);
    CHECK(is.filling.inside.value() == 300);
    CHECK(is.filling.damping.value() == 5);
    CHECK(is.triangles.size() == 8);
    CHECK(is.volume->value() == Approx(4.0 / 3 / 64).epsilon(1e-12));
    auto other = is;
    other.filling.inside = 301.0 * pascal;
    const auto before = world.hash();
    world.set(second_, other);
    CHECK(world.hash() != before);
    world.set(second_, is);
    CHECK(world.hash() == before);
}

TEST_CASE("A ball with a filling has no middle, the mass of the polyhedron, and bulges to the balance of its virial",
          "[soft_bodies][pressure]") {
    auto world = solved<double>();
    SoftBall ball{.centre = metres(1, 2, 3),
                  .radius = 0.3 * metre,
                  .density = 20.0 * kilogram_per_cubic_metre,
                  .divisions = 2,
                  .structural = {300.0 * N_per_m, 2.0 * N_s_per_m},
                  .filling = gas};
    const auto parts = add_soft_ball(world, ball);
    const auto mesh = ball_mesh(0.3 * metre, 2, metres(1, 2, 3));
    CHECK(parts.bodies.size() == 66);
    CHECK(world.size() == 66);
    CHECK(parts.spokes.empty());
    CHECK(mass_of_all(world) == Approx(20 * mesh.volume().value()).epsilon(1e-12));
    CHECK(excess_pressure(world, parts.enclosure).value() == Approx(200));
    run(world, 3000, 1.0 / 600);
    // At rest what the skin pulls, by how long it is, is three times what the filling presses, by how much it is.
    double pull = 0;
    Springs<>::In<Space<>>(Springs<>{}).tensions(world.view<Springs<>>(), [&](std::uint32_t id, const auto& t, auto) {
        const auto& link = world.view<Springs<>>().state().link(id);
        const auto view = world.view<Springs<>>();
        pull += t.value() *
                norm(view.get<Position>(view.slot_of_id(link.b)) - view.get<Position>(view.slot_of_id(link.a))).value();
    });
    const double press =
        excess_pressure(world, parts.enclosure).value() * enclosed_volume(world, parts.enclosure).value();
    CHECK(press > 10);
    CHECK(pull == Approx(3 * press).epsilon(1e-9));

    ball.spokes = {80.0 * N_per_m, 0.5 * N_s_per_m};
    CHECK(add_soft_ball(world, ball).bodies.size() == 67);
    const auto before = world.hash();
    ball.filling->inside = -1.0 * pascal;
    CHECK(refusal([&] { add_soft_ball(world, ball); }) ==
          "add_soft_ball: inside is -1 Pa; it must be finite and not negative");
    CHECK(world.hash() == before);
    ball.filling = gas;
    World without{SemiImplicitEuler{}, Springs<>{}};
    CHECK_THAT(refusal([&] { add_soft_ball(without, ball); }), ContainsSubstring("add Pressure{}"));
    CHECK(without.size() == 0);
}

TEST_CASE("What encloses nothing is refused, and says where", "[soft_bodies][pressure]") {
    auto world = solved<double>(Xpbd{});
    const auto mesh = ball_mesh(0.5 * metre, 0);
    const auto all = add_bodies(world, mesh);
    const auto good = Enclosure::of(all, mesh, gas);
    const auto before = world.hash();
    const auto says = [&](auto&& change) {
        auto bad = good;
        change(bad);
        return refusal([&] { world.add(bad); });
    };
    CHECK_THAT(says([](auto& e) { e.triangles.pop_back(); }),
               ContainsSubstring("the surface is open") && ContainsSubstring("a side of one triangle"));
    CHECK_THAT(says([](auto& e) { e.triangles[2][1] = 6; }),
               ContainsSubstring("triangle 2") && ContainsSubstring("vertex 6 does not exist"));
    CHECK_THAT(says([](auto& e) { e.triangles.push_back(e.triangles[1]); }), ContainsSubstring("triangle 8"));
    CHECK_THAT(says([](auto& e) { std::swap(e.triangles[0][0], e.triangles[0][1]); }),
               ContainsSubstring("there twice"));
    CHECK_THAT(says([](auto& e) {
                   for (auto& t : e.triangles) std::swap(t[0], t[1]);
               }),
               ContainsSubstring("enclosed volume") && ContainsSubstring("m^3") && ContainsSubstring("outside"));
    CHECK_THAT(says([](auto& e) { e.bodies[1] = e.bodies[0]; }), ContainsSubstring("of body 0 is 2"));
    CHECK_THAT(says([](auto& e) { e.filling = {}; }), ContainsSubstring("inside is 0 Pa"));
    CHECK_THAT(says([](auto& e) { e.filling.stiffness = -1.0 * pascal; }),
               ContainsSubstring("stiffness is -1 Pa") && ContainsSubstring("not negative"));
    CHECK_THAT(says([](auto& e) { e.filling.damping = NAN * pascal_second; }), ContainsSubstring("damping is"));
    CHECK_THAT(says([](auto& e) { e.volume = 0.0 * cubic_metre; }), ContainsSubstring("volume is 0 m^3"));
    CHECK_THROWS_AS(world.add([&] {
        auto bad = good;
        bad.bodies[0].generation += 1;
        return bad;
    }()),
                    std::out_of_range);
    CHECK(world.hash() == before);
    CHECK(world.elements<Enclosure>().size() == 0);
}

TEST_CASE("A ball that is too small for the scalar of its world, where it is, leaves the world as it was",
          "[soft_bodies][pressure]") {
    auto world = solved<float>(Xpbd{});
    const auto before = world.hash();
    const SoftBall ball{.centre = metres(1e6, 0, 0), // a float has steps of 6 cm there
                        .radius = 0.02 * metre,
                        .density = 40.0 * kilogram_per_cubic_metre,
                        .divisions = 0,
                        .structural = {10.0 * N_per_m},
                        .filling = gas};
    CHECK(refusal([&] { add_soft_ball(world, ball); }) != "");
    CHECK(world.size() == 0);
    CHECK(world.hash() == before);
}

TEST_CASE("A file with an enclosure that is none is refused", "[soft_bodies][pressure]") {
    auto world = solved<double>(Xpbd{});
    add_balloon(world, gas, 100, 1);
    std::stringstream file;
    save(world, file);
    const auto text = file.str();
    const auto with = [&](const std::string& from, const std::string& to) {
        auto changed = text;
        const auto at = changed.find(from, changed.find("\"Pressure\""));
        REQUIRE(at != std::string::npos);
        changed.replace(at, from.size(), to);
        std::stringstream in(changed);
        auto loaded = solved<double>(Xpbd{});
        return refusal([&] { load(loaded, in); });
    };
    CHECK_THAT(with("\"outside\":", "\"outside\": -1, \"was\":"), !ContainsSubstring("nothing"));
    CHECK_THAT(with("\"corners\":", "\"corners\": [0, 1, 2], \"was\":"), ContainsSubstring("at least 4"));
}
