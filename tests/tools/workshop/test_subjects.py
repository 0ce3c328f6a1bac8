# SPDX-License-Identifier: BSL-1.0
"""What the answers to an exercise are compiled as (tools/workshop/subjects.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import subjects

MACROS = """#define ONE 1
  #  define TWO(x) x
#define \\
    THREE
/* a comment */ # /* another */ undef FOUR
%:define FIVE
#ifdef SIX
#define ONE 2
#endif
// #define SEVEN
#include "beside.hpp"
#include <cmath>
"""

STUDENT = """template <class> struct NothingIsOpen;
#pragma push_macro("TWICE")
#include "exercises/1-a/b/exercise.hpp"
#pragma pop_macro("TWICE")
template <> struct NothingIsOpen<int> {};
"""

# With two answers: one that includes something and changes macros, and one that does neither, and, as the last, has no
# namespace.
OTHERS = """// Made by tools/exercises/subjects.sh.
#include "tools/exercises/expect.hpp"
template <int> struct NothingIsOpen;

// subject 0: solution
#if !defined(ANSATZ_BROKEN_0) && (!defined(ANSATZ_ONLY) || ANSATZ_ONLY + 0 == 0)
#include <cmath>
#include <ansatz/world.hpp>
#pragma push_macro("ONE")
#pragma push_macro("TWO")
namespace subject_0 {
static constexpr const char* tested_subject = "solution";
#include "exercises/1-a/b/solution.hpp"
}
#pragma pop_macro("ONE")
#pragma pop_macro("TWO")
template <> struct NothingIsOpen<0> {};
#endif

// subject 1: wrong.sign
#if !defined(ANSATZ_BROKEN_1) && (!defined(ANSATZ_ONLY) || ANSATZ_ONLY + 0 == 1)


static constexpr const char* tested_subject = "wrong.sign";
#include "wrong.sign.hpp"

template <> struct NothingIsOpen<1> {};
#endif

#include <vector>
#if !defined(ANSATZ_BROKEN_0) && (!defined(ANSATZ_ONLY) || ANSATZ_ONLY + 0 == 0)
namespace subject_0 {
#include "exercises/1-a/b/test.cpp"
static const ansatz::workbook::RegisteredProbe registered_probe(tested_subject, &probe);
}
#endif
#if !defined(ANSATZ_BROKEN_1) && (!defined(ANSATZ_ONLY) || ANSATZ_ONLY + 0 == 1)
#include "exercises/1-a/b/test.cpp"
static const ansatz::workbook::RegisteredProbe registered_probe(tested_subject, &probe);
#endif
"""


class InAFolder(unittest.TestCase):
    """With files."""

    def setUp(self) -> None:
        """A folder for an exercise."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def put(self, name: str, text: str) -> str:
        """Writes a file, and the folder where it lies, and returns its path."""
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
        return path


class Macros(InAFolder):
    """Those that an answer changes."""

    def test_every_way_to_write_a_directive(self) -> None:
        """In the answer and beside it, each once; two files may include each other."""
        self.put("beside.hpp", '#pragma once\n#define EIGHT\n#include "macros.hpp"\n')
        self.assertEqual(subjects.macros_of(self.put("macros.hpp", MACROS)),
                         ["ONE", "TWO", "THREE", "FOUR", "FIVE", "EIGHT"])

    def test_lines_that_end_as_windows_has_them(self) -> None:
        """Also where a directive goes on."""
        self.assertEqual(subjects.macros_of(self.put("macros.hpp", MACROS.replace("\n", "\r\n"))),
                         ["ONE", "TWO", "THREE", "FOUR", "FIVE"])

    def test_folders(self) -> None:
        """A file is looked for beside the one that includes it; one that comes back by another path has an end."""
        self.put("below/c.hpp", '#define C\n#include "../a.hpp"\n#include "../below/./c.hpp"\n#include "d.hpp"\n')
        self.put("below/d.hpp", "#undef D\n")
        file = self.put("a.hpp", '#include "below/c.hpp"\n#define A(x)\n')
        self.assertEqual(subjects.macros_of(file), ["C", "D", "A"])

    def test_no_macros(self) -> None:
        """A word that only begins as a directive, one in a comment or in a line, and a file that is not there."""
        file = self.put("a.hpp", "#defined X\n/* #define Y */\nx #define Z\n#define 1\n")
        self.assertEqual(subjects.macros_of(file), [])
        self.assertEqual(subjects.macros_of(os.path.join(self.folder, "nowhere.hpp")), [])


class Texts(InAFolder):
    """What is written."""

    def test_the_headers_of_a_library_each_once(self) -> None:
        """In order, and in one spelling; what lies beside is not among them."""
        file = self.put("a.hpp", "#include <cmath>   // roots\n # include  <a/b.hpp>\n#include <cmath>\n"
                        '#include "c.hpp"\n// #include <d>\n')
        self.assertEqual(subjects.headers_of(file), ["#include <cmath>", "#include <a/b.hpp>"])

    def test_a_student(self) -> None:
        """A template can be specialised behind the answer only where no brace is open."""
        self.put("exercise.hpp", "#define TWICE 2\n")
        self.assertEqual(subjects.student("exercises/1-a/b", os.path.join(self.folder, "exercise.hpp")), STUDENT)

    def test_all_the_others(self) -> None:
        """Each in a namespace of its own and with the tests once more."""
        self.put("solution.hpp", "#include <cmath>\n#include <ansatz/world.hpp>\n#define ONE\n#define TWO\n")
        self.put("test.cpp", '#include <vector>\n#include "x.hpp"\n')
        self.put("out/wrong.sign.hpp", "int x;\n")
        self.assertEqual(subjects.others("exercises/1-a/b", self.folder, os.path.join(self.folder, "out"),
                                         ["solution", "wrong.sign"]), OTHERS)


class Command(InAFolder):
    """Files and arguments."""

    def run_it(self, *arguments: str) -> tuple[int, str, str]:
        """The code it ends with, and what it prints and complains."""
        out, err = io.TextIOWrapper(io.BytesIO(), encoding="utf-8"), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = subjects.main(list(arguments))
        out.seek(0)
        return code, out.read(), err.getvalue()

    def test_both_kinds(self) -> None:
        """As they are called by subjects.sh."""
        self.put("exercise.hpp", "#define TWICE 2\n")
        self.assertEqual(self.run_it("student", self.folder, "exercises/1-a/b"), (0, STUDENT, ""))
        self.put("solution.hpp", "#include <cmath>\n#include <ansatz/world.hpp>\n#define ONE\n#define TWO\n")
        self.put("test.cpp", '#include <vector>\n')
        out = os.path.dirname(self.put("out/wrong.sign.hpp", "int x;\n"))
        self.assertEqual(self.run_it("others", self.folder, "exercises/1-a/b", out, "solution", "wrong.sign"),
                         (0, OTHERS, ""))

    def test_a_file_that_is_not_there_is_named(self) -> None:
        """And nothing is printed that could be compiled."""
        code, printed, said = self.run_it("others", self.folder, "exercises/1-a/b", self.folder, "library")
        self.assertEqual((code, printed), (1, ""))
        self.assertEqual(said, f"subjects.py: {self.folder}/library.hpp: No such file or directory\n")


if __name__ == "__main__":
    unittest.main()
