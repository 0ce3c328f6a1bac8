# SPDX-License-Identifier: BSL-1.0
"""What Doxygen reads instead of a file (INPUT_FILTER): doxygen_filter.py FILE, from the project's folder.

- Members that every policy and column has, as its role or its name, are documented once, here.
- "(notes 1.6.1" in a header becomes a link to the section of its chapter's page, where there is one.
- The page of a policy tells what its header tells (when to use it and when not), where it is taught, and which exercise
  asks for it: the exercise's page links back.
- An exercise's README.md becomes the page exercise_<module>_<name>.
- On text pages, links between files become links between pages, `Drag` a link to Drag, and a long page begins with its
  contents.

It starts once for each of some hundred files, so it imports little and looks up only what a file asks for.
"""

from __future__ import annotations

import functools
import glob
import os
import re
import sys

# What a member is, by its name, where it has no comment of its own.
MEMBERS = {
    "role": "the role that it has in a world",
    "reads": "the columns that it reads", "writes": "the columns that it changes",
    "scratch": "the columns that it needs for its stages, where bodies are coupled",
    "place": "where in the step it acts", "name": "its name in sentences",
    "parameters": "every parameter with its name, for those that read, print, save or hash them",
    "check": "refuses parameters out of their range: std::invalid_argument with name, value and range",
    "stages": "how often a step asks the forces",
    "order": "its order of accuracy: the error of a run falls with dt to this power",
    "reversible": "whether it runs backwards when the velocity is turned round",
    "needs_jacobian": "it asks the forces for their derivatives",
    "couples_bodies": "it acts between bodies, so that no body can be computed alone",
    "Unit": "the unit of its entries", "shape": "a number or a vector for each body", "Scalar": "the number type",
    # Of paths, and of property maps and iterators in the manner of Boost.
    "bind": "the estimate for one graph and goal: a function of a vertex",
    "default_heuristic": "the heuristic of a search that names none",
    "default_cost": "the number that a search counts in unless it is told otherwise",
    "updates": "whether a closed node gets the cheaper g and parent",
    "reopens": "whether it goes back to the open list", "resumable": "whether a search can be left and taken up again",
    "key_type": "what is looked up", "value_type": "what is found", "reference": "how it is handed out",
    "category": "what a property map of Boost is: readable", "iterator_category": "what an iterator is",
    "difference_type": "between two iterators", "pointer": "to what is found",
}

# The functions that make a class a graph of Boost.Graph, a property map or an iterator.
FUNCTIONS = {
    "out_edges": "the edges that lead out of a vertex, as two iterators",
    "out_degree": "how many edges lead out of a vertex",
    "source": "the vertex that an edge leaves", "target": "the vertex that an edge leads to",
    "vertices": "all vertices, as two iterators", "num_vertices": "how many vertices there are",
    "get": "a property map of a graph, or what it holds", "edge_weights": "the weights in the number of a search",
    "has_vertex": "whether there is this vertex", "is_passable": "the flag of a vertex or edge",
    "is_blocked": "whether a vertex can be no start and no goal",
    "name_of": "its name in sentences", "size_in_words": "how large the graph is, for sentences",
    "position_of": "where a vertex is", "least_cost_per_metre": "what a metre costs at least",
    "operator==": "whether both are the same", "operator++": "on to the next", "operator*": "what it points to",
}

# Headers of concepts: Doxygen finds no name from within a concept, so it is led to each.
OF_CONCEPTS = ("concepts", "broadphase", "constraint", "inside", "shapes")

FUNCTION = re.compile(r"(?:^|[ &])(?P<name>[a-z_]+|operator(?:==|\+\+|\*))\([^;]*\{")
MAY_BE_A_FUNCTION = re.compile(
    r"[a-zA-Z[]|    friend |    \[\[gnu::always_inline\]\] |    [A-Z][A-Za-z]*&? operator")
MEMBER = re.compile(
    r" +using (?P<type>[A-Za-z_]+) = | +static constexpr [A-Za-z:_]+ (?P<constant>[a-z_]+) = "
    r"| +static (?:constexpr )?void (?P<parameters>parameters)\(| +void (?P<check>check)\(\) const"
    r"| +template <class Cost, class Graph>(?: auto (?P<bind>bind)\(|$)")


def read(file: str) -> list[str]:
    """Its lines, without their ends."""
    with open(file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        return stream.read().removesuffix("\n").split("\n")


def stem_of(file: str) -> str:
    """"explicit_euler" of a path."""
    return re.sub(r"\.[a-z]+$", "", file.rpartition("/")[2])


def policy_of(stem: str) -> str:
    """"ExplicitEuler" of "explicit_euler"."""
    return "".join(word[:1].upper() + word[1:] for word in stem.split("_"))


def indented(line: str, comment: str) -> str:
    """The line with a comment before its first word."""
    bare = line.lstrip(" ")
    return f"{line[:len(line) - len(bare)]}/** {comment} */ {bare}"


class Course:
    """What a link can lead to, from the folder that the program was started in: each asked when it is first needed."""

    @functools.cached_property
    def sections(self) -> frozenset[str]:
        """The labels of the sections."""
        found: set[str] = set()
        for page in glob.glob("docs/*.md"):
            found.update(re.findall(r"\{#(section_[0-9_]+)\}", "\n".join(read(page))))
        return frozenset(found)

    @functools.cached_property
    def exercises(self) -> dict[str, str]:
        """The page of an exercise by its name: exercise_motion_drag of drag."""
        pages: dict[str, str] = {}
        for folder in sorted(glob.glob("exercises/*/*/")):
            _, module, name, _ = folder.split("/")
            pages[name] = f"exercise_{re.sub('^[0-9]+-', '', module)}_{name}"
        return pages

    @functools.cached_property
    def names(self) -> dict[str, str]:
        """What headers are named after: ansatz::World of World, which world.hpp holds, with the namespace that the
        header opens first."""
        names: dict[str, str] = {}
        type_line = re.compile(r"(?:template <.*> *)?(?:struct|class) [A-Z][A-Za-z0-9]*(?: |$|\{)")
        for folder, _, files in sorted(os.walk("include/ansatz")):
            for file in sorted(files):
                policy, space, there = policy_of(stem_of(file)), "", False
                for line in read(f"{folder}/{file}"):
                    if not space and (opened := re.match(r"namespace (ansatz::[a-z_]+) \{", line)):
                        space = opened[1]
                    if type_line.match(line) and not re.search(r"; *$", line):
                        name = re.sub(r"^.*(?:struct|class) ", "", line)
                        there = there or re.sub(r"[^A-Za-z0-9].*", "", name) == policy
                if there:
                    names[policy] = f"{space or 'ansatz'}::{policy}"
        return names

    @functools.lru_cache(maxsize=None)
    def label_of(self, file: str) -> str:
        """The label of a page, from the first heading of its file that has one."""
        try:
            lines = read(file)
        except OSError:
            return ""
        labelled = (re.match(r"# .*\{#([A-Za-z0-9_]+)\} *$", line) for line in lines)
        return next((label[1] for label in labelled if label), "")

    def linked(self, number: str) -> str:
        """"1.6.1" as a link, where its page has that section."""
        anchor = "section_" + number.replace(".", "_")
        return f'\\ref {anchor} "{number}"' if anchor in self.sections else number

    def with_sections(self, text: str) -> tuple[str, str]:
        """The text with the numbers behind its first "(notes " as links, and the first of those numbers."""
        number = r"[0-9]+(?:\.[0-9]+)+"
        if not (notes := re.search(r"\(notes ([0-9., and]+)", text)):
            return text, ""
        first = re.search(number, notes[1])
        linked = re.sub(number, lambda found: self.linked(found[0]), notes[1])
        return text[:notes.start(1)] + linked + text[notes.end(1):], first[0] if first else ""

    def with_names(self, text: str) -> str:
        """`Drag` as a link."""
        def link(quoted: re.Match[str]) -> str:
            name = quoted[1]
            return f'<code>\\ref {self.names[name]} "{name}"</code>' if name in self.names else quoted[0]
        return re.sub("`([^`]+)`", link, text) if "`" in text else text


class Header:
    """A header, line by line."""

    def __init__(self, course: Course, file: str) -> None:
        self.course = course
        self.stem = stem_of(file)
        self.type_line = re.compile(rf"(?:template <.*> *)?(?:struct|class) {policy_of(self.stem)}(?: |$|\{{)")
        self.space_line = re.compile(rf"(?:inline )?namespace ansatz::{re.escape(self.stem)} ")
        self.telling = False            # within the comment that begins with \file
        self.opening: list[str] = []    # its first paragraph, until it is told again,
        self.tale: list[str] = []       # and the others
        self.told = ""                  # the first section that a comment names
        self.own_comment = ""           # the first line of the comment before this line
        self.before = self.hidden_until = ""

    def filtered(self, line: str) -> list[str]:
        """What stands in its place."""
        if line.startswith("///"):
            line = self.read_comment(line)
            if re.match(r"/// \\file", line):
                self.telling = True
                return [line]
        said: list[str] = []
        if self.telling:
            if line.startswith("///"):
                self.keep(line)
            elif re.match("//( |$)", line):
                return ["///"]    # a remark between the lines of the comment would end it
            else:
                self.telling = False
                said = self.where_taught()
        if not self.telling and line.startswith("///"):
            # A comment that begins with a command has no first sentence of its own.
            self.own_comment = self.own_comment or line
        if self.is_named_after(line):
            return said + self.told_again() + [line]
        if not re.match("///|template|    requires", line):
            self.own_comment = ""
        return said + self.code(line)

    def read_comment(self, line: str) -> str:
        """Its links to sections, and within concepts to names."""
        line, number = self.course.with_sections(line)
        self.told = self.told or number
        if self.stem in OF_CONCEPTS and line.startswith("/// "):
            line = self.course.with_names(line)
        return line

    def keep(self, line: str) -> None:
        """What the header tells, for the page of its policy."""
        if self.tale or re.fullmatch("/// *", line):
            self.tale.append(line)
        else:
            self.opening.append(line)

    def where_taught(self) -> list[str]:
        """The section and the exercise, where there are such."""
        page = self.course.exercises.get(self.stem)
        if not self.told and not page:
            return []
        section = f"Section {self.course.linked(self.told)}" if self.told else "The"
        exercise = f'{"," if self.told else ""} exercise \\ref {page} "{self.stem}"' if page else ""
        return ["/// \\par In the course", f"/// {section}{exercise}."]

    def is_named_after(self, line: str) -> bool:
        """Whether the line begins the policy, or the namespace, of the header's name, and it was not told of yet."""
        if self.telling or not self.opening:
            return False
        return bool(self.type_line.match(line) and not line.endswith(";") or self.space_line.match(line))

    def told_again(self) -> list[str]:
        """What the header tells, where it is taught, and which exercise asks for it."""
        own, opening = self.own_comment, self.opening
        if re.match(r"/// [\\@][tp]", own):
            told = ["///", opening[0].replace("/// ", "/// \\brief ", 1), *opening[1:], *self.tale]
        elif own and not re.search(r"\\f[$\[]", own):
            told = self.tale
        else:
            told = ["///", *opening, *self.tale]
        self.opening = []
        self.own_comment = ""
        return told + self.where_taught()

    def code(self, line: str) -> list[str]:
        """What a policy is inside a world, `In<S>`, belongs to the step, and concepts.hpp says what it must have;
        members and functions of Boost's concepts get the comment that all of them have."""
        if re.match(r" +(?:template <[^>]*> *)?struct In \{", line) and "};" not in line:
            self.hidden_until = line[:len(line) - len(line.lstrip(" "))] + "};"
            return [f"/** \\cond */ {line}"]
        if self.hidden_until and line == self.hidden_until:
            self.hidden_until = ""
            return [f"{line} /** \\endcond */"]
        commented = re.match(r" *(?:///|\*/|template <.*> *$)", self.before)
        self.before = line
        if re.search("//[/!]", line):
            return [line]
        # Free functions, friends, and operators of iterators.
        if not commented and MAY_BE_A_FUNCTION.match(line) and (function := FUNCTION.search(line)):
            if function["name"] in FUNCTIONS:
                return [indented(line, FUNCTIONS[function["name"]])]
        return [self.member(line)]

    @staticmethod
    def member(line: str) -> str:
        """A conventional member with its comment; any other line as it is."""
        found = MEMBER.match(line)
        name = next((group for group in found.groups() if group), "bind") if found else ""
        if name not in MEMBERS:
            return line
        behind = line.endswith("}") and name not in ("parameters", "check")
        return f"{line} ///< {MEMBERS[name]}" if behind else indented(line, MEMBERS[name])


class TextPage:
    """A text page, line by line."""

    def __init__(self, course: Course, file: str) -> None:
        self.course = course
        # Doxygen names files by their whole path: from the project's folder on, links can be followed.
        self.folder = file.removeprefix(os.environ.get("PWD", os.getcwd()) + "/").rpartition("/")[0]
        self.is_exercise = bool(re.search(r"exercises/.*README\.md$", file))
        self.place = file.split("/")
        self.fenced = False

    def filtered(self, lines: list[str]) -> list[str]:
        """What stands in their place."""
        out: list[str] = []
        if self.is_exercise:
            out += self.heading(lines.pop(0))
        elif self.place[-1] == "README.md":
            out.append("# At a glance {#page_readme}")    # a forge shows the text without a label
            lines.pop(0)
        elif re.search(r"docs/[^/]*\.md$", "/".join(self.place)) and lines[0].startswith("# ") and is_long(lines):
            out += [lines.pop(0), "", "[TOC]"]
        for line in lines:
            if re.match(" *(```|~~~)", line):
                self.fenced = not self.fenced
            out.append(line if self.fenced else self.text(line))
        return out

    def heading(self, title: str) -> list[str]:
        """Of an exercise, with its command."""
        *_, module, name, _ = self.place
        title = re.sub(r"^# ([0-9.]+) ", r"# Exercise \1: ", title)
        return [f"{title} {{#{self.course.exercises.get(name, '')}}}", "",
                f"`./workbook exercise {name}` builds and tests your answer, which you write in "
                f"`exercises/{module}/{name}/exercise.hpp`."]

    def text(self, line: str) -> str:
        """A line that is no code."""
        if self.is_exercise:    # "Notes 1.7" leads to the section
            line = re.sub(r"([Nn]otes )([0-9]+(?:\.[0-9]+)*)", lambda notes: notes[1] + self.course.linked(notes[2]),
                          line, count=1)
        if line.startswith("#"):
            return line
        return self.course.with_names(re.sub(r"(!?)\[([^]]*)\]\(([^)]*)\)", self.link, line) if "](" in line else line)

    def link(self, link: re.Match[str]) -> str:
        """A link as it is on the site; a picture stays."""
        return link[0] if link[1] else self.link_of(link[2], link[3])

    def link_of(self, text: str, target: str) -> str:
        """What a link of a text page to a file of the project becomes."""
        if re.match(r"https?:|mailto:|#|@ref|\\ref", target):
            return f"[{text}]({target})"
        bare = text.replace("`", "")
        path = plain_path(f"{self.folder}/{target}" if self.folder else target)
        if path == "LICENSE":
            return f'<a href="LICENSE.txt">{bare}</a>'
        if path.endswith(".md") and not path.startswith("exercises/") and path != "README.md":
            label = self.course.label_of(path) if re.fullmatch(r"(docs/)?[^/]*\.md", path) else ""
            return f'\\ref {label} "{bare}"' if label else f"[{text}]({path})"
        page = self.page_of(path)
        return f'\\ref {page} "{bare}"' if page else f"`{bare}`"

    def page_of(self, path: str) -> str:
        """The page on which a file or folder is shown, or nothing."""
        part = path.split("/")
        name = part[-1]
        module = re.sub("^[0-9]+-", "", part[1]) if len(part) > 1 else ""
        if path == "README.md" or re.match(r"include/.*\.hpp$", path):
            return "page_readme" if path == "README.md" else path.removeprefix("include/")
        if part[0] == "exercises":
            if len(part) < 3:
                return "page_exercises"
            return self.course.exercises.get(part[2], "") if len(part) == 3 or name == "README.md" else ""
        if part[0] != "chapters":
            return ""
        if len(part) < 3:
            return (len(part) == 2 and self.course.label_of(f"docs/{module}.md")) or "page_programs"
        if not re.fullmatch(r"chapters/[^/]*/[^/]*\.[ch]pp", path):
            return ""
        # The name that tools/workshop/pages.py gives to a program's page.
        program = re.sub("[^A-Za-z0-9]", "_", name[:-len(".cpp")])
        return f"program_{module}_{program}" + ("_hpp" if name.endswith(".hpp") else "")


def plain_path(path: str) -> str:
    """A path without "folder/.."."""
    while (shorter := re.sub(r"[^/.][^/]*/\.\./", "", path, count=1)) != path:
        path = shorter
    return path.replace("/./", "/").removeprefix("./").removesuffix("/")


def is_long(lines: list[str]) -> bool:
    """Whether a page begins with its contents: of more than two sections, unless it asks for them itself."""
    asks = re.search(r"\[TOC\]|[\\@]tableofcontents", "\n".join(lines))
    return not asks and sum(line.startswith("## ") for line in lines) > 2


def filtered(file: str) -> list[str]:
    """What Doxygen reads instead of the file."""
    course = Course()
    lines = read(file)
    if file.endswith(".hpp"):
        header = Header(course, file)
        return [out for line in lines for out in header.filtered(line)]
    if file.endswith("/pages/library.md"):
        return [course.with_sections(line)[0] for line in lines]
    if file.endswith(".md") and not re.search(r"/pages/[^/]*\.md$", file):
        return TextPage(course, file).filtered(lines)
    return lines


def main(arguments: list[str]) -> int:
    """No argparse: it takes as long as all of the rest."""
    if len(arguments) != 1:
        print("usage: doxygen_filter.py FILE", file=sys.stderr)
        return 2
    text = "".join(line + "\n" for line in filtered(arguments[0]))
    sys.stdout.buffer.write(text.encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
