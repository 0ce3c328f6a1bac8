# SPDX-License-Identifier: BSL-1.0
"""What of the build a change concerns (tools/workshop/touched.py)."""

from __future__ import annotations

import contextlib
import io
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from workshop import touched

DRAG = """// SPDX-License-Identifier: BSL-1.0
#pragma once
/// Not Gravity.
#include <ansatz/units.hpp>
#define AIR 1
namespace ansatz {
template <class S, template <class> class T> struct Drag {
    double hidden(int x);
};
template <class S>
    requires(sizeof(S) > 1)
constexpr double air_of(S s) { return s; }
inline constexpr double thickest = 3;
static_assert(true, "Gravity(");
} // namespace ansatz
"""
FALL = "#include <ansatz/drag.hpp>\nstruct Fall {\n    Drag drag;\n};\n"
WORLD = "#include <ansatz/fall.hpp>\n// Drag, Fall\nstruct World {};\n"
ALGEBRA = "#pragma once\ndouble operator+(A, B);\n"


class Touched(unittest.TestCase):
    """A project of four headers and some tests."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Path(folder.name).resolve()
        self.build = self.project / "build"
        self.build.mkdir()
        for name, text in (("drag", DRAG), ("fall", FALL), ("world", WORLD), ("algebra", ALGEBRA), ("units", "")):
            self.write(f"include/ansatz/{name}.hpp", text)
        for name, text in (("drag", "Drag d;"), ("fall", "Fall f;"), ("other", '// Drag\nauto t = "Drag"; World w;'),
                           ("helped", '#include "tests/help.hpp"\n')):
            self.write(f"tests/{name}.cpp", text)
        self.write("tests/help.hpp", "using D = Drag;")

    def write(self, name: str, text: str) -> None:
        """A file of the project."""
        file = self.project / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def objects(self) -> dict[str, list[str]]:
        """As ninja tells of them."""
        all_headers = [f"../include/ansatz/{name}.hpp" for name in ("world", "fall", "drag", "units")]
        made = {f"tests/CMakeFiles/test_all.dir/{name}.cpp.o": [f"../tests/{name}.cpp", *all_headers]
                for name in ("drag", "fall", "other")}
        made["tests/CMakeFiles/test_all.dir/helped.cpp.o"] = ["../tests/helped.cpp", "../tests/help.hpp", *all_headers]
        made["tests/CMakeFiles/test_all.dir/sum.cpp.o"] = ["../tests/other.cpp", "../include/ansatz/algebra.hpp"]
        for name in ("drag", "fall", "world"):
            made[f"tests/CMakeFiles/headers_alone.dir/headers_alone/ansatz/{name}.hpp.cpp.o"] = [
                f"headers_alone/ansatz/{name}.hpp.cpp", *all_headers]
        return made

    def chosen(self, *changed: str) -> tuple[list[str], int]:
        """The last parts of what is chosen, and how many are left."""
        names, left = touched.choose(self.project, self.build, set(changed), self.objects())
        return sorted(name.rsplit("/", 1)[-1].removesuffix(".cpp.o") for name in names), left

    def test_declared(self) -> None:
        """What stands at the beginning of a line, no comment, no text, no member, no parameter of a template."""
        self.assertEqual(touched.declared_in(DRAG), ({"AIR", "Drag", "air_of", "thickest"}, False))
        self.assertTrue(touched.declared_in(ALGEBRA)[1])

    def test_named(self) -> None:
        """Who names it, itself, by a helper or by a header; who only includes it is left."""
        self.assertEqual(self.chosen("include/ansatz/drag.hpp"),
                         (["drag", "drag.hpp", "fall", "fall.hpp", "helped"], 2))
        self.assertEqual(self.chosen("include/ansatz/fall.hpp"), (["fall", "fall.hpp"], 5))

    def test_operator(self) -> None:
        """An operator is found without a name; so is what stood in a header that is gone."""
        self.assertEqual(self.chosen("include/ansatz/algebra.hpp"), (["sum"], 0))
        (self.project / "include/ansatz/drag.hpp").unlink()
        self.assertEqual(self.chosen("include/ansatz/drag.hpp"),
                         (["drag", "drag.hpp", "fall", "fall.hpp", "helped", "other", "world.hpp"], 0))

    def test_own_files(self) -> None:
        """A source or a helper of its own, and what was never built."""
        self.assertEqual(self.chosen("tests/other.cpp"), (["other", "sum"], 0))
        self.assertEqual(self.chosen("tests/help.hpp"), (["helped"], 0))
        names, _ = touched.choose(self.project, self.build, {"README.md"}, {"new.o": []})
        self.assertEqual(names, ["new.o"])

    def test_always(self) -> None:
        """What runs after every change."""
        self.write("tests/motion/newton.cpp", "")
        objects = {"a.o": ["../tests/motion/newton.cpp"]}
        self.assertEqual(touched.choose(self.project, self.build, {"include/ansatz/drag.hpp"}, objects), (["a.o"], 0))

    def test_link(self) -> None:
        """The objects that were not chosen are left out, the command ends before what CMake does next."""
        own = "tests/CMakeFiles/test_all.dir/"
        command = f": && c++ -O3 main.o {own}a.o {own}b.o -o tests/test_all libx.a && cd tests && cmake"
        done = subprocess.CompletedProcess([], 0, f"compile\n{command}\n", "")
        with mock.patch.object(subprocess, "run", return_value=done):
            self.assertEqual(touched.link_command(self.build, "all", {f"{own}b.o"}),
                             f"c++ -O3 main.o {own}b.o -o touched/test_all libx.a")

    def test_whole(self) -> None:
        """What is printed, and what is never built for it."""
        self.write("tests/must_not_compile/a_drag.cpp", "Drag{};")
        self.write("tests/must_not_compile/b_world.cpp", "World{}; // Drag")
        headers = ["../include/ansatz/drag.hpp"]
        objects = {"chapters/CMakeFiles/section_1.7.dir/1-motion/1.7-drag.cpp.o": ["../tests/drag.cpp", *headers],
                   "exercises/CMakeFiles/exercise.motion.drag.others.dir/x.cpp.o": ["../tests/drag.cpp", *headers],
                   "exercises/CMakeFiles/exercise.motion.drag.student.dir/x.cpp.o": ["../tests/drag.cpp", *headers],
                   "chapters/CMakeFiles/read_costs_motion.dir/x.cpp.o": ["../tests/drag.cpp", *headers],
                   "tests/CMakeFiles/test_motion.dir/drag.cpp.o": ["../tests/drag.cpp", *headers]}
        out = io.StringIO()
        changed = io.StringIO("include/ansatz/drag.hpp\ntests/motion/absent.sh\n")
        with mock.patch.object(touched, "deps_of", return_value=objects), \
                mock.patch.object(touched, "link_command", return_value="c++ x"), \
                mock.patch("sys.stdin", changed), contextlib.redirect_stdout(out):
            self.assertEqual(touched.main([str(self.project), str(self.build)]), 0)
        self.assertEqual(out.getvalue().splitlines(), [
            "section 1.7", "exercise motion.drag", "object tests/CMakeFiles/test_motion.dir/drag.cpp.o",
            "program motion c++ x", "mistake a_drag", "script motion.absent", "left 0"])

    def test_deps(self) -> None:
        """Ninja's two answers: all objects, and the files of those that were built."""
        answers = [subprocess.CompletedProcess([], 0, "a.o: CXX_COMPILER__x\nb.o: CXX_COMPILER__y\nx: phony\n", ""),
                   subprocess.CompletedProcess([], 0, "a.o: #deps 2, deps mtime 5 (VALID)\n    ../a.cpp\n"
                                                      "    /usr/include/stdio.h\n\n", "")]
        with mock.patch.object(subprocess, "run", side_effect=answers):
            self.assertEqual(touched.deps_of(self.project, self.build), {"a.o": ["../a.cpp"], "b.o": []})

    def read_of(self, name: str) -> set[str]:
        """The files, by their place in the project, that an object is made from which ninja knows and never built."""
        answers = [subprocess.CompletedProcess([], 0, f"{name}: CXX_COMPILER__x\n", ""),
                   subprocess.CompletedProcess([], 0, "", "")]
        with mock.patch.object(subprocess, "run", side_effect=answers):
            files = touched.deps_of(self.project, self.build)[name]
        return {str(Path(file).relative_to(self.project)) for file in files}

    def test_never_built(self) -> None:
        """A test that was never built by itself has what its text includes, by its place, and what that includes."""
        self.write("tests/motion/one.cpp", '#include "tests/help.hpp"\n#include <ansatz/drag.hpp>\n#include <cmath>\n')
        self.assertEqual(self.read_of("tests/CMakeFiles/test_motion.dir/motion/one.cpp.o"),
                         {"tests/motion/one.cpp", "tests/help.hpp", "include/ansatz/drag.hpp", "include/ansatz/units.hpp"})

    def test_section_never_built(self) -> None:
        """The same of a section, whose helpers lie beside it and in tools."""
        for file, text in (("chapters/1-motion/1.7-drag.cpp", '#include "plot.hpp"\n#include "problems.hpp"\n'),
                           ("chapters/1-motion/problems.hpp", '#include <ansatz/drag.hpp>\n'), ("tools/plot.hpp", "")):
            self.write(file, text)
        self.assertEqual(self.read_of("chapters/CMakeFiles/section_1.7.dir/1-motion/1.7-drag.cpp.o"),
                         {"chapters/1-motion/1.7-drag.cpp", "chapters/1-motion/problems.hpp", "tools/plot.hpp",
                          "include/ansatz/drag.hpp", "include/ansatz/units.hpp"})

    def test_within(self) -> None:
        """The first ones whatever they take, then the quick ones for which there is time."""
        seconds = {"own": 50.0, "a": 9.0, "b": 4.0, "c": 5.0}
        self.assertEqual(touched.within(60.0, ["a", "b", "c", "own", "new"], {"own"}, seconds), (["b", "c", "own"], 24.0))
        self.assertEqual(touched.within(0.0, ["a", "own"], {"own"}, seconds), (["own"], 9.0))
        self.assertEqual(touched.within(100.0, ["a", "new"], set(), seconds), (["a", "new"], 0.0))

    def test_seconds(self) -> None:
        """The longest of each object, and none from the cache; a build without a log has none."""
        log = self.build / ".ninja_log"
        self.assertEqual(touched.seconds_of(log), {})
        log.write_text("# ninja log v5\n5\t2005\t7\ta.o\tx\n0\t100\t8\ta.o\tx\n0\t30\t8\tb.o\ty\n", encoding="utf-8")
        self.assertEqual(touched.seconds_of(log), {"a.o": 2.0})

    def test_first(self) -> None:
        """What always runs, what was changed itself, the test of the header and the header alone."""
        def first(name: str, *files: str) -> bool:
            return touched.comes_first(name, list(files), {"include/ansatz/drag.hpp", "tests/help.hpp"}, lambda path: path)

        header = "include/ansatz/drag.hpp"
        self.assertTrue(first("a.o", "tests/drag.cpp", header))
        self.assertTrue(first("a.o", "tests/other.cpp", "tests/help.hpp"))
        self.assertTrue(first("a.o", "tests/motion/newton.cpp"))
        self.assertTrue(first("x/headers_alone/ansatz/drag.hpp.cpp.o", header))
        self.assertTrue(first("new.o"))
        self.assertFalse(first("a.o", "tests/other.cpp", header))
        self.assertFalse(first("x/headers_alone/ansatz/fall.hpp.cpp.o", header))

    def test_late(self) -> None:
        """With a limit, what is too dear is told and not built; the mistakes are counted, too."""
        self.write("tests/must_not_compile/a_drag.cpp", "Drag{};")
        self.write("build/.ninja_log", "".join(f"0\t{ms}\t7\ttests/CMakeFiles/test_all.dir/{name}.cpp.o\tx\n"
                                              for name, ms in (("drag", 9000), ("fall", 4000), ("helped", 5000))))
        objects = {name: files for name, files in self.objects().items() if "test_all" in name and "sum" not in name}
        for limit, late, fall in (("21", "late 1 5", True), ("16", "late 2 9", False)):
            out = io.StringIO()
            with mock.patch.object(touched, "deps_of", return_value=objects), \
                    mock.patch.object(touched, "link_command", return_value="c++ x"), \
                    mock.patch("sys.stdin", io.StringIO("include/ansatz/drag.hpp\n")), contextlib.redirect_stdout(out):
                self.assertEqual(touched.main([str(self.project), str(self.build), limit]), 0)
            self.assertIn(late, out.getvalue().splitlines())
            self.assertIn("drag.cpp.o", out.getvalue())
            self.assertEqual("fall.cpp.o" in out.getvalue(), fall)

    def test_usage(self) -> None:
        """Two folders, or it says what it is."""
        with contextlib.redirect_stderr(io.StringIO()) as errors:
            self.assertEqual(touched.main(["one"]), 2)
        self.assertIn("touched.py <project>", errors.getvalue())


if __name__ == "__main__":
    unittest.main()
