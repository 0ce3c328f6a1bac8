# SPDX-License-Identifier: BSL-1.0
r"""Text pages as a forge shows them, and as Doxygen reads them. From the project's folder:

    forge.py write <texts>     puts Markdown in the place of Doxygen's commands, and what is quoted as it is now
    forge.py check <texts>     prints a fault, and a line, each: a command that is left, a quotation that is old, a dead link

    what stands on a page                                       what Doxygen reads
    [drag](motion.md#section_1_7)                               \ref section_1_7 "drag"
    [Drag](../include/ansatz/motion/drag.hpp "ansatz::Drag")    \ref ansatz::Drag "Drag"
    ## 1.7 Drag <a id="section_1_7"></a>                        ## 1.7 Drag {#section_1_7}
    $`v = a t`$, and a fence that names math                    the formula between \f$ and \f$, or \f[ and \f]
    <!-- snippet: 1-motion/1.7-drag.cpp rate -->, a fence       \snippet{trimleft} 1-motion/1.7-drag.cpp rate
    <!-- output: docs/recordings/1.7.txt -->, a fence           \verbinclude docs/recordings/1.7.txt
    ![Its title](pictures/1.7-film.svg)                         \image html 1.7-film.svg "Its title" width=640px
    Picture: [Its title](../chapters/1-motion/1.7-drag.cpp "picture 1.7.svg")   the same of a picture that a section draws

Both may be written; write makes the left of the right. A page keeps its lines, so that faults have their numbers.
"""

from __future__ import annotations

import functools
import glob
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

WIDTH = "640px"
QUOTE = "\0"    # stands for a line that is quoted, which a text has nowhere else
# What a line holds that is no plain text: a formula, code, a comment; and, for links, the rest.
FORMULA = r"\$`(?P<tex>[^`]+)`\$"
CODE = r"(?P<code>(?P<ticks>`+)(?!`)(?:(?!\n[ \t]*\n).)+?(?<!`)(?P=ticks)(?!`)|<!--.*?-->)"
LINK = r'(?<!!)\[(?P<text>[^]\n]*)\]\((?P<target>[^)\s"]+)(?: "(?P<title>[^"\n]*)")?\)'
TO_DOXYGEN = re.compile(f"{FORMULA}|{CODE}|{LINK}", re.DOTALL)
TO_MARKDOWN = re.compile(
    rf'\\f\$(?P<tex>.*?)\\f\$|{CODE}|\\ref +(?P<to>[\w:./~]*[\w/])(?: +"(?P<text>[^"\n]*)")?', re.DOTALL)
FENCE = re.compile(r" *(```+|~~~+)")
QUOTED = re.compile(r"<!-- (snippet|output): (\S+)(?: (.+?))? -->")
PICTURE = re.compile(r'(?:!|Picture: )\[(?P<title>[^\n]*)\]\((?P<target>[^)\s]+)(?: "(?P<note>[^"]*)")?\)$')
COMMAND = re.compile(r"[\\@](?:ref|snippet|verbinclude|include|dontinclude|image|htmlinclude|htmlonly|f[$\[\]{]|subpage|anchor|page"
                     r"|section|par|verbatim|n\b)|\{#[\w-]+\}|\[TOC\]")


def read(file: str) -> str:
    """The text of a file."""
    with open(file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        return stream.read()


# ---------------------------------------------------------------- what Doxygen reads
def label_of_file(target: str) -> str:
    """What Doxygen calls the page of a file of the project: an exercise, a program, a header."""
    path = re.sub(r"^(?:\.\./)+", "", target)
    if exercise := re.fullmatch(r"(?:exercises/)?\d+-(\w+)/(\w+)/README\.md", path):
        return f"exercise_{exercise[1]}_{exercise[2]}"
    if program := re.fullmatch(r"chapters/\d+-(\w+)/([^/]+)\.(cpp|hpp)", path):
        return f"program_{program[1]}_" + re.sub("[^A-Za-z0-9]", "_", program[2]) + ("_hpp" if program[3] == "hpp" else "")
    if model := re.fullmatch(r"tests/package/models/(\w+)\.cpp", path):
        return f"model_{model[1]}"
    return path.removeprefix("include/") if re.fullmatch(r"include/.*\.hpp", path) else ""


def label_of_page(target: str) -> str:
    """The label of a page of docs/."""
    found = re.fullmatch(r"(?:(?:\.\./)+docs/)?([a-z_]+\.md)", target)
    if not found or not os.path.isfile(f"docs/{found[1]}"):
        return ""
    with open(f"docs/{found[1]}", encoding="utf-8") as stream:
        heading = re.search(r'(?:\{#|<a id=")([\w-]+)', stream.readline())
    return heading[1] if heading else ""


def link_for_doxygen(target: str, title: str, text: str) -> str:
    """A link, or nothing where it is an ordinary one."""
    page, _, anchor = target.partition("#")
    if title.startswith("ansatz::"):
        to = title
    elif re.fullmatch(r"[a-z]+(?:_\w+)+", anchor) and (not page or re.fullmatch(r"(?:[./\w]*/)?[a-z_]+\.md", page)):
        to = anchor
    else:
        to = label_of_file(target) or label_of_page(target)
    return f'\\ref {to} "{text.replace("`", "")}"' if to else ""


def text_for_doxygen(text: str, links: bool) -> str:
    """What stands between two fences; links stay Markdown where they are not asked for."""
    def becomes(found: re.Match[str]) -> str:
        if found["tex"]:
            return f"\\f$ {found['tex'].strip()} \\f$"
        if found["code"]:
            return found["code"]
        return links and link_for_doxygen(found["target"], found["title"] or "", found["text"]) or found[0]
    return TO_DOXYGEN.sub(becomes, text)


def line_for_doxygen(line: str) -> str:
    """A picture, a label or a remark that stands alone; any other line as it is."""
    if line.startswith("#"):
        return re.sub(r' *<a id="([\w-]+)"></a>\s*$', r" {#\1}", line)
    if remark := re.fullmatch(r"<!-- site: (\S+) -->", line):
        return f"\\htmlinclude {remark[1]}"
    if (picture := PICTURE.match(line)) and (shown := re.match(r"(?:picture (\S+))? *(\d+(?:px|%))?$", picture["note"] or "")):
        name = shown[1] or (os.path.basename(picture["target"]) if re.match(r"!\[.*\]\((?:\.\./docs/)?pictures/", line) else "")
        if name:
            return f'\\image html {name} "{picture["title"]}" width={shown[2] or WIDTH}'
    return line


def marked_for_doxygen(text: str, links: bool = True) -> str:
    """A page as Doxygen reads it, line by line: what it has already of Doxygen's commands stays. A quoted line is QUOTE."""
    out: list[str] = []
    plain: list[str] = []
    fence = kind = ""

    def end_of_plain() -> None:
        if plain:
            out.extend(text_for_doxygen("\n".join(plain), links).split("\n"))
            plain.clear()
    for line in text.split("\n"):
        marked = FENCE.match(line)
        if fence:
            closed = bool(marked) and line.strip() == fence
            out.append(QUOTE if kind == "quoted" else line.replace("```", "\\f]") if closed and kind == "math" else line)
            if closed:
                fence = ""
            continue
        if marked:
            end_of_plain()
            fence = marked[1]
            kind = "quoted" if out and re.match(r"\\(snippet|verbinclude)", out[-1]) else "math" if line.strip() == "```math" else ""
            out.append(QUOTE if kind == "quoted" else line.replace("```math", "\\f[") if kind == "math" else line)
        elif quoted := QUOTED.fullmatch(line):
            end_of_plain()
            out.append(f"\\snippet{{trimleft}} {quoted[2]} {quoted[3]}" if quoted[1] == "snippet" else f"\\verbinclude {quoted[2]}")
        elif (single := line_for_doxygen(line)) != line and not single.startswith("#"):
            end_of_plain()
            out.append(single)
        else:
            plain.append(single)
    end_of_plain()
    return "\n".join(out)


def doxygen(text: str) -> str:
    """A page as Doxygen reads it, with an empty line in the place of each that is quoted."""
    return marked_for_doxygen(text).replace(QUOTE, "")


def is_text(file: str) -> bool:
    """Whether a file is written for both."""
    return file.endswith(".md") and not re.search(r"(^|/)(pages|site)/[^/]*\.md$", file)


def page(file: str) -> str:
    """A file as Doxygen reads it."""
    return doxygen(read(file)) if is_text(file) else read(file)


# ---------------------------------------------------------------- what a forge shows
@functools.lru_cache(maxsize=None)
def labels() -> dict[str, tuple[str, bool]]:
    """The file of each label, and whether it is that of the whole page."""
    found: dict[str, tuple[str, bool]] = {}
    for file in sorted(glob.glob("docs/*.md")) + ["CHANGELOG.md"]:
        for line in page(file).split("\n") if os.path.isfile(file) else []:
            if heading := re.match(r"(#+) .*\{#([\w-]+)\} *$", line):
                found[heading[2]] = (file, heading[1] == "#")
    return found


@functools.lru_cache(maxsize=None)
def files_of_labels() -> dict[str, str]:
    """The file of each exercise and program, by what Doxygen calls its page."""
    files = [file for pattern in ("exercises/*/*/README.md", "chapters/*/*.[ch]pp", "tests/package/models/*.cpp")
             for file in glob.glob(pattern)]
    return {"page_readme": "README.md", "page_exercises": "exercises", "page_programs": "chapters",
            **{label_of_file(file): file for file in files}}


@functools.lru_cache(maxsize=None)
def header_of(name: str) -> str:
    """The header of a type, concept, function or constant, by its whole name."""
    from workshop import course    # it reads every header
    names = course.headers_of_names()
    part = name
    while part.count("::"):
        if part in names:
            return names[part][0]
        part = part.rpartition("::")[0]
    constant = re.compile(rf"inline constexpr [\w:<>]+ {re.escape(name.rpartition('::')[2])}\b")
    return next((file.removeprefix("include/ansatz/") for file in sorted(glob.glob("include/ansatz/**/*.hpp", recursive=True))
                 if constant.search(read(file))), "")


def link_for_forge(file: str, to: str, text: str) -> str:
    """The link, or nothing where nobody knows what it leads to."""
    def path(target: str) -> str:
        return os.path.relpath(target, os.path.dirname(file) or ".")
    text = text or re.sub(r"(\d)_", r"\1.", to.removeprefix("section_").removeprefix("ansatz/").rpartition("::")[2])
    if to in labels():
        there, whole = labels()[to]
        return f"[{text}]({'' if there == file and not whole else path(there)}{'' if whole else '#' + to})"
    if to in files_of_labels():
        return f"[{text}]({path(files_of_labels()[to])})"
    if to.endswith(".hpp"):
        header = "include/ansatz/" + to.removeprefix("ansatz/")
        return f"[{text}]({path(header)})" if os.path.isfile(header) else ""
    header = header_of(to) if to.startswith("ansatz::") else ""
    return f'[{text}]({path(f"include/ansatz/{header}")} "{to}")' if header else ""


def text_for_forge(file: str, text: str) -> str:
    """What stands between two fences."""
    def becomes(found: re.Match[str]) -> str:
        if found["tex"]:
            return "$`" + " ".join(found["tex"].split()) + "`$"
        if found["code"]:
            return found["code"]
        return link_for_forge(file, found["to"], found["text"] or "") or found[0]
    return TO_MARKDOWN.sub(becomes, text)


@functools.lru_cache(maxsize=None)
def snippet(path: str, name: str) -> str:
    """The lines between two marks of a program, at the margin; nothing where there are none."""
    from workshop.quoted import MARK, unindented
    file = next((place for place in (f"chapters/{path}", path) if os.path.isfile(place)), "")
    lines = unindented(read(file).split("\n")) if file else []
    marks = [number for number, line in enumerate(lines) if line.strip() == f"//! [{name}]"]
    return "\n".join(line for line in lines[marks[0] + 1:marks[1]] if not MARK.match(line)).strip("\n") if len(marks) == 2 else ""


def quotation(line: str) -> str:
    """What stands in the place of \\snippet or \\verbinclude; nothing where it quotes nothing."""
    if found := re.fullmatch(r"\\snippet(?:\{trimleft\})? (\S+) (.+)", line):
        quoted = snippet(found[1], found[2])
        return f"<!-- snippet: {found[1]} {found[2]} -->\n```cpp\n{quoted}\n```" if quoted else ""
    if found := re.fullmatch(r"\\verbinclude (\S+)", line):
        file = next((place for place in (found[1], f"chapters/{found[1]}") if os.path.isfile(place)), "")
        quoted = read(file).rstrip("\n") if file else ""
        return f"<!-- output: {found[1]} -->\n```text\n{quoted}\n```" if quoted else ""
    return ""


def program_of(picture: str) -> str:
    """The program that draws it, by the number in its name."""
    number = re.sub(r"[-.][a-z].*$", "", picture)
    drawn_by = glob.glob(f"chapters/*/{glob.escape(number)}-*.cpp")
    return drawn_by[0] if drawn_by else "tools/workshop/frame_picture.py" if picture == "frame.svg" else ""


def picture_for_forge(file: str, name: str, title: str, width: str) -> str:
    """The picture where it is kept, and otherwise its program."""
    shown = "" if width == WIDTH else width
    kept = f"docs/pictures/{name}"
    start = os.path.dirname(file) or "."
    if os.path.isfile(kept):
        return f"![{title}]({os.path.relpath(kept, start)}" + (f' "{shown}")' if shown else ")")
    program = program_of(name)
    note = f"picture {name} {shown}".strip()
    return f'Picture: [{title}]({os.path.relpath(program, start)} "{note}")' if program else ""


def line_for_forge(file: str, line: str) -> str:
    """What stands alone in its line."""
    if line.startswith("#"):
        return re.sub(r" *\{#([\w-]+)\}\s*$", r' <a id="\1"></a>', line)
    if picture := re.fullmatch(r'\\image html (\S+) "([^"]*)"(?: width=(\S+))?', line):
        return picture_for_forge(file, picture[1], picture[2], picture[3] or WIDTH) or line
    if site := re.fullmatch(r"\\htmlinclude (\S+)", line):
        return f"<!-- site: {site[1]} -->"
    return quotation(line) or line


def markdown(file: str, text: str) -> str:
    """A page as a forge shows it, whichever way it was written."""
    out: list[str] = []
    plain: list[str] = []
    fence = margin = ""

    def end_of_plain() -> None:
        if plain:
            out.extend(text_for_forge(file, "\n".join(plain)).split("\n"))
            plain.clear()
    math = False
    for line in marked_for_doxygen(text, links=False).split("\n"):
        if line == QUOTE:
            continue
        marked = FENCE.match(line)
        if fence or marked:
            end_of_plain()
            out.append(line)
            fence = "" if fence and line.strip() == fence else fence or (marked[1] if marked else "")
        elif math or line.lstrip().startswith("\\f["):
            end_of_plain()
            margin = margin if math else line[:len(line) - len(line.lstrip())]
            formula = line if math else "```math\n" + line.lstrip().removeprefix("\\f[")
            math = "\\f]" not in formula
            formula = formula if math else formula.partition("\\f]")[0].rstrip() + "\n```"
            out += [margin + part.strip() for part in formula.split("\n") if part.strip()]
        elif line == "[TOC]":
            end_of_plain()
            if out and out[-1] == "":
                out.pop()
        elif (single := line_for_forge(file, line)) != line:
            end_of_plain()
            out += single.split("\n")
        else:
            plain.append(line)
    end_of_plain()
    return "\n".join(out)


# ---------------------------------------------------------------- faults
def without_code(text: str) -> list[str]:
    """Its lines, without fences and code."""
    out: list[str] = []
    fence = ""
    for line in re.sub(CODE, lambda code: "\n" * code[0].count("\n") if code["ticks"] != "```" else code[0], text,
                       flags=re.DOTALL).split("\n"):
        marked = FENCE.match(line)
        if fence or marked:
            fence = "" if fence and line.strip() == fence else fence or (marked[1] if marked else "")
            line = ""
        out.append(line)
    return out


def faults_of_links(file: str, text: str) -> list[str]:
    """Links to files that are not there, and to places that they do not have."""
    faults: list[str] = []
    for number, line in enumerate(without_code(text), start=1):
        for _, target in re.findall(r"\[([^]]*)\]\(([^)\s]+)", line):
            path, _, anchor = target.partition("#")
            if re.match(r"https?:|mailto:", target):
                continue
            there = os.path.normpath(os.path.join(os.path.dirname(file), path)) if path else file
            if not os.path.exists(there):
                faults.append(f"{file}:{number}: there is no {there}, to which it links")
            elif anchor and (not there.endswith(".md") or f'<a id="{anchor}"></a>' not in read(there)):
                faults.append(f"{file}:{number}: {there} has no place '{anchor}', to which it links")
    return faults


HTML = re.compile(r"<(?!/?(?:a|br|details|img|kbd|pre|sub|summary|sup)\b|https?:|!--)[A-Za-z][^<>]*>")


def faults_of_html(file: str, text: str) -> list[str]:
    """What a forge takes for HTML, and rows of tables that it cuts."""
    faults: list[str] = []
    cells = 0
    raw = text.split("\n")
    for number, line in enumerate(without_code(text), start=1):
        if tag := HTML.search(line):
            faults.append(f"{file}:{number}: a forge takes {tag[0]} for HTML and drops it; put it in backticks")
        if line.strip() and re.match(r"\s*<!--.*-->\s*\S", raw[number - 1]):
            faults.append(f"{file}:{number}: a forge shows text behind a comment as HTML; put the comment behind the text")
        now = len(re.findall(r"(?<!\\)\|", raw[number - 1])) if line.startswith("|") else 0
        if cells and now and now != cells:
            faults.append(f"{file}:{number}: a forge cuts this row: {now - 1} cells, the head of its table has {cells - 1}")
        cells = cells if cells and now else now
    return faults


def faults_of(file: str, text: str) -> list[str]:
    """What a forge would show as it should not."""
    faults = [f"{file}:{number}: a forge shows {command[0]} as it is written; forge.py write puts Markdown in its place"
              for number, line in enumerate(without_code(text), start=1) if (command := COMMAND.search(line))]
    if not faults and (fresh := markdown(file, text)) != text:
        lines, now = text.split("\n"), fresh.split("\n")
        number = next((i for i, (a, b) in enumerate(zip(lines, now)) if a != b), min(len(lines), len(now)))
        line = lines[number] if number < len(lines) else ""
        faults.append(f"{file}:{number + 1}: what it quotes or links to is otherwise now: \"{line[:60]}\"; forge.py write")
    return faults + faults_of_links(file, text) + faults_of_html(file, text)


def main(arguments: list[str]) -> int:
    """One of the two."""
    import argparse    # doxygen_filter.py starts once for each of some hundred headers, and does without
    parser = argparse.ArgumentParser(prog="forge.py", description="Text pages as a forge shows them.")
    parser.add_argument("asked", choices=("write", "check"))
    parser.add_argument("texts", nargs="+", help="pages")
    given = parser.parse_args(arguments)
    for file in given.texts:
        text = read(file)
        if given.asked == "check":
            for fault in faults_of(file, text):
                print(fault)
        elif (fresh := markdown(file, text)) != text:
            with open(file, "w", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
                stream.write(fresh)
            print(f"written anew: {file}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
