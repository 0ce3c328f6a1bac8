# SPDX-License-Identifier: BSL-1.0
"""How wrong answers are made from a solution and their differences (tools/workshop/wrong.py): what is made, what is
refused, with which place and name."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import wrong

SOLUTION = """// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <cmath>

inline double twice(double x) {
    // task 1: return todo(1);
    const double y = x;
    return x + y;
    // end of task 1
}

inline double twice_more(double x) {
    // task 2: return todo(2);
    const double y = x;
    return twice(x + y);
    // end of task 2
}
"""

HEAD = "Mistake: m\nWhy:     w\nRead:    1.1\nFails:   f\n"
COMMENTS = "// Mistake: m\n// Why:     w\n// Read:    1.1\n// Fails:   f\n\n"

DIFFERENCE = """=== difference
Mistake: a minus
Why:     One line
         and one more.
Read:    1.1
Fails:   sum, more
@@ anything may stand here
-    return x + y;
+    return x - y;
"""

DIFFERENT = """// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: a minus
// Why:     One line
//          and one more.
// Read:    1.1
// Fails:   sum, more

#include <cmath>

inline double twice(double x) {
    const double y = x;
    return x - y;
}

inline double twice_more(double x) {
    const double y = x;
    return twice(x + y);
}
"""

TWO_PLACES = f"""=== two_places
{HEAD}--- solution.hpp
+++ mine.hpp
@@ -1,2 +3,4 @@
 #include <cmath>
+#include <string>

 inline double twice(double x) {{
-    const double y = x;
+    const double y =
+        x;
@@
-    return twice(x + y);
+    return 0;
"""

IN_TWO_PLACES = f"""// SPDX-License-Identifier: BSL-1.0
#pragma once

{COMMENTS}#include <cmath>
#include <string>

inline double twice(double x) {{
    const double y =
        x;
    return x + y;
}}

inline double twice_more(double x) {{
    const double y = x;
    return 0;
}}
"""

LESS = f"""=== less
{HEAD}@@
 inline double twice(double x) {{
-    const double y = x;
-    return x + y;
+    return 2 * x;
 }}
"""

WITH_LESS = f"""// SPDX-License-Identifier: BSL-1.0
#pragma once

{COMMENTS}#include <cmath>

inline double twice(double x) {{
    return 2 * x;
}}

inline double twice_more(double x) {{
    const double y = x;
    return twice(x + y);
}}
"""


class InAFolder(unittest.TestCase):
    """With a solution, a wrong.diff beside it and a folder for what is made."""

    def setUp(self) -> None:
        """The names in refusals are as they are given, so the folder is the one where we are."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        os.mkdir("out")
        self.put("solution.hpp", SOLUTION)

    def put(self, name: str, text: str) -> None:
        """Writes a file."""
        with open(name, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(text)

    def made(self, name: str) -> str:
        """What was written of a wrong answer."""
        return wrong.read(os.path.join("out", f"wrong.{name}.hpp"))

    def run_it(self, *arguments: str) -> tuple[int, str, str]:
        """The code it ends with, and what it prints and complains."""
        out, err = (io.TextIOWrapper(io.BytesIO(), encoding="utf-8") for _ in range(2))
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = wrong.main(list(arguments))
            err.flush()
        out.seek(0)
        err.seek(0)
        return code, out.read(), err.read()

    def make(self, difference: str) -> tuple[int, str, str]:
        """What is said of a wrong.diff."""
        self.put("wrong.diff", difference)
        return self.run_it("make", "solution.hpp", "wrong.diff", "out")


class Making(InAFolder):
    """Differences that apply."""

    def test_one_line(self) -> None:
        """Found without a number; the head stands below the first lines, and todo.hpp and the tasks' marks are gone."""
        self.assertEqual(self.make(DIFFERENCE), (0, "difference\n", ""))
        self.assertEqual(self.made("difference"), DIFFERENT)

    def test_two_places_and_what_diff_writes(self) -> None:
        """Numbers and file names of `diff -u` mean nothing, and an empty line in a hunk is one that stays."""
        self.assertEqual(self.make(TWO_PLACES), (0, "two_places\n", ""))
        self.assertEqual(self.made("two_places"), IN_TWO_PLACES)

    def test_fewer_lines(self) -> None:
        """Lines that stay say which of two is meant."""
        self.assertEqual(self.make(LESS), (0, "less\n", ""))
        self.assertEqual(self.made("less"), WITH_LESS)

    def test_several_with_comments_between(self) -> None:
        """Each from the solution as it is, and named in order; a comment ends a hunk."""
        several = f"# a comment\n\n{DIFFERENCE}\n\n{TWO_PLACES}\n# a comment between two answers\n{LESS}"
        self.assertEqual(self.make(several), (0, "difference\ntwo_places\nless\n", ""))
        self.assertEqual(self.made("difference"), DIFFERENT)
        self.assertEqual(self.made("two_places"), IN_TWO_PLACES)
        self.assertEqual(self.made("less"), WITH_LESS)

    def test_lines_that_end_as_windows_has_them(self) -> None:
        """Of the wrong.diff; what comes has the ends of the solution."""
        whole = f"{DIFFERENCE}\n{TWO_PLACES}\n# a comment\n{LESS}"
        self.assertEqual(self.make(whole.replace("\n", "\r\n")), (0, "difference\ntwo_places\nless\n", ""))
        self.assertEqual(self.made("difference"), DIFFERENT)
        self.assertEqual(self.made("two_places"), IN_TWO_PLACES)
        self.assertEqual(self.made("less"), WITH_LESS)

    def test_nothing_is_made_of_comments(self) -> None:
        """An exercise may have no wrong answer yet."""
        self.assertEqual(self.make("# none yet\n"), (0, "", ""))
        self.assertEqual(self.make(""), (0, "", ""))


class Refusing(InAFolder):
    """Whoever writes an exercise is told the place, the answer's name and what is wrong."""

    def refused(self, difference: str, line: int, sentence: str) -> None:
        """Nothing may be made then, and there is this one sentence."""
        self.assertEqual(self.make(difference), (1, "", f"wrong.diff:{line}: error: {sentence}\n"))
        self.assertEqual(os.listdir("out"), [])

    def test_lines_that_are_not_there(self) -> None:
        """Known by the first of them."""
        self.refused(f"=== gone\n{HEAD}@@\n-    return x * y;\n+    return 0;\n", 6,
                     "gone: these lines are not in solution.hpp: 'return x * y;'")

    def test_a_line_that_is_there_but_for_its_end(self) -> None:
        """In the second hunk, whose place is named."""
        self.refused(f"=== other\n{HEAD}@@ -1 +1 @@\n-    return twice(x + y);\n@@\n-    return x + y\n\n", 8,
                     "other: these lines are not in solution.hpp: 'return x + y'")

    def test_lines_that_another_hunk_has_changed(self) -> None:
        """Hunks apply one after the other."""
        self.refused(f"=== again\n{HEAD}@@\n-    return x + y;\n+    return 0;\n@@\n-    return x + y;\n+    x;\n", 9,
                     "again: these lines are not in solution.hpp: 'return x + y;'")

    def test_the_mark_of_a_task(self) -> None:
        """It is in no answer."""
        self.refused(f"=== mark\n{HEAD}@@\n     // end of task 1\n-    return x + y;\n", 6,
                     "mark: these lines are not in solution.hpp: '// end of task 1'")

    def test_lines_that_are_there_twice(self) -> None:
        """git apply and patch would take one of them."""
        self.refused(f"=== both\n{HEAD}@@\n-    const double y = x;\n+    const double y = 0;\n", 6,
                     "both: these lines are in solution.hpp 2 times: 'const double y = x;'; "
                     "more lines that stay say which are meant")

    def test_lines_that_only_come(self) -> None:
        """Nobody could tell where."""
        self.refused(f"=== nowhere\n{HEAD}@@\n+    return 0;\n", 6,
                     "nowhere: these lines only come; say with a line that stays where")

    def test_nothing_changes(self) -> None:
        """A wrong answer that is the solution."""
        self.refused(f"=== same\n{HEAD}@@\n     return x + y;\n", 6, "same: nothing goes and nothing comes here")

    def test_an_answer_without_a_difference(self) -> None:
        """At the line of its name."""
        self.refused(f"=== none\n{HEAD}", 1, "none: no @@ says in what it differs")

    def test_a_name_that_is_none(self) -> None:
        """It is part of the name of a file and of C++."""
        self.refused("#\n#\n=== two words\n", 3, "'two words' is no name: small letters, digits and _")
        self.refused(f"=== Great\n{HEAD}@@\n-    return x + y;\n", 1, "'Great' is no name: small letters, digits and _")
        self.refused(f"=== ../up\n{HEAD}@@\n-    return x + y;\n", 1, "'../up' is no name: small letters, digits and _")

    def test_two_of_one_name(self) -> None:
        """The first is made."""
        block = f"=== twice\n{HEAD}@@\n-    return x + y;\n+    return 0;\n"
        self.assertEqual(self.make(f"{block}\n{block}"),
                         (1, "twice\n", "wrong.diff:10: error: there are two of the name twice\n"))
        self.assertEqual(os.listdir("out"), ["wrong.twice.hpp"])

    def test_what_stands_before_the_first_name(self) -> None:
        """A hunk without an answer."""
        self.refused("# a comment\n@@\n", 2, "before the first '=== <name>' only comments may stand")

    def test_a_word_that_no_head_has(self) -> None:
        """It would be told to nobody."""
        self.refused("=== head\nBecause: w\n@@\n-    return x + y;\n", 2,
                     "head: 'Because: w' is neither Mistake:, Why:, Read: or Fails: nor below @@")
        self.refused("=== head\n    more\n@@\n-    return x + y;\n", 2,
                     "head: '    more' is neither Mistake:, Why:, Read: or Fails: nor below @@")

    def test_a_line_without_a_sign(self) -> None:
        """Below @@."""
        self.refused("=== sign\n@@\n-    return x + y;\nreturn 0;\n", 4,
                     "sign: a line below @@ begins with a minus, a plus or a blank")
        self.refused("=== sign\n@@\n-    return x + y;\nreturn 0;", 4,
                     "sign: a line below @@ begins with a minus, a plus or a blank")

    def test_all_that_is_wrong_is_said_at_once(self) -> None:
        """In the order of the lines, and what stands before the first is made."""
        good = "=== good\n@@\n-    return x + y;\n"
        self.assertEqual(self.make(f"{good}=== gone\n@@\n-    y;\n=== sign\n@@\n-    return x + y;\nx\n"), (
            1, "good\n", "wrong.diff:5: error: gone: these lines are not in solution.hpp: 'y;'\n"
            "wrong.diff:10: error: sign: a line below @@ begins with a minus, a plus or a blank\n"))
        self.assertEqual(os.listdir("out"), ["wrong.good.hpp"])

    def test_a_file_that_is_not_there(self) -> None:
        """It is named."""
        self.assertEqual(self.run_it("make", "solution.hpp", "nowhere.diff", "out"),
                         (1, "", "wrong.py: nowhere.diff: No such file or directory\n"))
        self.assertEqual(self.run_it("heads", "nowhere.diff"),
                         (1, "", "wrong.py: nowhere.diff: No such file or directory\n"))


class Heads(InAFolder):
    """What the answers say of themselves."""

    def test_lines_that_go_on_are_joined(self) -> None:
        """By one blank; what stands below @@ is no head, whatever it looks like."""
        self.put("wrong.diff", f"{DIFFERENCE}+Fails:   nothing\n\n=== empty\nMistake:\nWhy:\n         Below.\n@@\n-x\n")
        self.assertEqual(self.run_it("heads", "wrong.diff"), (0, (
            "difference\tMistake\ta minus\ndifference\tWhy\tOne line and one more.\ndifference\tRead\t1.1\n"
            "difference\tFails\tsum, more\nempty\tMistake\t\nempty\tWhy\tBelow.\n"), ""))


if __name__ == "__main__":
    unittest.main()
