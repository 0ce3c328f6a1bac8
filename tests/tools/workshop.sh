#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# The tests of tools/workshop: each module has its own, tests/tools/workshop/test_<module>.py; and its types hold.
#
#   workshop.sh <the project's folder>     with ANSATZ_SCRATCH in the environment, as ctest sets it
set -euo pipefail
cd "$1"
if ! command -v python3 > /dev/null; then echo "skipped: no python3 (on Debian: apt install python3)"; exit 0; fi
mkdir -p "$ANSATZ_SCRATCH"

for module in tools/workshop/*.py; do
    name=$(basename "$module" .py)
    if [ "$name" != __init__ ] && [ ! -f "tests/tools/workshop/test_$name.py" ]; then
        echo "$module has no test; write tests/tools/workshop/test_$name.py"
        exit 1
    fi
done
# No test found is no test passed.
PYTHONPATH=tools PYTHONDONTWRITEBYTECODE=1 python3 -m unittest discover -s tests/tools/workshop 2>&1 | tee "$ANSATZ_SCRATCH/said"
grep -qE '^Ran [1-9][0-9]* tests?' "$ANSATZ_SCRATCH/said" || { echo "no test ran"; exit 1; }

if command -v mypy > /dev/null; then
    # Debian's oldest Python that is in use.
    MYPYPATH=tools mypy --strict --python-version 3.9 --cache-dir "$ANSATZ_SCRATCH/types" tools/workshop tests/tools/workshop
else
    echo "the types were not checked: no mypy (on Debian: apt install mypy)"
fi
