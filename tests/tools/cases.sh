#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# The list of hard cases has no hole: each of its rows has a test or a reason, and no test names a row that is not there.
# That this is found out is tried on a copy, with a fault of each kind.
#
#   cases.sh <the project's folder>     with ANSATZ_SCRATCH in the environment, as ctest sets it
set -euo pipefail
cd "$1"
if ! command -v python3 > /dev/null; then echo "skipped: no python3 (on Debian: apt install python3)"; exit 0; fi
export PYTHONDONTWRITEBYTECODE=1

if ! python3 tools/workshop/cases.py check; then
    echo "tests/hard_cases.txt says in its first lines how a row is kept"
    exit 1
fi

tree=$ANSATZ_SCRATCH/tree
planted=0
# finds <what it must say> <a file> <a line to add to it>
finds() {
    local said
    rm -rf "$tree"
    mkdir -p "$tree/tools"
    cp -R tools/workshop "$tree/tools/"
    (find tests -name '*.cpp' -o -name '*.sh'; echo tests/hard_cases.txt) | tar -cf - -T - | tar -xf - -C "$tree"
    printf '%s\n' "$3" >> "$tree/$2"
    if said=$(cd "$tree" && python3 tools/workshop/cases.py check 2>&1); then
        echo "The check is content, where it should say: $1"; exit 1
    fi
    if [[ $said != *"$1"* ]] || [ "$(wc -l <<< "$said")" -ne 1 ]; then
        printf 'The check should say, alone,\n    %s\nbut it says\n%s\n' "$1" "$said"; exit 1
    fi
    planted=$((planted + 1))
}
# The names of rows are put together, so that nobody takes this file for a test of theirs.
finds "T99 has neither a test nor a reason" tests/hard_cases.txt 'T99 A row that nobody tests.'
finds "there is no row C""99 in tests/hard_cases.txt" tests/collision/contacts.cpp 'TEST_CASE("C''99: a row that is not there") {}'
finds "there is no row C""98 in tests/hard_cases.txt" tests/collision/contacts.cpp 'TEST_CASE("by its tag", "[collision][C''98]") {}'
finds "T99 holds by T98" tests/hard_cases.txt $'T99 By another.\n    by: T98'
finds "C28 has a test, and the list says 'does not apply yet'" tests/collision/contacts.cpp 'TEST_CASE("C28: convex shapes") {}'
echo "$planted faults, each found"
