# SPDX-License-Identifier: BSL-1.0
"""What of the library its users name. The list of types, the search and the list of headers put that first, and leave the
insides of the frame to those who look for them.

A type is named in a program of a chapter, an exercise, a model of a policy of one's own (tests/package), or as code on a text
page that is not about the frame itself; or docs/site/types.txt has it. A header is a user's that such a program includes, that a
text page links to, that declares such a type, or that declares a function of its own name which such a program calls.
"""

from __future__ import annotations

import functools
import glob
import os
import re

PROGRAMS = ("chapters", "exercises", "tests/package")
OF_THE_FRAME = ("docs/frame.md", "docs/contributing.md")
MORE = "docs/site/types.txt"
INSIDES = ("hook", "modules", "phases")    # namespaces that the frame speaks with itself in
TYPE = re.compile(r"^(?:template <.*> *)?(?:struct|class|enum class|concept) ([A-Z]\w*)\b(?! *<)(?!.*;$)", re.MULTILINE)


def read(file: str) -> str:
    """The text of a file."""
    with open(file, encoding="utf-8", errors="surrogateescape") as stream:
        return stream.read()


@functools.lru_cache(maxsize=None)
def code() -> str:
    """The programs, without their comments."""
    files = sorted(f"{place}/{file}" for folder in PROGRAMS for place, _, names in os.walk(folder) for file in names
                   if file.endswith((".cpp", ".hpp")))
    return "\n".join(re.sub("//.*", "", read(file)) for file in files)


@functools.lru_cache(maxsize=None)
def texts_of_users() -> str:
    """The text pages, those about the frame left out."""
    pages = ["README.md", *sorted(glob.glob("docs/*.md")), *sorted(glob.glob("exercises/*/*/README.md"))]
    return "\n".join(read(page) for page in pages if page not in OF_THE_FRAME and os.path.isfile(page))


def code_of_texts() -> str:
    """What stands in backticks on the text pages, in their lines and in blocks."""
    texts = texts_of_users()
    blocks = re.findall(r"^```cpp\n(.*?)^```", texts, re.DOTALL | re.MULTILINE)
    return "\n".join(blocks + re.findall("`[^`\n]+`", re.sub(r"^```.*?^```", "", texts, flags=re.DOTALL | re.MULTILINE)))


@functools.lru_cache(maxsize=None)
def types() -> frozenset[str]:
    """The words with a capital that users write."""
    listed = [line for line in read(MORE).split("\n") if line and not line.startswith("#")] if os.path.isfile(MORE) else []
    words = set(re.findall(r"\b[A-Z]\w*", code() + "\n" + code_of_texts()))
    words |= {line for line in listed if not line.startswith("-")}
    return frozenset(words - {line[1:] for line in listed})


def forget() -> None:
    """What was read: for who goes to another tree."""
    code.cache_clear()
    texts_of_users.cache_clear()
    types.cache_clear()


def is_named(space: tuple[str, ...], name: str) -> bool:
    """Whether users name a type of a namespace, which is ("ansatz", "states") or so."""
    return re.sub(r" *<.*", "", name) in types() and not set(space) & set(INSIDES)


def is_for_users(header: str, text: str) -> bool:
    """Of a header's path behind include/, and what it says."""
    stem = header.rpartition("/")[2].removesuffix(".hpp")
    if f"#include <{header}>" in code() or f"include/{header}" in texts_of_users() or any(name in types() for name in TYPE.findall(text)):
        return True
    declared = re.search(rf"^[^/\n]*\b{stem}\(", text, re.MULTILINE) is not None
    return declared and re.search(rf"\b{stem}\(", code()) is not None
