// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What accuracy costs in time: the harness behind every chapter's `what_it_costs`.
///
/// A chapter lists cases along a policy axis. Each has an untimed run that finds the error and the
/// count of work, and a run that is only timed. The harness measures, fits the orders of convergence,
/// prints the table, and writes `<module>.json` and one picture for every axis and problem.
///
/// \code
/// Costs costs{"motion", argc, argv};
/// const Axis integrator{.name = "integrator", .error_norm = "max |x - exact| (m)",
///                       .work_unit = "force evaluations", .time_unit = "ns per simulated second per body"};
/// for (auto dt : ladder)
///     costs.add(integrator, {.choice = "VelocityVerlet", .problem = "oscillator, 100 s", .parameter = {"dt", dt},
///                            .n = 1, .known_order = 2.0,
///                            .error_run = [=] { return Outcome{.error = error(dt), .work = steps(dt)}; },
///                            .timed_run = [=] { return run(dt); }, .per = 100.0 * second});
/// return costs.run();
/// \endcode

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "costs/json.hpp"
#include "costs/machine.hpp"
#include "costs/measure.hpp"
#include "costs/order.hpp"
#include "costs/picture.hpp"
#include "costs/row.hpp"
#include "costs/table.hpp"

namespace ansatz::workbook {

/// What a reader can ask of a `what_it_costs` program.
struct CostsOptions {
    TimingPlan plan{};
    bool untimed = false, check = false, list = false, help = false;
    std::string only{};
    std::filesystem::path out = std::filesystem::path{"build"} / "costs";

    static constexpr std::string_view text =
        "what_it_costs [options]: error, work and time of every choice, on this machine\n"
        "  --quick         3 repeats instead of 15: a first look\n"
        "  --repeats N     N repeats\n"
        "  --untimed       errors, work and orders only\n"
        "  --only TEXT     only rows whose axis, choice or problem contains TEXT\n"
        "  --check         fail when a fitted order is more than 0.1 off the known one\n"
        "  --out FOLDER    where the JSON and the pictures go (build/costs)\n"
        "  --list          the rows, without running them\n";

    /// Throws `std::invalid_argument` with a sentence on what it does not know.
    static CostsOptions parse(const std::vector<std::string>& arguments) {
        CostsOptions options;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const std::string& name = arguments[i];
            const auto value = [&]() -> const std::string& {
                if (i + 1 == arguments.size()) throw std::invalid_argument(name + " needs a value after it");
                return arguments[++i];
            };
            if (name == "--quick") {
                options.plan.repeats = 3;
                options.plan.sample_seconds = 0.003;
            } else if (name == "--untimed") options.untimed = true;
            else if (name == "--check") options.check = true;
            else if (name == "--list") options.list = true;
            else if (name == "--help" || name == "-h") options.help = true;
            else if (name == "--only") options.only = value();
            else if (name == "--out") options.out = value();
            else if (name == "--repeats") {
                const std::string& number = value();
                options.plan.repeats = std::atoi(number.c_str());
                if (options.plan.repeats < 1)
                    throw std::invalid_argument("--repeats takes a whole number from 1, not '" + number + "'");
            } else throw std::invalid_argument("unknown option '" + name + "'\n" + std::string{text});
        }
        return options;
    }
};

/// The cost table of one module.
class Costs {
public:
    Costs(std::string module, int argc, char** argv)
        : Costs{std::move(module), std::vector<std::string>(argv + (argc > 0), argv + argc)} {}
    Costs(std::string module, std::vector<std::string> arguments)
        : module_{std::move(module)}, arguments_{std::move(arguments)} {}

    /// Adds one measurement. Its place in the table is its place in the program.
    void add(const Axis& axis, Case measurement) {
        if (!measurement.per || !(*measurement.per > 0))
            throw std::invalid_argument("what_it_costs " + module_ + ": '.per' of " + measurement.choice +
                                        " must be above zero");
        axes_.push_back(axis);
        cases_.push_back(std::move(measurement));
    }

    /// Adds something to be printed below the table: what costs no time, such as bytes.
    void add_below(std::function<void(std::ostream&)> print) {
        add_summary(
            [print = std::move(print)](std::ostream& out, const Rows&, const std::filesystem::path&) { print(out); });
    }

    /// Adds what is made of the rows that were measured: where one choice overtakes another, a picture along another
    /// axis. It is called below the table, with all rows and the folder for pictures.
    void add_summary(std::function<void(std::ostream&, const Rows&, const std::filesystem::path&)> summary) {
        below_.push_back(std::move(summary));
    }

    /// Measures everything and reports; the result is the program's exit code.
    int run(std::ostream& out = std::cout) {
        try {
            const CostsOptions options = CostsOptions::parse(arguments_);
            if (options.help) {
                out << CostsOptions::text;
                return 0;
            }
            choose(options.only);
            if (cases_.empty())
                throw std::invalid_argument("no row contains '" + options.only + "'; --list shows what there is");
            if (options.list) {
                list(out);
                return 0;
            }
            return report(measure(options), options, out);
        } catch (const std::exception& error) {
            std::cerr << "what_it_costs " << module_ << ": " << error.what() << '\n';
            return 1;
        }
    }

    /// The rows without any report: for tests, and for whoever wants to do something else with them.
    Rows measure(const CostsOptions& options) const {
        Rows rows;
        for (std::size_t i = 0; i < cases_.size(); ++i) rows.push_back(outcome_of(axes_[i], cases_[i]));
        if (!options.untimed) {
            std::vector<Timed> runs;
            for (const Case& measurement : cases_) runs.push_back(measurement.timed_run);
            const std::vector<Timing> timings = time_runs(runs, options.plan);
            for (std::size_t i = 0; i < rows.size(); ++i) {
                if (timings[i].nanoseconds) rows[i].time = *timings[i].nanoseconds / *cases_[i].per;
                rows[i].spread = timings[i].spread;
            }
        }
        std::vector<std::string> fitted;
        for (const Axis& axis : axes_) {
            if (!axis.has_order || std::find(fitted.begin(), fitted.end(), axis.name) != fitted.end()) continue;
            fit_orders(rows, axis.name);
            fitted.push_back(axis.name);
        }
        return rows;
    }

private:
    static Row outcome_of(const Axis& axis, const Case& measurement) {
        Row row;
        row.axis = axis.name;
        row.choice = measurement.choice;
        row.problem = measurement.problem;
        row.parameter = measurement.parameter;
        row.n = measurement.n;
        row.error_norm = axis.error_norm;
        row.work_unit = axis.work_unit;
        row.time_unit = axis.time_unit;
        row.known_order = measurement.known_order;
        if (measurement.error_run) {
            const Outcome outcome = measurement.error_run();
            row.work = outcome.work;
            // An error that is not a number is a run that did not survive, whether it says so or not.
            row.diverged = outcome.diverged || (!outcome.error && !axis.error_norm.empty());
            if (!row.diverged) row.error = outcome.error;
        }
        return row;
    }

    void choose(const std::string& text) {
        std::vector<Axis> axes;
        std::vector<Case> cases;
        for (std::size_t i = 0; i < cases_.size(); ++i) {
            const auto contains = [&](const std::string& where) { return where.find(text) != std::string::npos; };
            if (!contains(axes_[i].name) && !contains(cases_[i].choice) && !contains(cases_[i].problem)) continue;
            axes.push_back(axes_[i]);
            cases.push_back(cases_[i]);
        }
        axes_ = std::move(axes);
        cases_ = std::move(cases);
    }

    void list(std::ostream& out) const {
        for (std::size_t i = 0; i < cases_.size(); ++i)
            out << axes_[i].name << " | " << cases_[i].choice << " | " << cases_[i].problem << " | "
                << cases_[i].parameter.text() << '\n';
    }

    int report(const Rows& rows, const CostsOptions& options, std::ostream& out) const {
        Machine machine = this_machine();
        machine.repeats = options.untimed ? 0 : options.plan.repeats;
        out << "What accuracy costs: " << module_ << '\n'
            << machine.cpu << ", " << machine.cores << " cores, " << machine.compiler << ", " << machine.flags << '\n';
        if (!options.untimed)
            out << "thread CPU time, the minimum of " << machine.repeats
                << " interleaved repeats; spread: how far their median lies above it\n";
        out << '\n';
        print_table(out, rows);

        const std::filesystem::path json = options.out / (module_ + ".json");
        write_json(json, machine, rows);
        draw_pictures(options.out, module_, rows);
        out << "table: " << json.string() << '\n';
        for (const auto& summary : below_) summary(out, rows, options.out);

        bool off = false;
        for (const Row& row : rows) off = off || order_is_off(row);
        if (options.check && off) {
            std::cerr << "what_it_costs " << module_
                      << ": a fitted order is off the known one; the rows are marked with ! above\n";
            return 1;
        }
        return 0;
    }

    std::string module_;
    std::vector<std::string> arguments_;
    std::vector<Axis> axes_;
    std::vector<Case> cases_;
    std::vector<std::function<void(std::ostream&, const Rows&, const std::filesystem::path&)>> below_;
};

} // namespace ansatz::workbook
