// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How the test of an exercise holds an answer against the right one, and says in words what a right one looks like.
///
/// A test.cpp is compiled once for each subject, the student's exercise.hpp, the library, the solution, the skeleton
/// and each wrong answer; all of them define `namespace exercise`. A test case has two tags, its task and its own name,
/// by which a wrong answer lists what it fails: "[task-1][old-velocity]". This header comes before the subject, so that
/// nothing that an answer defines can change what is asked of it.

#include "tools/exercises/drawn_paths.hpp"
#include "tools/exercises/registry.hpp"
#include "tools/exercises/todo.hpp"

#include <ansatz/units.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace ansatz::workbook {

/// Fails the test with a text of one or more lines.
inline void expect(bool holds, const std::string& text) {
    if (!holds) fail(text);
}

namespace detail {
inline bool all_finite(double x) { return std::isfinite(x); }
template <class Q> bool all_finite(const Q& q) { return is_finite(q); }
inline double size_of(double x) { return std::abs(x); }
template <class Q> auto size_of(const Q& q) {
    if constexpr (requires { q.value().norm(); }) return norm(q);
    else return abs(q);
}
template <class T> std::string shown(const T& value) {
    std::ostringstream text;
    text.precision(10);
    text << value;
    return text.str();
}
} // namespace detail

/// Fails unless `yours` is within `tolerance`, a quantity of the same unit, of `right`.
/// \param what  what it is, e.g. "the position after one step of 0.1 s"
/// \param why   what makes the right answer right, in one sentence
template <class Q, class R, class T>
void expect_near(std::string_view what, const Q& yours, const R& right, const T& tolerance, std::string_view why) {
    std::string text(what);
    text.append("\n    yours  ")
        .append(detail::shown(yours))
        .append("\n    right  ")
        .append(detail::shown(right))
        .append("\n");
    if (!detail::all_finite(yours))
        fail(text + "Yours is no finite number: something was divided by zero, or a root was taken of something "
                    "negative, or it "
                    "grew without end.");
    if (!(detail::size_of(yours - right) <= tolerance)) fail(text.append(why));
}

/// Fails unless two numbers of the subject's own, which must be equal, are within `tolerance` of each other.
/// \param first, second   what each is, e.g. "yours, before", "yours, after"
template <class Q, class R, class T>
void expect_agree(std::string_view what, std::string first, const Q& one, std::string second, const R& other,
                  const T& tolerance, std::string_view why) {
    const auto width = std::max(first.size(), second.size()) + 2;
    first.resize(width, ' '), second.resize(width, ' ');
    std::string text(what);
    text.append("\n    ")
        .append(first)
        .append(detail::shown(one))
        .append("\n    ")
        .append(second)
        .append(detail::shown(other))
        .append("\n")
        .append(why);
    expect(detail::all_finite(one) && detail::all_finite(other) && detail::size_of(one - other) <= tolerance, text);
}

/// Fails unless a path is within `tolerance` of the right one after each step; draws both, and says where they part.
/// \param what    what is followed, e.g. "the height of a ball that falls"
/// \param unit    of the numbers, e.g. "m"
/// \param yours, right after each step; the first of them is where both begin
/// \param seconds how long a step is
inline void expect_path(std::string_view what, std::string_view unit, const std::vector<double>& yours,
                        const std::vector<double>& right, double seconds, double tolerance, std::string_view why) {
    const std::size_t step = step_of_parting(yours, right, tolerance);
    if (step == right.size()) return;
    std::ostringstream text;
    text << std::setprecision(10) << what << ", after step " << step << " of " << right.size() - 1 << " (" << seconds
         << " s each)\n    yours  " << yours[step] << ' ' << unit << "\n    right  " << right[step] << ' ' << unit
         << "\n\n"
         << drawn_paths(yours, right, step, seconds) << '\n'
         << why;
    fail(text.str());
}

/// Fails unless the error falls as that of a method of `order` does, when the step is halved again and again.
inline void expect_order(std::string_view what, const std::vector<double>& errors, double order, double tolerance,
                         std::string_view why) {
    for (std::size_t i = 1; i < errors.size(); ++i) {
        const double ratio = errors[i - 1] / errors[i];
        if (!(std::abs(std::log2(ratio) - order) <= tolerance)) {
            std::ostringstream text;
            text << what << ": halving the step divided the error by " << ratio << "; a method of order " << order
                 << " gives " << std::exp2(order) << ".\n"
                 << why;
            fail(text.str());
        }
    }
}

} // namespace ansatz::workbook
