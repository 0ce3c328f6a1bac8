// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Films for the programs of the course: what moves is seen moving. A section adds a frame now and then, and the film
/// is an SVG that plays by itself, in a page or alone, and needs no script, no library and no gnuplot:
///
/// \code
/// Film film("4.3", "A level sheet is let go", "A square of cloth falls, swings and hangs from two corners.",
///           {.middle = metres(0.5, -0.4, 0), .width = 2.2 * metre, .height = 1.4 * metre, .above = degrees(15)});
/// for (int n = 0; n <= 240; ++n) {
///     if (n % 6 == 0) film.frame(world.time()).sheet(places, columns, paints::cloth);
///     world.step(1.0 / 120 * second);
/// }
/// film.write(); // 4.3-film.svg, and 4.3-sheet.svg: six of its frames side by side, for print and to look at
/// \endcode
///
/// Each frame is one line of the file, `<g id="f12" ...>`, and the same letters in every run: places are rounded to
/// half a pixel of the page, and depths and shades as coarsely, so that the last digits in which compilers differ are
/// gone. What is symmetric would lie exactly between two roundings; so all is shifted by an odd part of a unit first.
/// Frames that are kept (docs/pictures) are compared by tests/tools/recordings.sh.
///
/// Bodies are drawn from the farthest to the nearest, by the middle of each face (the painter's algorithm): what
/// intersects is drawn wrongly. Not provided: perspective, textures, turning balls.

#include <ansatz/units.hpp>

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "plain.hpp"

namespace ansatz::workbook {

/// A colour of both sides of what is drawn, 0xRRGGBB, and how much it hides.
struct Paint {
    unsigned front, back;
    int opacity = 100; ///< per cent
    auto operator<=>(const Paint&) const = default;
};

/// The colours of the house's pictures, as things.
namespace paints {
inline constexpr Paint cloth{0x2b83ba, 0xe3a23c}, flag{0xd0532b, 0xe9b44c}, ball{0xd55e00, 0xd55e00},
    rubber{0x009e73, 0x00724f}, stone{0x6b7480, 0x6b7480}, wood{0xc98a3d, 0x9a6a2d}, sea{0x2f8fc4, 0x1f6a94},
    water{0x3a9ad0, 0x3a9ad0, 62}, wire{0x222222, 0x222222};
} // namespace paints

/// What of the world a film shows: a box of width x height around a middle, seen from far away. Without a turn one
/// looks against z, x to the right and y up; `turn` walks around it to the right, `above` climbs.
struct View {
    VectorQuantity<unit::Length> middle = metres(0, 0, 0);
    Quantity<unit::Length> width = 1.0 * metre, height = 1.0 * metre;
    Quantity<unit::PlaneAngle> turn = degrees(0), above = degrees(0);
};

class Film;

/// One frame, or the scenery behind all of them. Shapes take containers of positions (quantities).
class Frame {
public:
    /// A grid of points, row by row, as a surface of two sides: cloth.
    template <class Points> Frame& sheet(const Points& points, std::size_t columns, const Paint& paint) {
        return add_sheet(in_metres(points), columns, paint);
    }
    /// Triangles of three numbers each. Of a closed surface that faces outwards only the near side is drawn.
    template <class Points, class Triangles>
    Frame& mesh(const Points& points, const Triangles& triangles, const Paint& paint, bool closed = false) {
        std::vector<std::array<std::uint32_t, 3>> all;
        for (const auto& [a, b, c] : triangles) all.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
        return add_mesh(in_metres(points), all, paint, closed);
    }
    template <class Point> Frame& ball(const Point& centre, Quantity<unit::Length> radius, const Paint& paint) {
        return add_ball(in_metres(std::array{centre}), radius.value(), paint);
    }
    /// An upright box, by its middle and half of its sides.
    template <class Point, class Half> Frame& box(const Point& middle, const Half& half, const Paint& paint) {
        return add_box(in_metres(std::array{middle, Point(half)}), paint);
    }
    /// A line through points.
    template <class Points> Frame& line(const Points& points, const Paint& paint) {
        return add_line(in_metres(points), paint);
    }
    /// What is under a line of points, down to a level: water from the side.
    template <class Points> Frame& filled(const Points& points, Quantity<unit::Length> down_to, const Paint& paint) {
        return add_filled(in_metres(points), down_to.value(), paint);
    }
    /// A grid of points, row by row, as one filled line for each row: water from above, the farther the lighter.
    template <class Points>
    Frame& rows(const Points& points, std::size_t columns, Quantity<unit::Length> down_to, const Paint& paint) {
        return add_rows(in_metres(points), columns, down_to.value(), paint);
    }
    /// Square tiles of a map by their middles, seen from the front. In the view a tile is a whole number of units.
    template <class Points> Frame& tiles(const Points& middles, Quantity<unit::Length> side, const Paint& paint) {
        return add_tiles(in_metres(middles), side.value(), paint);
    }
    /// The shadow of some points on level ground, as that of one convex thing.
    template <class Points> Frame& shadow(const Points& points, Quantity<unit::Length> level) {
        return add_shadow(in_metres(points), level.value());
    }
    /// Level ground between two corners, with lines each so many metres; for the scenery.
    template <class Point> Frame& ground(const Point& from, const Point& to, Quantity<unit::Length> lines) {
        return add_ground(in_metres(std::array{from, to}), lines.value());
    }

    /// A few words that begin at a place, in front of everything.
    template <class Point> Frame& note(const Point& at, std::string text) {
        return add_note(in_metres(std::array{at}), std::move(text));
    }

private:
    friend class Film;
    using Point = std::array<double, 3>; ///< m
    using Points = std::vector<Point>;
    struct Pixel {
        int x = 0, y = 0;
    };
    struct Shape {
        std::string style; ///< its class in the file
        enum Kind { face, line, ball } kind = face;
        int depth = 0, radius = 0; ///< depth: the larger, the nearer
        std::vector<Pixel> points = {};
        std::vector<Pixel> hull = {}; ///< convex, around all of it
    };

    Frame(Film& film, double time) : film_{&film}, time_{time} {}

    template <class Range> static Points in_metres(const Range& range) {
        Points points;
        for (const auto& p : range) {
            if constexpr (requires { z(p); }) points.push_back({plain(x(p)), plain(y(p)), plain(z(p))});
            else points.push_back({plain(x(p)), plain(y(p)), 0.0});
        }
        return points;
    }
    Frame& add_sheet(const Points&, std::size_t columns, const Paint&);
    Frame& add_mesh(const Points&, const std::vector<std::array<std::uint32_t, 3>>&, const Paint&, bool closed);
    Frame& add_ball(const Points&, double radius, const Paint&);
    Frame& add_box(const Points&, const Paint&);
    Frame& add_line(const Points&, const Paint&);
    Frame& add_filled(const Points&, double down_to, const Paint&);
    Frame& add_rows(const Points&, std::size_t columns, double down_to, const Paint&);
    Frame& add_tiles(const Points&, double side, const Paint&);
    Frame& add_shadow(const Points&, double level);
    Frame& add_ground(const Points&, double lines);
    Frame& add_note(const Points&, std::string text);

    void begin(const char* what, const Points&);
    Pixel pixel(const Point&) const;
    void face(const Points&, const Paint&, bool cull);
    void keep(Shape, std::size_t first_point);
    [[noreturn]] void refuse(const std::string& why) const;
    [[nodiscard]] std::string where() const;
    [[nodiscard]] std::string drawn() const;

    Film* film_;
    double time_;                                            ///< s; negative for the scenery
    std::vector<std::pair<std::string, std::size_t>> added_; ///< what, of how many points
    std::vector<Shape> shapes_;
    std::string notes_;
};

/// A film: a scenery, frames at equal distances in time, and how they are played.
class Film {
public:
    /// \param number  of its section; `<number>-film.svg` is written, or with a word, "4.9-storm", that
    /// \param title   what is seen, as a sentence; stands above the picture
    /// \param told    the same for who does not see it: what moves, from where to where
    /// \param view    what of the world
    /// \throws std::invalid_argument for a view without an area
    Film(std::string number, std::string title, std::string told, const View& view);
    Film(const Film&) = delete; // frames know their film
    Film& operator=(const Film&) = delete;

    /// Frames a second, 20 without it. Played as fast as time goes where frames are that far apart.
    Film& rate(double frames_a_second) {
        rate_ = frames_a_second;
        return *this;
    }
    /// For how many frames the last one stays before the film begins again; 12 without it, 0 for what is periodic.
    Film& hold(std::size_t frames) {
        hold_ = frames;
        return *this;
    }
    /// What a second of its frames' times stands for, where they count something: "turns" of a search.
    Film& counts(std::string what) {
        counted_ = std::move(what);
        return *this;
    }
    /// Things may leave the picture; without it they are refused.
    Film& may_leave() {
        may_leave_ = true;
        return *this;
    }
    /// Things may come, go and have more points than before; without it they are refused.
    Film& may_change() {
        may_change_ = true;
        return *this;
    }
    /// The frame that is seen where nothing moves; the one in the middle without it.
    Film& still(std::size_t frame) {
        still_ = frame;
        return *this;
    }

    /// What is drawn once, behind all frames.
    Frame& scenery() { return scenery_; }
    /// The next frame. Frames are equally far apart, so that none is lost unseen.
    Frame& frame(Quantity<unit::Time> time);
    /// What is drawn in it, until the next one.
    [[nodiscard]] std::size_t frames() const { return frames_.size(); }

    /// The film and the contact sheet, as they are written.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::string sheet(std::size_t pictures = 6) const;

    /// Writes both into the folder for pictures. False, with one line said, where it cannot.
    /// \throws std::invalid_argument where there is no frame, or the film has more than 150 kB
    bool write(std::size_t pictures_of_sheet = 6) const;

    static constexpr int wide = 1280;              ///< units of the picture, two to a pixel of the page
    static constexpr int title_height = 60;        ///< units of it above what is seen
    static constexpr std::size_t largest = 150000; ///< bytes of a film

private:
    friend class Frame;
    [[nodiscard]] int tall() const { return tall_; }
    [[nodiscard]] std::string style_of(const Paint&, int shade, bool back, const char* kind);
    [[nodiscard]] std::string style_of_tiles(const Paint&, int side);
    [[nodiscard]] std::string style_of_row(const Paint&, std::size_t j, std::size_t rows);
    char letter_of(const Paint&);
    [[nodiscard]] std::string styles() const;
    [[nodiscard]] std::string gradients() const;
    [[nodiscard]] std::string head(int width, int height, const std::string& rules) const;
    [[nodiscard]] std::string stamp(const Frame&, int height) const;
    [[nodiscard]] std::string name(const char* what) const;
    [[noreturn]] void refuse(const std::string& why) const;
    void check() const;

    std::string number_, title_, told_, counted_;
    View view_;
    Frame::Point right_{}, up_{}, toward_{}; ///< of the viewer
    double scale_ = 1;                       ///< units a metre
    int tall_ = 0;
    double rate_ = 20;
    std::size_t hold_ = 12;
    bool may_leave_ = false, may_change_ = false;
    std::size_t still_ = std::size_t(-1);
    std::map<Paint, char> paints_;
    std::map<std::string, std::string> styles_; ///< by class
    Frame scenery_;
    std::deque<Frame> frames_;
};

} // namespace ansatz::workbook

#include "film_draw.hpp"
