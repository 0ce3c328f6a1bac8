// SPDX-License-Identifier: BSL-1.0
// An ensemble of oscillators on MPI ranks: prints the results of every rank, and what it cost in messages.
//   ranks <file of results, or -> [throw | die]     with `throw` run 20 throws, with `die` its rank is killed

#include <ansatz/execution/on_ranks.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <boost/mpi/environment.hpp>

#include <bit>
#include <csignal>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace ansatz;

int main(int count, char** words) {
    boost::mpi::environment environment(count, words);
    const boost::mpi::communicator ranks;
    const std::string file = count > 1 ? words[1] : "-", mode = count > 2 ? words[2] : "";

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
    try {
        const auto results = ensemble(run, steps, executor, options);
        std::string text;
        for (const auto& result : results)
            for (const double number : result) text += std::to_string(std::bit_cast<std::uint64_t>(number)) + '\n';
        // One rank after the other, so that the lines of one stand together.
        for (int rank = 0; rank < ranks.size(); ++rank) {
            if (rank == ranks.rank()) std::cout << text << std::flush;
            ranks.barrier();
        }
        // A line at once: those of several ranks come together.
        std::cerr << "rank " + std::to_string(ranks.rank()) + ": " + std::to_string(runs) + " runs, " +
                         std::to_string(executor.messages()) + " messages\n";
    } catch (const std::exception& e) {
        std::cerr << "rank " + std::to_string(ranks.rank()) + " was told: " + e.what() + '\n';
        return 3;
    }
}
