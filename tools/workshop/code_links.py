# SPDX-License-Identifier: BSL-1.0
"""Links in the listings of a page that lead to something else than what the listing names.

Doxygen links a word of a listing to whatever it knows by that name: the member `it.second` to the unit second, a function
after() that the listing itself defines to ansatz::states::after. site_pages.py asks this module for each page; what a rule
below takes for wrong becomes a plain word again.

A word without a namespace before it is no link where

- the listing declares it itself,
- it is a member (behind . or ->) that is not the member of a type, or no member where Doxygen means one,
- it means a namespace that the page does not speak of: phases::end and hooke::tension are called by their whole names,
- it is an enumerator, which is never called without its enumeration,
- it is `second`, and nothing is multiplied with it or divided by it, and no number is asked in it: then it comes behind the first.

A word with its namespace is no link where that leads to another one, as suvat::acceleration to mechanics.
"""

from __future__ import annotations

import html
import re

FRAGMENT = re.compile(r'<div class="fragment">.*?</div><!-- fragment -->', re.DOTALL)
LINK = re.compile(r'<a class="code(?: hl_(?P<kind>\w+))?" href="(?P<page>[^"#]*)(?:#[^"]*)?">(?P<text>[^<]*)</a>')
TAG = re.compile(r"<[^>]*>")
TOLD = re.compile(r'<div class="ttc".*')    # what shows where the mouse is: not of the listing, though it stands in it
# A type and what it declares: "const auto& after =", "Quantity<unit::Time> second,", "double end;".
TYPE = r"(?:\b(?:auto|double|float|bool|int|unsigned|char|(?:\w+::)*[A-Z]\w*|std::\w+)(?:<[^;(){}]*>)?(?:::\w+)*[&*]*(?: const)?[&*]*)"
DECLARED = re.compile(TYPE + r" ([a-z_]\w*) ?(?=[=;,(){\[]|: )")
BOUND = re.compile(r"\bauto ?&{0,2} ?\[([\w, ]*)\]")
WORD = re.compile(r"[a-z_]\w*")
SAID = re.compile(r"//[^\n]*|\"(?:[^\"\\\n]|\\.)*\"")
# Where a chapter's listings use names of its namespace without saying so.
AT_HOME = {"states": "states|section_5", "paths": "paths|section_6", "goap": "paths|goap|section_6", "water": "water|section_7"}


def declared(listing: str) -> frozenset[str]:
    """The names that a listing, which has no tags any more, declares; comments and strings declare none."""
    listing = SAID.sub(" ", listing)
    bound = (name.strip() for names in BOUND.findall(listing) for name in names.split(","))
    return frozenset(DECLARED.findall(listing)) | frozenset(bound)


def space_of(page: str) -> str:
    """"states" of namespaceansatz_1_1states.html, nothing of any other page."""
    found = re.fullmatch(r"namespaceansatz_1_1(\w+)\.html", page)
    return found[1] if found else ""


def at_home(space: str, page: str, text: str) -> bool:
    """Whether the page of this name, with this text, calls things of the namespace by their short names."""
    last = space.rpartition("_1_1")[2]
    named = f"namespace ansatz::{space.replace('_1_1', '::')};" in text or last in AT_HOME and f"{last}::" in text
    return named or re.search(AT_HOME.get(last, f"_1_1{last}"), page) is not None


def is_wrong(link: re.Match[str], before: str, behind: str, own: frozenset[str], short: frozenset[str]) -> bool:
    """Of a link between the text of its line before and behind it; the names that the listing declares are its own, and those
    namespaces are `short` that the page leaves out."""
    text, target, kind = html.unescape(link["text"]), link["page"], link["kind"]
    if kind == "namespace":
        return False
    if qualified := re.fullmatch(r"(?:\w+::)*(\w+)::[a-z_]\w*", text):
        space = space_of(target).rpartition("_1_1")[2]
        return bool(space) and WORD.fullmatch(qualified[1]) is not None and qualified[1] != space
    if kind not in ("function", "variable", "enumvalue", "typedef") or not WORD.fullmatch(text) or before.endswith("::"):
        return False
    of_type = re.match(r"(?:struct|class)ansatz", target) is not None
    is_member = re.search(r"(?:\.|->)$", before) is not None
    if text in own or is_member != of_type or kind == "enumvalue":
        return True
    if target.endswith("_8hpp.html") or (space := space_of(target)) and space not in short:
        return True
    counted = re.search(r"[*/] ?\(?$|\bin\((?:.*, )?$", before) or re.match(r" ?[*/]", behind)
    return text == "second" and not counted


def mended_listing(listing: str, short: frozenset[str]) -> str:
    """A listing without the links that are wrong."""
    own = declared(html.unescape(TAG.sub("", TOLD.sub("", listing))))
    lines: list[str] = []
    for line in listing.split("\n"):
        def word(link: re.Match[str], line: str = line) -> str:
            before = html.unescape(TAG.sub("", line[:link.start()]))
            behind = html.unescape(TAG.sub("", line[link.end():]))
            return link["text"] if is_wrong(link, before, behind, own, short) else link[0]
        lines.append(LINK.sub(word, line))
    return "\n".join(lines)


def without_wrong_links(page: str, name: str) -> str:
    """The page of this name with mended listings. That of a source is its own dictionary, and stays."""
    if name.endswith("_source") or 'class="fragment"' not in page:
        return page
    spaces = frozenset(filter(None, (space_of(link["page"]) for link in LINK.finditer(page))))
    text = html.unescape(TAG.sub("", page)) if spaces else ""
    short = frozenset(space for space in spaces if at_home(space, name, text))
    return FRAGMENT.sub(lambda listing: mended_listing(listing[0], short), page)
