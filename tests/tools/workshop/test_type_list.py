# SPDX-License-Identifier: BSL-1.0
"""The list of types without those of the frame (tools/workshop/type_list.py)."""

from __future__ import annotations

import os
import tempfile
import unittest

from workshop import type_list

TREE: list[type_list.Node] = [("ansatz", "namespaceansatz.html", [
    ("hook", "namespacehook.html", [("Wake", "structhook_Wake.html", None)]),
    ("states", "namespacestates.html", [("To", "structTo.html", "structTo"), ("Row", "structRow.html", None)]),
    ("Door", "structDoor.html", "structDoor"), ("Lanes", "structLanes.html", None),
    ("Lanes&lt; S &gt;", "structLanes_S.html", None), ("World", "classWorld.html", "classWorld")])]


def kept(space: tuple[str, ...], name: str) -> bool:
    """What these tests keep."""
    return "hook" not in space and name not in ("Door", "Row")


class Lists(unittest.TestCase):
    """The navigation."""

    def test_shorter(self) -> None:
        """A namespace without types goes, as a specialisation beside its template does; places are counted again."""
        short = type_list.shorter(TREE, kept)
        self.assertEqual([node[0] for node in short.nodes[0][2] or [] if not isinstance(node, str)], ["states", "Lanes", "World"])
        self.assertEqual(short.places, {(0,): (0,), (0, 1): (0, 0), (0, 1, 0): (0, 0, 0), (0, 3): (0, 1), (0, 5): (0, 2)})
        self.assertEqual(short.nodes[0][2][0], ("states", "namespacestates.html", [TREE[0][2][1][2][0]]))  # type: ignore[index]

    def test_a_namespace_without_a_page(self) -> None:
        """Nothing is said of it, but it has types."""
        bare: list[type_list.Node] = [("named", None, [("World", "w.html", None), ("Row", "r.html", None)])]
        self.assertEqual(type_list.shorter(bare, kept).nodes, [("named", None, [("World", "w.html", None)])])
        self.assertEqual(type_list.pages_of(bare), {"w.html", "r.html"})

    def test_what_is_asked(self) -> None:
        """The namespaces, from the outermost."""
        asked: list[tuple[str, ...]] = []

        def keep(space: tuple[str, ...], name: str) -> bool:
            asked.append((*space, name))
            return False
        self.assertEqual(type_list.shorter(TREE, keep).nodes, [])
        self.assertEqual(asked[:2], [("ansatz", "hook", "Wake"), ("ansatz", "states", "To")])

    def test_a_specialisation_alone_stays(self) -> None:
        alone: list[type_list.Node] = [("Lanes&lt; S &gt;", "a.html", None)]
        self.assertEqual(type_list.shorter(alone, lambda _, name: name == "Lanes< S >").nodes, alone)

    def test_places(self) -> None:
        """Members move with their type; what is gone stands at the list; other branches stay."""
        short = type_list.shorter(TREE, kept)
        index = '"a.html":[3,0],\n"classWorld.html":[13,0,0,5],\n"classWorld.html#a1":[13,0,0,5,7],\n' \
                '"structDoor.html#a2":[13,0,0,2,1],\n"x.html":[13,1,0],\n"annotated.html":[13,0]\n'
        self.assertEqual(type_list.moved(index, TREE, short.places, (13, 0)),
                         '"a.html":[3,0],\n"classWorld.html":[13,0,0,2],\n"classWorld.html#a1":[13,0,0,2,7],\n'
                         '"structDoor.html#a2":[13,0],\n"x.html":[13,1,0],\n"annotated.html":[13,0]\n')

    def test_page(self) -> None:
        """Every row that stays is open, and striped again; the others are gone, and with them the choice of levels."""
        def row(number: str, page: str, hidden: str = "") -> str:
            return f'<tr id="row_{number}"{hidden}><td>&#9658;<a class="el" href="{page}" target="_self">x</a></td></tr>\n'
        hidden = ' style="display:none;"'
        page = ('<div class="levels">[detail <span>1</span>]</div><table>\n' + row("0_", "namespacea.html", ' class="even"')
                + row("0_0_", "a.html", hidden) + row("0_1_", "b.html", hidden) + "</table>")
        opened = type_list.open_list(page, {"namespacea.html", "b.html"})
        self.assertEqual(opened, "<table>\n" + row("0_", "namespacea.html", ' class="even"').replace("58", "60")
                         + row("0_1_", "b.html", ' class="odd"').replace("&#9658;", "&#160;") + "</table>")


class Files(unittest.TestCase):
    """Of a site."""

    def test_written(self) -> None:
        """List, branch and index agree; without a list nothing happens."""
        with tempfile.TemporaryDirectory() as folder:
            type_list.mend(folder, kept)
            self.assertEqual(os.listdir(folder), [])
            files = {"annotated.js": 'var annotated =\n[\n  [ "Door", "d.html", null ],\n  [ "World", "w.html", "w" ]\n];\n',
                     "annotated.html": '<tr id="row_0_" class="even"><a class="el" href="d.html" target="_self">Door</a></tr>\n',
                     "navtreeindex0.js": '"annotated.html":[13,0],\n"d.html":[13,0,0],\n"w.html":[13,0,1]\n',
                     "navtreeindex1.js": '"w.html#a":[13,0,1,4]\n'}
            for name, text in files.items():
                with open(f"{folder}/{name}", "w", encoding="utf-8") as stream:
                    stream.write(text)
            type_list.mend(folder, kept)
            said = {}
            for name in files:
                with open(f"{folder}/{name}", encoding="utf-8") as stream:
                    said[name] = "".join(stream.read().split())
            self.assertEqual(said, {"annotated.js": 'varannotated=[["World","w.html","w"]];', "annotated.html": "",
                                    "navtreeindex0.js": '"annotated.html":[13,0],"d.html":[13,0],"w.html":[13,0,0]',
                                    "navtreeindex1.js": '"w.html#a":[13,0,0,4]'})


if __name__ == "__main__":
    unittest.main()
