// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Pictures for the programs of the course. A section says what is to be seen, with quantities, and
/// gnuplot draws it in the house's style:
///
/// \code
/// Plot{"1.6.1", "Explicit Euler gains energy at every step"}
///     .x("time").y("energy")
///     .line("explicit Euler", times, energies)                     // containers of quantities
///     .reference("closed form", times, [&](Time t) { return e0; }) // or a function of the first
///     .write();
/// \endcode
///
/// The axes take their units from the data; a second curve in another unit is refused. Pictures are
/// named after the section's number: `1.6.1`, or `1.6.1-phase` where a section draws several.
/// Not provided: bars, surfaces. What moves is a film: film.hpp.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "gnuplot.hpp"
#include "plain.hpp"

namespace ansatz::workbook {

/// A picture of curves over one pair of axes.
class Plot {
public:
    /// \param name  the picture's file, without folder and ending; it begins with the section's number
    /// \param title the claim that the picture shows, as a sentence
    Plot(std::string name, std::string title) : name_{std::move(name)}, title_{std::move(title)} {}

    /// What an axis shows. The unit comes from the data; for plain numbers it may be given here.
    Plot& x(std::string what, std::string unit = {}) { return describe(x_, std::move(what), std::move(unit)); }
    Plot& y(std::string what, std::string unit = {}) { return describe(y_, std::move(what), std::move(unit)); }

    Plot& log_x() {
        x_.logarithmic = true;
        return *this;
    }
    Plot& log_y() {
        y_.logarithmic = true;
        return *this;
    }

    /// The part of an axis to show; without it everything is shown.
    template <class Value> Plot& x_range(Value from, Value to) { return limit(x_, from, to); }
    template <class Value> Plot& y_range(Value from, Value to) { return limit(y_, from, to); }

    /// One metre as long on the page in both directions: for paths in space and orbits.
    Plot& equal_axes() {
        equal_axes_ = true;
        return *this;
    }

    /// A curve. `ys` is a container as long as `xs`, or a function of one element of `xs`.
    template <class Xs, class Ys> Plot& line(std::string name, const Xs& xs, const Ys& ys) {
        return add(Style::line, std::move(name), xs, ys);
    }
    /// Single points, for measurements.
    template <class Xs, class Ys> Plot& points(std::string name, const Xs& xs, const Ys& ys) {
        return add(Style::points, std::move(name), xs, ys);
    }
    /// A curve through marked points, where there are few of them.
    template <class Xs, class Ys> Plot& linked_points(std::string name, const Xs& xs, const Ys& ys) {
        return add(Style::linked_points, std::move(name), xs, ys);
    }
    /// What the others are held against (a closed form, a law): dashed, dark, behind nothing.
    template <class Xs, class Ys> Plot& reference(std::string name, const Xs& xs, const Ys& ys) {
        return add(Style::reference, std::move(name), xs, ys);
    }

    /// Filled squares around their centres, for the tiles of a map; the first ones are dark, others light. What comes
    /// after them is drawn over them.
    template <class Xs, class Ys, class Side> Plot& tiles(std::string name, const Xs& xs, const Ys& ys, Side side) {
        take_unit<Side>(x_, name);
        add(Style::tiles, std::move(name), xs, ys);
        curves_.back().side = plain(side);
        return *this;
    }

    /// A dotted line across the picture at one value, with a word beside it; and a word at a point.
    template <class Value> Plot& vertical(Value at, std::string text) {
        take_unit<Value>(x_, text);
        marks_.push_back({Mark::vertical, plain(at), 0, std::move(text)});
        return *this;
    }
    template <class Value> Plot& horizontal(Value at, std::string text) {
        take_unit<Value>(y_, text);
        marks_.push_back({Mark::horizontal, 0, plain(at), std::move(text)});
        return *this;
    }
    template <class X, class Y> Plot& note(X at_x, Y at_y, std::string text) {
        take_unit<X>(x_, text);
        take_unit<Y>(y_, text);
        marks_.push_back({Mark::note, plain(at_x), plain(at_y), std::move(text)});
        return *this;
    }

    /// Draws `<name>.svg` into the folder for pictures. False, with one line said, where it cannot.
    bool write() const;

    /// Draws a compact plot in letters between the lines of the program's output.
    bool terminal() const;

    /// The commands that `write` gives to gnuplot: for tests, and for whoever wants another format.
    [[nodiscard]] std::string script() const;

private:
    enum class Style { line, points, linked_points, reference, tiles };
    struct Axis {
        std::string what;
        std::optional<std::string> unit;
        bool logarithmic = false;
        std::optional<std::pair<double, double>> range;
    };
    struct Curve {
        Style style;
        std::string name;
        std::vector<std::pair<double, double>> points;
        double side = 0; ///< of a tile
    };
    struct Mark {
        enum Kind { vertical, horizontal, note } kind;
        double x, y;
        std::string text;
    };

    template <class Xs, class Ys> Plot& add(Style style, std::string name, const Xs& xs, const Ys& ys) {
        using X = std::decay_t<decltype(*std::begin(xs))>;
        Curve curve{style, std::move(name), {}, 0};
        if constexpr (std::is_invocable_v<const Ys&, const X&>) {
            using Y = std::decay_t<std::invoke_result_t<const Ys&, const X&>>;
            take_unit<Y>(y_, curve.name);
            for (const X& x : xs) curve.points.emplace_back(plain(x), plain(ys(x)));
        } else {
            using Y = std::decay_t<decltype(*std::begin(ys))>;
            take_unit<Y>(y_, curve.name);
            auto y = std::begin(ys);
            for (const X& x : xs) {
                if (y == std::end(ys)) refuse("'" + curve.name + "' has fewer values than places");
                curve.points.emplace_back(plain(x), plain(*y));
                ++y;
            }
            if (y != std::end(ys)) refuse("'" + curve.name + "' has more values than places");
        }
        take_unit<X>(x_, curve.name);
        curves_.push_back(std::move(curve));
        return *this;
    }

    /// The first data of an axis name its unit, everything after must agree: metres and seconds on
    /// one axis are a mistake that no picture should hide.
    template <class Value> void take_unit(Axis& axis, const std::string& whose) {
        // Plain numbers say nothing about the unit, so they fit an axis whose unit was given in words.
        if constexpr (requires { typename Value::unit_type; }) {
            const std::string unit = unit_of<Value>();
            if (axis.unit && *axis.unit != unit)
                refuse("'" + whose + "' is in [" + unit + "], and its axis is in [" + *axis.unit + "]");
            axis.unit = unit;
        }
    }

    template <class Value> Plot& limit(Axis& axis, Value from, Value to) {
        take_unit<Value>(axis, axis.what + " (range)");
        axis.range = {plain(from), plain(to)};
        return *this;
    }
    Plot& describe(Axis& axis, std::string what, std::string unit) {
        axis.what = std::move(what);
        if (!unit.empty()) axis.unit = std::move(unit);
        return *this;
    }
    [[noreturn]] void refuse(const std::string& why) const {
        throw std::invalid_argument("Plot " + name_ + ": " + why);
    }

    [[nodiscard]] bool nothing_to_draw() const;
    [[nodiscard]] std::pair<double, double> extent(char axis) const;
    [[nodiscard]] std::string colour_of(std::size_t curve) const;
    void axes(std::ostream&) const;
    void logarithmic_axis(std::ostream&, char letter, const Axis& axis) const;
    void legend(std::ostream&, double width, double height) const;
    void marks(std::ostream&) const;
    void data(std::ostream&, std::size_t most) const;

    std::string name_, title_;
    Axis x_, y_;
    bool equal_axes_ = false;
    std::vector<Curve> curves_;
    std::vector<Mark> marks_;
};

} // namespace ansatz::workbook

#include "plot_draw.hpp"
