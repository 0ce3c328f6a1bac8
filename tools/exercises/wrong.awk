# SPDX-License-Identifier: BSL-1.0
#
# Makes the wrong answers of an exercise from its solution, so that the two cannot drift apart. Each block of its
# wrong.diff is one of them:
#
#     === new_velocity
#     Mistake: the position moved with the new velocity        what a student is told that it is
#     Why:     The two lines are the other way round. The
#              velocity of the end is not known before.        lines that go on begin with blanks
#     Read:    1.6.3                                           sections of the notes
#     Fails:   old-velocity, fall                              the tests that it fails
#     @@
#     -        x += v * dt;
#              v += a * dt;
#     +        x += v * dt;
#
# Below each @@ stand lines of the solution (without the marks of its tasks), as in any diff: those that go have a minus,
# those that come a plus, those that stay a blank. They are found by what they say, wherever they are, so that they must
# stand there once: what stands nowhere, or twice, is refused with its place.
#
#   awk -v out=<folder> -f wrong.awk <solution.hpp> <wrong.diff>     writes <folder>/wrong.<name>.hpp, prints the names

function refuse(line, text) {
    printf "%s:%d: error: %s%s\n", FILENAME, line, (name == "" ? "" : name ": "), text > "/dev/stderr"
    failed = 1
}
function found(at,    i) {
    for (i = 1; i <= olds; i++) if (text[at + i - 1] != old[i]) return 0
    return 1
}
# The lines of a hunk in their place.
function apply(    at, i, place, places) {
    if (!hunk) return
    while (blanks_at_end > 0) { olds--; news--; blanks_at_end-- }        # empty lines before the next block are no context
    if (hunk_changes == 0) refuse(hunk, "nothing goes and nothing comes here")
    else if (olds == 0) refuse(hunk, "these lines only come; say with a line that stays where")
    else {
        for (at = 1; at + olds - 1 <= lines; at++) if (found(at)) { places++; place = at }
        if (places == 0) refuse(hunk, "these lines are not in " solution ": '" first_of_hunk "'")
        else if (places > 1) refuse(hunk, "these lines are in " solution " " places " times: '" first_of_hunk "'; more lines that stay say which are meant")
        else put(place)
    }
    hunk = 0
}
function put(place,    i, by) {
    by = news - olds
    if (by > 0) for (i = lines; i >= place + olds; i--) text[i + by] = text[i]
    if (by < 0) for (i = place + olds; i <= lines; i++) text[i + by] = text[i]
    lines += by
    for (i = 1; i <= news; i++) text[place + i - 1] = new[i]
}
# A wrong answer is whole: its head stands where the solution's first lines end.
function finish(    file, i, word) {
    if (name == "") return
    apply()
    if (!hunks) refuse(began, "no @@ says in what it differs")
    if (failed) return
    file = out "/wrong." name ".hpp"
    for (i = 1; i <= lines; i++) {
        print text[i] > file
        if (i == 3 && heads) { for (word = 1; word <= heads; word++) print "// " head[word] > file; print "" > file }
    }
    close(file)
    print name
}
function begin(which,    i) {
    finish()
    name = ""
    if (which !~ /^[a-z][a-z0-9_]*$/) { refuse(FNR, "'" which "' is no name: small letters, digits and _"); return }
    if (which in seen) refuse(FNR, "there are two of the name " which)
    seen[which] = 1
    name = which
    began = FNR; hunk = 0; hunks = 0; heads = 0
    lines = plains
    for (i = 1; i <= plains; i++) text[i] = plain[i]
}

FNR == 1 { files++ }
files == 1 { solution = FILENAME; sub(/.*\//, "", solution) }
files == 1 && /^ *\/\/ (end of )?task [0-9]+/ { next }
files == 1 && /^#include "todo.hpp"$/ { after_todo = 1; next }
files == 1 && after_todo && /^$/ { after_todo = 0; next }
files == 1 { after_todo = 0; plain[++plains] = $0; next }

{ sub(/\r$/, "") }
/^=== / { sub(/^=== +/, ""); sub(/ +$/, ""); begin($0); next }
/^#/ { apply(); next }
/^$/ && !hunk { next }
name == "" { refuse(FNR, "before the first '=== <name>' only comments may stand"); exit }
/^@@/ { apply(); hunk = FNR; hunks++; olds = news = hunk_changes = blanks_at_end = 0; first_of_hunk = ""; next }
!hunk && /^(---|\+\+\+) / { next }                                        # what diff -u writes above
!hunk && /^(Mistake|Why|Read|Fails):/ { head[++heads] = $0; next }
!hunk && /^ +[^ ]/ && heads { head[++heads] = $0; next }
!hunk { refuse(FNR, "'" $0 "' is neither Mistake:, Why:, Read: or Fails: nor below @@"); next }
/^[-+ ]/ || /^$/ {
    sign = substr($0, 1, 1); line = substr($0, 2)
    if (sign != "+") old[++olds] = line
    if (sign != "-") new[++news] = line
    blanks_at_end = $0 == "" ? blanks_at_end + 1 : 0
    if (sign == "-" || sign == "+") hunk_changes++
    if (first_of_hunk == "" && sign != "+" && line ~ /[^ ]/) { first_of_hunk = line; sub(/^ +/, "", first_of_hunk) }
    next
}
{ refuse(FNR, "a line below @@ begins with a minus, a plus or a blank") }
END {
    finish()
    if (failed) exit 1
}
