// SPDX-License-Identifier: BSL-1.0
// 4.9 A flag that tears: a spring that breaks takes its triangles with it, and vertices split

// Springs that break are not yet a tear. The wind goes on blowing on the triangles beside them, hinges go on holding,
// and whole triangles hang together by a vertex. So a sheet that tears knows its triangles: one whose spring has broken
// is torn, with its sail and its hinges, and where whole ones hang together by a vertex alone, it splits. (A part of
// section 4, which the notes do not divide.)

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <numeric>
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
    const auto blow = [&](double seconds) {
        for (int i = 0; i < int(60 * seconds); ++i) {
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

    workbook::Plot plot("4.9", "A flag in a breeze, and in a storm from 2 s on");
    plot.x("time").y("torn, and blown away", "");
    plot.line("triangles that are torn", times, torn).line("bodies that are off", times, off).write();
    return claim.result();
}
