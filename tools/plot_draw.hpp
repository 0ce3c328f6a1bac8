// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How a `Plot` becomes commands of gnuplot. Included by `plot.hpp`, whose half a reader wants.

#include "plot.hpp"

namespace ansatz::workbook {

/// The curve with at most about `most` points, for a file of sensible size: of every run of
/// neighbours the lowest and the highest stay, in order, so that no peak is lost.
inline std::vector<std::pair<double, double>> thinned(const std::vector<std::pair<double, double>>& points,
                                                      std::size_t most) {
    if (points.size() <= most) return points;
    const std::size_t runs = most / 2;
    std::vector<std::pair<double, double>> kept{points.front()};
    for (std::size_t run = 0; run < runs; ++run) {
        const auto begin = points.begin() + static_cast<std::ptrdiff_t>(run * points.size() / runs);
        const auto end = points.begin() + static_cast<std::ptrdiff_t>((run + 1) * points.size() / runs);
        auto [low, high] = std::minmax_element(begin, end, [](auto& a, auto& b) { return a.second < b.second; });
        if (high < low) std::swap(low, high);
        kept.push_back(*low);
        if (high != low) kept.push_back(*high);
    }
    kept.push_back(points.back());
    return kept;
}

inline bool Plot::nothing_to_draw() const {
    for (const Curve& curve : curves_)
        for (const auto& [x, y] : curve.points)
            if (std::isfinite(x) && std::isfinite(y) && (!x_.logarithmic || x > 0) && (!y_.logarithmic || y > 0))
                return false;
    return true;
}

/// The first and the last x that the picture shows.
inline std::pair<double, double> Plot::shown_x() const {
    if (x_.range) return *x_.range;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Curve& curve : curves_)
        for (const auto& point : curve.points) {
            if (!std::isfinite(point.first)) continue;
            low = std::min(low, point.first);
            high = std::max(high, point.first);
        }
    return {low, high};
}

/// References are dark grey and do not use up a colour.
inline std::string Plot::colour_of(std::size_t curve) const {
    if (curves_[curve].style == Style::reference) return "#444444";
    std::size_t coloured = 0;
    for (std::size_t i = 0; i < curve; ++i) coloured += curves_[i].style != Style::reference;
    return colour(coloured);
}

inline void Plot::axes(std::ostream& s) const {
    const auto one = [&](char letter, const Axis& axis) {
        const std::string unit = axis.unit.value_or("");
        s << "set " << letter << "label " << in_quotes(unit.empty() ? axis.what : axis.what + " (" + unit + ")")
          << " noenhanced textcolor rgb '#333333'\n";
        if (axis.logarithmic) s << "set logscale " << letter << " 10\nset format " << letter << " '10^{%L}'\n";
        else s << "set format " << letter << " '%h'\n";
        if (axis.range) s << "set " << letter << "range [" << number(axis.range->first) << ':' << number(axis.range->second) << "]\n";
    };
    one('x', x_);
    one('y', y_);
    if (!x_.range && !x_.logarithmic) s << "set autoscale xfix\n";   // curves begin and end at the frame
    if (equal_axes_) s << "set size ratio -1\nset autoscale\nset offsets graph 0.04, graph 0.04, graph 0.04, graph 0.04\n";
}

/// One row of samples under the title, left-aligned, wrapped where the picture ends. gnuplot's own key
/// spreads its entries over the width; a reader finds a curve faster where they stand together.
inline void Plot::legend(std::ostream& s, double width, double height) const {
    const double per_letter = 7.4, sample = 24, gap = 26, left = 22;   // pixels at font size 13
    double x = left, y = 66;
    std::size_t rows = curves_.empty() ? 0 : 1;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const Curve& curve = curves_[i];
        const double needs = sample + 7 + per_letter * static_cast<double>(visible_width(curve.name));
        if (x > left && x + needs > width - left) { x = left; y += 22; ++rows; }
        const auto at = [&](double px) { return "screen " + number(px / width) + ", screen " + number(1 - y / height); };
        if (curve.style != Style::points)
            s << "set arrow from " << at(x) << " to " << at(x + sample) << " nohead front lw 2.5 lc rgb '" << colour_of(i) << "'"
              << (curve.style == Style::reference ? " dt (8,6)\n" : "\n");
        if (curve.style == Style::points || curve.style == Style::linked_points)
            s << "set label '' at " << at(x + sample / 2) << " front point pt " << point_shape(i) << " ps 0.8 lc rgb '" << colour_of(i) << "'\n";
        s << "set label " << in_quotes(curve.name) << " at " << at(x + sample + 7) << " left front noenhanced font ',13' textcolor rgb '#333333'\n";
        x += needs + gap;
    }
    const double top = 58 + 22 * static_cast<double>(rows) + 12;
    s << "set tmargin at screen " << number(1 - top / height) << '\n';
}

inline void Plot::marks(std::ostream& s) const {
    const auto [first, last] = shown_x();
    for (const Mark& mark : marks_) {
        const bool in_the_right_part = x_.logarithmic ? mark.x * mark.x > first * last : mark.x > (first + last) / 2;
        const std::string text = " noenhanced front font ',13' textcolor rgb '#555555'\n";
        const std::string style = " nohead lw 1.5 lc rgb '#888888' dt (2,4)\n";
        const std::string beside = in_the_right_part ? " right offset -0.6,0" : " left offset 0.6,0";
        switch (mark.kind) {
        case Mark::vertical:
            s << "set arrow from first " << number(mark.x) << ", graph 0 to first " << number(mark.x) << ", graph 1" << style;
            s << "set label " << in_quotes(mark.text) << " at first " << number(mark.x) << ", graph 0.96" << beside << text;
            break;
        case Mark::horizontal:
            s << "set arrow from graph 0, first " << number(mark.y) << " to graph 1, first " << number(mark.y) << style;
            s << "set label " << in_quotes(mark.text) << " at graph 0.99, first " << number(mark.y) << " right offset 0,0.6" << text;
            break;
        case Mark::note:
            s << "set label " << in_quotes(mark.text) << " at " << number(mark.x) << ", " << number(mark.y) << beside
              << " point pt 6 ps 0.9 lc rgb '#555555'" << text;
            break;
        }
    }
}

/// The curves as named blocks: `$curve0`, `$curve1`, ...
inline void Plot::data(std::ostream& s, std::size_t most) const {
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        s << "$curve" << i << " << END\n";
        for (const auto& [x, y] : thinned(curves_[i].points, most)) s << number(x) << ' ' << number(y) << '\n';
        s << "END\n";
    }
}

inline std::string Plot::script() const {
    const int width = 800, height = 500;
    std::ostringstream s;
    s << house_style(width, height);
    // A claim that is too long for one line is set smaller.
    const std::size_t letters = visible_width(title_);
    s << "set label " << in_quotes(title_) << " at screen " << number(22.0 / width) << ", screen " << number(1 - 32.0 / height)
      << " left front noenhanced font '," << (letters <= 72 ? 18 : letters <= 86 ? 15 : 13) << "' textcolor rgb '#222222'\n";
    axes(s);
    legend(s, width, height);
    marks(s);
    data(s, 3000);
    s << "set bmargin 4\nset rmargin 4\n";
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const Curve& curve = curves_[i];
        s << (i == 0 ? "plot " : ", ") << "$curve" << i << " using 1:2 with ";
        switch (curve.style) {
        case Style::line: s << "lines lw 2.5"; break;
        case Style::reference: s << "lines lw 2 dt (8,6)"; break;
        case Style::points: s << "points pt " << point_shape(i) << " ps 0.7"; break;
        case Style::linked_points: s << "linespoints lw 2 pt " << point_shape(i) << " ps 0.7"; break;
        }
        s << " lc rgb '" << colour_of(i) << "'";
    }
    s << '\n';
    return s.str();
}

inline bool Plot::write() const {
    if (nothing_to_draw()) {
        std::clog << "picture skipped: " << name_ << " has no point that its axes can show\n";
        return false;
    }
    return draw(picture_folder() / (name_ + ".svg"), script());
}

inline bool Plot::terminal() const {
    if (nothing_to_draw() || !gnuplot_installed()) return false;
    std::ostringstream s;
    s << "set encoding utf8\nset terminal dumb size 78,20 noenhanced mono\nset key below\nset tics nomirror scale 0.5\nset border 3\n"
      << "set title " << in_quotes(title_) << "\n";
    axes(s);
    data(s, 400);
    for (std::size_t i = 0; i < curves_.size(); ++i)
        s << (i == 0 ? "plot " : ", ") << "$curve" << i << " using 1:2 with "
          << (curves_[i].style == Style::points ? "points" : "lines") << " title " << in_quotes(curves_[i].name);
    s << '\n';
    // Letters only: gnuplot begins a page with a form feed and fills its lines with spaces.
    return run_gnuplot(s.str(), "gnuplot | tr -d '\\f' | sed 's/ *$//' | sed '/./,$!d'");
}

}  // namespace ansatz::workbook
