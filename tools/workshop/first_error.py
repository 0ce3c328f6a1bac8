# SPDX-License-Identifier: BSL-1.0
"""From the output of g++ or clang++ the first error, for somebody who has written one short file: three lines, the line
in that file (0 if it is elsewhere), where the error was raised, and what it says.
"""

from __future__ import annotations

import argparse
import os
import re
import sys

ANSWER = re.compile(r"exercise\.hpp:([0-9]+)")
DIMENSION = re.compile(r"dim<([a-z:_]*)_base_dimension, *(?:boost::units::)?static_rational<(-?[0-9]+)")
QUANTITY = re.compile(r"(const )?quantity<unit<")
DELETED = re.compile(r"Ansatz_units_([a-z_]+)")
LINKER = re.compile(r".*(undefined reference to|multiple definition of|undefined symbol:|duplicate symbol:) *(.*)",
                    re.DOTALL)
# Each begins the sentence of an assertion: g++'s and the newer clang's, and the older clang's, which is in quotes.
ASSERTIONS = (re.compile(r"static assertion failed(?: due to requirement '.*?')?: (.*)", re.DOTALL),
              re.compile(r"static_assert failed(?: due to requirement '.*?')? \"(.*?)\"?", re.DOTALL))
CONVERSION = re.compile(r"could not convert '|cannot convert '|no viable conversion from |conversion from '")
FROM = re.compile(r"(?:^|[ )])from (?:returned value of type )?'")
TO = re.compile(r" to (?:function return type |non-scalar type )?(?=')")
NUMBER = re.compile(r"(const )?(double|float|int|long|unsigned|unsigned long|std::size_t|size_t)( const)?&?")
NO_RETURN = re.compile(r"no return statement in function|control reaches end of non-void"
                       r"|non-void function.* does not return a value")
# Comments, strings and characters, in which a bracket is none, and brackets.
PIECE = re.compile(r"//[^\n]*|/\*.*?\*/|R\"([^(\s]*)\(.*?\)\1\"|\"(?:[^\"\\\n]|\\.)*\""
                   r"|(?<![0-9a-fA-F])'(?:[^'\\\n]|\\.)+'|[()\[\]{}]", re.DOTALL)
CLOSING = {"(": ")", "[": "]", "{": "}"}
NO_FUNCTION = re.compile(r"no matching function for call to "
                         r"'(?:std::)?((?:exp|log|sinh|cosh|tanh|asin|acos|atan)[a-z0-9]*)\("
                         r".*?((?:quantity|vector) in [^,>)]*?) *[,>)]")
OPEN_BEFORE = re.compile(r"expected .*[;}]|function.definition is not allowed")
CAME_FROM = re.compile(r"note: (in instantiation|while)|required from")
SYMBOLS = {"length": "m", "mass": "kg", "time": "s", "plane_angle": "rad"}


def powers(factors: list[tuple[str, int]], between: str = " ") -> str:
    """Symbols with their powers, as m^2 s; the first power is not written."""
    return between.join(symbol if power == 1 else f"{symbol}^{power}" for symbol, power in factors)


def unit_of(text: str) -> str:
    """The compiler's "unit<list<dim<length_base_dimension, static_rational<1> >, ..." as m, kg, s with their powers."""
    factors: list[tuple[str, int]] = []
    for dimension in DIMENSION.finditer(text.partition("homogeneous_system")[0]):
        symbol = next((symbol for name, symbol in SYMBOLS.items() if name in dimension[1]), "?")
        factors.append((symbol, int(dimension[2])))
    over = [factor for factor in factors if factor[1] > 0]
    over.sort(key=lambda factor: factor[0] != "kg")          # as in kg m/s^2
    under = [(symbol, -power) for symbol, power in factors if power <= 0]
    if not under:
        return powers(over) or "no unit"
    return f"{powers(over) or '1'}/{powers(under)}"


def end_of(text: str, start: int) -> int:
    """Where a bracket < ends whose inside begins at `start`: behind its >."""
    depth = 1
    for at in range(start, len(text)):
        if text[at] == "<":
            depth += 1
        elif text[at] == ">":
            depth -= 1
        if depth == 0:
            return at + 1
    return len(text)


def readable(text: str) -> str:
    """Each quantity's type by its unit: "quantity in m/s", "vector in m"."""
    text = text.replace("boost::units::", "")
    while True:
        found = QUANTITY.search(text)
        if not found:
            return text
        end_of_unit = end_of(text, found.end())
        end = end_of(text, end_of_unit)
        kind = "vector" if "Matrix" in text[end_of_unit:end] else "quantity"
        text = f"{text[:found.start()]}{kind} in {unit_of(text[found.end():end_of_unit])}{text[end:]}"


def sentence(text: str) -> str:
    """What the library says with the name of a deleted function: the name as a sentence, and the two units."""
    name = DELETED.search(text)
    if not name:
        return text
    words = name[1].replace("_", " ")
    _, first, first_unit = text.partition("Unit1 = ")
    _, second, second_unit = text.partition("Unit2 = ")
    return f"{words}: {unit_of(first_unit)} and {unit_of(second_unit)}" if first and second else words


def called(kind: str) -> str:
    """A type as a person calls it: 'Length' {aka 'quantity in m'} is a quantity in m."""
    alias = re.search(r"[({]aka '", kind)
    name = (kind[alias.end():] if alias else kind.removeprefix("'")).partition("'")[0]
    if NUMBER.fullmatch(name):
        return "a plain number"
    return f"a {name}" if name.startswith(("quantity in ", "vector in ")) else name


def conversion(text: str) -> str:
    """A quantity where one of another unit belongs, most often behind `return`: what it is and what belongs there, and
    nothing of how either came to be."""
    told = text.replace("‘", "'").replace("’", "'")
    if not CONVERSION.search(told):
        return text
    if "cannot convert '" in told:
        told = told[told.rindex("cannot convert ") + len("cannot convert "):]
    else:
        places = [given.end() - 1 for given in FROM.finditer(told)]
        told = told[places[-1]:] if places else told         # the first may stand in a type
    to = TO.search(told)
    if not to:
        return text
    given_kind, wanted = told[:to.start()], told[to.end():]
    if not re.search("(quantity|vector) in ", given_kind + wanted):
        return text
    return f"this is {called(given_kind)}, where {called(wanted)} belongs"


def plain(text: str) -> str:
    """What a compiler says in its own words, where a person needs others."""
    if NO_RETURN.search(text):
        return "the function ends without return"
    of_number = NO_FUNCTION.search(text.replace("‘", "'").replace("’", "'"))
    if of_number:
        return (f"{of_number[1]} takes a plain number, and this is a {of_number[2]}: which factor would make it one?")
    return re.sub(r" *\[-Werror[^]]*\]$", "", text)


def linker_message(kind: str, rest: str) -> str:
    """What the linker misses, or has twice: the name between its quotes, with clang's or without."""
    name = re.sub(r"['\"’]+(;.*)?$", "", rest.lstrip("`'\"‘"), count=1, flags=re.DOTALL)
    if kind not in ("multiple definition of", "duplicate symbol:"):
        return f"{name} is declared and used, but it is defined nowhere"
    if re.fullmatch(r"main(\(.*)?", name):
        return "there are two of main: the tests have their own, so that an answer has none"
    return f"there are two of {name}: write it once, and 'inline' before a function of a header"


def asserted(text: str) -> str:
    """The sentence of a static assertion, where it is one."""
    for assertion in ASSERTIONS:
        found = assertion.fullmatch(text)
        if found:
            return found[1]
    return text


def never_closed(code: str) -> tuple[int, str] | None:
    """The line of a ( or a [ that has no partner, and which of the two it is. Where a brace has none, nothing: that
    could be any of those that are open."""
    opened: list[tuple[int, str]] = []
    for piece in PIECE.finditer(code):
        bracket = piece[0]
        if bracket in CLOSING:
            opened.append((code.count("\n", 0, piece.start()) + 1, bracket))
        elif bracket in CLOSING.values():
            if opened and CLOSING[opened[-1][1]] == bracket:
                opened.pop()
            else:
                return opened[-1] if opened and opened[-1][1] != "{" else None
    return opened[-1] if opened and opened[-1][1] != "{" else None


class FirstError:
    """What has been found in the lines so far; `line` is 0 where the answer has no part in it."""

    def __init__(self, file: str, root: str, code: str) -> None:
        """`file` is the answer as the compiler names it, `root` begins the paths that are shortened, and `code` is what
        the answer says."""
        self.file = file
        self.code = code
        self.root = root
        self.found = False
        self.line = 0
        self.where = ""
        self.message = ""
        self.compiling = False      # whether more may be said of it
        self.deleted = False        # whether the sentence is still to come
        self.near = 0               # the line of the answer that the compiler was led on from

    def set(self, where: str, message: str, line: int = 0) -> None:
        """An error that is shown."""
        self.found, self.compiling, self.deleted = True, False, False
        self.line, self.where, self.message = line, where, message

    def take_error(self, text: str) -> None:
        """The compiler's own error."""
        message = asserted(re.sub(r"^.*error: ", "", text, count=1))
        where = re.sub(r": (fatal )?error: .*", "", text, count=1)
        in_answer = ANSWER.search(text)
        line = (int(in_answer[1]) if in_answer else 0) if self.file in text else self.near
        self.set(where.removeprefix(self.root), plain(conversion(readable(sentence(message)))), line)
        self.compiling = True
        self.deleted = "deleted operator" in message

    def take(self, text: str) -> None:
        """The next line of the compiler's output."""
        in_answer, linker = ANSWER.search(text), LINKER.match(text)
        if "No space left on device" in text and not self.found:
            self.set("disk", "no space is left on the disk: make room and give the same command again")
        elif linker and not self.found:
            self.set("linking", linker_message(linker[1], linker[2]))
        # The lines of subject.hpp after the answer ask whether a bracket is open there. Then the compiler has often
        # missed another one before, in a place that is right.
        elif re.search(r"subject\.hpp:[0-9]+.*error:", text) and (not self.found or OPEN_BEFORE.search(self.message)):
            opened = never_closed(self.code)
            if opened:
                self.set("end", f"the {opened[1]} here is never closed", opened[0])
            else:
                self.set("end", "something is open at the end of the file: most often a closing brace } is missing")
        elif "error:" in text:
            if not self.found:
                self.take_error(text)
        elif "In file included from" in text:
            self.near = 0
        elif in_answer and re.search("required|instantiation", text):
            self.near = int(in_answer[1])
        # clang++ names the deleted operator first, and the sentence that is its type only afterwards.
        if self.deleted and DELETED.search(text):
            self.message, self.deleted = sentence(text), False
        # clang++ says afterwards from where it came.
        if self.compiling and not self.line and in_answer and CAME_FROM.search(text):
            self.line = int(in_answer[1])


def first_error(log: str, file: str, root: str, code: str = "") -> FirstError:
    """The first error of a log."""
    error = FirstError(file, root, code)
    for line in log.split("\n"):
        error.take(line)
    return error


def main(arguments: list[str]) -> int:
    """Ends with 1 where there is no error."""
    parser = argparse.ArgumentParser(prog="first_error.py", description="The first error of a compiler's output.")
    parser.add_argument("--file", required=True, help="the student's file, as the compiler names it")
    parser.add_argument("--root", required=True, help="the project's folder and a /, which are left out of places")
    parser.add_argument("log", help="the compiler's output")
    given = parser.parse_args(arguments)
    try:
        code = ""
        if os.path.exists(given.file):
            with open(given.file, encoding="utf-8", errors="surrogateescape") as stream:
                code = stream.read()
        with open(given.log, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
            error = first_error(stream.read(), given.file, given.root, code)
    except OSError as problem:
        print(f"first_error.py: {problem.filename}: {problem.strerror}", file=sys.stderr)
        return 1
    if not error.found:
        return 1
    said = f"{error.line}\n{error.where}\n{error.message}\n"
    sys.stdout.buffer.write(said.encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
