// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The words of a cost table: what a chapter says about one measurement (`Case`), and what the
/// harness finds out about it (`Row`, one line of the table, one object of the JSON).

#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../plain.hpp"

namespace ansatz::workbook {

/// A number that may be missing; made from a plain number or a quantity, so that chapters need not
/// strip units. What is not finite is missing: a table never holds a NaN.
struct Number : std::optional<double> {
    Number() = default;
    Number(std::nullopt_t) {}
    template <class Value>
        requires(!std::is_base_of_v<Number, Value> && !std::is_same_v<Value, std::nullopt_t>)
    Number(const Value& value) {
        if (const double number = plain(value); std::isfinite(number)) emplace(number);
    }
};

/// What is varied along one curve: `{"dt", 0.01 * second}`. Orders are fitted against it, so give the
/// step, not the number of steps: it must get smaller as the computation gets finer.
struct Parameter {
    std::string name;
    Number value;
    std::string unit;

    Parameter() = default;
    template <class Value>
    Parameter(std::string what, const Value& how_much)
        : name{std::move(what)}, value{how_much}, unit{unit_of<Value>()} {}

    /// "dt = 0.01 s"; empty when there is no parameter.
    [[nodiscard]] std::string text() const;
};

/// One policy axis: everything its rows have in common.
struct Axis {
    std::string name{};          ///< "integrator", "scalar", "broadphase"
    std::string error_norm{};    ///< what the error is, with its unit: "max |x - exact| (m)"
    std::string work_unit{};     ///< what is counted: "force evaluations"; no clock in it
    std::string time_unit{"ns"}; ///< what `Case::per` makes of the time: "ns per simulated second per body"
    bool has_order = true;       ///< does the error fall as a power of the parameter?
};

/// What the untimed run found: how far off, at what count of work, and whether it still stands.
struct Outcome {
    Number error{};
    Number work{};
    bool diverged = false;
};

/// The run to be timed: any callable. What it returns is handed to an opaque sink, so that the
/// compiler cannot drop the computation: return something that depends on all of it.
class Timed {
public:
    Timed() = default;
    template <class Run>
        requires(std::is_invocable_v<Run&> && !std::is_same_v<std::decay_t<Run>, Timed>)
    Timed(Run run) {
        if constexpr (std::is_void_v<std::invoke_result_t<Run&>>) call_ = std::move(run);
        else
            call_ = [run = std::move(run)]() mutable {
                const auto result = run();
                keep(&result);
            };
    }
    void operator()() const { call_(); }
    explicit operator bool() const { return static_cast<bool>(call_); }

private:
    // An address that leaves through inline assembly counts as read (g++ and clang).
    static void keep(const void* address) { asm volatile("" : : "g"(address) : "memory"); }
    std::function<void()> call_;
};

/// One measurement, as a chapter states it.
struct Case {
    std::string choice{};  ///< the policy's type name
    std::string problem{}; ///< the scene, with its numbers
    Parameter parameter{};
    Number n{}; ///< how many bodies, nodes, ... where that has a meaning
    Number known_order{};
    std::function<Outcome()> error_run{};
    Timed timed_run{};
    Number per = 1.0; ///< the time of one run is divided by this: simulated time x bodies
};

/// One line of the table. `order` is there on the rows whose errors follow the fitted order.
struct Row {
    std::string axis{}, choice{}, problem{};
    Parameter parameter{};
    Number n{};
    Number error{};
    std::string error_norm{};
    Number work{};
    std::string work_unit{};
    Number time{};
    std::string time_unit{};
    Number spread{}; ///< (median - minimum) / minimum of the repeats
    Number order{}, known_order{};
    bool diverged = false;
};

using Rows = std::vector<Row>;

/// A number with `digits` significant digits and no superfluous zeros: 0.01, 1.23e-07, 12800.
inline std::string significant(double value, int digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

inline std::string Parameter::text() const {
    if (name.empty()) return {};
    if (!value) return name;
    return name + " = " + significant(*value, 6) + (unit.empty() ? "" : " " + unit);
}

/// The different values of one text member, in the order in which they first appear.
inline std::vector<std::string> different(const Rows& rows, std::string Row::*member) {
    std::vector<std::string> values;
    for (const Row& row : rows) {
        bool known = false;
        for (const std::string& value : values) known = known || value == row.*member;
        if (!known) values.push_back(row.*member);
    }
    return values;
}

/// The rows that have `value` in one text member.
inline Rows where(const Rows& rows, std::string Row::*member, const std::string& value) {
    Rows chosen;
    for (const Row& row : rows)
        if (row.*member == value) chosen.push_back(row);
    return chosen;
}

} // namespace ansatz::workbook
