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
# shellcheck source=/dev/null
. "$(dirname "${BASH_SOURCE[0]}")/../absent.bash" "$@"

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

# ---------------------------------------------------------------- a world without collisions
{ echo "$includes"; colliding run 'Impulse<>{}' ''; } > used.cpp
object used -O0
about='Collisions|Contact\w*|Touch|Sphere|Plane|Box|Boxes|Shapes\w*|Narrowphase|BoundingBoxes|Impulse|Projection|Penalty\w*|Soft\w*|Restitution|Friction|Layers|Islands|collide\w*'
never_heard_of collision "$about"

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
