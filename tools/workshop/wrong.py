# SPDX-License-Identifier: BSL-1.0
"""Makes the wrong answers of an exercise from its solution, so that the two cannot drift apart. Each block of its
wrong.diff is one of them:

    === new_velocity
    Mistake: the position moved with the new velocity        what a student is told that it is
    Why:     The two lines are the other way round. The
             velocity of the end is not known before.        lines that go on begin with blanks
    Read:    1.6.3                                           sections of the notes
    Fails:   old-velocity, fall                              the tests that it fails
    @@
    -        x += v * dt;
             v += a * dt;
    +        x += v * dt;

Below each @@ stand lines of the solution (without the marks of its tasks), as in any diff: those that go have a minus,
those that come a plus, those that stay a blank. They are found by what they say, wherever they are, so that they must
stand there once: what stands nowhere, or twice, is refused with its place.

`git apply` and `patch` are no help here: both want line numbers behind @@, take lines that stand twice at the place
which is nearest to those, put lines that only come wherever the number says, and name the place in the solution, but
neither the line of wrong.diff nor the answer.
"""

from __future__ import annotations

import argparse
import os
import re
import sys

NAME = re.compile(r"[a-z][a-z0-9_]*")
HEAD = re.compile(r"(Mistake|Why|Read|Fails):(.*)", re.DOTALL)
GOES_ON = re.compile(r" +[^ ]")
MARK = re.compile(r" *// (end of )?task [0-9]+")


class Hunk:
    """What stands below one @@."""

    def __init__(self, line: int) -> None:
        """The hunk whose @@ is that line of the file."""
        self.line = line
        self.old: list[str] = []
        self.new: list[str] = []
        self.changes = False
        self.first = ""             # of the old lines, to be known by
        self.blanks_at_end = 0

    def add(self, text: str) -> None:
        """A line with its sign; an empty one is a line that stays, whose blank an editor has taken."""
        sign, line = text[:1], text[1:]
        if sign != "+":
            self.old.append(line)
            self.first = self.first or line.lstrip(" ")
        if sign != "-":
            self.new.append(line)
        self.changes = self.changes or sign in ("-", "+")
        self.blanks_at_end = self.blanks_at_end + 1 if text == "" else 0

    def end(self) -> None:
        """Empty lines before the next block are no context."""
        if self.blanks_at_end:
            del self.old[-self.blanks_at_end:], self.new[-self.blanks_at_end:]


class Answer:
    """A block of wrong.diff: its name, the lines of its head as they are written, and its hunks."""

    def __init__(self, name: str, line: int) -> None:
        """The block that begins in that line of the file."""
        self.name = name
        self.line = line
        self.last = line
        self.head: list[str] = []
        self.hunks: list[Hunk] = []

    def said(self) -> dict[str, str]:
        """What the head says by Mistake, Why, Read and Fails; lines that go on are joined."""
        texts: dict[str, str] = {}
        word = ""
        for line in self.head:
            begins = HEAD.match(line)
            if begins:
                word = begins[1]
                texts[word] = begins[2].lstrip(" ")
            else:
                texts[word] = f"{texts[word]} {line.lstrip(' ')}".lstrip(" ")
        return texts


class Reader:
    """Reads a wrong.diff. What cannot be read is refused with its place, and the rest is read all the same."""

    def __init__(self, file: str) -> None:
        """`file` is how refusals name it."""
        self.file = file
        self.answers: list[Answer] = []
        self.refusals: dict[int, str] = {}
        self.answer: Answer | None = None
        self.hunk: Hunk | None = None

    def refuse(self, line: int, text: str) -> None:
        """A refusal in the form of a compiler's error; of one line the first counts."""
        name = f"{self.answer.name}: " if self.answer and self.answer.name else ""
        self.refusals.setdefault(line, f"{self.file}:{line}: error: {name}{text}")

    def end_hunk(self) -> None:
        """What comes now belongs to no hunk."""
        if self.hunk:
            self.hunk.end()
        self.hunk = None

    def begin(self, name: str, line: int) -> None:
        """The line === with a name."""
        self.end_hunk()
        self.answer = None
        if any(answer.name == name for answer in self.answers):
            self.refuse(line, f"there are two of the name {name}")
        self.answer = Answer(name, line)
        if NAME.fullmatch(name):
            self.answers.append(self.answer)
        else:
            self.answer.name = ""
            self.refuse(line, f"'{name}' is no name: small letters, digits and _")

    def read_head(self, answer: Answer, line: int, text: str) -> None:
        """A line of an answer before its first @@, or between two."""
        if text.startswith(("--- ", "+++ ")):
            return                                  # what diff -u writes above
        if HEAD.match(text) or (answer.head and GOES_ON.match(text)):
            answer.head.append(text)
        else:
            self.refuse(line, f"'{text}' is neither Mistake:, Why:, Read: or Fails: nor below @@")

    def read(self, text: str) -> None:
        """All lines; where nothing has a name yet, the first that is no comment ends it."""
        for line, with_end in enumerate(text.split("\n"), 1):
            written = with_end.removesuffix("\r")
            if written.startswith("=== "):
                self.begin(written[3:].strip(" "), line)
            elif written.startswith("#") or (written == "" and not self.hunk):
                self.end_hunk()
            elif not self.answer:
                self.refuse(line, "before the first '=== <name>' only comments may stand")
                return
            elif written.startswith("@@"):
                self.end_hunk()
                self.hunk = Hunk(line)
                self.answer.hunks.append(self.hunk)
            elif not self.hunk:
                self.read_head(self.answer, line, written)
            elif written == "" or written[0] in "-+ ":
                self.hunk.add(written)
            else:
                self.refuse(line, "a line below @@ begins with a minus, a plus or a blank")
            if self.answer:
                self.answer.last = line
        self.end_hunk()


class Refused(Exception):
    """A hunk that does not apply."""


def plain(solution: str) -> list[str]:
    """The lines of a solution without the marks of its tasks and what includes todo.hpp."""
    kept: list[str] = []
    after_todo = False
    lines = solution.split("\n")
    for line in lines[:-1] if lines[-1] == "" else lines:
        if MARK.match(line):
            continue
        if line == '#include "todo.hpp"':
            after_todo = True
            continue
        if not (after_todo and line == ""):
            kept.append(line)
        after_todo = False
    return kept


def applied(text: list[str], hunk: Hunk, name: str) -> list[str]:
    """The text with a hunk in its place.

    Raises:
        Refused: where it changes nothing, or its place is not to be told; `name` is what the text is called then.
    """
    count = len(hunk.old)
    if not hunk.changes:
        raise Refused("nothing goes and nothing comes here")
    if count == 0:
        raise Refused("these lines only come; say with a line that stays where")
    places = [at for at in range(len(text) - count + 1) if text[at:at + count] == hunk.old]
    if not places:
        raise Refused(f"these lines are not in {name}: '{hunk.first}'")
    if len(places) > 1:
        raise Refused(f"these lines are in {name} {len(places)} times: '{hunk.first}'; "
                      "more lines that stay say which are meant")
    return text[:places[0]] + hunk.new + text[places[0] + count:]


def made(reader: Reader, answer: Answer, solution: list[str], name: str) -> str:
    """A wrong answer, its head below the solution's first lines. Whatever does not apply is refused by the reader."""
    reader.answer = answer
    if not answer.hunks:
        reader.refuse(answer.line, "no @@ says in what it differs")
    text = solution
    for hunk in answer.hunks:
        try:
            text = applied(text, hunk, name)
        except Refused as why:
            reader.refuse(hunk.line, str(why))
    head = [*(f"// {line}" for line in answer.head), ""] if answer.head else []
    return "".join(line + "\n" for line in [*text[:3], *head, *text[3:]])


def read(file: str) -> str:
    """The text of a file, whatever bytes are in it."""
    with open(file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        return stream.read()


def make(solution: str, file: str, out: str) -> tuple[list[str], list[str]]:
    """Writes <out>/wrong.<name>.hpp for the blocks of a wrong.diff, as far as nothing is refused.

    Returns:
        The names of what was written, and the refusals by their lines.
    """
    reader = Reader(file)
    reader.read(read(file))
    lines = plain(read(solution))
    texts = [made(reader, answer, lines, os.path.basename(solution)) for answer in reader.answers]
    names: list[str] = []
    for answer, text in zip(reader.answers, texts):
        if reader.refusals and answer.last >= min(reader.refusals):
            break
        names.append(answer.name)
        with open(os.path.join(out, f"wrong.{answer.name}.hpp"), "w", encoding="utf-8", errors="surrogateescape",
                  newline="\n") as stream:
            stream.write(text)
    return names, [reader.refusals[line] for line in sorted(reader.refusals)]


def heads(file: str) -> str:
    """What the answers of a wrong.diff say of themselves, a line each: name, word and text with tabs between."""
    reader = Reader(file)
    reader.read(read(file))
    return "".join(f"{answer.name}\t{word}\t{text}\n"
                   for answer in reader.answers for word, text in answer.said().items())


def main(arguments: list[str]) -> int:
    """Ends with 1 where a file cannot be read or written, or something in it is refused."""
    parser = argparse.ArgumentParser(prog="wrong.py", description="Makes the wrong answers of an exercise.")
    verbs = parser.add_subparsers(dest="verb", required=True)
    making = verbs.add_parser("make", help="write each as <out>/wrong.<name>.hpp and print the names")
    making.add_argument("solution")
    making.add_argument("file", help="the wrong.diff")
    making.add_argument("out")
    saying = verbs.add_parser("heads", help="print what they say of themselves: name, word and text, with tabs between")
    saying.add_argument("file", help="the wrong.diff")
    given = parser.parse_args(arguments)
    refusals: list[str] = []
    try:
        if given.verb == "make":
            names, refusals = make(given.solution, given.file, given.out)
            said = "".join(name + "\n" for name in names)
        else:
            said = heads(given.file)
    except OSError as error:
        print(f"wrong.py: {error.filename}: {error.strerror}", file=sys.stderr)
        return 1
    sys.stdout.buffer.write(said.encode("utf-8", "surrogateescape"))
    sys.stdout.buffer.flush()
    sys.stderr.buffer.write("".join(line + "\n" for line in refusals).encode("utf-8", "surrogateescape"))
    return 1 if refusals else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
