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
            const double r = spheres.radius[i];
            kept->boxes.set(i, metres(x[0] - r, x[1] - r, x[2] - r), metres(x[0] + r, x[1] + r, x[2] + r));
        }
        std::size_t pairs = 0;
        kept->bound.find(kept->boxes, [&](std::size_t, std::size_t) { ++pairs; });
        return pairs;
    };
}

/// How many pairs all frames of a scene have.
std::size_t all_pairs(const Spheres& spheres, const peers::Broadphase& find) {
    std::size_t pairs = 0;
    for (int f = 0; f < spheres.frames; ++f) pairs += find(spheres, f);
    return pairs;
}

/// Who plays a scene.
class Players {
public:
    explicit Players(const Spheres& spheres) : spheres_(spheres), right_(all_pairs(spheres, ours(UniformGrid{}))) {}
    void add(const std::string& name, const peers::Broadphase& find, bool exact = true) {
        const std::size_t pairs = all_pairs(spheres_, find);
        if (exact && pairs != right_) {
            std::cerr << name << " finds " << pairs << " pairs where there are " << right_
                      << "; its time means nothing\n";
            std::exit(1);
        }
        subjects_.push_back({name,
                             [this, find, there = true]() mutable {
                                 static volatile std::size_t all = 0; // so that nothing is left out
                                 const int last = spheres_.frames - 1;
                                 for (int f = 0; f <= last; ++f) all = all + find(spheres_, there ? f : last - f);
                                 there = !there;
                             },
                             std::to_string(pairs / std::size_t(spheres_.frames)) + " pairs a frame"});
    }
    void play(Contest& contest, const std::string& scene) const {
        contest.play("broadphase, " + scene, spheres_.size(), "ns a body", double(spheres_.frames) * spheres_.size(),
                     subjects_);
    }

private:
    const Spheres& spheres_;
    std::size_t right_;
    std::vector<Subject> subjects_;
};

void broadphase(Contest& contest, const std::string& scene, const Spheres& spheres) {
    Players players(spheres);
    players.add("ansatz UniformGrid", ours(UniformGrid{}));
    players.add("ansatz UniformGrid<SortAndSweep>", ours(UniformGrid<SortAndSweep>{{}, {Sorting::in_cells}}));
    players.add("ansatz Octree", ours(Octree{}));
    players.add("ansatz BinarySplit", ours(BinarySplit{}));
    players.add("ansatz Coherent<UniformGrid>", ours(Coherent{UniformGrid{}}));
    if (spheres.size() <= 10000) players.add("ansatz SortAndSweep", ours(SortAndSweep{}));
#ifdef ANSATZ_PEER_CGAL
    players.add("CGAL box_intersection_d", peers::cgal_box_intersection(spheres));
#endif
#ifdef ANSATZ_PEER_FCL
    players.add("FCL dynamic AABB tree array", peers::fcl_tree_array(spheres));
#endif
#ifdef ANSATZ_PEER_BULLET
    players.add("Bullet btDbvtBroadphase", peers::bullet_dbvt(spheres), false);
#endif
    players.play(contest, scene);
}

/// Those that keep something from frame to frame, beside those that do not, at three speeds. Bodies turn round every 32
/// frames.
void in_motion(Contest& contest, int n) {
    for (const double fastest : {0.005, 0.05, 0.25}) {
        const auto play = [&](const std::string& scene, const Spheres& spheres) {
            Players players(spheres);
            players.add("ansatz UniformGrid", ours(UniformGrid{}));
            players.add("ansatz Coherent<UniformGrid>", ours(Coherent{UniformGrid{}}));
            players.add("ansatz Octree", ours(Octree{}));
            players.add("ansatz Coherent<Octree>", ours(Coherent{Octree{}}));
#ifdef ANSATZ_PEER_FCL
            players.add("FCL dynamic AABB tree array", peers::fcl_tree_array(spheres));
#endif
#ifdef ANSATZ_PEER_BULLET
            if (n <= 10000) players.add("Bullet btDbvtBroadphase", peers::bullet_dbvt(spheres), false);
#endif
            players.play(contest, scene + ", up to " + std::to_string(int(1000 * fastest)) + " mm a frame");
        };
        play("uniform", Spheres::uniform(n, fastest, 32));
        play("clustered", Spheres::clustered(n, fastest, 32));
        if (n <= 10000) play("mixed radii", Spheres::mixed(n, fastest, 32));
    }
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
        in_motion(contest, n);
    }
    contest.write(folder);
    return 0;
}
