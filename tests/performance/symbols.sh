#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Looks at every compiler that is here.
#
# No symbol of a policy that nobody called for is in the object file of a world (hard case N5): neither its name nor that
# of the column it would have stored, although <ansatz/world.hpp> includes them all. With every compiler found, without
# optimisation (where every function that is used has a symbol) and with all of it.
#
# So that a search that finds nothing means something, the same search must find each policy in the object file of a
# world that has it.
#
# usage: symbols.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
export LC_ALL=C
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"
command -v nm > /dev/null || skip "no nm (on Debian: apt install binutils)"
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

# What is looked for: policies, and the columns of which a world without them knows nothing.
sought=(Drag FrameDrag QuadraticDrag StopBelow Rest Attraction AppliedForces Interpolation
    Verlet VelocityVerlet RungeKutta4 ImplicitEulerBy ExplicitEuler
    InverseMass PreviousPosition CoupledForce AppliedForce RestTime DrawnPosition decay)

program() {    # <its name> <the policies of a world> <properties of its bodies>, and so on for each of its worlds
    local name=$1 number=0
    shift
    {
        printf '#include <ansatz/world.hpp>\nusing namespace ansatz;\n'
        while [ $# -gt 0 ]; do
            number=$((number + 1))
            cat <<END
double run$number() {
    World world{$1};
    const auto body = world.add(position(metres(0, 10, 0)), velocity(metres_per_second(1, 0, 0))$2);
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
    return world.position(body).value()[1];
}
END
            shift 2
        done
    } > "$name.cpp"
}
program plain "SemiImplicitEuler{}, Gravity{}" ""
program with_forces "ExplicitEuler{}, Drag{}, FrameDrag{}, QuadraticDrag{}, StopBelow{}, Rest{}, AppliedForces{}, Attraction{}, Interpolation{}" \
    ", mass(1.0 * kilogram)"
program with_integrators "Verlet{}" "" "VelocityVerlet{}" "" "RungeKutta4{}" "" "ImplicitEuler{}" ""
controls=(with_forces with_integrators)

# How many symbols of an object file name the word, themselves or in their arguments. They are read once for all words.
count() { grep -cE "ansatz::(detail::)?$2\b" "$1.symbols" || true; }

object() {
    local object=$2-${1##*/}$3.o
    compile "$1" "$2.cpp" "$object" -c "$3" -DNDEBUG && nm -C "$object" > "$object.symbols"
}
mapfile -t compilers < <(found_compilers)
for compiler in "${compilers[@]}"; do
    for option in -O0 -O3; do start object "$compiler" plain "$option"; done
    for program in "${controls[@]}"; do start object "$compiler" "$program" -O0; done
done
all_done

faults=0
for compiler in "${compilers[@]##*/}"; do
    for option in -O0 -O3; do
        object=plain-$compiler$option.o
        all=$(nm "$object" | wc -l)
        [ "$all" -gt 20 ] || { echo "$object has only $all symbols"; exit 1; }
        [ "$option" != -O0 ] || [ "$(count "$object" Gravity)" -gt 0 ] || { echo "$object does not name Gravity, which it has"; exit 1; }
        there=
        for word in "${sought[@]}"; do
            [ "$(count "$object" "$word")" -eq 0 ] || there+=" $word($(count "$object" "$word"))"
        done
        printf '%-10s %s  World{SemiImplicitEuler, Gravity}: %4d symbols, of %d other policies and columns: %s\n' \
            "$compiler" "$option" "$all" ${#sought[@]} "${there:-none}"
        if [ -n "$there" ]; then faults=$((faults + 1)); fi
    done
    missing=
    for word in "${sought[@]}"; do
        found=0
        for program in "${controls[@]}"; do
            found=$((found + $(count "$program-$compiler-O0.o" "$word")))
        done
        if [ $found -eq 0 ]; then missing+=" $word"; fi
    done
    printf '%-10s -O0  worlds that have them: %d of %d found by the same search%s\n' "$compiler" \
        $((${#sought[@]} - $(wc -w <<< "$missing"))) ${#sought[@]} "${missing:+; not found:$missing}"
    if [ -n "$missing" ]; then faults=$((faults + 1)); fi
done
if [ $faults -gt 0 ]; then
    echo "nm -C shows the symbols; the object files are in $scratch"
    exit 1
fi
