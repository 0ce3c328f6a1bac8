// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The guard's evening of guard_npc.hpp as a film.

#include "film.hpp"
#include "guard_npc.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace guard {

/// The evening as a film. His colour is his state, and the strip on the floor is where he sees (GuardNpc::sight): up to
/// 9 m to each side while he chases, else up to 7 m.
inline void draw_evening() {
    using namespace workbook;
    Film film(
        "5.1", "What the guard does, and where he sees",
        "A guard walks between two posts. He stops when he hears a noise, and goes on. An intruder comes; the guard "
        "sees him, chases him and strikes four times. The intruder runs, the guard loses sight of him, looks for "
        "him and goes back to his posts.",
        {.middle = metres(14.5, 1.1, 0), .width = 37.0 * metre, .height = 6.0 * metre});
    film.rate(20).may_change().may_leave();
    film.scenery().line(std::vector{metres(-4, 0, 0), metres(33, 0, 0)}, paints::stone);
    for (const double post : {0.0, 10.0})
        film.scenery().box(metres(post, -0.4, 0), metres(0.2, 0.35, 0.01), paints::wood);
    const std::map<std::string_view, Paint> paint_of{
        {"patrol", {0x009e73, 0}}, {"search", {0xe0a020, 0}}, {"chase", {0xd55e00, 0}}, {"strike", {0xa01020, 0}}};
    Npc npc;
    Machine<GuardNpc> machine;
    const EventId noise = machine.event("noise");
    int step = 0, heard = -1000;
    const auto frame = [&] {
        const double at = in(npc.place, metre), sees = machine.is_in("chase") ? 9 : 7;
        auto& now = film.frame(step / 60.0 * second);
        now.filled(std::vector{metres(at - sees, 0.25, 0), metres(at + sees, 0.25, 0)}, 0.0 * metre, {0xf4dc90, 0})
            .ball(metres(at, 0.9, 0), 0.6 * metre, paint_of.at(machine.active_name()))
            .ball(metres(in(npc.intruder, metre), 0.9, 0), 0.6 * metre, paints::stone)
            .note(metres(at - 1, 2, 0), std::string(machine.active_name()));
        if (npc.intruder < 31.0 * metre) now.note(metres(in(npc.intruder, metre) - 1.4, -0.9, 0), "intruder");
        if (step - heard < 90) now.note(metres(14, 3, 0), "a noise"); // for a second and a half
    };
    evening(
        npc, [&](Npc& n) { machine.start(n), frame(); }, [&](Npc& n) { machine.handle(n, noise), heard = step; },
        [&](Npc& n, Time dt) {
            machine.update(n, dt);
            if (++step % 24 == 0 && step <= 40 * 60) frame(); // each 0.4 s, and not the last 5 s
        },
        [&] { return machine.active_name(); });
    film.write();
}

} // namespace guard
