// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Plays random scenes in a composition until one breaks a law or the time is over, and makes a program of it.

#include "tests/fuzz/scenes.hpp"
#include "tests/fuzz/shrink.hpp"

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <optional>
#include <string>

namespace fuzz {

struct Found {
    std::string law;
    std::uint64_t seed; ///< of the scene
    std::string program;
    int lines;
};
struct Hunt {
    std::uint64_t scenes = 0;
    std::optional<Found> found;
};

/// s, of this process
inline double processor_time() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// \param seconds of processor time; at least one scene is played
inline Hunt hunt(const Subject& subject, std::uint64_t seed, double seconds) {
    Hunt result;
    const double begin = processor_time();
    do {
        const std::uint64_t one = seed + result.scenes++;
        const Scene scene = Scenes(subject.facts(), one).scene();
        const auto fault = Play(subject).run(scene);
        if (!fault) continue;
        const Scene small = Shrinker(subject, fault->law).shrunk(scene);
        const auto same = Play(subject).run(small);
        const std::string check = same ? same->check : fault->check;
        Program program(subject.facts(), check);
        Play(subject, &program).run(small);
        const auto text = program.text(fault->law + " (seed " + std::to_string(one) + ")");
        result.found = {fault->law, one, text, int(std::count(text.begin(), text.end(), '\n'))};
    } while (!result.found && processor_time() - begin < seconds);
    return result;
}

} // namespace fuzz
