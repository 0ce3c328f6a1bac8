// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Tiles of a map in a frame of film.hpp. Those side by side in a row are one dashed line, a dash for each tile: so the
/// many tiles of a search take few letters of the file, and each is seen all the same.

#include "film_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace ansatz::workbook {

/// The class of tiles that are so many units wide, with a gap of two between them.
inline std::string Film::style_of_tiles(const Paint& paint, int side) {
    const auto style = std::string{letter_of(paint)} + "t" + std::to_string(side), dash = std::to_string(side - 2);
    styles_[style] = "fill:none;stroke-width:" + dash + ";stroke-dasharray:" + dash +
                     " 2;stroke:" + film::shaded(paint.front, 5) +
                     (paint.opacity != 100 ? ";stroke-opacity:" + film::digits(paint.opacity / 100.0) : "");
    return style;
}

inline Frame& Frame::add_tiles(const Points& middles, double side, const Paint& paint) {
    begin("tiles", middles);
    const double units = side * film_->scale_;
    const int whole = film::rounded(units);
    if (!(std::abs(units - whole) < 1e-6) || whole < 4)
        refuse("tiles: they are " + film::digits(units) + " units wide; take a view of which they are whole numbers, " +
               "four at least: of width Film::wide / 18.0 * metre a metre is 18");
    if (film_->right_ != Point{1, 0, 0} || film_->up_ != Point{0, 1, 0}) refuse("tiles are seen from the front only");
    std::vector<Pixel> all;
    for (const Point& middle : middles) all.push_back(pixel(middle));
    // Row by row, from left to right, each tile once.
    const auto before = [](const Pixel& a, const Pixel& b) { return std::array{a.y, a.x} < std::array{b.y, b.x}; };
    const auto same = [](const Pixel& a, const Pixel& b) { return a.x == b.x && a.y == b.y; };
    std::sort(all.begin(), all.end(), before);
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    const auto style = film_->style_of_tiles(paint, whole);
    const int half = whole / 2 - 1; // of a tile, without the gap
    // A line for each row of neighbours, from `first` up to `next`.
    for (std::size_t first = 0, next = 0; first < all.size(); first = next) {
        while (next < all.size() && all[next].y == all[first].y &&
               all[next].x - all[first].x <= int(next - first) * whole)
            ++next;
        const int begin = all[first].x - half, end = begin + int(next - first) * whole - 2;
        keep({.style = style, .kind = Shape::line, .points = {{begin, all[first].y}, {end, all[first].y}}}, first);
    }
    return *this;
}

} // namespace ansatz::workbook
