# SPDX-License-Identifier: BSL-1.0
"""The drawing of the frame (tools/workshop/frame_picture.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest
import xml.etree.ElementTree

from workshop import frame_picture

SCHEDULE = """
inline constexpr Phase forces{30};      ///< laws & couplings
inline constexpr Phase fields{70};      ///< what has a `state` advances
inline constexpr Phase between_them = between(forces, fields); ///< in the middle
"""
MODULE = """
#include <ansatz/world/schedule.hpp>
#include <ansatz/core/error.hpp>
struct Advance {
    static constexpr Phase phase = phases::forces, until = phases::fields;
    static constexpr std::string_view name = "parts";
};
struct Flow {
    static constexpr Phase phase = phases::between_them;
    static constexpr std::string_view name = "flow";
};
"""
ROOMS = {"core": {"core/error.hpp": ""}, "world": {"world/schedule.hpp": "#include <ansatz/core/error.hpp>\n" + SCHEDULE},
         "water": {"water/module.hpp": MODULE}}


class Rooms(unittest.TestCase):
    """Who includes whom."""

    def test_arrows(self) -> None:
        """An arrow that leads through another room is not drawn twice."""
        arrows = frame_picture.arrows_of(ROOMS)
        self.assertEqual(arrows, {"core": set(), "world": {"core"}, "water": {"world", "core"}})
        self.assertEqual(frame_picture.reduced(arrows), {"core": set(), "world": {"core"}, "water": {"world"}})
        self.assertEqual(frame_picture.storeys(arrows), {"core": 0, "world": 1, "water": 2})

    def test_ring(self) -> None:
        """Rooms that include each other have no storeys."""
        with self.assertRaisesRegex(ValueError, "a -> b -> a"):
            frame_picture.storeys({"a": {"b"}, "b": {"a"}})


class Step(unittest.TestCase):
    """Phases and systems."""

    def test_order(self) -> None:
        """A phase between two stands between them."""
        self.assertEqual([(phase.name, phase.at) for phase in frame_picture.phases_of(ROOMS)],
                         [("forces", 30.0), ("between_them", 50.0), ("fields", 70.0)])

    def test_systems(self) -> None:
        """With the room that they are of, and how far a driver reaches."""
        self.assertEqual(frame_picture.systems_of(ROOMS),
                         [frame_picture.System("parts", "water", "forces", "fields"),
                          frame_picture.System("flow", "water", "between_them", "")])


class Drawing(unittest.TestCase):
    """The whole."""

    def test_xml(self) -> None:
        """Well-formed, with every name, whatever it is made of."""
        with tempfile.TemporaryDirectory() as folder:
            for headers in ROOMS.values():
                for path, text in headers.items():
                    os.makedirs(os.path.dirname(f"{folder}/{path}"), exist_ok=True)
                    with open(f"{folder}/{path}", "w", encoding="utf-8") as stream:
                        stream.write(text)
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                self.assertEqual(frame_picture.main([folder]), 0)
        words = [text.text for text in xml.etree.ElementTree.fromstring(printed.getvalue()).iter(
            "{http://www.w3.org/2000/svg}text")]
        for word in ("water", "laws & couplings", "flow (water)", "what has a state advances",
                     "parts (water): a driver, it owns the phases along the bar", "1 header"):
            self.assertIn(word, words)

    def test_library(self) -> None:
        """Of the library: every phase of the schedule, and the systems of both modules."""
        here = os.path.join(os.path.dirname(__file__), "../../../include/ansatz")
        rooms = frame_picture.headers_of(here)
        drawn = frame_picture.drawing(rooms)
        with open(f"{here}/world/schedule.hpp", encoding="utf-8") as stream:
            self.assertEqual(stream.read().count("inline constexpr Phase "),
                             sum(phase.name != "contacts" for phase in frame_picture.phases_of(rooms)))
        for name in ("substeps (collision)", "forces and integration (motion)", "clock (world)"):
            self.assertIn(name, drawn)
