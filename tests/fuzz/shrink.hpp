// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Makes a scene that breaks a law as small as it can be while it breaks the same law: it leaves out operations, as
/// many at once as it can (delta debugging, Zeller and Hildebrandt 2002), and then makes the numbers of the others
/// rounder.

#include "tests/fuzz/play.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace fuzz {

class Shrinker {
public:
    /// \param plays how many scenes it may play at most
    Shrinker(const Subject& subject, std::string law, int plays = 5000)
        : subject_(subject), law_(std::move(law)), plays_(plays) {}

    Scene shrunk(Scene scene) {
        scene = played(scene);
        std::size_t before = 0;
        do {
            before = weight(scene);
            leave_out(scene);
            simplify(scene);
        } while (weight(scene) < before && plays_ > 0);
        return joined(scene);
    }

private:
    bool fails(const Scene& scene) {
        if (--plays_ < 0) return false;
        const auto fault = Play(subject_).run(scene);
        return fault && fault->law == law_;
    }
    Scene played(const Scene& scene) {
        Play play(subject_);
        play.run(scene);
        return play.played();
    }
    /// Halves, quarters, and at last every operation by itself.
    void leave_out(Scene& scene) {
        for (std::size_t part = std::max<std::size_t>(scene.size() / 2, 1); part >= 1; part /= 2) {
            for (std::size_t from = 0; from < scene.size();) {
                Scene without(scene.begin(), scene.begin() + std::ptrdiff_t(from));
                const auto to = std::min(from + part, scene.size());
                without.insert(without.end(), scene.begin() + std::ptrdiff_t(to), scene.end());
                if (fails(without)) scene = without;
                else from = to;
            }
        }
    }
    void simplify(Scene& scene) {
        const int dimension = subject_.facts().dimension;
        for (std::size_t i = 0; i < scene.size(); ++i) {
            const auto try_it = [&](auto&& change) {
                const Operation was = scene[i];
                change(scene[i]);
                if (fails(scene)) return true;
                scene[i] = was;
                return false;
            };
            if (scene[i].verb == Verb::add && scene[i].kind != Kind::awake && scene[i].shape != Shape::plane)
                try_it([](Operation& o) { o.kind = Kind::awake; });
            if (scene[i].verb == Verb::add && scene[i].shape == Shape::box)
                try_it([](Operation& o) { o.shape = Shape::sphere; });
            const std::size_t numbers = numbers_of(scene[i], dimension).size();
            for (std::size_t k = 0; k < numbers; ++k) {
                const auto number = [&](Operation& o) -> double& { return *numbers_of(o, dimension)[k]; };
                const double x = number(scene[i]);
                for (const double rounder : {0.0, 1.0, -1.0, 0.5, std::round(x), std::round(x * 10) / 10,
                                             std::round(x * 100) / 100, std::round(x * 1e4) / 1e4}) {
                    if (std::isfinite(x) && simpler(rounder, x) && try_it([&](Operation& o) { number(o) = rounder; }))
                        break;
                }
            }
        }
    }
    static std::size_t length(double x) { return x == 0 ? 0 : text_of(x).size(); }
    static bool simpler(double a, double b) { return length(a) < length(b); }
    std::size_t weight(Scene& scene) const {
        std::size_t sum = 0;
        for (auto& o : scene) {
            sum += 100;
            for (const double* number : numbers_of(o, subject_.facts().dimension)) sum += length(*number);
        }
        return sum;
    }
    /// Equal steps, one after another, are one line; the last stays alone, because something is tested before it.
    static Scene joined(const Scene& scene) {
        Scene all;
        for (std::size_t i = 0; i < scene.size(); ++i) {
            const auto& o = scene[i];
            const bool again = o.verb == Verb::step && !all.empty() && all.back().verb == Verb::step &&
                               all.back().dt == o.dt && i + 1 < scene.size();
            if (again) ++all.back().times;
            else all.push_back(o);
        }
        return all;
    }

    const Subject& subject_;
    std::string law_;
    int plays_;
};

} // namespace fuzz
