# SPDX-License-Identifier: BSL-1.0
#
# Where the time of a build and of its tests went, by kind: lines of kind, number, seconds, the dearest and its seconds.
# Seconds are added up over all jobs, and are wall clock: on two cores that are busy the build takes half as long.
#
#   awk -v since=<seconds since 1970> -f times.awk <build>/.ninja_log <build>/Testing/Temporary/LastTest.log
#
# What ninja built before `since` is left out; a file that is not there is nothing.

function count(kind, name, seconds) {
    number[kind]++
    sum[kind] += seconds
    if (!(kind in most) || seconds > most[kind]) { most[kind] = seconds; dearest[kind] = name }
}

# .ninja_log: begin and end in ms since that build began, when the output was written in ns since 1970, the output.
FILENAME ~ /\.ninja_log$/ {
    if ($1 !~ /^[0-9]+$/ || $3 / 1e9 < since) next
    name = $4
    if (sub(/^tests\/CMakeFiles\/headers_alone\.dir\/headers_alone\//, "", name)) kind = "build: headers alone"
    else if (match(name, /CMakeFiles\/test_[a-z_]+\.dir\//)) {
        kind = substr(name, RSTART + 16, RLENGTH - 21)
        name = substr(name, RSTART + RLENGTH)
        kind = "build: tests of " kind
    }
    else if (name ~ /CMakeFiles\/(static|archetypes)_tests\.dir/) kind = "build: static tests"
    else if (name ~ /section_/) kind = "build: sections"
    else if (name ~ /costs_/) kind = "build: what it costs"
    else if (name ~ /exercise/) kind = "build: exercises"
    else kind = "build: other"
    sub(/\.cpp\.o$/, ".cpp", name)
    # Several outputs of one command have one begin and end.
    if (!(($1 SUBSEP $2 SUBSEP $3) in seen)) count(kind, name, ($2 - $1) / 1000)
    seen[$1, $2, $3]
    next
}

# LastTest.log: "3/784 Testing: name", and later "Test time =   0.05 sec".
/^[0-9]+\/[0-9]+ Testing: / { name = $0; sub(/^[0-9]+\/[0-9]+ Testing: /, "", name); next }
/^Test time = / {
    kind = name
    sub(/\..*/, "", kind)
    if (kind == "must_not_compile") {
        compiler = name
        sub(/.*\./, "", compiler)
        kind = "test: must not compile, " compiler
    }
    else kind = "test: " kind
    count(kind, name, $4)
}

END { for (kind in sum) printf "%s\t%d\t%.1f\t%s\t%.1f\n", kind, number[kind], sum[kind], dearest[kind], most[kind] }
