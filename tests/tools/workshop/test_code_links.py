# SPDX-License-Identifier: BSL-1.0
"""Which links of a listing are wrong (tools/workshop/code_links.py)."""

from __future__ import annotations

import html
import re
import unittest

from workshop import code_links


def link(text: str, page: str = "namespaceansatz.html", kind: str = "function") -> str:
    """As Doxygen writes it."""
    return f'<a class="code hl_{kind}" href="{page}#a1">{text}</a>'


def unit(text: str) -> str:
    """A link to a unit."""
    return link(text, kind="variable")


def listing(*lines: str) -> str:
    """A page with one."""
    inner = "\n".join(f'<div class="line">{line}</div>' for line in lines)
    return f'<p>{link("outside", "x_8hpp.html")}</p><div class="fragment">{inner}\n</div><!-- fragment -->'


class Listings(unittest.TestCase):
    """What stays of the links of a line."""

    def left(self, *lines: str, name: str = "section_1_5") -> list[str]:
        """The texts of the links that stay."""
        mended = code_links.without_wrong_links(listing(*lines), name)
        self.assertEqual(re.sub("<[^>]*>", "", mended), re.sub("<[^>]*>", "", listing(*lines)), "the words stay as they are")
        return [html.unescape(found["text"]) for found in code_links.LINK.finditer(mended)][1:]

    def test_what_the_listing_declares(self) -> None:
        """Its own function is not the library's, before and behind the line that declares it; nor is a parameter."""
        states = "namespaceansatz_1_1states.html"
        self.assertEqual(self.left(f"inline End {link('after', states)}(Velocity u);", f"{link('after', states)}(u)",
                                   name="section_5_1"), [])
        self.assertEqual(self.left(f"const {link('norm')}, double {link('mass')}, {link('mass')} * 2"), ["norm"])
        self.assertEqual(self.left(f"for (auto&amp; [end, {link('mass')}] : all)"), [])
        self.assertEqual(self.left(f"Quantity&lt;unit::Time&gt; {link('mass')};"), [])

    def test_what_declares_nothing(self) -> None:
        """A comment, a string, and the window that shows where the mouse is."""
        for line in ("// A double mass;", '"Mass mass = "', '<div class="ttc" id="a">constexpr Mass mass(Q x)</div>'):
            self.assertEqual(self.left(line, f"{link('mass')}(2)"), ["mass"], line)

    def test_members(self) -> None:
        """A function of a namespace is no member; a member of a type is one, and stands alone nowhere."""
        of_type = "structansatz_1_1Spring.html"
        self.assertEqual(self.left(f"it.{link('norm')}", f"it-&gt;{link('norm')}", f"{link('norm')}(it)"), ["norm"])
        self.assertEqual(self.left(f"it.{link('first', of_type)}", f"{link('first', of_type)}"), ["first"])

    def test_second(self) -> None:
        """Is a unit where it is multiplied or asked for."""
        second = unit("second")
        self.assertEqual(self.left(f"it.{second}", f"f({second})", f"first == {second})", f"g = {second};"), [])
        for good in (f"1.0 / 60 * {second}", f"x / ({second} * y)", f"{second} * y", f"{second}/y", f"in({second})",
                     f"in(a, {second})"):
            self.assertEqual(self.left(good), ["second"], good)
        self.assertEqual(self.left(f"in(x, {unit('metre')})", f"f({unit('metre')})"), ["metre", "metre"])

    def test_namespaces(self) -> None:
        """What stands in another namespace is called by its short name where the page is that namespace's."""
        states = link("to", "namespaceansatz_1_1states.html")
        self.assertEqual(self.left(states), [])
        self.assertEqual(self.left(states, name="section_5_1"), ["to"])
        self.assertEqual(self.left(states, name="program_states_5"), ["to"])
        self.assertEqual(self.left(states, "using namespace ansatz::states;"), ["to"])
        phase = link("end", "namespaceansatz_1_1phases.html", "variable")
        self.assertEqual(self.left(phase, link("tension", "hooke_8hpp.html"), link("found", kind="enumvalue")), [])

    def test_qualified(self) -> None:
        """By the namespace that it leads to."""
        mechanics = "namespaceansatz_1_1mechanics.html"
        self.assertEqual(self.left(link("suvat::acceleration", mechanics), link("mechanics::force", mechanics)),
                         ["mechanics::force"])
        self.assertEqual(self.left(link("ansatz::states", "namespaceansatz_1_1states.html", "namespace"),
                                   link("Motion::fixed", "namespaceansatz.html", "enumvalue")), ["ansatz::states", "Motion::fixed"])

    def test_types_stay(self) -> None:
        self.assertEqual(self.left(link("Drag", "structansatz_1_1Drag.html", "struct")), ["Drag"])

    def test_sources_stay(self) -> None:
        """There a name is linked to what it declares."""
        page = listing(f"inline End {link('after')}(u)")
        self.assertEqual(code_links.without_wrong_links(page, "after_8hpp_source"), page)


if __name__ == "__main__":
    unittest.main()
