// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The shapes of a frame of film.hpp: each becomes faces of whole pixels, and the faces of a frame a few paths.

#include "film.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>

namespace ansatz::workbook {

namespace film {

/// No two numbers that a scene is made of differ by this part of a unit: a place that is symmetric by rights is not
/// rounded to one side by one compiler and to the other by the next.
inline constexpr double odd = 0.01237;
inline int rounded(double value) { return int(std::floor(value + 0.5 + odd)); }

/// A number of the style sheet, with as many digits as it has, nine at most.
inline std::string digits(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.9g", value);
    return text.data();
}
/// Text between tags.
inline std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '&') safe += "&amp;";
        else if (c == '<') safe += "&lt;";
        else if (c == '>') safe += "&gt;";
        else safe += c;
    }
    return safe;
}

/// A colour in one of eight shades, from dark to light; 5 is the colour itself.
inline std::string shaded(unsigned colour, int shade) {
    shade = std::clamp(shade, 0, 7);
    std::array<char, 8> text{};
    unsigned mixed = 0;
    for (const int at : {16, 8, 0}) {
        const int part = int(colour >> at & 0xffU);
        const int made = shade <= 5 ? part * (10 + 2 * shade) / 20 : part + (255 - part) * (shade - 5) / 5;
        mixed |= unsigned(made) << at;
    }
    std::snprintf(text.data(), text.size(), "#%06x", mixed);
    return text.data();
}

/// The colour of row j of so many: the farthest is almost as light as the air, the nearest dark.
inline std::string hazy(unsigned colour, std::size_t j, std::size_t rows) {
    const int part = int(100 * j / (rows - 1)); // per cent of the way
    std::array<char, 8> text{};
    unsigned mixed = 0;
    for (const int at : {16, 8, 0}) {
        const int pure = int(colour >> at & 0xffU), light = pure + (255 - pure) * 55 / 100, dark = pure * 62 / 100;
        mixed |= unsigned(light + (dark - light) * part / 100) << at;
    }
    std::snprintf(text.data(), text.size(), "#%06x", mixed);
    return text.data();
}

/// Twice the area that three pixels enclose; positive where they turn to one side.
template <class P> long turn(const P& a, const P& b, const P& c) {
    return long(b.x - a.x) * (c.y - a.y) - long(b.y - a.y) * (c.x - a.x);
}
/// The convex polygon around some pixels (Andrew's monotone chain), without its first one again.
template <class P> std::vector<P> convex_hull(std::vector<P> points) {
    const auto before = [](const P& a, const P& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    const auto same = [](const P& a, const P& b) { return a.x == b.x && a.y == b.y; };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    if (points.size() < 3) return points;
    std::vector<P> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = hull.size();
        for (const P& p : points) {
            while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}
/// Whether two convex polygons have more than their borders in common: no edge of one has the other on its far side.
template <class P> bool overlap(const std::vector<P>& a, const std::vector<P>& b) {
    const auto separated = [](const std::vector<P>& by, const std::vector<P>& from) {
        for (std::size_t i = 0; i < by.size(); ++i) {
            const P &p = by[i], &q = by[(i + 1) % by.size()];
            if (std::all_of(from.begin(), from.end(), [&](const P& r) { return turn(p, q, r) <= 0; })) return true;
        }
        return by.empty();
    };
    return !separated(a, b) && !separated(b, a);
}
/// A line without the points that lie within a unit of what is left (Douglas and Peucker, 1973).
template <class P> void thin(std::span<const P> line, std::vector<P>& kept) {
    const P first = line.front(), last = line.back();
    std::size_t far = 0;
    double most = 0.8;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const double length = std::hypot(double(last.x - first.x), double(last.y - first.y));
        const double off = length > 0 ? double(std::abs(turn(first, last, line[i]))) / length
                                      : std::hypot(double(line[i].x - first.x), double(line[i].y - first.y));
        if (off > most) most = off, far = i;
    }
    if (far == 0) {
        kept.push_back(last);
        return;
    }
    thin(line.subspan(0, far + 1), kept);
    thin(line.subspan(far), kept);
}
template <class P> std::vector<P> thinned(const std::vector<P>& line) {
    if (line.size() < 3) return line;
    std::vector<P> kept{line.front()};
    thin(std::span<const P>(line), kept);
    return kept;
}
/// Numbers of a path, without a blank where a sign separates them.
inline void put(std::string& path, int number) {
    if (!path.empty() && number >= 0 && path.back() >= '0' && path.back() <= '9') path += ' ';
    path += std::to_string(number);
}
} // namespace film

inline std::string Frame::where() const {
    if (time_ < 0) return "the scenery";
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", time_);
    const auto& all = film_->frames_;
    std::size_t index = 0;
    while (index < all.size() && &all[index] != this) ++index;
    return "frame " + std::to_string(index) + " (" + text.data() + " s)";
}
inline void Frame::refuse(const std::string& why) const { film_->refuse(where() + ": " + why); }

/// Every shape passes here first: its points are numbers.
inline void Frame::begin(const char* what, const Points& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (!std::isfinite(points[i][k]))
                refuse(std::string{what} + ": " + "xyz"[k] + " of point " + std::to_string(i) + " is " +
                       std::to_string(points[i][k]) + "; the points of a film are finite");
    if (points.empty()) refuse(std::string{what} + " of no point");
    added_.emplace_back(what, points.size());
}
inline Frame::Pixel Frame::pixel(const Point& p) const {
    double across = 0, high = 0;
    const std::array middle{plain(x(film_->view_.middle)), plain(y(film_->view_.middle)),
                            plain(z(film_->view_.middle))};
    for (std::size_t k = 0; k < 3; ++k) {
        across += (p[k] - middle[k]) * film_->right_[k];
        high += (p[k] - middle[k]) * film_->up_[k];
    }
    // What is far outside is as good as a little outside, and fits into an int.
    const auto bounded = [](double value) { return film::rounded(std::clamp(value, -1e6, 1e6)); };
    const int seen = film_->tall() - Film::title_height;
    return {bounded(Film::wide / 2.0 + across * film_->scale_),
            bounded(Film::title_height + seen / 2.0 - high * film_->scale_)};
}

/// Keeps a shape that is in the picture.
inline void Frame::keep(Shape shape, std::size_t first_point) {
    if (shape.kind == Shape::ball) {
        const auto [x, y] = shape.points[0];
        const int r = shape.radius;
        shape.hull = {{x - r, y - r}, {x + r, y - r}, {x + r, y + r}, {x - r, y + r}};
    } else shape.hull = film::convex_hull(shape.points);
    const auto outside = [&](const Pixel& p) { return p.x < 0 || p.y < 0 || p.x > Film::wide || p.y > film_->tall(); };
    const auto& points = shape.kind == Shape::ball ? shape.hull : shape.points;
    for (std::size_t i = 0; i < points.size() && !film_->may_leave_ && time_ >= 0; ++i)
        if (outside(points[i]))
            refuse(added_.back().first + ": point " + std::to_string(first_point + i) + " is at " +
                   std::to_string(points[i].x) + ", " + std::to_string(points[i].y) + " of a picture of " +
                   std::to_string(Film::wide) + " x " + std::to_string(film_->tall()) +
                   "; widen the view, or say may_leave()");
    const auto all = [&](auto&& past) { return std::all_of(points.begin(), points.end(), past); };
    if (all([](const Pixel& p) { return p.x < 0; }) || all([](const Pixel& p) { return p.y < 0; }) ||
        all([](const Pixel& p) { return p.x > Film::wide; }) ||
        all([&](const Pixel& p) { return p.y > film_->tall(); }))
        return;
    shapes_.push_back(std::move(shape));
}

/// A flat piece of a surface, in the shade of how it stands to the light. Corners run to the left seen from its front.
inline void Frame::face(const Points& corners, const Paint& paint, bool cull) {
    const auto less = [](const Point& a, const Point& b) { return Point{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
    const auto dot = [](const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const auto &a = corners[0], &b = corners[1], &c = corners[2], &d = corners.back();
    const Point p = less(c, a), q = corners.size() == 4 ? less(d, b) : less(c, b);
    const Point n{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    const double size = std::sqrt(dot(n, n));
    if (!(size > 0)) return;
    const bool back = dot(n, film_->toward_) < -1e-9 * size;
    if (back && cull) return;
    double lit = 0, depth = 0;
    for (std::size_t k = 0; k < 3; ++k) { // from above, on the left of the viewer
        lit += n[k] / size * (-0.40 * film_->right_[k] + 0.74 * film_->up_[k] + 0.54 * film_->toward_[k]);
        for (const Point& corner : corners) depth += corner[k] * film_->toward_[k];
    }
    const int shade = std::clamp(film::rounded(2.6 + 4.5 * (back ? -lit : lit)), 0, 7);
    Shape shape{.style = film_->style_of(paint, shade, back, ""),
                .depth = film::rounded(depth / double(corners.size()) * film_->scale_)};
    for (const Point& corner : corners) shape.points.push_back(pixel(corner));
    keep(std::move(shape), 0);
}
inline Frame& Frame::add_sheet(const Points& points, std::size_t columns, const Paint& paint) {
    begin("sheet", points);
    if (columns < 2 || points.size() % columns != 0 || points.size() < 2 * columns)
        refuse("sheet: " + std::to_string(points.size()) + " points are no rows of " + std::to_string(columns));
    for (std::size_t i = 0; i + columns < points.size(); ++i)
        if (i % columns + 1 < columns)
            face({points[i], points[i + 1], points[i + columns + 1], points[i + columns]}, paint, false);
    return *this;
}
inline Frame& Frame::add_mesh(const Points& points, const std::vector<std::array<std::uint32_t, 3>>& triangles,
                              const Paint& paint, bool closed) {
    begin("mesh", points);
    for (const auto& t : triangles)
        for (const auto corner : t)
            if (corner >= points.size())
                refuse("mesh: a triangle names point " + std::to_string(corner) + " of " +
                       std::to_string(points.size()));
    for (const auto& [a, b, c] : triangles) face({points[a], points[b], points[c]}, paint, closed);
    return *this;
}
inline Frame& Frame::add_ball(const Points& centre, double radius, const Paint& paint) {
    begin("ball", centre);
    if (!(radius > 0) || !std::isfinite(radius)) refuse("ball: its radius is " + std::to_string(radius) + " m");
    double depth = 0;
    for (std::size_t k = 0; k < 3; ++k) depth += centre[0][k] * film_->toward_[k];
    keep({.style = film_->style_of(paint, 0, false, "g"),
          .kind = Shape::ball,
          .depth = film::rounded(depth * film_->scale_),
          .radius = film::rounded(radius * film_->scale_),
          .points = {pixel(centre[0])}},
         0);
    return *this;
}
inline Frame& Frame::add_box(const Points& of, const Paint& paint) {
    begin("box", of);
    const Point &m = of[0], &h = of[1];
    const std::size_t before = shapes_.size();
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            Points corners(4, m);
            const std::array<std::array<double, 2>, 4> around{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
            for (std::size_t i = 0; i < 4; ++i) {
                corners[i][axis] += side * h[axis];
                corners[i][u] += side * around[i][0] * h[u];
                corners[i][v] += around[i][1] * h[v];
            }
            face(corners, paint, true);
        }
    double depth = 0; // all of it where its middle is
    for (std::size_t k = 0; k < 3; ++k) depth += m[k] * film_->toward_[k];
    for (std::size_t i = before; i < shapes_.size(); ++i) shapes_[i].depth = film::rounded(depth * film_->scale_);
    return *this;
}
inline Frame& Frame::add_line(const Points& points, const Paint& paint) {
    begin("line", points);
    if (points.size() < 2) refuse("line: it has one point");
    Shape shape{.style = film_->style_of(paint, 0, false, "l"), .kind = Shape::line};
    double depth = 0;
    for (const Point& p : points) {
        shape.points.push_back(pixel(p));
        for (std::size_t k = 0; k < 3; ++k) depth += p[k] * film_->toward_[k];
    }
    shape.depth = film::rounded(depth / double(points.size()) * film_->scale_);
    shape.points = film::thinned(shape.points);
    keep(std::move(shape), 0);
    return *this;
}
inline Frame& Frame::add_filled(const Points& points, double down_to, const Paint& paint) {
    return add_rows(points, points.size(), down_to, paint);
}
inline Frame& Frame::add_rows(const Points& points, std::size_t columns, double down_to, const Paint& paint) {
    begin("rows", points);
    if (columns < 2 || points.size() % columns != 0)
        refuse("rows: " + std::to_string(points.size()) + " points are no rows of " + std::to_string(columns));
    const std::size_t rows = points.size() / columns;
    for (std::size_t j = 0; j < rows; ++j) {
        Shape shape{.style = rows == 1 ? film_->style_of(paint, 5, false, "") : film_->style_of_row(paint, j, rows)};
        double depth = 0;
        for (std::size_t i = 0; i < columns; ++i) {
            const Point& p = points[columns * j + i];
            shape.points.push_back(pixel(p));
            depth += p[0] * film_->toward_[0] + p[2] * film_->toward_[2];
        }
        shape.points = film::thinned(shape.points);
        shape.depth = film::rounded((depth / double(columns) + down_to * film_->toward_[1]) * film_->scale_);
        for (const std::size_t end : {columns * (j + 1) - 1, columns * j})
            shape.points.push_back(pixel({points[end][0], down_to, points[end][2]}));
        keep(std::move(shape), columns * j);
    }
    return *this;
}
inline Frame& Frame::add_shadow(const Points& points, double level) {
    begin("shadow", points);
    Shape shape{.style = "s", .depth = INT_MIN};
    for (const Point& p : points) shape.points.push_back(pixel({p[0], level, p[2]}));
    shape.points = film::convex_hull(shape.points);
    keep(std::move(shape), 0);
    return *this;
}
inline Frame& Frame::add_ground(const Points& corners, double lines) {
    begin("ground", corners);
    const Point &a = corners[0], &b = corners[1];
    if (!(lines > 0) || !(b[0] > a[0]) || !(b[2] > a[2])) refuse("ground: its corners or its lines are no ground");
    const auto at = [&](double x, double z) { return pixel({x, a[1], z}); };
    keep({.style = "e", .depth = INT_MIN, .points = {at(a[0], a[2]), at(b[0], a[2]), at(b[0], b[2]), at(a[0], b[2])}},
         0);
    for (double x = a[0]; x <= b[0] + 1e-9; x += lines)
        keep({.style = "r", .kind = Shape::line, .depth = INT_MIN, .points = {at(x, a[2]), at(x, b[2])}}, 0);
    for (double z = a[2]; z <= b[2] + 1e-9; z += lines)
        keep({.style = "r", .kind = Shape::line, .depth = INT_MIN, .points = {at(a[0], z), at(b[0], z)}}, 0);
    return *this;
}

inline Frame& Frame::add_note(const Points& at, std::string text) {
    begin("note", at);
    const auto [x, y] = pixel(at[0]);
    notes_ +=
        "<text x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\">" + film::escaped(text) + "</text>";
    return *this;
}

/// From the farthest to the nearest. A face joins an earlier path of its style where nothing between would be
/// drawn over it or under it: that takes most of the letters out.
inline std::string Frame::drawn() const {
    std::vector<const Shape*> order;
    for (const Shape& shape : shapes_) order.push_back(&shape);
    std::stable_sort(order.begin(), order.end(), [](const Shape* a, const Shape* b) { return a->depth < b->depth; });
    struct Path {
        std::string style;
        std::vector<const Shape*> shapes;
    };
    std::vector<Path> paths;
    for (const Shape* shape : order) {
        bool joined = false;
        for (auto path = paths.rbegin(); path != paths.rend() && shape->kind != Shape::ball; ++path) {
            if (std::any_of(path->shapes.begin(), path->shapes.end(),
                            [&](const Shape* other) { return film::overlap(other->hull, shape->hull); }))
                break;
            if (path->style != shape->style) continue;
            path->shapes.push_back(shape);
            joined = true;
            break;
        }
        if (!joined) paths.push_back({shape->style, {shape}});
    }
    std::string text;
    for (const auto& [style, shapes] : paths) {
        if (shapes[0]->kind == Shape::ball) {
            const auto [x, y] = shapes[0]->points[0];
            text += "<circle class=\"" + style + "\" cx=\"" + std::to_string(x) + "\" cy=\"" + std::to_string(y) +
                    "\" r=\"" + std::to_string(shapes[0]->radius) + "\"/>";
            continue;
        }
        std::string path;
        Pixel at;
        for (const Shape* shape : shapes) {
            path += path.empty() ? "M" : "m"; // numbers after an absolute M are absolute: the first is alone
            const Pixel begin = shape->points[0];
            film::put(path, begin.x - at.x);
            film::put(path, begin.y - at.y);
            at = begin;
            if (path[0] == 'M' && shape == shapes[0]) path += 'l';
            for (std::size_t i = 1; i < shape->points.size(); ++i) {
                film::put(path, shape->points[i].x - at.x);
                film::put(path, shape->points[i].y - at.y);
                at = shape->points[i];
            }
            if (shape->kind == Shape::face) path += 'z', at = begin;
        }
        text += "<path class=\"" + style + "\" d=\"" + path + "\"/>";
    }
    return text + notes_;
}

} // namespace ansatz::workbook
