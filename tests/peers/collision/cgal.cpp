// SPDX-License-Identifier: BSL-1.0
// CGAL's box_self_intersection_d, with the cutoff of 100 that was found best for it.

#include "tests/peers/collision/spheres.hpp"
#include "tests/peers/versions.hpp"

#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>

static const peers::Version version("CGAL", CGAL_VERSION_STR);

peers::Broadphase peers::cgal_box_intersection(const Spheres&) {
    using Box = CGAL::Box_intersection_d::Box_d<double, 3>;
    auto boxes = std::make_shared<std::vector<Box>>();
    return [boxes](const Spheres& spheres, int frame) {
        boxes->clear();
        for (std::size_t i = 0; i < spheres.start.size(); ++i) {
            auto low = spheres.at(i, frame), high = low;
            for (std::size_t k = 0; k < 3; ++k) low[k] -= spheres.radius[i], high[k] += spheres.radius[i];
            boxes->emplace_back(low.data(), high.data());
        }
        std::size_t pairs = 0;
        CGAL::box_self_intersection_d(
            boxes->begin(), boxes->end(), [&](const Box&, const Box&) { ++pairs; }, std::ptrdiff_t(100));
        return pairs;
    };
}
