// SPDX-License-Identifier: BSL-1.0
// What a broadphase costs: pairs compared for one that touches, and time, against number, spread and threshold

// Errors there are none: each of them tells every pair of boxes that touch, once. What stands in the place of the error
// is the waste: pairs of boxes that were compared, for one that touches. It is counted in an untimed run, in which each
// comparison of two boxes goes through a counter, in every method. The time is that of a step: the search in boxes
// that have moved a little since the last one, and the narrowphase's test of each pair of balls that was told. AllPairs
// compares no boxes, so that every pair is tested; that is why the test is timed with all of them.

#include "what_it_costs.hpp"

#include <ansatz/collision/broadphase.hpp>
#include <ansatz/collision/narrowphase/sphere_sphere.hpp>

#include <array>
#include <cstdint>
#include <iomanip>
#include <memory>
#include <numeric>
#include <optional>
#include <random>

using namespace ansatz;
using namespace collision_costs;
using workbook::Axis;
using workbook::Outcome;

namespace {

// ---------------------------------------------------------------- counting
/// A space like any other, by which the comparisons of boxes below are chosen: they count.
struct Counted : Space<double, 3> {};
std::uint64_t compared = 0;

// The library calls `scan` by its plain name; for boxes of this space these two are found, because they fit better.
template <class F> void scan(const Lot<Counted>& lot, std::size_t p, std::size_t first, std::size_t last, F&& found) {
    if (last > first) compared += last - first;
    for (std::size_t q = first; q < last; ++q) {
        bool touch = true;
        for (std::size_t k = 0; k < 3; ++k)
            touch = touch && lot[q].lower(k) <= lot[p].upper(k) && lot[p].lower(k) <= lot[q].upper(k);
        if (touch) found(q);
    }
}
template <class F>
void scan(const Boxes<Counted>& boxes, std::size_t p, std::size_t first, std::size_t last, F&& found) {
    if (last > first) compared += last - first;
    for (std::size_t q = first; q < last; ++q)
        if (boxes.touch(p, q)) found(q);
}

// ---------------------------------------------------------------- scenes
/// The same numbers with every standard library.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double between(double low, double high) { return low + (high - low) * double(engine_() >> 11) * 0x1p-53; }
    double bell() {
        return between(-1, 1) + between(-1, 1) + between(-1, 1);
    } // of variance 1, near enough to a normal one
    Eigen::Vector3d in_cube(double half) {
        Eigen::Vector3d x;
        for (int k = 0; k < 3; ++k) x[k] = between(-half, half);
        return x;
    }

private:
    std::mt19937_64 engine_;
};

/// Balls that drift: where they are in each of a few frames.
struct Scene {
    static constexpr int frames = 8;
    std::vector<double> radii; ///< m
    std::array<std::vector<Eigen::Vector3d>, frames> centres;

    int size() const { return int(radii.size()); }
    void add(Dice& dice, const Eigen::Vector3d& centre, double radius = 0.5) {
        const Eigen::Vector3d drift = dice.in_cube(0.05);
        radii.push_back(radius);
        for (int f = 0; f < frames; ++f) centres[std::size_t(f)].push_back(centre + f * drift);
    }
    template <class S> Boxes<S> boxes(int frame) const {
        Boxes<S> all;
        for (std::size_t i = 0; i < radii.size(); ++i) {
            const Eigen::Vector3d half = Eigen::Vector3d::Constant(radii[i]), &centre = centres[std::size_t(frame)][i];
            all.push_back(S::Position::from_value(centre - half), S::Position::from_value(centre + half));
        }
        all.set_active(all.size());
        return all;
    }
};

Scene uniform(int n) {
    Dice dice(std::uint64_t(n) + 1);
    Scene scene;
    for (int i = 0; i < n; ++i) scene.add(dice, dice.in_cube(0.5 * std::cbrt(n / 0.25)));
    return scene;
}
Scene clustered(int n) {
    Dice dice(std::uint64_t(n) + 2);
    Scene scene;
    Eigen::Vector3d cluster;
    for (int i = 0; i < n; ++i) {
        if (i % 100 == 0) cluster = dice.in_cube(std::cbrt(n / 0.25));
        Eigen::Vector3d beside;
        for (int k = 0; k < 3; ++k) beside[k] = 1.5 * dice.bell();
        scene.add(dice, cluster + beside);
    }
    return scene;
}
Scene column(int n) {
    Dice dice(std::uint64_t(n) + 3);
    Scene scene;
    for (int i = 0; i < n; ++i) {
        Eigen::Vector3d x = dice.in_cube(1);
        x[1] = dice.between(0, n);
        scene.add(dice, x);
    }
    return scene;
}
Scene mixed(int n) {
    Dice dice(std::uint64_t(n) + 4);
    Scene scene;
    for (int i = 0; i < n; ++i) {
        const Eigen::Vector3d x = dice.in_cube(2.5 * std::cbrt(n));
        scene.add(dice, x, 0.05 * std::pow(100.0, dice.between(0, 1)));
    }
    return scene;
}
/// Everybody within half a metre: whatever divides the world has nothing to divide.
Scene heap(int n) {
    Dice dice(std::uint64_t(n) + 5);
    Scene scene;
    for (int i = 0; i < n; ++i) scene.add(dice, dice.in_cube(0.25));
    return scene;
}

// ---------------------------------------------------------------- runs
/// A broadphase at work on a scene: each call is a step.
template <class P> class Search {
public:
    Search(std::shared_ptr<const Scene> scene, const P& policy) : scene_(std::move(scene)), bound_(policy) {}
    double operator()() {
        // Made at the first call: only the searches that are run need room for their boxes.
        if (boxes_.empty()) {
            for (int f = 0; f < Scene::frames; ++f) boxes_.push_back(scene_->boxes<Space<>>(f));
            for (const double radius : scene_->radii) balls_.emplace_back(Sphere{radius * metre});
        }
        // There and back again, so that the next step is always a small one.
        step_ = (step_ + 1) % (2 * Scene::frames - 2);
        const auto frame = std::size_t(step_ < Scene::frames ? step_ : 2 * Scene::frames - 2 - step_);
        const auto& centres = scene_->centres[frame];
        double depths = 0;
        bound_.find(boxes_[frame], [&](std::size_t i, std::size_t j) {
            Touch<Space<>> touch;
            if (collide(balls_[i], Space<>::Position::from_value(centres[i]), balls_[j],
                        Space<>::Position::from_value(centres[j]), touch))
                depths += touch.depth.value();
        });
        return depths;
    }

private:
    std::shared_ptr<const Scene> scene_;
    std::vector<Boxes<Space<>>> boxes_;
    std::vector<Sphere::In<Space<>>> balls_;
    typename P::template In<Space<>> bound_;
    int step_ = 0;
};

/// What a step compares, for one pair whose boxes touch; the mean over the frames.
template <class P> Outcome count(const Scene& scene, const P& policy, std::size_t touching) {
    typename P::template In<Counted> bound(policy);
    compared = 0;
    std::uint64_t told = 0;
    for (int f = 0; f < Scene::frames; ++f)
        bound.find(scene.boxes<Counted>(f), [&](std::size_t, std::size_t) { ++told; });
    const bool blind = compared == 0; // it tells every pair, and the test is the comparison
    const double all = double(blind ? told : compared);
    return {.error = all / double(touching),
            .work = std::round(all / Scene::frames),
            .diverged = !blind && told != touching};
}

/// Pairs whose boxes touch, in all frames.
std::size_t touching_boxes(const Scene& scene) {
    std::size_t n = 0;
    for (int f = 0; f < Scene::frames; ++f) n += find_pairs(SortAndSweep{}, scene.boxes<Space<>>(f)).size();
    return n;
}

const Axis broadphase{.name = "broadphase",
                      .error_norm = "pairs compared for one whose boxes touch",
                      .work_unit = "pairs compared",
                      .time_unit = "ns per body and step",
                      .has_order = false};
const Axis threshold{.name = "threshold",
                     .error_norm = broadphase.error_norm,
                     .work_unit = broadphase.work_unit,
                     .time_unit = broadphase.time_unit,
                     .has_order = false};

template <class P>
void add_row(Costs& costs, const Axis& axis, const char* choice, const std::string& problem,
             const workbook::Parameter& parameter, const std::shared_ptr<const Scene>& scene, std::size_t touching,
             const P& policy) {
    costs.add(axis, {.choice = choice,
                     .problem = problem,
                     .parameter = parameter,
                     .n = scene->size(),
                     .error_run = [=] { return count(*scene, policy, touching); },
                     .timed_run = [search = std::make_shared<Search<P>>(scene, policy)] { return (*search)(); },
                     .per = scene->size()});
}

using Scenes = std::vector<std::pair<std::shared_ptr<const Scene>, std::size_t>>;
template <class P>
void add_rows(Costs& costs, const char* choice, const std::string& problem, const Scenes& scenes, const P& policy,
              int most = 1 << 20) {
    for (const auto& [scene, touching] : scenes)
        if (scene->size() <= most) add_row(costs, broadphase, choice, problem, {}, scene, touching, policy);
}

void add_spread(Costs& costs, const std::string& problem, Scene (*make)(int), const std::vector<int>& numbers) {
    Scenes scenes;
    for (const int n : numbers) {
        auto scene = std::make_shared<const Scene>(make(n));
        const auto touching = touching_boxes(*scene);
        scenes.emplace_back(std::move(scene), touching);
    }
    constexpr int affordable = 4096; // of what grows with the square
    add_rows(costs, "AllPairs", problem, scenes, AllPairs{}, affordable);
    add_rows(costs, "BoundingBoxes", problem, scenes, BoundingBoxes{}, affordable);
    add_rows(costs, "UniformGrid", problem, scenes, UniformGrid{});
    add_rows(costs, "Octree", problem, scenes, Octree{});
    add_rows(costs, "BinarySplit", problem, scenes, BinarySplit{});
    add_rows(costs, "SortAndSweep", problem, scenes, SortAndSweep{});
    add_rows(costs, "UniformGrid<SortAndSweep>", problem, scenes, UniformGrid<SortAndSweep>{});
    add_rows(costs, "Octree<SortAndSweep>", problem, scenes, Octree<SortAndSweep>{});
}

// ---------------------------------------------------------------- what is made of the rows
/// From which number of bodies on `a` is faster than `b` by a twentieth, which is more than noise: between two
/// neighbours of the table, by powers.
struct Crossing {
    bool always = false, never = false;
    double n = 0;
};
std::optional<Crossing> crossing(const Rows& rows, const std::string& a, const std::string& b) {
    std::vector<std::pair<double, double>> points; // log n, log of how many times faster a is
    for (const workbook::Row& of_a : workbook::where(rows, &workbook::Row::choice, a))
        for (const workbook::Row& of_b : workbook::where(rows, &workbook::Row::choice, b))
            if (of_a.n && of_b.n && *of_a.n == *of_b.n && of_a.time && of_b.time)
                points.emplace_back(std::log(*of_a.n), std::log(*of_b.time / *of_a.time / 1.05));
    if (points.empty()) return {};
    if (!(points.back().second > 0)) return Crossing{.never = true};
    std::size_t last = points.size(); // where it is slower for the last time
    while (last > 0 && points[last - 1].second > 0) --last;
    if (last == 0) return Crossing{.always = true};
    const auto& [x0, y0] = points[last - 1];
    const auto& [x1, y1] = points[last];
    return Crossing{.n = std::exp(x0 + (x1 - x0) * (0 - y0) / (y1 - y0))};
}

void summarise(std::ostream& out, const Rows& all, const std::filesystem::path& folder) {
    const Rows rows = rows_of(all, broadphase.name);
    bool timed = false;
    for (const workbook::Row& row : rows) timed = timed || row.time;
    if (!timed) return;
    out << "\nFrom how many bodies on the first is faster than the second by more than 5 %:\n";
    const std::vector<std::pair<std::string, std::string>> contests{
        {"BoundingBoxes", "AllPairs"},     {"SortAndSweep", "AllPairs"},
        {"UniformGrid", "AllPairs"},       {"Octree", "AllPairs"},
        {"SortAndSweep", "BoundingBoxes"}, {"UniformGrid", "BoundingBoxes"},
        {"Octree", "BoundingBoxes"},       {"BinarySplit", "BoundingBoxes"},
        {"UniformGrid", "SortAndSweep"},   {"Octree", "SortAndSweep"},
        {"UniformGrid", "Octree"},         {"UniformGrid<SortAndSweep>", "UniformGrid"},
        {"Octree<SortAndSweep>", "Octree"}};
    const auto problems = workbook::different(rows, &workbook::Row::problem);
    out << "  " << std::left << std::setw(42) << "";
    for (const auto& problem : problems) out << std::right << std::setw(14) << problem.substr(0, problem.find(','));
    out << '\n';
    for (const auto& [a, b] : contests) {
        out << "  " << std::left << std::setw(42) << std::string(a).append(" : ").append(b);
        for (const auto& problem : problems) {
            const auto at = crossing(workbook::where(rows, &workbook::Row::problem, problem), a, b);
            out << std::right << std::setw(14)
                << (!at          ? ""
                    : at->always ? "always"
                    : at->never  ? "never"
                                 : workbook::grouped(std::stod(workbook::significant(at->n, 2))));
        }
        out << '\n';
    }
    for (const auto& problem : problems) {
        const Rows here = workbook::where(rows, &workbook::Row::problem, problem);
        workbook::Plot plot("", std::string("A step of every broadphase: ").append(problem));
        plot.x("bodies").y("ns per body and step").log_x().log_y();
        for (const auto& choice : workbook::different(here, &workbook::Row::choice)) {
            std::vector<double> n, time;
            for (const workbook::Row& row : workbook::where(here, &workbook::Row::choice, choice))
                if (row.time) n.push_back(*row.n), time.push_back(*row.time);
            if (!n.empty()) plot.linked_points(choice, n, time);
        }
        collision_costs::write(
            plot, folder,
            workbook::file_name(std::string("collision-broadphase-against-n-").append(problem, 0, problem.find(','))));
    }
}

} // namespace

void collision_costs::add_broadphase(Costs& costs) {
    const std::vector<int> numbers{16, 64, 256, 1024, 4096, 16384};
    add_spread(costs, "uniform, a quarter of a ball in each cubic metre", uniform, numbers);
    add_spread(costs, "clustered, a hundred in each of few places", clustered, numbers);
    add_spread(costs, "column, 2 m wide and as high as there are balls", column, numbers);
    add_spread(costs, "mixed radii, from 0.05 to 5 m", mixed, numbers);
    add_spread(costs, "one cell, everybody touches everybody", heap, {16, 64, 256, 1024});

    const auto scene = std::make_shared<const Scene>(clustered(4096));
    const auto touching = touching_boxes(*scene);
    const auto each_threshold = [&](const char* choice, auto with_threshold) {
        for (int most = 1; most <= 4096; most *= 2)
            add_row(costs, threshold, choice, "clustered, 4096 balls", {"threshold", double(most)}, scene, touching,
                    with_threshold(most));
    };
    each_threshold("Octree", [](int most) { return Octree<>{.threshold = most}; });
    each_threshold("Octree<SortAndSweep>", [](int most) { return Octree<SortAndSweep>{.threshold = most}; });
    each_threshold("BinarySplit", [](int most) { return BinarySplit<>{.threshold = most}; });
    costs.add_summary(summarise);
    costs.add_summary([](std::ostream&, const Rows& all, const std::filesystem::path& folder) {
        const Rows rows = rows_of(all, threshold.name);
        workbook::Plot plot("", "The threshold of a cell: too low is sorting, too high is comparing");
        plot.x("threshold").y("ns per body and step").log_x().log_y();
        bool any = false;
        for (const auto& choice : workbook::different(rows, &workbook::Row::choice)) {
            std::vector<double> x, y;
            for (const workbook::Row& row : workbook::where(rows, &workbook::Row::choice, choice))
                if (row.time) x.push_back(*row.parameter.value), y.push_back(*row.time);
            if (!x.empty()) plot.linked_points(choice, x, y), any = true;
        }
        if (any) collision_costs::write(plot, folder, "collision-threshold");
    });
}
