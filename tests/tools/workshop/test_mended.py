# SPDX-License-Identifier: BSL-1.0
"""Mended forms together (tools/workshop/mended.py)."""

from __future__ import annotations

import contextlib
import io
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from workshop import mended

FORM = """// expect: a sentence
#include <vector>
struct Ball {};
int main() {
#ifdef ANSATZ_MISTAKE
    Ball ball = 1;
#else
    Ball ball;
    if (true) {
    }
#endif
}
"""


class Mended(unittest.TestCase):
    """Files in a folder, and a compiler that refuses what has the word `bad` in it."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.runs: list[int] = []

    def write(self, name: str, text: str) -> Path:
        """One of the mistakes."""
        file = self.folder / f"{name}.cpp"
        file.write_text(text, encoding="utf-8")
        return file

    def compile(self, command: list[str], **_: object) -> subprocess.CompletedProcess[bytes]:
        """The compiler."""
        text = Path(command[-1]).read_text(encoding="utf-8")
        self.runs.append(text.count("namespace mended_"))
        return subprocess.CompletedProcess(command, 1 if "bad" in text else 0)

    def main(self, *files: Path) -> str:
        """What it prints of these."""
        out = io.StringIO()
        arguments = [str(self.folder / "found"), *map(str, files), "--", "g++", "-c"]
        with mock.patch.object(subprocess, "run", side_effect=self.compile), contextlib.redirect_stdout(out):
            self.assertEqual(mended.main(arguments), 0)
        return out.getvalue()

    def found(self) -> list[str]:
        """The names of those that were found clean."""
        return sorted(file.stem for file in (self.folder / "found").glob("*.mended"))

    def test_unit(self) -> None:
        """Each in its namespace, the includes before them once, and main returns; its lines keep their numbers."""
        files = [self.write("a", FORM), self.write("b", FORM)]
        text = mended.unit(files)
        self.assertTrue(text.startswith('#include <vector>\nnamespace mended_0 {\n#line 1 "'))
        self.assertEqual(text.count("#include"), 1)
        self.assertEqual(text.count("\nreturn 0; }\n"), 2)
        own = text.split(f'#line 1 "{files[1]}"\n')[1].splitlines()
        self.assertEqual(own[:5], ["// expect: a sentence", "", *FORM.splitlines()[2:5]])

    def test_all_clean(self) -> None:
        """One run."""
        self.assertEqual(self.main(self.write("a", FORM), self.write("b", FORM)), "2 of 2 mended forms are clean, found in 1 runs\n")
        self.assertEqual((self.found(), self.runs), (["a", "b"], [2]))

    def test_one_is_not(self) -> None:
        """It is named and has no file; all others have theirs."""
        files = [self.write(name, "bad" if name == "d" else FORM) for name in "abcde"]
        self.assertEqual(self.main(*files), "4 of 5 mended forms are clean, found in 7 runs; left: d\n")
        self.assertEqual((self.found(), self.runs), (["a", "b", "c", "e"], [5, 2, 3, 1, 2, 1, 1]))

    def test_many(self) -> None:
        """No more at once than a run may lose."""
        self.main(*(self.write(f"m{number}", FORM) for number in range(mended.TOGETHER + 1)))
        self.assertEqual(self.runs, [mended.TOGETHER, 1])

    def test_usage(self) -> None:
        """Without a compiler there is nothing to do."""
        with contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(mended.main(["folder", "a.cpp"]), 2)
            self.assertEqual(mended.main(["folder", "a.cpp", "--"]), 2)
