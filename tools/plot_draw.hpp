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

/// The smallest and the largest x or y of the data that its axis can show.
inline std::pair<double, double> Plot::extent(char letter) const {
    const bool positive = (letter == 'x' ? x_ : y_).logarithmic;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Curve& curve : curves_)
        for (const auto& [x, y] : curve.points) {
            const double value = letter == 'x' ? x : y;
            if (!std::isfinite(value) || (positive && value <= 0)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    return {low, high};
}

/// References are dark grey and tiles have colours of their own, so that they do not use up one.
inline std::string Plot::colour_of(std::size_t curve) const {
    if (curves_[curve].style == Style::reference) return "#444444";
    std::size_t coloured = 0, tiles = 0;
    for (std::size_t i = 0; i < curve; ++i) {
        tiles += curves_[i].style == Style::tiles;
        coloured += curves_[i].style != Style::reference && curves_[i].style != Style::tiles;
    }
    static constexpr std::array<std::string_view, 4> of_tiles{"#59616b", "#c8d9ea", "#f0d9bf", "#d5e6c9"};
    if (curves_[curve].style == Style::tiles) return std::string(of_tiles[std::min<std::size_t>(tiles, 3)]);
    return colour(coloured);
}

/// "m^2/s^2" as it is printed in books: "m²/s²".
inline std::string with_superscripts(const std::string& unit) {
    static constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const auto is_digit = [&](std::size_t at) { return at < unit.size() && unit[at] >= '0' && unit[at] <= '9'; };
        if (unit[i] != '^' || !is_digit(i + 1)) {
            text += unit[i];
            continue;
        }
        for (; is_digit(i + 1); ++i) text += digits[static_cast<std::size_t>(unit[i + 1] - '0')];
    }
    return text;
}

/// A logarithmic axis shows its data and a little room, not whole decades. Over few decades their powers would label it
/// hardly at all, so 1, 2 and 5 of each decade do, and every digit where less than one decade is shown.
inline void Plot::logarithmic_axis(std::ostream& s, char letter, const Axis& axis) const {
    const auto [low, high] = axis.range ? *axis.range : extent(letter);
    const double room = axis.range ? 1 : std::max(std::pow(high / low, 0.04), 1.1);
    s << "set logscale " << letter << " 10\nset " << letter << "range [" << number(low / room) << ':'
      << number(high * room) << "]\n";
    if (high / low > 100) {
        s << "set format " << letter << " '10^{%L}'\n";
        return;
    }
    s << "set " << letter << "tics (";
    const char* separator = "";
    for (int decade = static_cast<int>(std::floor(std::log10(low))); decade <= std::ceil(std::log10(high)); ++decade)
        for (int digit = 1; digit < 10; ++digit) {
            if (digit != 1 && digit != 2 && digit != 5 && high / low > 4) continue;
            const std::string value = std::to_string(digit) + "e" + std::to_string(decade);
            s << separator << value;
            separator = ", ";
        }
    s << ")\nset format " << letter << " '%h'\n";
}

inline void Plot::axes(std::ostream& s) const {
    const auto one = [&](char letter, const Axis& axis) {
        const std::string unit = with_superscripts(axis.unit.value_or(""));
        s << "set " << letter << "label " << in_quotes(unit.empty() ? axis.what : axis.what + " (" + unit + ")")
          << " noenhanced textcolor rgb '#333333'\n";
        if (axis.logarithmic) {
            logarithmic_axis(s, letter, axis);
            return;
        }
        s << "set format " << letter << " '%h'\n";
        if (axis.range)
            s << "set " << letter << "range [" << number(axis.range->first) << ':' << number(axis.range->second)
              << "]\n";
    };
    one('x', x_);
    one('y', y_);
    if (!x_.range && !x_.logarithmic) s << "set autoscale xfix\n"; // curves begin and end at the frame
    if (equal_axes_) s << "set size ratio -1\n";
    if (equal_axes_ && !x_.range && !y_.range)
        s << "set autoscale\nset offsets graph 0.04, graph 0.04, graph 0.04, graph 0.04\n";
}

/// One row of samples under the title, left-aligned, wrapped where the picture ends. gnuplot's own key
/// spreads its entries over the width; a reader finds a curve faster where they stand together.
inline void Plot::legend(std::ostream& s, double width, double height) const {
    const double per_letter = 7.4, sample = 24, gap = 26, left = 22; // pixels at font size 13
    double x = left, y = 66;
    std::size_t rows = curves_.empty() ? 0 : 1;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const Curve& curve = curves_[i];
        const double needs = sample + 7 + per_letter * static_cast<double>(visible_width(curve.name));
        if (x > left && x + needs > width - left) {
            x = left;
            y += 22;
            ++rows;
        }
        const auto at = [&](double px) {
            return "screen " + number(px / width) + ", screen " + number(1 - y / height);
        };
        if (curve.style == Style::tiles)
            s << "set label '' at " << at(x + sample / 2) << " front point pt 5 ps 1.6 lc rgb '" << colour_of(i)
              << "'\n";
        else if (curve.style != Style::points)
            s << "set arrow from " << at(x) << " to " << at(x + sample) << " nohead front lw 2.5 lc rgb '"
              << colour_of(i) << "'" << (curve.style == Style::reference ? " dt (8,6)\n" : "\n");
        if (curve.style == Style::points || curve.style == Style::linked_points)
            s << "set label '' at " << at(x + sample / 2) << " front point pt " << point_shape(i) << " ps 0.8 lc rgb '"
              << colour_of(i) << "'\n";
        s << "set label " << in_quotes(curve.name) << " at " << at(x + sample + 7)
          << " left front noenhanced font ',13' textcolor rgb '#333333'\n";
        x += needs + gap;
    }
    const double top = 58 + 22 * static_cast<double>(rows) + 12;
    s << "set tmargin at screen " << number(1 - top / height) << '\n';
}

inline void Plot::marks(std::ostream& s) const {
    const auto [first, last] = x_.range ? *x_.range : extent('x');
    for (const Mark& mark : marks_) {
        const bool in_the_right_part = x_.logarithmic ? mark.x * mark.x > first * last : mark.x > (first + last) / 2;
        const std::string text = " noenhanced front font ',13' textcolor rgb '#555555'\n";
        const std::string style = " nohead lw 1.5 lc rgb '#888888' dt (2,4)\n";
        const std::string beside = in_the_right_part ? " right offset -0.6,0" : " left offset 0.6,0";
        switch (mark.kind) {
        case Mark::vertical:
            s << "set arrow from first " << number(mark.x) << ", graph 0 to first " << number(mark.x) << ", graph 1"
              << style;
            s << "set label " << in_quotes(mark.text) << " at first " << number(mark.x) << ", graph 0.96" << beside
              << text;
            break;
        case Mark::horizontal:
            s << "set arrow from graph 0, first " << number(mark.y) << " to graph 1, first " << number(mark.y) << style;
            s << "set label " << in_quotes(mark.text) << " at graph 0.99, first " << number(mark.y)
              << " right offset 0,0.6" << text;
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
        const bool all = curves_[i].style == Style::tiles; // a wall without some of its tiles is another wall
        for (const auto& [x, y] : thinned(curves_[i].points, all ? curves_[i].points.size() : most))
            s << number(x) << ' ' << number(y) << '\n';
        s << "END\n";
    }
}

inline std::string Plot::script() const {
    const int width = 800, height = 500;
    std::ostringstream s;
    s << house_style(width, height);
    // A claim that is too long for one line is set smaller.
    const std::size_t letters = visible_width(title_);
    s << "set label " << in_quotes(title_) << " at screen " << number(22.0 / width) << ", screen "
      << number(1 - 32.0 / height) << " left front noenhanced font ',"
      << (letters <= 72   ? 18
          : letters <= 86 ? 15
                          : 13)
      << "' textcolor rgb '#222222'\n";
    axes(s);
    legend(s, width, height);
    marks(s);
    data(s, 3000);
    s << "set bmargin 4\nset rmargin 4\n";
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const Curve& curve = curves_[i];
        s << (i == 0 ? "plot " : ", ") << "$curve" << i << " using 1:2";
        const std::string half = "(" + number(curve.side / 2) + ")";
        if (curve.style == Style::tiles) s << ':' << half << ':' << half;
        s << " with ";
        switch (curve.style) {
        case Style::line: s << "lines lw 2.5"; break;
        case Style::reference: s << "lines lw 2 dt (8,6)"; break;
        case Style::points: s << "points pt " << point_shape(i) << " ps 0.7"; break;
        case Style::tiles: s << "boxxyerror fs solid 1 noborder"; break;
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
    s << "set encoding utf8\nset terminal dumb size 78,20 noenhanced mono\nset key below\nset tics nomirror scale "
         "0.5\nset border 3\n"
      << "set title " << in_quotes(title_) << "\n";
    std::ostringstream described;
    axes(described);
    std::string text = described.str(); // letters cannot be raised: 1e-3 for 10^{-3}
    for (auto at = text.find("10^{%L}"); at != std::string::npos; at = text.find("10^{%L}"))
        text.replace(at, 7, "1e%L");
    s << text;
    data(s, 400);
    for (std::size_t i = 0; i < curves_.size(); ++i)
        s << (i == 0 ? "plot " : ", ") << "$curve" << i << " using 1:2 with "
          << (curves_[i].style == Style::points || curves_[i].style == Style::tiles ? "points" : "lines") << " title "
          << in_quotes(curves_[i].name);
    s << '\n';
    // Letters only: gnuplot begins a page with a form feed and fills its lines with spaces.
    return run_gnuplot(s.str(), "gnuplot | tr -d '\\f' | sed 's/ *$//' | sed '/./,$!d'");
}

} // namespace ansatz::workbook
