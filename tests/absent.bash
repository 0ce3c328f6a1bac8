# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
# What scripts share that show that a world pays nothing for what is not in it; they read it with `source`, which sets `project`
# and goes to ANSATZ_SCRATCH. A search that finds nothing must find something in a program that has it.
set -euo pipefail
export LC_ALL=C
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}" && pwd)
if ! command -v nm > /dev/null || ! command -v objdump > /dev/null; then
    echo "skipped: no nm or objdump (on Debian: apt install binutils)"
    exit
fi
# shellcheck source=/dev/null
source "$project/tests/programs.bash"    # launcher
mkdir -p "${ANSATZ_SCRATCH:=$(mktemp -d)}"
cd "$ANSATZ_SCRATCH"
eigen=$(pkg-config --cflags eigen3 2> /dev/null || echo -I/usr/include/eigen3)

object() {    # <name> <optimisation>
    # shellcheck disable=SC2086,SC2154
    "${launcher[@]}" "${CXX:-g++}" -std=c++20 -MD "$2" -DNDEBUG -I"$project/include" $eigen -c "$1.cpp" -o "$1$2.o"
    nm -C "$1$2.o" > "$1$2.o.symbols"    # once for all names that are looked for
}
names() { grep -cE "ansatz::(\w+::)?($2)\b" "$1.symbols" || true; }

# What an object does, as text, into <name>.bytes and <name>.literals: the instructions of every function, without their operands,
# sorted by the functions' names, how long each section is, and the literals. The order in which a compiler writes functions
# follows from that in which the headers mention them, and from that order addresses, and with which of the functions that share
# a literal it lies.
look() {    # <name> <optimisation>
    objdump -d --no-show-raw-insn "$1$2.o" |
        awk '/^[0-9a-f]+ <.*>:$/ { printf "\n%s", $2; next } /^ +[0-9a-f]+:/ { printf " %s", $2 }' | grep '^<' | sort > "$1.bytes"
    objdump -h "$1$2.o" | awk '$2 ~ /^\.(text|data|bss|tdata|init_array)/ { print $2, $3 }' | sort >> "$1.bytes"
    objdump -s "$1$2.o" | awk '
        function cut_at_zeros(hex,    i, byte, literal) {
            for (i = 1; i < length(hex); i += 2) {
                byte = substr(hex, i, 2)
                if (byte != "00") literal = literal byte
                else { print literal; literal = "" }
            }
            print literal
        }
        /^Contents of section/ { cut_at_zeros(hex); hex = ""; within = $4 ~ /^\.rodata/; next }
        within && match($0, /^ [0-9a-f]+ /) { line = substr($0, RLENGTH + 1, 35); gsub(/ /, "", line); hex = hex line }
        END { cut_at_zeros(hex) }' | sort -u > "$1.literals"
}

# A world of bodies that fall, and what it comes to.
plain() {    # <includes behind the world's: the order of functions in the file follows that of the headers> <policies> <more>
    cat << END
#include <ansatz/world.hpp>
$1
using namespace ansatz;
unsigned long long run() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}, Rest{}, Keep<InverseMass>{}${2:-}};
    const auto body = world.add(position(metres(0, 10, 0)), velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    ${3:-}
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
    world.apply_impulse(body, newton_seconds(1, 2, 3));
    return world.hash() + sizeof(world);
}
END
}

# A world without what a header brings is that of a program which never heard of it. used-O0.o is a program that has it.
never_heard_of() {    # <header> <names that are about it, a regular expression> [<functions that are not compared>]
    plain '' > without.cpp
    plain "#include <ansatz/$1.hpp>" > unused.cpp
    for name in without unused; do
        object "$name" -O2
        look "$name" -O2
        grep -v -E "${3:-^$}" "$name.bytes" > "$name.compared"
    done
    [ "$(names used-O0.o "$2")" -gt 100 ] || { echo "the search finds nothing about $1 where there is some"; exit 1; }
    [ "$(names unused-O2.o "$2")" -eq 0 ] || { echo "symbols about $1 in a world without:"; nm -C unused-O2.o | grep -E "ansatz::(\w+::)?($2)\b"; exit 1; }
    [ "$(wc -l < without.literals)" -gt 20 ] || { echo "no literals were found in a world's object file"; exit 1; }
    cmp without.literals unused.literals && cmp without.compared unused.compared ||
        { echo "including $1.hpp changed the machine code of a world without it"; exit 1; }
}
