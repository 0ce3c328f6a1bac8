// SPDX-License-Identifier: BSL-1.0
// `./workbook peers collision`: the broadphases beside those of CGAL, FCL and Bullet, and whole steps beside ODE's and
// Bullet's.

#include "tests/peers/collision/pile.hpp"
#include "tests/peers/collision/spheres.hpp"
#include "tests/peers/contest.hpp"

#include <ansatz/collision/broadphase.hpp>

#include <cstdlib>

using namespace ansatz;
using peers::Contest;
using peers::Spheres;
using peers::Subject;

namespace {

/// Fills the boxes of a frame and finds their pairs, as the peers do.
template <class Policy> peers::Broadphase ours(const Policy& policy) {
    struct Kept {
        explicit Kept(const Policy& p) : bound(p) {}
        typename Policy::template In<Space<>> bound;
        Boxes<Space<>> boxes;
    };
    auto kept = std::make_shared<Kept>(policy);
    return [kept](const Spheres& spheres, int frame) {
        kept->boxes.resize(spheres.start.size());
        kept->boxes.set_active(spheres.start.size());
        for (std::size_t i = 0; i < spheres.start.size(); ++i) {
            const auto x = spheres.at(i, frame);
            constexpr double r = Spheres::radius;
            kept->boxes.set(i, metres(x[0] - r, x[1] - r, x[2] - r), metres(x[0] + r, x[1] + r, x[2] + r));
        }
        std::size_t pairs = 0;
        kept->bound.find(kept->boxes, [&](std::size_t, std::size_t) { ++pairs; });
        return pairs;
    };
}

void broadphase(Contest& contest, const std::string& scene, const Spheres& spheres) {
    const std::size_t right = ours(UniformGrid{})(spheres, 0);
    std::vector<Subject> subjects;
    auto add = [&](const std::string& name, const peers::Broadphase& find, bool exact) {
        const std::size_t pairs = find(spheres, 0);
        if (exact && pairs != right) {
            std::cerr << name << " finds " << pairs << " pairs where there are " << right
                      << "; its time means nothing\n";
            std::exit(1);
        }
        subjects.push_back({name,
                            [&spheres, find, there = true]() mutable {
                                static volatile std::size_t all = 0; // so that nothing is left out that nobody looks at
                                for (int f = 0; f < Spheres::frames; ++f)
                                    all = all + find(spheres, there ? f : Spheres::frames - 1 - f);
                                there = !there;
                            },
                            std::to_string(pairs) + " pairs"});
    };
    add("ansatz UniformGrid", ours(UniformGrid{}), true);
    add("ansatz UniformGrid<SortAndSweep>", ours(UniformGrid<SortAndSweep>{{}, {Sorting::in_cells}}), true);
    add("ansatz Octree", ours(Octree{}), true);
    add("ansatz BinarySplit", ours(BinarySplit{}), true);
    if (spheres.size() <= 10000) add("ansatz SortAndSweep", ours(SortAndSweep{}), true);
#ifdef ANSATZ_PEER_CGAL
    add("CGAL box_intersection_d", peers::cgal_box_intersection(spheres), true);
#endif
#ifdef ANSATZ_PEER_FCL
    add("FCL dynamic AABB tree array", peers::fcl_tree_array(spheres), true);
#endif
#ifdef ANSATZ_PEER_BULLET
    add("Bullet btDbvtBroadphase", peers::bullet_dbvt(spheres), false);
#endif
    contest.play("broadphase, " + scene, spheres.size(), "ns a body", double(Spheres::frames) * spheres.size(),
                 subjects);
}

} // namespace

/// usage: peers_collision <folder for collision.json> [repeats]
int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : ".";
    Contest contest("collision", argc > 2 ? std::max(1, std::atoi(argv[2])) : 15);
#ifndef ANSATZ_PEER_CGAL
    Contest::left_out("CGAL", "libcgal-dev");
#endif
#ifndef ANSATZ_PEER_FCL
    Contest::left_out("FCL", "libfcl-dev");
#endif
#ifndef ANSATZ_PEER_BULLET
    Contest::left_out("Bullet", "libbullet-dev");
#endif
#ifndef ANSATZ_PEER_ODE
    Contest::left_out("ODE", "libode-dev");
#endif
    for (const int n : {1000, 8000}) peers::play_piles(contest, n);
    for (const int n : {10000, 100000}) {
        broadphase(contest, "uniform spheres", Spheres::uniform(n));
        broadphase(contest, "clustered spheres", Spheres::clustered(n));
    }
    contest.write(folder);
    return 0;
}
