// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The work-precision picture of one problem: error against time, and error against the count of
/// work that no machine can bend. Down and left is better. A diverged run is no point on such axes
/// and is drawn all the same, as a cross in a strip at the right edge; an error of exactly zero
/// stands in a strip at the left edge.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "../gnuplot.hpp"
#include "row.hpp"

namespace ansatz::workbook {

/// "integrator", "oscillator, 100 s" -> "integrator-oscillator-100-s": a file name for every system.
inline std::string file_name(const std::string& text) {
    std::string name;
    for (const char c : text) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!name.empty() && name.back() != '-') name += '-';
    }
    while (!name.empty() && name.back() == '-') name.pop_back();
    return name;
}

namespace detail {

/// From the lowest to the highest of some positive numbers, and whether decades suit them.
struct Extent {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] bool empty() const { return high <= 0; }
    [[nodiscard]] bool decades() const { return high / low > 4; }
};

/// One panel: `value` is what stands on the y axis.
struct Panel {
    std::string label;
    Number Row::*value;
};

class WorkPrecision {
public:
    explicit WorkPrecision(const Rows& rows) : rows_{rows}, choices_{different(rows, &Row::choice)} {
        for (const Row& row : rows_) {
            if (row.diverged) diverged_ = true;
            else if (row.error && *row.error > 0) errors_.add(*row.error);
            else if (row.error && *row.error == 0) exact_ = true;
        }
        const Row& first = rows_.front();
        if (has(&Row::time)) panels_.push_back({"time: " + first.time_unit, &Row::time});
        if (has(&Row::work)) panels_.push_back({first.work_unit, &Row::work});
    }

    /// No finite error above zero, or nothing to hold it against: no picture.
    [[nodiscard]] bool empty() const { return errors_.empty() || panels_.empty(); }

    [[nodiscard]] std::string script() const {
        const int width = panels_.size() == 2 ? 1100 : 700;
        std::ostringstream s;
        s << house_style(width, height_) << "set multiplot\n";
        title(s, width);
        legend(s, width);
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            const double from = (88.0 + static_cast<double>(i) * width / 2.0) / width;
            const double to =
                (panels_.size() == 2 ? (width / 2.0) * static_cast<double>(i + 1) : width) / width - 24.0 / width;
            s << "set lmargin at screen " << number(from) << "\nset rmargin at screen " << number(to)
              << "\nset tmargin at screen " << number(1 - top_ / height_) << "\nset bmargin at screen "
              << number(70.0 / height_) << '\n';
            panel(s, panels_[i]);
            s << "unset label\nunset arrow\nunset object\n";
        }
        s << "unset multiplot\n";
        return s.str();
    }

private:
    [[nodiscard]] bool has(Number Row::*value) const {
        return std::any_of(rows_.begin(), rows_.end(), [&](const Row& row) { return row.*value && *(row.*value) > 0; });
    }

    /// "VelocityVerlet, order 2.00 (2)": the fitted order, and the known one in brackets.
    [[nodiscard]] std::string caption(const std::string& choice) const {
        for (const Row& row : where(rows_, &Row::choice, choice)) {
            if (!row.order) continue;
            char text[64];
            std::snprintf(text, sizeof text, ", order %.2f", *row.order);
            return choice + text + (row.known_order ? " (" + significant(*row.known_order, 3) + ")" : "");
        }
        return choice;
    }

    void title(std::ostream& s, int width) const {
        const Row& first = rows_.front();
        s << "set label " << in_quotes(first.axis + (first.problem.empty() ? "" : ": " + first.problem))
          << " at screen " << number(22.0 / width) << ", screen " << number(1 - 32.0 / height_)
          << " left front noenhanced font ',18' textcolor rgb '#222222'\n";
    }

    void legend(std::ostream& s, int width) const {
        double x = 22, y = 66;
        for (std::size_t i = 0; i < choices_.size(); ++i) {
            const std::string text = caption(choices_[i]);
            const double needs = 16 + 7.6 * static_cast<double>(visible_width(text));
            if (x > 22 && x + needs > width - 22) {
                x = 22;
                y += 22;
            }
            const auto at = [&](double px) {
                return "screen " + number(px / width) + ", screen " + number(1 - y / height_);
            };
            s << "set label '' at " << at(x + 5) << " front point pt " << point_shape(i) << " ps 0.9 lc rgb '"
              << colour(i) << "'\n"
              << "set label " << in_quotes(text) << " at " << at(x + 16)
              << " left front noenhanced font ',13' textcolor rgb '#333333'\n";
            x += needs + 26;
        }
        top_ = y + 26;
    }

    /// Sets one axis from its extent, with room for a strip at its ends; answers with where the strips begin.
    static void scale(std::ostream& s, char letter, const Extent& extent, double& low, double& high, bool left,
                      bool right) {
        if (extent.decades()) {
            const double first = std::floor(std::log10(extent.low) - 0.02),
                         last = std::ceil(std::log10(extent.high) + 0.02);
            low = std::pow(10.0, first);
            high = std::pow(10.0, last);
            const double strip = std::pow(high / low, 0.13);
            // Every decade gets a tick, or as few as fit; none of them inside a strip.
            const int every = std::max(1, static_cast<int>((last - first) / 6.0 + 0.9));
            s << "set logscale " << letter << " 10\nset format " << letter << " '10^{%L}'\nset " << letter << "tics "
              << number(low) << ',' << number(std::pow(10.0, every)) << ',' << number(high) << "\n"
              << (every == 1 ? "set m" : "unset m") << letter << "tics\n";
            s << "set " << letter << "range [" << number(left ? low / strip : low) << ':'
              << number(right ? high * strip : high) << "]\n";
        } else {
            const double room = extent.high > extent.low ? 0.12 * (extent.high - extent.low) : 0.1 * extent.high;
            low = extent.low - room;
            high = extent.high + room;
            const double strip = 0.13 * (high - low);
            s << "unset logscale " << letter << "\nset format " << letter << " '%h'\nset " << letter << "tics auto\n";
            s << "set " << letter << "range [" << number(left ? low - strip : low) << ':'
              << number(right ? high + strip : high) << "]\n";
        }
    }

    void panel(std::ostream& s, const Panel& panel) const {
        Extent values;
        for (const Row& row : rows_)
            if ((row.error || row.diverged) && row.*panel.value && *(row.*panel.value) > 0)
                values.add(*(row.*panel.value));
        double low = 0, high = 0, bottom = 0, ceiling = 0;
        scale(s, 'x', errors_, low, high, exact_, diverged_);
        scale(s, 'y', values, bottom, ceiling, false, false);
        s << "set xlabel " << in_quotes("error: " + rows_.front().error_norm) << " noenhanced textcolor rgb '#333333'\n"
          << "set ylabel " << in_quotes(panel.label) << " noenhanced textcolor rgb '#333333'\n";

        const auto strip = [&](const std::string& from, const std::string& to, const std::string& text,
                               const std::string& at) {
            s << "set object rectangle from " << from << ", graph 0 to " << to
              << ", graph 1 behind fc rgb '#f3f3f3' fs noborder\n"
              << "set label '" << text << "' at " << at
              << ", graph 0.04 left rotate by 90 front font ',12' textcolor rgb '#777777'\n";
        };
        if (diverged_) strip("first " + number(high), "graph 1", "diverged", "graph 0.985");
        if (exact_) strip("graph 0", "first " + number(low), "error is zero", "graph 0.015");

        const auto at_edge = [&](const Row& row, const std::string& x, int shape, const std::string& colour) {
            s << "set label '' at " << x << ", first " << number(*(row.*panel.value)) << " front point pt " << shape
              << " ps 1.0 lw 2 lc rgb '" << colour << "'\n";
        };
        std::vector<std::size_t> drawn;
        for (std::size_t i = 0; i < choices_.size(); ++i) {
            std::ostringstream points;
            bool any = false;
            // Equal counts of several choices would lie on top of each other: each has a place of its own.
            const double beside = (static_cast<double>(i) + 0.5) / static_cast<double>(choices_.size());
            for (const Row& row : where(rows_, &Row::choice, choices_[i])) {
                if (!(row.*panel.value) || *(row.*panel.value) <= 0) continue;
                if (row.diverged) {
                    at_edge(row, "graph " + number(0.91 + 0.05 * beside), 2, colour(i));
                    points << '\n';
                } // and a gap
                else if (row.error && *row.error == 0)
                    at_edge(row, "graph " + number(0.04 + 0.05 * beside), point_shape(i), colour(i));
                else if (row.error) {
                    points << number(*row.error) << ' ' << number(*(row.*panel.value)) << '\n';
                    any = true;
                }
            }
            if (!any) continue;
            s << "$choice" << i << " << END\n" << points.str() << "END\n";
            drawn.push_back(i);
        }
        for (std::size_t k = 0; k < drawn.size(); ++k)
            s << (k == 0 ? "plot " : ", ") << "$choice" << drawn[k] << " using 1:2 with linespoints lw 2 ps 0.8 pt "
              << point_shape(drawn[k]) << " lc rgb '" << colour(drawn[k]) << "'";
        s << '\n';
    }

    static constexpr int height_ = 540;
    Rows rows_;
    std::vector<std::string> choices_;
    std::vector<Panel> panels_;
    Extent errors_;
    bool diverged_ = false, exact_ = false;
    mutable double top_ = 100; // set by the legend, which may wrap
};

} // namespace detail

/// The picture's gnuplot commands; empty where the rows have no error to show.
inline std::string work_precision_script(const Rows& rows) {
    if (rows.empty()) return {};
    const detail::WorkPrecision picture{rows};
    return picture.empty() ? std::string{} : picture.script();
}

/// Draws one picture for every axis and problem into `folder`: `<module>-<axis>-<problem>.svg`.
inline std::vector<std::filesystem::path> draw_pictures(const std::filesystem::path& folder, const std::string& module,
                                                        const Rows& rows) {
    std::vector<std::filesystem::path> pictures;
    for (const std::string& axis : different(rows, &Row::axis)) {
        const Rows of_axis = where(rows, &Row::axis, axis);
        for (const std::string& problem : different(of_axis, &Row::problem)) {
            const std::string script = work_precision_script(where(of_axis, &Row::problem, problem));
            if (script.empty()) continue;
            const std::filesystem::path file = folder / (file_name(module + "-" + axis + "-" + problem) + ".svg");
            if (draw(file, script)) pictures.push_back(file);
        }
    }
    return pictures;
}

} // namespace ansatz::workbook
