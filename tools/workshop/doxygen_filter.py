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

import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop.link_targets import Course, policy_of, read, stem_of  # noqa: E402  (it is run as a file)
from workshop.text_pages import TextPage  # noqa: E402

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


def indented(line: str, comment: str) -> str:
    """The line with a comment before its first word."""
    bare = line.lstrip(" ")
    return f"{line[:len(line) - len(bare)]}/** {comment} */ {bare}"


class Header:
    """A header, line by line."""

    def __init__(self, course: Course, file: str) -> None:
        self.course = course
        self.stem = stem_of(file)
        self.path = re.sub(r"^.*?(?=include/ansatz/)", "", file)
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
        """The section, and the exercises that ask for what the header has: that of its name, and those whose task leads to it.
        The notes' number may have sections of this course below it; then that of the exercise says more."""
        asking = dict(self.course.asking.get(self.path, []))
        if self.stem in self.course.exercises:
            asking = {self.stem: asking.get(self.stem, ""), **asking}
        if not self.told and not asking:
            return []
        below = [number for number in asking.values() if self.told and number.startswith(f"{self.told}.")]
        number = below[0] if below else self.told
        section = f"Section {self.course.linked(number)}" if number else "The"
        pages = [f'\\ref {self.course.exercises[name]} "{name}"' for name in asking]
        listed = " and ".join(filter(None, (", ".join(pages[:-1]), *pages[-1:])))
        exercise = f'{"," if number else ""} exercise{"s" if len(pages) > 1 else ""} {listed}' if pages else ""
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
