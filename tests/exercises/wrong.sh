#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# How wrong answers are made from a solution and their differences (tools/exercises/wrong.awk): what is made, what is
# refused, with which place and name. And which macros an answer changes (tools/exercises/macros.awk).
#
#   wrong.sh <the project's folder>
set -u
project=${1:?the project folder}
scratch=${ANSATZ_SCRATCH:?a folder for this test}
rm -rf "$scratch" && mkdir -p "$scratch/out" || exit 1
passed=0
failed=0
cat > "$scratch/solution.hpp" << 'HPP'
// SPDX-License-Identifier: BSL-1.0
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
HPP

check() { # <what> <expected> <got>
    if [ "$2" = "$3" ]; then passed=$((passed + 1)); else failed=$((failed + 1)); printf 'FAILED: %s: expected\n%s\ngot\n%s\n' "$@"; fi
}
made() { (cd "$scratch" && rm -f out/* && awk -v out=out -f "$project/tools/exercises/wrong.awk" solution.hpp wrong.diff 2>&1); }
# What differs from the solution without its marks, as ed would have it.
difference() { sed '/^ *\/\/ \(end of \)\?task/d; /todo.hpp/,+1d' "$scratch/solution.hpp" | diff - "$scratch/out/wrong.$1.hpp" | grep '^[<>]'; }
# refused <line> <sentence>: for the wrong.diff on standard input; nothing may be made of that answer.
refused() {
    cat > "$scratch/wrong.diff"
    local output status
    output=$(made)
    status=$?
    check "refused" "1 wrong.diff:$1: error: $2" "$status $output"
}

cat > "$scratch/wrong.diff" << 'DIFF'
# a comment

=== difference
Mistake: a minus
Why:     One line
         and one more.
Read:    1.1
Fails:   sum
@@ anything may stand here
-    return x + y;
+    return x - y;

=== two_places
Mistake: two at once
Why:     Why not.
Read:    1.1
Fails:   sum
--- solution.hpp
+++ mine.hpp
@@ -1,2 +3,4 @@
 #include <cmath>
+#include <string>

 inline double twice(double x) {
-    const double y = x;
+    const double y =
+        x;
@@
-    return twice(x + y);
+    return 0;

# a comment between two answers
=== less
Mistake: a line is gone
Why:     It was.
Read:    1.1
Fails:   sum
@@
 inline double twice(double x) {
-    const double y = x;
-    return x + y;
+    return 2 * x;
 }
DIFF
check "names" $'difference\ntwo_places\nless' "$(made)"
check "one line" $'> // Mistake: a minus\n> // Why:     One line\n> //          and one more.\n> // Read:    1.1\n> // Fails:   sum\n> \n<     return x + y;\n>     return x - y;' "$(difference difference)"
check "two places" $'> #include <string>\n<     const double y = x;\n>     const double y =\n>         x;\n<     return twice(x + y);\n>     return 0;' "$(difference two_places | sed '/^> \/\/ /d; /^> $/d')"
check "fewer lines" $'<     const double y = x;\n<     return x + y;\n>     return 2 * x;' "$(difference less | sed '/^> \/\/ /d; /^> $/d')"
sed -i 's/$/\r/' "$scratch/wrong.diff"
check "lines that end as Windows has them" $'difference\ntwo_places\nless' "$(made)"

head=$'Mistake: m\nWhy:     w\nRead:    1.1\nFails:   f'
refused 6 "gone: these lines are not in solution.hpp: 'return x * y;'" <<< "=== gone"$'\n'"$head"$'\n@@\n-    return x * y;\n+    return 0;'
refused 6 "both: these lines are in solution.hpp 2 times: 'const double y = x;'; more lines that stay say which are meant" <<< "=== both"$'\n'"$head"$'\n@@\n-    const double y = x;\n+    const double y = 0;'
refused 8 "other: these lines are not in solution.hpp: 'return x + y'" <<< "=== other"$'\n'"$head"$'\n@@ -1 +1 @@\n-    return twice(x + y);\n@@\n-    return x + y\n'
refused 6 "nowhere: these lines only come; say with a line that stays where" <<< "=== nowhere"$'\n'"$head"$'\n@@\n+    return 0;'
refused 6 "same: nothing goes and nothing comes here" <<< "=== same"$'\n'"$head"$'\n@@\n     return x + y;'
refused 1 "none: no @@ says in what it differs" <<< "=== none"$'\n'"$head"
refused 3 "'two words' is no name: small letters, digits and _" <<< $'#\n#\n=== two words'
refused 2 "before the first '=== <name>' only comments may stand" <<< $'# a comment\n@@'
refused 2 "head: 'Because: w' is neither Mistake:, Why:, Read: or Fails: nor below @@" <<< $'=== head\nBecause: w\n@@\n-    return x + y;'
refused 4 "sign: a line below @@ begins with a minus, a plus or a blank" <<< $'=== sign\n@@\n-    return x + y;\nreturn 0;'
block="=== twice"$'\n'"$head"$'\n@@\n-    return x + y;\n+    return 0;'
check "twice the same name" $'twice\nwrong.diff:10: error: there are two of the name twice' "$(printf '%s\n\n%s\n' "$block" "$block" > "$scratch/wrong.diff"; made | LC_ALL=C sort)"

cat > "$scratch/macros.hpp" << 'HPP'
#define ONE 1
  #  define TWO(x) x
#define \
    THREE
/* a comment */ # /* another */ undef FOUR
%:define FIVE
#ifdef SIX
#define ONE 2
#endif
// #define SEVEN
#include "beside.hpp"
#include <cmath>
HPP
printf '#pragma once\n#define EIGHT\n#include "macros.hpp"\n' > "$scratch/beside.hpp"
check "macros" "ONE TWO THREE FOUR FIVE EIGHT " "$(awk -f "$project/tools/exercises/macros.awk" "$scratch/macros.hpp" | tr '\n' ' ')"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
