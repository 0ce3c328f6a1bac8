#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# No effect, no instruction, where bodies collide:
#
#   - a world without collisions is that of a program which never heard of them: the same source with and without
#     #include <ansatz/collision.hpp> gives the same instructions and literals, sections of the same length, and no symbol about
#     collisions
#   - a world that collides without friction, layers or sensors of its own names neither of the policies and columns that it
#     was not asked for: no symbol of them, without optimisation, where every function that is used has one
#   - a world with `Impulse<>` has fewer bytes of code than one with `Impulse<Friction>`
#
# So that this means something, the same searches must find these things in programs that have them.
#
# usage: absent.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
export LC_ALL=C
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
if ! command -v nm > /dev/null || ! command -v objdump > /dev/null; then
    echo "skipped: no nm or objdump (on Debian: apt install binutils)"
    exit
fi
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

plain() {    # <more includes, behind the world's: the order of functions in the file follows that of the headers>
    cat << END
#include <ansatz/world.hpp>
$1
using namespace ansatz;
unsigned long long run() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}, Rest{}, Keep<InverseMass>{}};
    const auto body = world.add(position(metres(0, 10, 0)), velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
    world.apply_impulse(body, newton_seconds(1, 2, 3));
    return world.hash() + sizeof(world);
}
END
}
colliding() {    # <a name> <its policies> <more of a body>
    cat << END
unsigned long long $1() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, $2};
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < 3; ++i) world.add(Sphere{0.5 * metre}, position(metres(0.1 * i, 1 + i, 0)), mass(1.0 * kilogram)$3);
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
    return world.hash() + sizeof(world);
}
END
}
includes='#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>
using namespace ansatz;'
eigen=$(pkg-config --cflags eigen3 2> /dev/null || echo -I/usr/include/eigen3)
object() {    # <name> <optimisation>
    # shellcheck disable=SC2086
    "${CXX:-g++}" -std=c++20 "$2" -DNDEBUG -I"$project/include" $eigen -c "$1.cpp" -o "$1$2.o"
}
names() { nm -C "$1" | grep -cE "ansatz::(detail::)?($2)\b" || true; }

# ---------------------------------------------------------------- a world without collisions
plain '' > without.cpp
plain '#include <ansatz/collision.hpp>' > unused.cpp
{ echo "$includes"; colliding run 'Impulse<>{}' ''; } > used.cpp
about='Collisions|Contact\w*|Touch|Sphere|Plane|Box|Boxes|Shapes\w*|Narrowphase|BoundingBoxes|Impulse|Projection|Penalty\w*|Soft\w*|Restitution|Friction|Layers|Islands|collide\w*'
for name in without unused; do
    object "$name" -O2
    # The instructions of every function, without their operands, sorted by the functions' names, how long each section is, and
    # the literals: the order in which a compiler writes functions follows from that in which the headers mention them, and
    # from that order addresses, and with which of the functions that share a literal it lies.
    objdump -d --no-show-raw-insn "$name-O2.o" |
        awk '/^[0-9a-f]+ <.*>:$/ { printf "\n%s", $2; next } /^ +[0-9a-f]+:/ { printf " %s", $2 }' | grep '^<' | sort > "$name.bytes"
    objdump -h "$name-O2.o" | awk '$2 ~ /^\.(text|data|bss|tdata|init_array)/ { print $2, $3 }' | sort >> "$name.bytes"
    objdump -s "$name-O2.o" | awk '
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
        END { cut_at_zeros(hex) }' | sort -u > "$name.literals"
done
object used -O0
[ "$(names used-O0.o "$about")" -gt 100 ] || { echo "the search finds no collisions where there are some"; exit 1; }
[ "$(names unused-O2.o "$about")" -eq 0 ] || { echo "symbols about collisions in a world without them:"; nm -C unused-O2.o | grep -E "ansatz::(detail::)?($about)\b"; exit 1; }
[ "$(wc -l < without.literals)" -gt 20 ] || { echo "no literals were found in a world's object file"; exit 1; }
cmp without.literals unused.literals && cmp without.bytes unused.bytes || { echo "including collision.hpp changed the machine code of a world without collisions"; exit 1; }

# ---------------------------------------------------------------- a world that collides, without what nobody asked for
declare -A asked=(
    [Friction]="Impulse<Friction>{}|, friction(0.5)" ["ContactPushes<.*>::rub"]="Impulse<Friction>{}|, friction(0.5)" [Layers]="Impulse<>{}, Layers{}|, member_of(1)"
    [Member]="Impulse<>{}, Layers{}|, member_of(1)" [Ignored]="Impulse<>{}, Layers{}|, ignores(2)" [CoupledForce]="Penalty{}|"
    [PenaltyContacts]="Penalty{}|" [Projection]="Impulse<>{}, Projection{}|" [SoftContacts]="SoftSubsteps<>{}|" [RestTime]="Impulse<>{}, Rest{}|"
    [UniformGrid]="Impulse<>{}|" [Box]="Impulse<>{}|" [SleepScratch]="Impulse<>{}, Rest{}|"
)
{
    echo "$includes"
    number=0
    for given in "${asked[@]}"; do
        number=$((number + 1))
        colliding "run$number" "${given%%|*}" "${given#*|}"
    done
    colliding grid 'Impulse<>{}' '' | sed 's/BoundingBoxes{}/UniformGrid<>{}/; s/Sphere, Plane>/Sphere, Plane, Box>/'
} > all.cpp
object all -O0
there=
for word in "${!asked[@]}"; do
    [ "$(names all-O0.o "$word")" -gt 0 ] || { echo "the search finds no $word where there is one"; exit 1; }
    [ "$(names used-O0.o "$word")" -eq 0 ] || there+=" $word($(names used-O0.o "$word"))"
done
[ -z "$there" ] || { echo "a world with Impulse<> alone has symbols of what nobody asked for:$there"; exit 1; }

# ---------------------------------------------------------------- friction is code where it was asked for
bytes_of() {    # <object>: how long all of its functions are
    local sum=0 size
    while read -r _ size _; do sum=$((sum + 16#$size)); done < <(nm -S --defined-only "$1" | awk 'NF == 4 && $3 ~ /^[tTW]$/')
    echo $sum
}
{ echo "$includes"; colliding rubbing 'Impulse<Friction>{}' ', friction(0.5)'; } > rubbing.cpp
object rubbing -O0
without=$(bytes_of used-O0.o) with=$(bytes_of rubbing-O0.o)
[ "$without" -gt 10000 ] || { echo "no functions of a world with Impulse<> were found"; exit 1; }
[ "$without" -lt "$with" ] || { echo "a world without friction has $without bytes of code, one with it $with"; exit 1; }
printf 'the same instructions and sizes in %s functions and sections without collisions; of %s things not asked for no symbol; %s bytes of code without friction, %s with it\n' \
    "$(wc -l < without.bytes)" "${#asked[@]}" "$without" "$with"
