// SPDX-License-Identifier: BSL-1.0
// An ensemble of oscillators on MPI ranks: every rank writes its results to a file, and says what they cost in
// messages.
//   ranks <stem> <file to keep results in, or -> [throw | die | tell]
// Rank 1 writes <stem>.1. With `throw` run 20 throws, with `die` its rank is killed, with `tell` what tells of the
// progress throws a number.

#include <ansatz/execution/on_ranks.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <boost/mpi/environment.hpp>

#include <bit>
#include <csignal>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace ansatz;

int main(int count, char** words) {
    boost::mpi::environment environment(count, words);
    const boost::mpi::communicator ranks;
    const std::string stem = count > 1 ? words[1] : "results", file = count > 2 ? words[2] : "-",
                      mode = count > 3 ? words[3] : "";

    std::vector<double> steps;
    for (int i = 1; i <= 40; ++i) steps.push_back(0.001 * i);
    std::size_t runs = 0;
    const auto run = [&](double step) {
        ++runs;
        if (step == steps[20] && mode == "throw") throw std::runtime_error("no such step");
        if (step == steps[20] && mode == "die") std::raise(SIGKILL);
        World world{SemiImplicitEuler{}, Springs{}};
        const auto body = world.add(position(metres(1, 0, 0)), mass(1.0 * kilogram));
        world.add(Spring{body, metres(0, 0, 0), 100.0 * newton_per_metre});
        for (int i = 0; i < 20000; ++i) world.step(step * second);
        return std::vector<double>{world.position(body).value()[0], world.velocity(body).value()[0]};
    };

    OnRanks executor(ranks);
    EnsembleOptions options;
    if (file != "-") options.kept = file;
    if (mode == "tell")
        options.progress = [](std::size_t done, std::size_t) {
            if (done == 20) throw 7;
        };
    try {
        const auto results = ensemble(run, steps, executor, options);
        // Not to standard output: mpirun passes on what several ranks print in pieces, in any order.
        std::ofstream written(stem + '.' + std::to_string(ranks.rank()));
        for (const auto& result : results)
            for (const double number : result) written << std::bit_cast<std::uint64_t>(number) << '\n';
        // A line at once: those of several ranks come together.
        std::cerr << "rank " + std::to_string(ranks.rank()) + ": " + std::to_string(runs) + " runs, " +
                         std::to_string(executor.messages()) + " messages\n";
    } catch (const std::exception& e) {
        std::cerr << "rank " + std::to_string(ranks.rank()) + " was told: " + e.what() + '\n';
        return 3;
    }
}
