# SPDX-License-Identifier: BSL-1.0
"""What is changed in the pages that Doxygen made.

    site_pages.py head <header> <lines>    prints a page's header with these lines before the end of its head
    site_pages.py foot <footer>            prints a page's footer with version and licence
    site_pages.py mend <html> [<order>]    changes the pages of the site

A line of the order is a page and its title, with a tab between; the pages of a group, which ends with an empty line, lead
to the one before and the one behind them.

What a concept asks for is said in words: where its definition is made of names of namespace detail, which nobody else
uses, it stands in the header and not on the page. And x, y and z are components where they are called; a parameter of
that name is none of them, and no link. The page of a type begins with its description (docs/site/layout.xml), and does not
say its first sentence twice. A path in the list of headers may go on in a second line behind a stroke. Links of listings are
code_links.py's, the list of types is type_list.py's.
"""

from __future__ import annotations

import argparse
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop import code_links, named, type_list  # noqa: E402  (it is run as a file)

DEFINITION = '<h2 class="groupheader">Concept definition</h2>'
FRAGMENT = "<!-- fragment -->"
COMPONENT = re.compile(r'<a class="(?:el|code hl_function)" href="[^"\n]*">([xyz])</a>( ?[^( \n])')

BRIEF = re.compile(r'\n<p>(?:(?!</p>)(?!<p>).)*?<a href="[^"\n]*#details">More\.\.\.</a></p>\n', re.DOTALL)
PATH = re.compile(r'(<a class="el" href="[^"\n]*_8hpp\.html"[^>\n]*>)([\w./]+)(?=</a>)')


def read(file: str) -> str:
    """The text of a file."""
    with open(file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        return stream.read()


def without_details(page: str) -> str:
    """The page of a concept without a definition that shows namespace detail."""
    out: list[str] = []
    block: list[str] = []
    for line in re.findall(r"[^\n]*\n|[^\n]+", page):
        if not block and DEFINITION not in line:
            out.append(line)
            continue
        block.append(line)
        if FRAGMENT in line:
            shown = any("detail::" in part for part in block)
            out += [line.rpartition(FRAGMENT)[2]] if shown else block
            block = []
    return "".join(out + block)


def without_components(page: str) -> str:
    """x as a word where it is not called."""
    while (mended := COMPONENT.sub(r"\1\2", page)) != page:
        page = mended
    return page


def told_once(page: str) -> str:
    """The page of a type whose description begins with the sentence that also stands above it."""
    return BRIEF.sub("\n", page, count=1) if 'name="details"' in page else page


def with_broken_paths(page: str) -> str:
    """Each path of a header may be broken behind a stroke or a low one, and in no word."""
    return PATH.sub(lambda link: link[1] + re.sub("(?<=[/_])(?=[a-z])", "<wbr/>", link[2]), page)


def with_head(header: str, lines: str) -> str:
    """The header of a page, with lines before each line that ends its head."""
    return re.sub("^(?=.*</head>)", lambda _: lines, header, flags=re.MULTILINE)


def with_licence(footer: str) -> str:
    """The footer of a page, which says what it is of."""
    said = 'Ansatz $projectnumber &middot; <a href="$relpath^LICENSE.txt">Boost Software License 1.0</a> &middot; '
    return footer.replace('<li class="footer">', f'<li class="footer">{said}')


def neighbours(order: str) -> dict[str, str]:
    """For each page the line that leads to those beside it."""
    found: dict[str, str] = {}
    for group in re.split(r"\n{2,}", order.strip("\n")):
        pages = [line.split("\t", 1) for line in group.split("\n") if "\t" in line]
        for i, (page, _) in enumerate(pages):
            def leading(at: int, kind: str, arrow: str) -> str:
                if not 0 <= at < len(pages):
                    return "<span></span>"
                return f'<a class="{kind}" rel="{kind}" href="{pages[at][0]}.html">{arrow.format(pages[at][1])}</a>'
            found[page] = ('<div class="onward">' + leading(i - 1, "prev", "&larr; {}")
                           + leading(i + 1, "next", "{} &rarr;") + "</div>\n")
    return found


def with_neighbours(page: str, line: str) -> str:
    """At the end of its text."""
    return page.replace("</div></div><!-- contents -->", f"{line}</div></div><!-- contents -->", 1)


def mend(folder: str, order: str = "") -> None:
    """Writes the pages that change."""
    onward = neighbours(order)
    for place, _, files in os.walk(folder):
        for file in (f"{place}/{name}" for name in files if name.endswith(".html")):
            page = read(file)
            name = file.rpartition("/")[2].removesuffix(".html") if place == folder else ""
            mended = without_components(code_links.without_wrong_links(page, name))
            if name.startswith("concept"):
                mended = without_details(mended)
            elif name.startswith(("struct", "class")):
                mended = told_once(mended)
            elif name == "page_library":
                mended = with_broken_paths(mended)
            if name in onward:
                mended = with_neighbours(mended, onward[name])
            if mended != page:
                with open(file, "w", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
                    stream.write(mended)
    type_list.mend(folder, named.is_named)


def main(arguments: list[str]) -> int:
    """One of the two."""
    parser = argparse.ArgumentParser(prog="site_pages.py", description="What is changed in the pages of Doxygen.")
    kinds = parser.add_subparsers(dest="kind", required=True)
    head = kinds.add_parser("head", help="prints a page's header with more lines in its head")
    head.add_argument("header", help="Doxygen's own header of a page")
    head.add_argument("lines", help="the file of the lines")
    kinds.add_parser("foot", help="prints a page's footer").add_argument("footer", help="Doxygen's own")
    mending = kinds.add_parser("mend", help="changes the pages of the site")
    mending.add_argument("html", help="its folder")
    mending.add_argument("order", nargs="?", help="the file of the pages that lead to each other")
    given = parser.parse_args(arguments)
    if given.kind != "mend":
        text = with_head(read(given.header), read(given.lines)) if given.kind == "head" else with_licence(read(given.footer))
        sys.stdout.buffer.write(text.encode("utf-8", "surrogateescape"))
    else:
        mend(given.html.rstrip("/"), read(given.order) if given.order else "")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
