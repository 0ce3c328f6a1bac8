// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ensemble`: one run for each of many parameters, and their results in the order of the parameters.
///
/// A world is a value, so that what outgrows one core, or one machine, is mostly many worlds: scans of steps,
/// coefficients and seeds, tournaments of machines and plans, crowds in separate regions. Write the run as a function
/// of its parameter, which builds its world, steps it and gives back what is of interest:
///
///     const auto energy = ensemble(
///         [](double step) {
///             World world{SemiImplicitEuler{}, Gravity{}, Springs{}};
///             ...
///             return total_energy(world).value();
///         },
///         steps, OnThreads{});
///
/// What runs them is the third argument: `OneByOne` (without it), `OnThreads` (on_threads.hpp, oneTBB) or `OnRanks`
/// (on_ranks.hpp, MPI, across machines). The results are the same to the bit, because a run sees nothing but its
/// parameter: it must not change what it shares with others, and takes its random numbers from a seed in its parameter.
///
/// A long ensemble keeps its results in a file as they come (`EnsembleOptions::kept`). If it ends early (a run throws,
/// a machine fails, somebody presses Ctrl-C), the same call goes on from there.

#include <ansatz/core/error.hpp>
#include <ansatz/execution/kept_results.hpp>

#include <concepts>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

/// What an ensemble may do beside its runs.
struct EnsembleOptions {
    /// The file in which results are kept as they come; none, if it is empty. It is there when the ensemble has ended,
    /// too: remove it when it is no longer wanted.
    std::filesystem::path kept{};
    /// What is run. It stands in the file; another text refuses the file. Change it when the run itself changes, for
    /// which the file cannot check. (Parameters that are numbers are compared as well.)
    std::string name{};
    /// Called after each run, one at a time: how many are done, and of how many. See `ProgressLine`.
    std::function<void(std::size_t done, std::size_t all)> progress{};
};

/// Says on one line of a terminal how many runs are done: `EnsembleOptions{.progress = ProgressLine{std::cerr}}`.
struct ProgressLine {
    std::ostream& out; ///< where it is said
    /// Says it; the last one ends the line.
    void operator()(std::size_t done, std::size_t all) const {
        out << '\r' << done << " of " << all << " runs" << (done == all ? "\n" : "") << std::flush;
    }
};

/// One run after the other, in this thread.
struct OneByOne {
    /// Calls `take(i, run(i))` for each i of `todo`.
    /// \throws what a run throws
    template <class Result> void each(const std::vector<std::size_t>& todo, const auto& run, const auto& take) const {
        for (const std::size_t i : todo) take(i, run(i));
    }
};

/// What runs an ensemble: `each<Result>(todo, run, take)` calls `run(i)` for each index of `todo`, anywhere, and
/// `take(i, result)` for each result, one at a time. What a run throws leaves it when no other is under way.
///
/// Where several processes call `ensemble` together, `leads()` is true in the one that keeps the file and takes the
/// results; `agree(failure)` brings its refusal to the others before anything is run, and `share(results, failure)` its
/// results, or the sentence of what went wrong.
template <class E, class Result>
concept EnsembleExecutor =
    requires(E& executor, const std::vector<std::size_t>& todo, Result (*run)(std::size_t),
             void (*take)(std::size_t, Result)) { executor.template each<Result>(todo, run, take); };

namespace detail {
/// A run's own words, with the place of the parameter.
[[noreturn]] inline void run_failed(std::size_t index, std::size_t all, const std::string& why) {
    throw std::runtime_error(joined({"run ", std::to_string(index), " of ", std::to_string(all), " failed: ", why}));
}
template <class E> bool leads(const E& executor) {
    if constexpr (requires { executor.leads(); }) return executor.leads();
    else return true;
}

/// The results so far, and what happens with each that comes.
template <class Result> class EnsembleInProgress {
public:
    EnsembleInProgress(std::size_t count, std::uint64_t parameters, const EnsembleOptions& options, bool leads)
        : results_(count), options_(options) {
        if (!options.kept.empty() && leads) {
            if constexpr (!BytesOf<Result>::known)
                refuse(Refusal::invalid_argument,
                       "ensemble: results of this type cannot be kept in a file; give back numbers, a trivially "
                       "copyable struct of them, a std::vector of such or a std::string");
            else {
                file_.emplace(options.kept, options.name, count, parameters);
                file_->read(
                    [&](std::size_t i, const std::string& bytes) { results_[i] = BytesOf<Result>::read(bytes); });
            }
        }
        for (std::size_t i = 0; i < count; ++i)
            if (results_[i]) ++done_;
            else todo_.push_back(i);
    }
    const std::vector<std::size_t>& todo() const { return todo_; }
    std::size_t done() const { return done_; }

    void take(std::size_t index, Result result) {
        if constexpr (BytesOf<Result>::known)
            if (file_) file_->append(index, BytesOf<Result>::write(result));
        results_[index] = std::move(result);
        ++done_;
        if (options_.progress) tell();
    }
    /// What is added to a failure: what remains of the work.
    std::string kept() const {
        const auto count = std::to_string(done_);
        if (!file_) return joined({"; ", count, " results are lost (EnsembleOptions::kept names a file for them)"});
        return joined(
            {"; ", count, " results are kept in ", options_.kept.string(), ": the same call goes on from there"});
    }
    std::vector<Result> all() && {
        std::vector<Result> all;
        all.reserve(results_.size());
        for (auto& result : results_) all.push_back(std::move(*result));
        return all;
    }

private:
    /// What it throws is a sentence in any case: executors and other ranks wait for one.
    void tell() const {
        try {
            options_.progress(done_, results_.size());
        } catch (const std::exception&) {
            throw;
        } catch (...) {
            throw std::runtime_error("EnsembleOptions::progress threw what is no std::exception");
        }
    }

    std::vector<std::optional<Result>> results_;
    const EnsembleOptions& options_;
    std::vector<std::size_t> todo_;
    std::size_t done_ = 0;
    std::optional<KeptResults> file_;
};
} // namespace detail

/// One run for each parameter.
/// \param run        called with each parameter, perhaps by several threads at once; gives back a result
/// \param parameters in any number; none is no run
/// \param executor   OneByOne, OnThreads, OnRanks or one of your own
/// \return the results in the order of the parameters
/// \throws std::runtime_error if a run throws: which one, its own words, and what was kept; of several that failed the
///         first in the order of the parameters that is known when the runs under way have ended
/// \throws std::invalid_argument if `options.kept` is a file of another ensemble, or cannot be written; no run has begun
template <class Run, class Parameter, class Executor = OneByOne>
    requires std::invocable<const Run&, const Parameter&>
auto ensemble(const Run& run, const std::vector<Parameter>& parameters, Executor&& executor = OneByOne{},
              const EnsembleOptions& options = {}) {
    using Result = std::remove_cvref_t<std::invoke_result_t<const Run&, const Parameter&>>;
    static_assert(!std::is_void_v<Result>,
                  "Ansatz: an ensemble whose run gives nothing back; return what is of interest");
    static_assert(EnsembleExecutor<std::remove_cvref_t<Executor>, Result>,
                  "Ansatz: the third argument of ensemble runs it; pass OneByOne{}, OnThreads{} or OnRanks{ranks}, or "
                  "give yours `template <class Result> void each(todo, run, take)`");
    constexpr bool together = requires(std::string& failure) { executor.agree(failure); };
    std::string failure;
    std::exception_ptr refused;
    std::optional<detail::EnsembleInProgress<Result>> progress;
    try {
        progress.emplace(parameters.size(), detail::fingerprint(parameters), options, detail::leads(executor));
    } catch (const std::exception& e) {
        refused = std::current_exception();
        failure = e.what();
    }
    if constexpr (together) executor.agree(failure);
    if (refused) std::rethrow_exception(refused);
    if (!failure.empty()) refuse(Refusal::invalid_argument, failure);

    const auto one = [&](std::size_t i) -> Result {
        try {
            return std::invoke(run, parameters[i]);
        } catch (const std::exception& e) {
            detail::run_failed(i, parameters.size(), e.what());
        } catch (...) {
            detail::run_failed(i, parameters.size(), "it threw what is no std::exception");
        }
    };
    try {
        executor.template each<Result>(progress->todo(), one,
                                       [&](std::size_t i, Result result) { progress->take(i, std::move(result)); });
    } catch (const std::exception& e) {
        failure = detail::joined({"ensemble: ", e.what(), progress->kept()});
    }
    std::vector<Result> results;
    if (failure.empty() && detail::leads(executor)) results = std::move(*progress).all();
    if constexpr (together) executor.share(results, failure);
    if (!failure.empty()) throw std::runtime_error(failure);
    return results;
}
/// A run that cannot be called with a parameter: a mistake.
template <class Run, class Parameter, class Executor = OneByOne>
    requires(!std::invocable<const Run&, const Parameter&>)
auto ensemble(const Run&, const std::vector<Parameter>& parameters, Executor&& = OneByOne{},
              const EnsembleOptions& = {}) {
    constexpr bool takes_a_parameter = std::invocable<const Run&, const Parameter&>;
    static_assert(takes_a_parameter,
                  "Ansatz: the run of an ensemble is called with one parameter, by several threads at once, so that it "
                  "must not be `mutable`; write e.g. ensemble([](double step) { return ...; }, steps)");
    return parameters;
}

} // namespace ansatz
