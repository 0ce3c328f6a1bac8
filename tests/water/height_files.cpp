// SPDX-License-Identifier: BSL-1.0
// A map as an image and as a mesh, read back here by their own descriptions.

#include <ansatz/water/height_files.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <Eigen/Geometry>

#include <sstream>

using namespace ansatz;
using namespace ansatz::test;
using Catch::Approx;

namespace {
using Length = Quantity<unit::Length>;
HeightMap<> slope() {
    return HeightMap<>::of(4, 3, 0.5 * metre, 2.0 * metre,
                           [](Length x, Length z) { return 3.0 * x - 0.25 * z + 0.1 * metre; });
}
} // namespace

TEST_CASE("an image holds each height to half a grey value, with the largest z on top", "[water]") {
    const auto map = slope();
    std::stringstream file;
    write_pgm(file, map, -1.0 * metre, 5.0 * metre);
    std::string kind;
    std::size_t width = 0, height = 0, most = 0;
    file >> kind >> width >> height >> most;
    REQUIRE(kind == "P5");
    REQUIRE(width == 4);
    REQUIRE(height == 3);
    REQUIRE(most == 65535);
    REQUIRE(file.get() == '\n');
    for (std::size_t row = 0; row < height; ++row)
        for (std::size_t i = 0; i < width; ++i) {
            const int large = file.get(), small = file.get();
            const double y = -1 + 6.0 * (256 * large + small) / 65535;
            CHECK(y == Approx(map(i, height - 1 - row).value()).margin(6.0 / 65535 / 2 * 1.0001));
        }
    CHECK(file.get() == std::char_traits<char>::eof());

    std::stringstream cut, level;
    write_pgm(cut, map, 0.2 * metre, 0.3 * metre); // what lies outside is cut
    CHECK(cut.str().size() == std::string("P5\n4 3\n65535\n").size() + 24);
    write_pgm(level, HeightMap<float>(2, 2, 1.0 * metre, 1.0 * metre));
    CHECK(level.str() == std::string("P5\n2 2\n65535\n") + std::string(8, '\0'));
    for (const double flat_at :
         {-1e17, -3.0, 1e308}) { // where a metre more is nothing, and where twice as much is none
        std::stringstream flat;
        write_pgm(flat,
                  HeightMap<>::of(2, 2, 1.0 * metre, 1.0 * metre, [&](Length, Length) { return flat_at * metre; }));
        CHECK(flat.str() == level.str());
    }
    std::stringstream far_apart;
    write_pgm(far_apart, HeightMap<>::of(3, 2, 1.0 * metre, 1.0 * metre,
                                         [&](Length x, Length) { return 1.5e308 * (x.value() - 1) * metre; }));
    CHECK(far_apart.str().substr(far_apart.str().size() - 6) == std::string("\0\0\x80\0\xff\xff", 6));
    CHECK(refusal([&] { write_pgm(level, map, 1.0 * metre, 1.0 * metre); }) ==
          "write_pgm: high is 1 m; white is higher than black, low = 1 m");
}

TEST_CASE("a mesh has the map's points, its normals, and triangles that face up and cover it once", "[water]") {
    const auto map = slope();
    std::stringstream file;
    write_obj(file, map);
    std::vector<Vector<double, 3>> points, normals;
    double covered = 0;
    int triangles = 0;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v" || kind == "vn") {
            Vector<double, 3> v;
            words >> v[0] >> v[1] >> v[2];
            (kind == "v" ? points : normals).push_back(v);
        } else {
            REQUIRE(kind == "f");
            std::size_t corner[3];
            for (auto& c : corner) {
                std::size_t normal = 0;
                char slash = 0;
                words >> c >> slash >> slash >> normal;
                REQUIRE(c >= 1);
                REQUIRE(c <= points.size());
                CHECK(normal == c);
                --c;
            }
            const auto a = points[corner[0]], b = points[corner[1]], c = points[corner[2]];
            const Vector<double, 3> up = (b - a).cross(c - a);
            CHECK(up[1] > 0);
            CHECK((up.normalized() - normals[corner[0]]).norm() < 1e-5); // a plane has one normal; six digits of it
            covered += up[1] / 2;
            ++triangles;
        }
    }
    REQUIRE(points.size() == 12);
    REQUIRE(normals.size() == 12);
    CHECK(triangles == 12);
    CHECK(covered == Approx(1.5 * 4).epsilon(1e-14));
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(points[j * 4 + i][0] == map.x(i).value());
            CHECK(points[j * 4 + i][1] == map(i, j).value()); // every digit
            CHECK(points[j * 4 + i][2] == map.z(j).value());
        }
}
