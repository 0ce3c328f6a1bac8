// SPDX-License-Identifier: BSL-1.0
// 4.9 A flag that tears: a spring that breaks takes its triangles with it, and vertices split

// Springs that break are not yet a tear. The wind goes on blowing on the triangles beside them, hinges go on holding,
// and whole triangles hang together by a vertex. So a sheet that tears knows its triangles: one whose spring has broken
// is torn, with its sail and its hinges, and where whole ones hang together by a vertex alone, it splits. (A part of
// section 4, which the notes do not divide.)

#include "claims.hpp"
#include "film.hpp"
#include "plot.hpp"

#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

using namespace ansatz;

namespace {

constexpr std::size_t columns = 19, rows = 13;

/// A flag of 0.9 m x 0.6 m at a pole, its side at x = 0.
Cloth flag() {
    //! [flag]
    Cloth cloth{.mesh = TriangleMesh::grid(columns, rows, metres(0.9, 0, 0), metres(0, 0.6, 0)),
                .mass_per_area = 0.12 * kilogram / square_metre,
                .structural = {.stiffness = 600.0 * newton_per_metre,
                               .damping = 0.02 * newton_second_per_metre,
                               .breaks = breaks_at(0.2)},
                .shear = {.stiffness = 150.0 * newton_per_metre,
                          .damping = 0.02 * newton_second_per_metre,
                          .breaks = breaks_at(0.3)},
                .drag = 0.4,
                .lift = 1.0};
    //! [flag]
    for (std::size_t j = 0; j < rows; ++j) cloth.pins.push_back(std::uint32_t(columns * j));
    return cloth;
}

template <class World_> Quantity<unit::Mass> mass_of(const World_& world) {
    Quantity<unit::Mass> sum{};
    world.for_each([&](Handle body) {
        if (world.motion(body) == Motion::awake) sum += world.mass(body);
    });
    return sum;
}
/// How many bodies do not hang at the pole any more, by any spring.
template <class World_> std::size_t blown_off(const World_& world) {
    std::vector<std::size_t> to(world.handles().back().id + 1U);
    std::iota(to.begin(), to.end(), 0U);
    const auto root = [&](std::size_t i) {
        while (to[i] != i) i = to[i] = to[to[i]];
        return i;
    };
    std::size_t pole = to.size();
    world.for_each([&](Handle body) {
        if (world.motion(body) != Motion::fixed) return;
        if (pole == to.size()) pole = body.id;
        to[root(body.id)] = root(pole);
    });
    world.template elements<Spring>().for_each(
        [&](std::uint32_t, const auto& link) { to[root(link.a)] = root(link.b); });
    std::size_t off = 0;
    world.for_each([&](Handle body) { off += root(body.id) != root(pole); });
    return off;
}

/// Draws what is left of a flag: the cells of its grid that are whole, single triangles of those that are not, and the
/// threads between them.
template <class World_> void draw(workbook::Frame& frame, const World_& world, const ClothParts& parts) {
    using workbook::paints::flag;
    std::set<std::pair<std::uint32_t, std::uint32_t>> within; // two bodies of one face
    const auto face = [&](const auto& corners) {
        std::vector<VectorQuantity<unit::Length>> places;
        for (const Handle one : corners) {
            places.push_back(world.position(one));
            for (const Handle other : corners) within.insert({one.id, other.id});
        }
        if (places.size() == 3) frame.mesh(places, std::array<std::array<int, 3>, 1>{{{0, 1, 2}}}, flag);
        else frame.sheet(places, 2, flag);
    };
    for (std::size_t i = 0; i < parts.tearable.size(); i += 2) { // the two triangles of a cell
        std::vector<std::array<Handle, 3>> whole;
        for (const std::size_t k : {i, i + 1}) // what is torn has lost its sail
            if (world.contains(parts.sails[k])) whole.push_back(world.get(parts.tearable[k]).corners);
        const auto alone = [&](std::size_t k, std::size_t other) { // a corner that the other one has not
            std::size_t n = 0;
            while (n < 2 && std::count(whole[other].begin(), whole[other].end(), whole[k][n]) > 0) ++n;
            return n;
        };
        if (whole.size() == 2) {
            const auto& one = whole[0];
            const std::size_t n = alone(0, 1), m = alone(1, 0);
            const std::array<Handle, 4> cell{one[(n + 2) % 3], one[n], whole[1][m], one[(n + 1) % 3]}; // row by row
            const auto shared = [&](Handle h) { return std::count(whole[1].begin(), whole[1].end(), h) > 0; };
            if (shared(cell[0]) && shared(cell[3])) {
                face(cell);
                continue;
            }
        }
        for (const auto& triangle : whole) face(triangle);
    }
    for (const SpringHandle thread : world.template elements<Spring>().handles()) {
        const Spring it = world.get(thread);
        const Handle a = it.first.body(), b = it.second.body();
        if (world.motion(a) == Motion::fixed && world.motion(b) == Motion::fixed) continue; // along the pole
        if (within.count({a.id, b.id}) == 0) frame.line(std::array{world.position(a), world.position(b)}, flag);
    }
}

} // namespace

int main() {
    workbook::Claims claim;
    //! [world]
    World field{SemiImplicitEuler{},
                Gravity{},
                Springs<Breaking>{},
                Xpbd{.substeps = 12},
                Wind{metres_per_second(6, 0, 0.3)},
                Tearing<Splitting>{.room = 400}};
    //! [world]
    const auto parts = add_cloth(field, flag());
    const auto mass = mass_of(field);
    std::vector<Quantity<unit::Time>> times;
    std::vector<double> torn, off;
    workbook::Film film("4.9", "A storm tears a flag: two and a half times slower",
                        "A flag waves at a pole in a breeze. When the storm comes it tears, first at the lower end of "
                        "the pole and then "
                        "all along it; the flag flies away, and a net of threads with a few scraps flutters on.",
                        {.middle = metres(0.72, 0.27, 0),
                         .width = 1.75 * metre,
                         .height = 1.0 * metre,
                         .turn = degrees(-25),
                         .above = degrees(14)});
    film.rate(12).may_leave().may_change();
    film.scenery().box(metres(-0.012, 0.2, 0), metres(0.012, 0.45, 0.012), workbook::paints::wood);
    const auto blow = [&](double seconds) {
        for (int i = 0; i < int(60 * seconds); ++i) {
            if (field.tick() % 2 == 0 && field.tick() >= 114 && film.frames() < 36)
                draw(film.frame(field.time()), field, parts);
            field.step(1.0 / 60 * second);
            times.push_back(field.time());
            torn.push_back(double(field.tearing().torn));
            off.push_back(double(blown_off(field)));
        }
    };
    const auto report = [&](const char* what) {
        const auto status = field.tearing();
        std::cout << "   " << std::setw(18) << what << std::setw(8) << field.elements<Spring>().size() << std::setw(9)
                  << field.elements<Sail>().size() << std::setw(8) << status.torn << std::setw(8) << status.split
                  << std::setw(11) << blown_off(field) << '\n';
    };
    std::cout << "                        springs   sails    torn   split  blown off\n";
    blow(2);
    report("a breeze");
    claim("in a breeze the flag holds", field.tearing().torn == 0);
    //! [storm]
    field.set(Wind{metres_per_second(26, 0, 2)});
    //! [storm]
    blow(1.5);
    report("a storm");
    const auto status = field.tearing();
    claim("in a storm it tears", status.torn > 10);
    claim("each torn triangle has taken its sail with it",
          field.elements<Sail>().size() + status.torn == parts.sails.size());
    claim("vertices have split", status.split > 0 && field.size() == parts.bodies.size() + status.split);
    claim("and there was room for all of them", status.waiting == 0);
    claim("nothing of its mass is lost", abs(mass_of(field) / mass - 1.0) < 1e-12);
    claim("pieces are blown away", blown_off(field) > 0);
    claim("and something is left at the pole", blown_off(field) < field.size() - rows);

    film.still(8).write(9);
    workbook::Plot plot("4.9", "A flag in a breeze, and in a storm from 2 s on");
    plot.x("time").y("torn, and blown away", "");
    plot.line("triangles that are torn", times, torn).line("bodies that are off", times, off).write();
    return claim.result();
}
