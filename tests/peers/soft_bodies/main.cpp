// SPDX-License-Identifier: BSL-1.0
// `./workbook peers soft_bodies`: an implicit step beside Eigen's conjugate gradients over an assembled matrix, XPBD
// beside a loop over structures that was written by hand, and both beside Bullet's soft body. Double, one thread.

#include "tests/peers/contest.hpp"
#include "tests/peers/soft_bodies/hand.hpp"
#include "tests/peers/soft_bodies/sheet.hpp"
#include "tests/peers/versions.hpp"

#include <ansatz/motion/integrators/matrix_free.hpp>
#include <ansatz/soft_bodies/coloured_xpbd.hpp>
#include <ansatz/springs/springs.hpp>
#include <ansatz/world.hpp>

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

static const peers::Version version("Eigen", std::to_string(EIGEN_WORLD_VERSION) + "." +
                                                 std::to_string(EIGEN_MAJOR_VERSION) + "." +
                                                 std::to_string(EIGEN_MINOR_VERSION));

using namespace ansatz;
using peers::Contest;
using peers::Sheet;
using peers::Subject;

namespace {

/// The sheet in a world.
template <class... Policies> class InWorld : public peers::SheetOf {
public:
    explicit InWorld(const Sheet& sheet, const Policies&... policies) : world(policies...) {
        for (std::size_t i = 0; i < sheet.size(); ++i) {
            const auto& x = sheet.places[i];
            const auto place = position(metres(x[0], x[1], x[2]));
            bodies.push_back(sheet.masses[i] > 0 ? world.add(place, mass(sheet.masses[i] * kilogram))
                                                 : world.add(place, fixed));
        }
        for (const auto& l : sheet.links)
            world.add(Spring{bodies[l.a], bodies[l.b], sheet.stiffness * newton_per_metre,
                             sheet.damping * newton_second_per_metre, l.rest * metre});
    }
    void step() override { world.step(Sheet::dt * second); }
    std::array<double, 3> at(std::size_t i) const override {
        const auto x = world.position(bodies[i]).value();
        return {x[0], x[1], x[2]};
    }
    World<Policies...> world;
    std::vector<Handle> bodies;
};

std::string text(auto&&... part) {
    std::ostringstream out;
    out.precision(3);
    (out << ... << part);
    return out.str();
}
std::string stretch(const Sheet& sheet, const peers::SheetOf& played) {
    const auto s = peers::Stretch::of(sheet, played);
    return text("stretched by ", 100 * s.largest, " % at most, ", 100 * s.mean, " % in the mean");
}
/// Ends the contest where two who should do the same do not.
void same(const std::string& who, const Sheet& sheet, const peers::SheetOf& one, const peers::SheetOf& other,
          double tolerance) {
    double most = 0;
    for (std::size_t i = 0; i < sheet.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(one.at(i)[k] - other.at(i)[k]));
    if (most <= tolerance) return;
    std::cerr << who << " is " << most << " m off; its time means nothing\n";
    std::exit(1);
}

using Implicit = InWorld<ImplicitEulerBy<MatrixFree>, Gravity, Springs<>>;

/// The linear system of one implicit step, solved by both to the same residual: assembly, solve, and for ours what a
/// world's step has besides. Then a whole step of several such systems against one of Eigen's.
void implicit_steps(Contest& contest, int n) {
    const Sheet sheet = Sheet::of(n, true, 200, 0.02);
    Implicit begun(sheet, {}, {}, {});
    for (int i = 0; i < 10; ++i) begun.step();
    peers::EigenStep where(sheet, 0);
    for (std::size_t i = 0; i < sheet.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            where.x[Eigen::Index(3 * i + k)] = begun.at(i)[k];
            where.v[Eigen::Index(3 * i + k)] = begun.world.velocity(begun.bodies[i]).value()[Eigen::Index(k)];
        }
    where.assemble();
    // What a change of velocities leaves of the system, as a fraction of its right-hand side.
    const auto left = [&](const Eigen::VectorXd& change) {
        return (where.rhs - where.matrix * change).norm() / where.rhs.norm();
    };
    for (const double tolerance : {1e-4, 1e-10}) {
        Implicit ours(sheet, {.tolerance = tolerance, .most_iterations = 1}, {}, {});
        const auto set = [&] {
            const auto policy = ours.world.get<ImplicitEulerBy<MatrixFree>>();
            ours.world = begun.world;
            ours.world.set(policy);
        };
        set();
        ours.step();
        Eigen::VectorXd change(where.v.size());
        for (std::size_t i = 0; i < sheet.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                change[Eigen::Index(3 * i + k)] =
                    ours.world.velocity(begun.bodies[i]).value()[Eigen::Index(k)] - where.v[Eigen::Index(3 * i + k)];
        const double reached = left(change);
        peers::EigenStep eigen(sheet, reached);
        eigen.x = where.x;
        eigen.v = where.v;
        eigen.assemble();
        const double theirs = left(eigen.solve());
        contest.play(text("linear system of an implicit step, to ", tolerance), n, "us", 1000,
                     {{"ansatz MatrixFree, the whole step",
                       [&] {
                           set();
                           ours.step();
                       },
                       text("leaves ", reached)},
                      {"Eigen, triplets and ConjugateGradient",
                       [&] {
                           eigen.assemble();
                           eigen.solve();
                       },
                       text("leaves ", theirs, " in ", eigen.solver.iterations(), " iterations")},
                      {"Eigen, ConjugateGradient alone", [&] { eigen.solve(); }}});
    }
    Implicit ours(sheet, {}, {}, {});
    peers::EigenStep eigen(sheet, 1e-4);
    contest.play("whole implicit steps", n, "us a step", 10 * 1000,
                 {{"ansatz MatrixFree, default",
                   [&] {
                       ours.world = begun.world;
                       for (int i = 0; i < 10; ++i) ours.step();
                   },
                   "Newton to a hundredth"},
                  {"Eigen, one system to 1e-4", [&] {
                       eigen.x = where.x;
                       eigen.v = where.v;
                       for (int i = 0; i < 10; ++i) eigen.step();
                   }}});
}

/// A second of XPBD in ten substeps a frame.
void constraints(Contest& contest, int n) {
    const Sheet sheet = Sheet::of(n, false, 2000, 0.02);
    InWorld<SemiImplicitEuler, Gravity, Springs<>, Xpbd> ours(sheet, {}, {}, {}, {10, 1});
    InWorld<SemiImplicitEuler, Gravity, Springs<>, ColouredXpbd> coloured(sheet, {}, {}, {}, {10, 1});
    peers::HandXpbd hand(sheet, 10);
    for (int i = 0; i < 60; ++i) {
        ours.step();
        coloured.step();
        hand.step();
        if (i == 4) same("the hand-written loop", sheet, ours, hand, 1e-9);
    }
    const double springs = 60. * 10 * double(sheet.links.size());
    const auto second_of = [&](peers::SheetOf& one) {
        return [&one] {
            for (int i = 0; i < 60; ++i) one.step();
        };
    };
    contest.play("XPBD, 10 substeps", n, "ns a spring", springs,
                 {{"ansatz Xpbd", second_of(ours), stretch(sheet, ours)},
                  {"ansatz ColouredXpbd", second_of(coloured), stretch(sheet, coloured)},
                  {"hand-written loop over structures", second_of(hand), stretch(sheet, hand)}});
}

#ifdef ANSATZ_PEER_BULLET_SOFT
/// Frames of the same sheet beside Bullet's: what one has for its time.
void frames(Contest& contest, int n) {
    const Sheet sheet = Sheet::of(n, false, 2000, 0.02);
    InWorld<SemiImplicitEuler, Gravity, Springs<>, Xpbd> few(sheet, {}, {}, {}, {10, 1}),
        many(sheet, {}, {}, {}, {40, 1});
    InWorld<SemiImplicitEuler, Gravity, Springs<>, ColouredXpbd> coloured(sheet, {}, {}, {}, {40, 1});
    const auto bullet_10 = peers::bullet_sheet(sheet, 10), bullet_40 = peers::bullet_sheet(sheet, 40);
    std::vector<Subject> subjects;
    const auto add = [&](const std::string& name, peers::SheetOf& one) {
        for (int i = 0; i < 120; ++i) one.step();
        subjects.push_back({name,
                            [&one] {
                                for (int i = 0; i < 60; ++i) one.step();
                            },
                            stretch(sheet, one) + " after 2 s"});
    };
    add("ansatz Xpbd, 10 substeps", few);
    add("Bullet btSoftBody, 10 passes", *bullet_10);
    add("ansatz Xpbd, 40 substeps", many);
    add("ansatz ColouredXpbd, 40 substeps", coloured);
    add("Bullet btSoftBody, 40 passes", *bullet_40);
    contest.play("frames of a sheet", n, "us a frame", 60 * 1000, subjects);
}
#endif

} // namespace

/// usage: peers_soft_bodies <folder for soft_bodies.json> [repeats]
int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : ".";
    Contest contest("soft_bodies", argc > 2 ? std::max(1, std::atoi(argv[2])) : 15);
#ifndef ANSATZ_PEER_BULLET_SOFT
    Contest::left_out("Bullet's soft bodies", "libbullet-dev");
#endif
    for (const int n : {50, 100}) implicit_steps(contest, n);
    for (const int n : {20, 50}) constraints(contest, n);
#ifdef ANSATZ_PEER_BULLET_SOFT
    for (const int n : {20, 50}) frames(contest, n);
#endif
    contest.write(folder);
    return 0;
}
