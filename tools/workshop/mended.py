# SPDX-License-Identifier: BSL-1.0
"""The mended forms of mistakes that must not compile, many in one run of a compiler.

    mended.py <folder> <mistake.cpp>... -- <compiler> <flags>...

Each is put into a namespace of its own, with the includes of all before them, and compiled without ANSATZ_MISTAKE. If that is clean,
so is each of them, and <folder>/<name>.mended says so; if it is not, it is tried with half as many. One that is not clean by itself
here gets no such file: check.cmake then compiles it alone, as it does when nobody has called this program, and that verdict counts.

It prints how many were found clean in how many runs, and the names of the others.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

TOGETHER = 48    # so many at once: a minute's work would be lost when one of them is not clean
INCLUDE = re.compile(r"^#include .*\n", re.MULTILINE)
# In a namespace main is a function like others, which must not end without a return.
MAIN = re.compile(r"(^int main\(\) \{\n(?:.*\n)*?)\}$", re.MULTILINE)


def unit(files: list[Path]) -> str:
    """One source with all of these. What the compiler says of it, it says of their own lines."""
    texts = [file.read_text(encoding="utf-8") for file in files]
    includes = dict.fromkeys(line for text in texts for line in INCLUDE.findall(text))
    parts = list(includes)
    for number, (file, text) in enumerate(zip(files, texts)):
        code = MAIN.sub(r"\1return 0; }", INCLUDE.sub("\n", text))
        parts.append(f"namespace mended_{number} {{\n#line 1 \"{file}\"\n{code}\n}}\n")
    return "".join(parts)


def clean(files: list[Path], source: Path, command: list[str]) -> bool:
    """Whether they compile together without a warning."""
    source.write_text(unit(files), encoding="utf-8")
    run = subprocess.run([*command, "-Wall", "-Wextra", "-Werror", str(source)], capture_output=True, check=False)
    return run.returncode == 0


def find_clean(files: list[Path], source: Path, command: list[str]) -> tuple[list[Path], int]:
    """Those that are clean, and the number of runs that it took."""
    if not files:
        return [], 0
    if clean(files, source, command):
        return files, 1
    if len(files) == 1:
        return [], 1
    half = len(files) // 2
    first, runs = find_clean(files[:half], source, command)
    second, more = find_clean(files[half:], source, command)
    return first + second, 1 + runs + more


def main(arguments: list[str]) -> int:
    """As the module's description says."""
    if "--" not in arguments[1:-1]:
        print(__doc__, file=sys.stderr)
        return 2
    at = arguments.index("--")
    folder, command = Path(arguments[0]), arguments[at + 1:]
    files = [Path(name) for name in arguments[1:at]]
    folder.mkdir(parents=True, exist_ok=True)
    found: list[Path] = []
    runs = 0
    for begin in range(0, len(files), TOGETHER):
        some, needed = find_clean(files[begin:begin + TOGETHER], folder / "mended.cpp", command)
        found += some
        runs += needed
    for file in found:
        (folder / f"{file.stem}.mended").touch()
    alone = " ".join(sorted({file.stem for file in files} - {file.stem for file in found}))
    print(f"{len(found)} of {len(files)} mended forms are clean, found in {runs} runs" + (f"; left: {alone}" if alone else ""))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
