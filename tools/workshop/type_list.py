# SPDX-License-Identifier: BSL-1.0
"""The list of types with those that users name (named.py), open from the beginning; in the navigation the same.

Doxygen's has every type that is documented, hooks, doors and rows of tables among them. Their pages stay, and links lead to
them: in the navigation they then stand at the list. site_pages.py calls this for the finished site.
"""

from __future__ import annotations

import glob
import html
import json
import os
import re
from typing import Callable, NamedTuple, Optional, Union

# A node of the navigation: title, page (of a namespace that nothing is said of there is none), and what is below it: a list, the
# name of another file, or nothing.
Node = tuple[str, Optional[str], Union[list["Node"], str, None]]
Kept = Callable[[tuple[str, ...], str], bool]
PLACE = re.compile(r'^("[^"\n]*"):\[([0-9,]+)\](,?)$', re.MULTILINE)
ROW = re.compile(r'<tr id="row_([0-9_]+)"[^>]*>(.*?)</tr>\n?', re.DOTALL)
NAME = re.compile(r'<a class="el" href="([^"]*)" target="_self">(.*?)</a>')


class Shorter(NamedTuple):
    """A list of nodes, and for each place in the longer one that in this one, or where it ended."""
    nodes: list[Node]
    places: dict[tuple[int, ...], tuple[int, ...]]


def is_namespace(node: Node) -> bool:
    """A type has a page."""
    return node[1] is None or node[1].startswith("namespace")


def is_specialised(title: str, beside: list[Node]) -> bool:
    """Table<S, Q> where Table itself stands beside it."""
    name, angle, _ = html.unescape(title).partition("<")
    return bool(angle) and any(node[0] == name.strip() for node in beside)


def shorter(nodes: list[Node], kept: Kept, space: tuple[str, ...] = ()) -> Shorter:
    """The types that are kept, and the namespaces that have such."""
    found = Shorter([], {})
    for at, node in enumerate(nodes):
        title, page, below = node
        inner = Shorter([], {})
        if is_namespace(node):
            inner = shorter(below if isinstance(below, list) else [], kept, (*space, *title.split("::")))
            stays = bool(inner.nodes)
        else:
            stays = kept(space, html.unescape(title)) and not is_specialised(title, nodes)
        if not stays:
            continue
        place = len(found.nodes)
        found.nodes.append((title, page, inner.nodes if is_namespace(node) else below))
        found.places[(at,)] = (place,)
        found.places.update({(at, *old): (place, *new) for old, new in inner.places.items()})
    return found


def depth_of(nodes: list[Node], place: tuple[int, ...]) -> int:
    """How many numbers of a place lead through this list; the others lead through the page that stands there."""
    depth = 0
    below: Union[list[Node], str, None] = nodes
    while isinstance(below, list) and depth < len(place):
        below = below[place[depth]][2]
        depth += 1
    return depth


def moved(index: str, nodes: list[Node], places: dict[tuple[int, ...], tuple[int, ...]], root: tuple[int, ...]) -> str:
    """An index of the navigation, pages with their places, where the list below the root has become shorter."""
    def place(found: re.Match[str]) -> str:
        numbers = tuple(int(number) for number in found[2].split(","))
        if numbers[:len(root)] != root or len(numbers) == len(root):
            return found[0]
        rest = numbers[len(root):]
        depth = depth_of(nodes, rest)
        new = (*root, *places[rest[:depth]], *rest[depth:]) if rest[:depth] in places else root
        return f"{found[1]}:[{','.join(map(str, new))}]{found[3]}"
    return PLACE.sub(place, index)


def pages_of(nodes: list[Node]) -> set[str]:
    """Every page of the list."""
    return {page for _, page, _ in nodes if page}.union(*(pages_of(below) for _, _, below in nodes if isinstance(below, list)))


def open_list(page: str, kept: set[str]) -> str:
    """The page of the list with the rows of these pages, all of them open."""
    count = 0

    def row(found: re.Match[str]) -> str:
        nonlocal count
        name = NAME.search(found[2])
        if not name or name[1] not in kept:
            return ""
        count += 1
        inner = found[2].replace("&#9658;", "&#9660;" if name[1].startswith("namespace") else "&#160;")
        return f'<tr id="row_{found[1]}" class="{"even" if count % 2 else "odd"}">{inner}</tr>\n'
    page = re.sub(r'<div class="levels">.*?</div>', "", page)
    return ROW.sub(row, page)


def mend(folder: str, kept: Kept) -> None:
    """Writes the list, its branch of the navigation, and where there each page stands."""
    def read(file: str) -> str:
        with open(f"{folder}/{file}", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
            return stream.read()

    def write(file: str, text: str) -> None:
        with open(f"{folder}/{file}", "w", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
            stream.write(text)
    if not os.path.isfile(f"{folder}/annotated.js"):
        return
    head, _, tree = read("annotated.js").partition("=")
    nodes: list[Node] = json.loads(tree.strip().removesuffix(";"))
    short = shorter(nodes, kept)
    write("annotated.js", f"{head}=\n{json.dumps(short.nodes, indent=0, ensure_ascii=False)};\n")
    write("annotated.html", open_list(read("annotated.html"), pages_of(short.nodes)))
    indices = [os.path.basename(file) for file in glob.glob(f"{glob.escape(folder)}/navtreeindex*.js")]
    texts = {file: read(file) for file in indices}
    root = next((found for text in texts.values() for found in re.findall(r'^"annotated\.html":\[([0-9,]+)\]', text, re.MULTILINE)), "")
    for file, text in texts.items():
        if root:
            write(file, moved(text, nodes, short.places, tuple(int(number) for number in root.split(","))))
