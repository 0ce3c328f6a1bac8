// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Shapes as they lie in the plane, for the pictures of this chapter: circles, boxes, arrows, all of one colour in one
/// curve of a Plot. Lengths are in metres.

#include "plot.hpp"

#include <ansatz/units.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace scenes {

using Point = ansatz::Vector<double, 2>;

/// A drawing of lines that need not hang together.
class Strokes {
public:
    /// \param corners a Plot thins out a curve of more than 3000 points: fewer where there are many circles
    Strokes& circle(const Point& centre, double radius, int corners = 64) {
        for (int i = 0; i <= corners; ++i) {
            const double angle = 2 * M_PI * i / corners;
            to({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
        }
        return lift();
    }
    Strokes& box(const Point& low, const Point& high) {
        for (const Point& corner : std::array<Point, 5>{low, {high[0], low[1]}, high, {low[0], high[1]}, low})
            to(corner);
        return lift();
    }
    Strokes& line(const Point& from, const Point& end) {
        to(from);
        to(end);
        return lift();
    }
    /// A line with a head at its end.
    Strokes& arrow(const Point& from, const Point& end) {
        line(from, end);
        const Point along = end - from, back = end - 0.18 * along, aside(-0.07 * along[1], 0.07 * along[0]);
        to(back + aside);
        to(end);
        to(back - aside);
        return lift();
    }
    /// Puts them into a picture.
    void draw(ansatz::workbook::Plot& plot, const std::string& name) const { plot.line(name, x_, y_); }

private:
    void to(const Point& point) {
        x_.push_back(point[0]);
        y_.push_back(point[1]);
    }
    Strokes& lift() {
        constexpr double gap = std::numeric_limits<double>::quiet_NaN();
        to({gap, gap});
        return *this;
    }

    std::vector<double> x_, y_;
};

} // namespace scenes
