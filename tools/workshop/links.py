# SPDX-License-Identifier: BSL-1.0
"""The faults of a site's pages: what asks another host, and links to pages and places that are not there.

    links.py <the folder with the html>

It reads the pages, the styles, the pictures, the scripts, and the lists that the navigation and the search are made of;
not MathJax, of which only what is wanted is copied.

Debian's linkchecker is no substitute: it takes four minutes for what takes seconds here, follows neither the navigation
nor the search, which are scripts, and without a network says nothing of what a page asks from another host.
Tags are found by a regular expression, and each different one is read once by html.parser, which alone, on every tag of
some thousand pages, takes four times as long.
"""

from __future__ import annotations

import argparse
import functools
import html
import os
import re
import sys
from html.parser import HTMLParser
from typing import NamedTuple

# Scripts of Doxygen and of the theme: they hold addresses, and ask nobody.
KNOWN_SCRIPTS = re.compile(
    r"(jquery|dynsections|resize|navtree|menu|svgpan|clipboard|cookie|doxygen-awesome-(darkmode-toggle|"
    r"fragment-copy-button|interactive-toc|paragraph-link)|search/search)\.js")

# What can ask another host for something, by a name put together.
ASKS = re.compile(r"(^|[^A-Za-z_.])(fetch|importScripts|import) *\(|XMLHttpRequest|WebSocket|EventSource|sendBeacon")
ATTRIBUTES = r"(?:[^>\"']|\"[^\"]*\"|'[^']*')*"
TOKEN = re.compile(
    rf"<!--.*?-->|<(?P<block>(?P<kind>script|style)\b{ATTRIBUTES})>(?P<content>.*?)</(?P=kind)"
    rf"|<(?P<tag>[a-z]{ATTRIBUTES})>", re.DOTALL | re.IGNORECASE)
STYLE = re.compile(r"url\([^)]*\)|@import[ \t\n]+[\"'][^\"']*[\"']|image-set\([ \t\n]*[\"'][^\"']*[\"']", re.IGNORECASE)
LISTED = re.compile(r"[\"']([^\"' ]*\.html(?:#[^\"' ]*)?|[@\\]ref [^\"']*)[\"']")


class Tag(NamedTuple):
    """What a tag says, on whatever page it stands."""
    places: tuple[str, ...] = ()    # the names that links can lead to
    follows: tuple[str, ...] = ()   # the links that a reader may follow
    loads: tuple[str, ...] = ()     # and what a browser fetches without being asked
    faults: tuple[str, ...] = ()    # the ends of sentences that begin with the page


class Attributes(HTMLParser):
    """The attributes of a tag, by name."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=False)
        self.name = ""
        self.values: dict[str, str] = {}

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Of two attributes of one name the first counts."""
        self.name = tag
        self.values = {name: value or "" for name, value in reversed(attrs)}

    def of(self, tag: str) -> dict[str, str]:
        """Those of a tag without its brackets."""
        self.name, self.values = "", {}
        self.reset()
        self.feed(f"<{tag}>")
        return self.values


def is_elsewhere(link: str) -> bool:
    """Whether it names another host, or this one in a way that a disk does not understand."""
    return re.match(r"(https?:)?//", link, re.IGNORECASE) is not None


def faults_of_style(text: str) -> list[str]:
    """What url(...), @import and the strings of image-set(...) ask from elsewhere, wherever the line is broken."""
    asked = (re.sub(r"^[^(\"']*[(\"' \t\n]+|[\"' \t\n)]", "", found) for found in STYLE.findall(html.unescape(text)))
    return [f"asks another host: {url}" for url in asked if is_elsewhere(url)]


def faults_of_script(text: str) -> list[str]:
    """A script that names another host, or that could ask one by a name put together."""
    if re.search(r"[\"'`](https?:)?//[a-z0-9]", text, re.IGNORECASE):
        return ["has a script that names another host"]
    if ASKS.search(text):
        return ["has a script that asks for something"]
    return []


def read_tag(tag: str, parser: Attributes) -> Tag:
    """What a tag says; most say nothing."""
    of = parser.of(tag)
    if "srcdoc" in of:    # a page within the tag, in place of its src
        named = re.search(r"(https?:)?//[a-z0-9]", of["srcdoc"], re.IGNORECASE)
        return Tag(faults=("has a page within that names another host",) if named else ())
    name = parser.name
    follows = [of.get("href", "")] if name in ("a", "area") else []
    loads = [of.get("src", ""), of.get("poster", ""), of.get("action", "")]
    if name in ("link", "base", "image", "use", "feimage", "script"):
        loads += [of.get("href", ""), of.get("xlink:href", "")]
    loads += [picture.strip().split(" ")[0] for picture in of.get("srcset", "").split(",")]
    if name == "object":
        loads.append(of.get("data", ""))
    faults = [f"asks another host: {link}" for link in loads if is_elsewhere(link)]
    if name == "meta" and of.get("http-equiv", "").lower() == "refresh":
        faults.append(f"sends the reader on: <{tag}>")
    if re.search(r"url\(|image-set\(", tag, re.IGNORECASE):
        faults += faults_of_style(tag)
    places = [of.get("id", ""), of.get("name", "") if name == "a" else ""]
    return Tag(tuple(filter(None, places)), tuple(filter(None, follows)),
               tuple(link for link in loads if link and not is_elsewhere(link)), tuple(faults))


@functools.lru_cache(maxsize=None)
def target_of(folder: str, link: str) -> str | None:
    """Where in the site a link of a file in this folder leads: page#place, page, or on its own page #place; None where
    it leads out of the site."""
    if re.match(r"(https?|mailto|javascript|data|magnet|file):|//", link, re.IGNORECASE):
        return None
    path, _, place = link.replace("%20", " ").partition("#")
    path = path.partition("?")[0]
    return (os.path.normpath(f"{folder}/{path}" if folder else path) if path else "") + (f"#{place}" if place else "")


class Site:
    """A site, file by file."""

    def __init__(self, root: str) -> None:
        self.root = root
        self.files = sorted(f"{folder}/{file}"[len(root) + 1:] for folder, _, files in os.walk(root) for file in files)
        self.places: set[str] = set()                 # page#place
        self.links: dict[str, dict[str, None]] = {}   # of page#place, or page: the files that lead there
        self.faults: list[str] = []
        self.parser = Attributes()
        self.tags: dict[str, Tag] = {}

    def read(self) -> list[str]:
        """Its faults."""
        for file in self.files:
            if file.startswith("mathjax/"):
                continue
            if file.endswith((".html", ".svg")):
                self.read_page(file)
            elif file.endswith(".css"):
                self.blame(file, faults_of_style(self.text(file)))
            elif file.endswith(".js") and not KNOWN_SCRIPTS.fullmatch(file):
                text = self.text(file)
                self.blame(file, faults_of_script(text))
                self.read_list(file, text)
        return self.faults + self.dead_links()

    def text(self, file: str) -> str:
        """Of a file of the site."""
        with open(f"{self.root}/{file}", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
            return stream.read()

    def blame(self, file: str, faults: list[str]) -> None:
        """The file has these."""
        self.faults += [f"{file} {fault}" for fault in faults]

    def read_page(self, file: str) -> None:
        """Pages, and pictures of lines, which have tags as well."""
        tags: dict[str, None] = {}
        for block, kind, content, tag in TOKEN.findall(self.text(file)):
            if "=" in tag or "=" in block:
                tags[tag or block] = None
            if content:
                self.blame(file, faults_of_script(content) if kind.lower() == "script" else faults_of_style(content))
        for tag in tags:
            if tag not in self.tags:
                self.tags[tag] = read_tag(tag, self.parser)
            said = self.tags[tag]
            self.places.update(f"{file}#{place}" for place in said.places)
            self.blame(file, list(said.faults))
            for link in said.follows + said.loads:
                self.leads(file, link)

    def read_list(self, file: str, text: str) -> None:
        """Strings that are pages: "world_8hpp.html#a1", '../world_8hpp.html'; and references of the navigation that
        lead nowhere. navtreeindex*.js is no list of links but of where in the tree a page stands. In the tree's
        branches (world_8hpp.js) Doxygen names places by the header, though it describes a member of a namespace on the
        page of that namespace: only pages count; and so in the list NAVTREEINDEX, which repeats one in some hundred of
        those."""
        if re.fullmatch(r"navtreeindex[0-9]*\.js", file):
            return
        branches = "/" not in file and file not in ("navtreedata.js", "menudata.js")
        own, index, repeated = text.partition("\nvar NAVTREEINDEX")
        for part, pages_only in ((own, branches), (index + repeated, True)):
            for link in LISTED.findall(part):
                self.leads(file, link.partition("#")[0] if pages_only else link)

    def leads(self, file: str, link: str) -> None:
        """A link as the file writes it: kept under its path in the site."""
        if re.match(r"[@\\]ref ", link):
            self.blame(file, [f"names '{link}', which no page has"])
        elif (target := target_of(file.rpartition("/")[0], link)) is not None:
            self.links.setdefault(file + target if target[:1] in ("", "#") else target, {})[file] = None

    def dead_links(self) -> list[str]:
        """Links to what is not there."""
        dead: list[str] = []
        there = set(self.files)
        for link, pages in self.links.items():
            target, _, place = link.partition("#")
            first, *others = pages
            whence = f"to which {first} links" + (f", and {len(others)} more" if others else "")
            if target not in there:
                dead.append(f"there is no {target}, {whence}")
            elif place == "nested-classes" and first == target:
                continue    # Doxygen 1.9.4 names that section in the head of a page though all in it are private
            elif place and target.endswith(".html") and link not in self.places:
                dead.append(f"{target} has no place '{place}', {whence}")
        return dead


def main(arguments: list[str]) -> int:
    """Prints them; there may be none."""
    parser = argparse.ArgumentParser(prog="links.py", description="The faults of a site's links and requests.")
    parser.add_argument("site", help="the folder with the html")
    site = Site(parser.parse_args(arguments).site.rstrip("/"))
    for fault in sorted(site.read()):
        sys.stdout.buffer.write(f"{fault}\n".encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
