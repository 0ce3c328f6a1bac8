// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `OnRanks`: the runs of an ensemble on the ranks of an MPI program, on one machine or on many.
// not in the umbrella: it needs MPI and Boost.MPI
///
///     boost::mpi::environment environment;
///     const boost::mpi::communicator ranks;
///     const auto results = ensemble(run, parameters, OnRanks{ranks}, {.kept = "scan.results"});   // on every rank
///
/// `mpirun -n 5 ./scan` has rank 0 hand out the runs and keep their results, and four ranks run. Rank 0 runs nothing
/// where there are others, and sleeps while it waits, so that a machine of four cores takes five ranks. All ranks call
/// `ensemble` with the same parameters, and all get all results, in the order of the parameters and the same to the bit
/// for any number of ranks.
///
/// How far it goes: two messages a run (`messages()` counts them), and one broadcast at the end. A rank 0 that handles
/// 100,000 messages a second serves 1,000 ranks whose runs take 20 ms or more. Give shorter ones more to do.
///
/// A run that throws ends the ensemble on all ranks with one sentence. A rank that dies (it is killed, its machine
/// fails) is mpirun's to notice, which ends the program; rank 0 says before that what is kept
/// (`EnsembleOptions::kept`), and the same call goes on from there.
///
/// A program that includes this links MPI and Boost.MPI (on Debian: libopenmpi-dev, libboost-mpi-dev;
/// `find_package(MPI)`, `find_package(Boost COMPONENTS mpi serialization)`). No other header of the library knows of
/// them.

#include <ansatz/core/error.hpp>
#include <ansatz/execution/ensemble.hpp>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>

#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <string>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {
/// While it lives, a program that is told to end (SIGTERM, as mpirun does when a rank has died) first says this.
class LastWords {
public:
    LastWords() { before_ = std::signal(SIGTERM, &LastWords::say); }
    LastWords(const LastWords&) = delete;
    LastWords& operator=(const LastWords&) = delete;
    ~LastWords() {
        std::signal(SIGTERM, before_);
        words_ = nullptr;
    }
    /// Two texts take turns, so that a signal never sees one that is being written.
    void set(std::string text) {
        turn_ = !turn_;
        texts_[turn_] = std::move(text);
        words_ = texts_[turn_].c_str();
    }

private:
    static void say(int signal) {
        if (const char* words = words_) {
            std::size_t size = 0;
            while (words[size] != '\0') ++size;
            [[maybe_unused]] const auto written = ::write(STDERR_FILENO, words, size);
        }
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    static inline const char* volatile words_ = nullptr; // NOLINT(readability-identifier-naming): a member
    void (*before_)(int) = SIG_DFL;
    std::string texts_[2];
    bool turn_ = false;
};
} // namespace detail

/// Runs of an ensemble on the ranks of a communicator, one at a time on each but rank 0, which hands them out.
class OnRanks {
public:
    /// \param ranks of which each calls `ensemble`, with the same parameters
    explicit OnRanks(boost::mpi::communicator ranks) : ranks_(std::move(ranks)) {}

    /// Whether this rank takes the results and keeps the file.
    bool leads() const { return ranks_.rank() == 0; }
    /// How many messages this rank has sent and received.
    std::size_t messages() const { return messages_; }

    /// Rank 0 hands out the runs and takes what comes of them; the others run them, and take nothing.
    /// \throws what a run threw, as std::runtime_error with its words, on rank 0
    template <class Result> void each(const std::vector<std::size_t>& todo, const auto& run, const auto& take) {
        static_assert(detail::BytesOf<Result>::known,
                      "Ansatz: results of this type cannot be sent to another rank; give back numbers, a trivially "
                      "copyable struct of them, a std::vector of such or a std::string");
        if (!leads()) return work<Result>(run);
        if (ranks_.size() == 1) return OneByOne{}.each<Result>(todo, run, take);
        hand_out<Result>(todo, take);
    }

    /// Brings the sentence of rank 0 to all ranks, an empty one too.
    void agree(std::string& failure) { share_text(failure); }
    /// Brings the results of rank 0, or the sentence of what went wrong there, to all ranks.
    template <class Result> void share(std::vector<Result>& results, std::string& failure) {
        std::vector<std::uint64_t> sizes;
        std::string bytes;
        if (leads() && failure.empty())
            for (const auto& result : results) {
                const std::string one = detail::BytesOf<Result>::write(result);
                sizes.push_back(one.size());
                bytes += one;
            }
        share_text(failure);
        if (!failure.empty()) return;
        std::uint64_t count = sizes.size();
        boost::mpi::broadcast(ranks_, count, 0);
        sizes.resize(std::size_t(count));
        if (count > 0) boost::mpi::broadcast(ranks_, sizes.data(), int(count), 0);
        share_text(bytes);
        if (leads()) return;
        std::size_t at = 0;
        for (const auto size : sizes) {
            results.push_back(detail::BytesOf<Result>::read(bytes.substr(at, std::size_t(size))));
            at += std::size_t(size);
        }
    }

private:
    enum Tag : int { asks = 1, runs = 2, gives = 3, failed = 4 };
    static constexpr std::uint64_t nothing_left = ~std::uint64_t(0);

    /// What a rank other than 0 does: it asks for a run, sends what came of it, and asks again.
    template <class Result> void work(const auto& run) {
        for (send(asks, nothing_left, {});;) {
            std::uint64_t index = nothing_left;
            ranks_.recv(0, runs, index);
            ++messages_;
            if (index == nothing_left) return;
            try {
                send(gives, index, detail::BytesOf<Result>::write(run(std::size_t(index))));
            } catch (const std::exception& e) {
                send(failed, index, e.what());
            }
        }
    }

    /// What rank 0 does: it answers each result with the next run, until every rank has been told that none is left.
    template <class Result> void hand_out(const std::vector<std::size_t>& todo, const auto& take) {
        detail::LastWords words;
        std::size_t next = 0, taken = 0;
        std::uint64_t first_failed = nothing_left;
        std::string why;
        const auto tell = [&] {
            words.set(
                detail::joined({"\nensemble: a rank has died, or the program was told to end, after ",
                                std::to_string(taken), " of ", std::to_string(todo.size()),
                                " runs of this call; with EnsembleOptions::kept the same call goes on from there\n"}));
        };
        tell();
        for (int working = ranks_.size() - 1; working > 0;) {
            const auto [source, tag, index, bytes] = next_message();
            if (tag == failed && index < first_failed) {
                first_failed = index;
                why = bytes;
            } else if (tag == gives && why.empty()) {
                try {
                    take(std::size_t(index), detail::BytesOf<Result>::read(bytes));
                } catch (const std::exception& e) { // the file cannot be written
                    why = e.what();
                }
                ++taken;
                tell();
            }
            const bool more = why.empty() && next < todo.size();
            ranks_.send(source, runs, more ? std::uint64_t(todo[next++]) : nothing_left);
            ++messages_;
            if (!more) --working;
        }
        if (!why.empty()) throw std::runtime_error(why);
    }

    struct Message {
        int source, tag;
        std::uint64_t index;
        std::string bytes;
    };
    /// Waits for a message of any rank; asleep, because MPI's own waiting takes a core.
    Message next_message() {
        auto wait = std::chrono::microseconds(20);
        for (;;) {
            if (const auto status = ranks_.iprobe(boost::mpi::any_source, boost::mpi::any_tag)) {
                Message message{status->source(), status->tag(), 0, {}};
                std::string packed;
                packed.resize(std::size_t(*status->count<char>()));
                ranks_.recv(message.source, message.tag, packed.data(), int(packed.size()));
                ++messages_;
                std::memcpy(&message.index, packed.data(), sizeof message.index);
                message.bytes = packed.substr(sizeof message.index);
                return message;
            }
            std::this_thread::sleep_for(wait);
            if (wait < std::chrono::milliseconds(1)) wait *= 2;
        }
    }
    void send(Tag tag, std::uint64_t index, const std::string& bytes) {
        std::string packed(sizeof index, '\0');
        std::memcpy(packed.data(), &index, sizeof index);
        packed += bytes;
        ranks_.send(0, int(tag), packed.data(), int(packed.size()));
        ++messages_;
    }
    void share_text(std::string& text) {
        std::uint64_t size = text.size();
        boost::mpi::broadcast(ranks_, size, 0);
        text.resize(std::size_t(size));
        if (size > 0) boost::mpi::broadcast(ranks_, text.data(), int(size), 0);
    }

    boost::mpi::communicator ranks_;
    std::size_t messages_ = 0;
};

} // namespace ansatz
