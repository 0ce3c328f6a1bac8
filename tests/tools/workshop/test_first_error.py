# SPDX-License-Identifier: BSL-1.0
"""Which line of a compiler's output a student gets to see, and how it is put (tools/workshop/first_error.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest
from typing import NamedTuple

from workshop import first_error

ANSWER = "/p/exercises/1-a/b/exercise.hpp"
SHOWN = "exercises/1-a/b/exercise.hpp"
SUBJECT = "/p/build/exercises/subjects/a.b/student/subject.hpp"
BRACE = "something is open at the end of the file: most often a closing brace } is missing"

LENGTH = [("length", 1)]
TIME = [("time", 1)]
SPEED = [("length", 1), ("time", -1)]
FREQUENCY = [("time", -1)]
FORCE = [("length", 1), ("mass", 1), ("time", -2)]
VECTOR = "Eigen::Matrix<double, 3, 1>"


class Spelling(NamedTuple):
    """How a compiler writes the arguments of a template."""

    comma: str
    bracket: str            # behind another one


GCC = Spelling(", ", " >")
GCC_TYPEDEF = Spelling(",", ">")        # the types of what it names by a typedef
CLANG = Spelling(", ", ">")


def unit(dimensions: list[tuple[str, int]], space: str = "", by: Spelling = GCC) -> str:
    """The type of a unit as compilers print it, in a namespace or without."""
    listed = f"{space}dimensionless_type"
    for name, power in reversed(dimensions):
        of = f"{space}dim<{space}{name}_base_dimension{by.comma}{space}static_rational<{power}>{by.bracket}"
        listed = f"{space}list<{of}{by.comma}{listed}" + (by.bracket if listed.endswith(">") else ">")
    bases = f"{space}list<{space}si::meter_base_unit{by.comma}{space}dimensionless_type>"
    return f"{space}unit<{listed}{by.comma}{space}homogeneous_system<{bases}{by.bracket}{by.comma}void>"


def quantity(dimensions: list[tuple[str, int]], of: str = "double", space: str = "", by: Spelling = GCC) -> str:
    """The type of a quantity as compilers print it."""
    end = by.bracket if of.endswith(">") else ">"
    return f"{space}quantity<{unit(dimensions, space, by)}{by.comma}{of}{end}"


class FirstError(unittest.TestCase):
    """Logs of g++ and clang++."""

    def expect(self, line: int, where: str, message: str, *log: str) -> None:
        """The first error of these lines."""
        error = first_error.first_error("".join(text + "\n" for text in log), ANSWER, "/p/")
        self.assertTrue(error.found)
        self.assertEqual((error.line, error.where, error.message), (line, where, message))

    def expect_error(self, message: str, error: str) -> None:
        """How one error in line 8 of the answer is put."""
        self.expect(8, f"{SHOWN}:8:9", message, f"{ANSWER}:8:9: error: {error}")

    def test_the_first_error_and_no_warning(self) -> None:
        """What comes after it is most often its consequence."""
        self.expect(12, f"{SHOWN}:12:9", "expected ';' before '}' token",
                    "[1/2] Building CXX object x.o",
                    f"{ANSWER}:9:1: warning: unused variable 'x'",
                    f"{ANSWER}:12:9: error: expected ';' before '}}' token",
                    f"{ANSWER}:30:9: error: another")

    def test_raised_in_the_library_gcc(self) -> None:
        """g++ says from where before."""
        self.expect(17, "include/ansatz/x.hpp:5:3", "Ansatz: say it otherwise",
                    f"In file included from {ANSWER}:3,",
                    "/p/include/ansatz/x.hpp: In instantiation of 'f(T) [with T = int]':",
                    f"{ANSWER}:17:9:   required from here",
                    "/p/include/ansatz/x.hpp:5:3: error: static assertion failed: Ansatz: say it otherwise")

    def test_raised_in_the_library_clang(self) -> None:
        """clang++ says from where after, and the newer one without quotes; what it requires is left out."""
        came = f"{ANSWER}:18:9: note: in instantiation of function template specialization 'f<int>' requested here"
        for error in ("static_assert failed due to requirement 'ok<int>' \"Ansatz: say it otherwise\"",
                      "static assertion failed due to requirement 'a::ok<int>': Ansatz: say it otherwise"):
            self.expect(18, "include/ansatz/x.hpp:5:3", "Ansatz: say it otherwise",
                        f"/p/include/ansatz/x.hpp:5:3: error: {error}", came)

    def test_raised_in_the_test(self) -> None:
        """That the answer is included is not to say that it is to blame."""
        self.expect(0, "exercises/1-a/b/test.cpp:4:1", "'f' is not a member of 'exercise'",
                    f"In file included from {ANSWER}:3,",
                    "/p/exercises/1-a/b/test.cpp:4:1: error: 'f' is not a member of 'exercise'")

    def test_no_line_of_the_answer(self) -> None:
        """Where nobody names one."""
        self.expect(0, "include/ansatz/x.hpp:5:3", "wrong", "/p/include/ansatz/x.hpp:5:3: error: wrong")
        self.expect(0, "cc1plus", f"{ANSWER}: No such file or directory",
                    f"cc1plus: fatal error: {ANSWER}: No such file or directory")

    def test_where_an_earlier_instantiation_came_from_is_forgotten(self) -> None:
        """With the next file that is included."""
        self.expect(0, "include/ansatz/x.hpp:5:3", "wrong",
                    f"{ANSWER}:17:9:   required from here",
                    "In file included from /p/include/ansatz/y.hpp:3,",
                    "/p/include/ansatz/x.hpp:5:3: error: wrong")

    def test_a_deleted_function_is_a_sentence_gcc(self) -> None:
        """With both units."""
        self.expect_error(
            "this adds or compares quantities of different units: m and m/s",
            "use of deleted function 'boost::units::Ansatz_units_this_adds_or_compares_quantities_of_different_units "
            f"boost::units::operator+=(A, B) [with Unit1 = {unit(LENGTH)}; Unit2 = {unit(SPEED)}]'")

    def test_a_deleted_function_is_a_sentence_clang(self) -> None:
        """It names the operator first, and the units nowhere."""
        self.expect(8, f"{SHOWN}:8:11", "this adds or compares quantities of different units",
                    f"{ANSWER}:8:11: error: overload resolution selected deleted operator '+='",
                    "/p/include/ansatz/units/x.hpp:3:1: note: candidate function [with Unit1 = a, Unit2 = b] has been "
                    "explicitly deleted",
                    "Ansatz_units_this_adds_or_compares_quantities_of_different_units "
                    "operator+=(quantity<Unit1, X>&, const quantity<Unit2, Y>&) = delete;")

    def test_a_sentence_without_two_units(self) -> None:
        """One alone would be a riddle."""
        self.expect_error("this is not done", "use of deleted function 'Ansatz_units_this_is_not_done f(A) "
                          f"[with Unit1 = {unit(LENGTH)}]'")

    def test_a_candidate_is_not_what_was_chosen(self) -> None:
        """What might have been called has its sentence too, but it is not the error."""
        self.expect(8, f"{SHOWN}:8:11", "no matching function for call to 'f'",
                    f"{ANSWER}:8:11: error: no matching function for call to 'f'",
                    "Ansatz_units_this_adds_or_compares operator+=(quantity<Unit1, X>&) = delete;")

    def test_types_by_their_units(self) -> None:
        """Mass comes first, as people write it."""
        space = "boost::units::"
        self.expect_error(
            "no match for 'operator=' (operand types are 'quantity in kg m/s^2' and 'vector in no unit')",
            f"no match for 'operator=' (operand types are '{quantity(FORCE, space=space)}' and "
            f"'{quantity([], VECTOR, space)}')")

    def test_a_wrong_unit_in_a_return_gcc(self) -> None:
        """What is there and what belongs there, and nothing of how it came to be; in its quotes and without blanks."""
        product = quantity([("time", -2)])
        self.expect_error(
            "this is a quantity in 1/s^2, where a quantity in 1/s belongs",
            "could not convert ‘boost::units::operator*(const quantity<Unit1, X>&, const quantity<Unit2, Y>&) "
            f"[with Unit1 = {unit(FREQUENCY)}; X = double; typename multiply_typeof_helper<quantity<Unit1, X>, "
            f"quantity<Unit2, Y> >::type = {product}](f)’ from ‘{quantity([('time', -2)], by=GCC_TYPEDEF)}’ to "
            f"‘{quantity(FREQUENCY, by=GCC_TYPEDEF)}’")

    def test_a_quantity_where_a_number_belongs(self) -> None:
        """The alias's name is left out."""
        self.expect_error(
            "this is a quantity in m, where a plain number belongs",
            f"cannot convert 'exercise::Length' {{aka '{quantity(LENGTH, space='boost::units::')}'}} to 'double' "
            "in return")

    def test_a_number_where_a_quantity_belongs(self) -> None:
        """And what was converted is left out, too."""
        self.expect_error(
            "this is a plain number, where a quantity in m belongs",
            f"could not convert 'a' from 'double' to 'exercise::Length' {{aka '{quantity(LENGTH)}'}}")

    def test_a_wrong_unit_in_a_return_clang(self) -> None:
        """It has words of its own for it."""
        self.expect_error(
            "this is a vector in m/s, where a vector in m belongs",
            f"no viable conversion from returned value of type '{quantity(SPEED, VECTOR, by=CLANG)}' "
            f"to function return type 'Place' (aka '{quantity(LENGTH, 'Matrix<double, 3, 1>', by=CLANG)}')")

    def test_a_conversion_that_was_asked_for(self) -> None:
        """g++, where a quantity begins with another one."""
        self.expect_error(
            "this is a quantity in m, where a quantity in s belongs",
            f"conversion from '{quantity(LENGTH, by=GCC_TYPEDEF)}' to non-scalar type "
            f"'{quantity(TIME, by=GCC_TYPEDEF)}' requested")

    def test_what_has_no_unit_keeps_the_compilers_words(self) -> None:
        """They are as good as ours."""
        self.expect_error("cannot convert 'std::string' to 'double' in return",
                          "cannot convert 'std::string' to 'double' in return")

    def test_a_function_without_return(self) -> None:
        """In one sentence, whoever says it."""
        for error in ("no return statement in function returning non-void [-Werror=return-type]",
                      "non-void function does not return a value [-Werror,-Wreturn-type]",
                      "control reaches end of non-void function [-Werror=return-type]"):
            self.expect_error("the function ends without return", error)

    def test_the_option_is_no_news(self) -> None:
        """It would only send people to the compiler's handbook."""
        self.expect_error("'q' is used uninitialized", "'q' is used uninitialized [-Werror=uninitialized]")

    def test_a_name_that_is_defined_nowhere(self) -> None:
        """The linker's error names the symbol, not the program that called the linker."""
        sentence = "exercise::other(double) is declared and used, but it is defined nowhere"
        self.expect(0, "linking", sentence,
                    "/usr/bin/ld: test.cpp.o: in function `probe':",
                    "test.cpp:(.text+0x4e7): undefined reference to `exercise::other(double)'",
                    "collect2: error: ld returned 1 exit status")
        self.expect(0, "linking", sentence,
                    "ld.lld: error: undefined symbol: exercise::other(double)",
                    "clang: error: linker command failed with exit code 1 (use -v to see invocation)")

    def test_a_name_that_is_defined_twice(self) -> None:
        """main is the tests', and any other lacks `inline`."""
        place = "/usr/bin/ld: test.cpp:(.text+0x3c): multiple definition of"
        self.expect(0, "linking", "there are two of main: the tests have their own, so that an answer has none",
                    f"{place} `main'; main.cpp.o:main.cpp:(.text+0x1fe46): first defined here",
                    "collect2: error: ld returned 1 exit status")
        self.expect(0, "linking", "there are two of f(int): write it once, and 'inline' before a function of a header",
                    f"{place} `f(int)'; main.cpp.o:main.cpp:(.text+0x1fe46): first defined here")

    def test_something_is_open_at_the_end(self) -> None:
        """Whoever is included next is not to blame, nor is the last line."""
        open_there = (f"{SUBJECT}:3:20: error: specialization of 'template<class> struct NothingIsOpen' in different "
                      "namespace")
        self.expect(0, "end", BRACE, open_there,
                    "/p/tools/exercises/expect.hpp:14:1: error: expected '}' at end of input")
        self.expect(0, "end", BRACE, f"{ANSWER}:31:2: error: expected ';' after struct definition", open_there)

    def test_a_bracket_that_is_never_closed(self) -> None:
        """The compiler swallows the rest of the file with it; the file says where it stands."""
        log = f"{SUBJECT}:3:20: error: specialization of 'template<class> struct NothingIsOpen' in different namespace"
        for code, line, message in (
                ("void f() {\n    g(1, h(2);\n}\n", 2, "the ( here is never closed"),
                ("void f() {\n    a[1 = 2;\n}\n", 2, "the [ here is never closed"),
                ("void f() {\n    x = exp(-a * b\n}\nint g(int);\n", 2, "the ( here is never closed"),
                ("int f(\n", 1, "the ( here is never closed"),
                ("void f() {\n    g(\")\" /* ) */, ')' // )\n    ;\n}\n", 2, "the ( here is never closed"),
                ("int n = 1'000'000;\nvoid f() { g('\\'', R\"x())x\"; }\n", 2, "the ( here is never closed"),
                ("struct A {\n    void f() { g(1); }\n", 0, BRACE),
                ("void f() { g(1)); }\nstruct A {\n", 0, BRACE), ("}\n", 0, BRACE), ("", 0, BRACE)):
            with self.subTest(code=code):
                error = first_error.first_error(log + "\n", ANSWER, "/p/", code)
                self.assertEqual((error.line, error.where, error.message), (line, "end", message))

    def test_a_function_of_numbers_is_given_a_quantity(self) -> None:
        """How the compiler calls what was handed over is of no use; its unit is."""
        quantity = "boost::units::unit<boost::units::list<boost::units::dim<boost::units::time_base_dimension, " \
                   "boost::units::static_rational<-1> >, boost::units::dimensionless_type>, " \
                   "boost::units::homogeneous_system<x> >, double"
        ending = "which factor would make it one?"
        for given in (f"boost::units::quantity<{quantity} >",
                      f"boost::units::unary_minus_typeof_helper<boost::units::quantity<{quantity} > >::type"):
            self.expect_error(f"exp takes a plain number, and this is a quantity in 1/s: {ending}",
                              f"no matching function for call to ‘exp({given})’")
        self.expect_error("no matching function for call to 'exp(A)'", "no matching function for call to 'exp(A)'")

    def test_an_error_before_what_is_open(self) -> None:
        """Another mistake stays the first, and nothing is said of the end."""
        self.expect(9, f"{SHOWN}:9:1", "'x' was not declared", f"{ANSWER}:9:1: error: 'x' was not declared",
                    f"{SUBJECT}:3:20: error: specialization of 'template<class> struct NothingIsOpen'")

    def test_a_disk_that_is_full(self) -> None:
        """It is no fault of the answer."""
        self.expect(0, "disk", "no space is left on the disk: make room and give the same command again",
                    f"{ANSWER}:3:9: fatal error: error writing to /x.s: No space left on device")


class Command(unittest.TestCase):
    """Files and what it ends with."""

    def run_it(self, log: bytes | None) -> tuple[int, bytes, str]:
        """The code it ends with, and what it prints and complains."""
        raw = io.BytesIO()
        out, err = io.TextIOWrapper(raw, encoding="utf-8"), io.StringIO()
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "log")
            if log is not None:
                with open(file, "wb") as stream:
                    stream.write(log)
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                code = first_error.main(["--file", ANSWER, "--root", "/p/", file])
            out.flush()
            return code, raw.getvalue(), err.getvalue().replace(folder + "/", "")

    def test_three_lines(self) -> None:
        """Every byte of the compiler's stays, also what is no UTF-8."""
        self.assertEqual(self.run_it(ANSWER.encode() + b":8:1: error: stray '\xff' in program\n"),
                         (0, b"8\n" + SHOWN.encode() + b":8:1\nstray '\xff' in program\n", ""))

    def test_the_answer_is_read(self) -> None:
        """Where the compiler only says that something is open."""
        with tempfile.TemporaryDirectory() as folder:
            answer, log = os.path.join(folder, "exercise.hpp"), os.path.join(folder, "log")
            with open(answer, "w", encoding="utf-8") as stream:
                stream.write("int f() {\n    return (1;\n}\n")
            with open(log, "w", encoding="utf-8") as stream:
                stream.write("subject.hpp:3:20: error: specialization\n")
            said = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
            with contextlib.redirect_stdout(said):
                code = first_error.main(["--file", answer, "--root", folder + "/", log])
            said.flush()
            self.assertEqual((code, said.buffer.getvalue()),  # type: ignore[attr-defined]
                             (0, b"2\nend\nthe ( here is never closed\n"))

    def test_no_error_no_answer(self) -> None:
        """In a log without one, and where there is no log."""
        self.assertEqual(self.run_it(b"all is well\n"), (1, b"", ""))
        self.assertEqual(self.run_it(None), (1, b"", "first_error.py: log: No such file or directory\n"))


if __name__ == "__main__":
    unittest.main()
