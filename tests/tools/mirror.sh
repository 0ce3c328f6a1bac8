# SPDX-License-Identifier: BSL-1.0
# tools/mirror finds nothing in a clean tree; and each fault, put into that tree alone, is the one that it names.
# What switches a test off is written in pieces here, so that nobody who searches for it finds this file.
set -euo pipefail
if ! command -v python3 > /dev/null; then echo "skipped: no python3 (on Debian: apt install python3)"; exit 0; fi

mirror=$1/tools/mirror
tree=$ANSATZ_SCRATCH/tree
spdx='// SPDX-License-Identifier: BSL-1.0'
checked=0

write() {    # a file, and its lines
    mkdir -p "$(dirname "$tree/$1")"
    printf '%s\n' "${@:2}" > "$tree/$1"
}

clean_tree() {
    rm -rf "$tree"
    write include/ansatz/world.hpp "$spdx" '#include <ansatz/world/step.hpp>' '#include <ansatz/motion.hpp>'
    write include/ansatz/world/step.hpp "$spdx"
    write include/ansatz/motion.hpp "$spdx" '#include <ansatz/motion/explicit_euler.hpp>'
    write include/ansatz/motion/explicit_euler.hpp "$spdx" '#include <ansatz/motion/stage.hpp>'
    write include/ansatz/motion/stage.hpp "$spdx"
    write include/ansatz/motion/print.hpp "$spdx" '// not in the umbrella: it needs streams'
    write include/ansatz/water.hpp "$spdx" '#include <ansatz/water/surface/grid.hpp>'
    write include/ansatz/water/surface/grid.hpp "$spdx"
    write tests/world/step.cpp "$spdx" 'TEST_CASE("a step", "[world]") {}'
    write tests/motion/explicit_euler.cpp "$spdx" '#include <ansatz/motion/stage.hpp>' 'SKIP("no gnuplot");'
    write tests/motion/streams.cpp "$spdx" '#include <ansatz/motion/print.hpp>'
    write tests/water/grid.cpp "$spdx"
    write chapters/1-motion/1.6.1-explicit_euler.cpp "$spdx" 'World w{ExplicitEuler{}};'
    write docs/world.md 'All of it happens in `world/step.hpp`.' '`motion/stage.hpp` and `Print` serve it.'
    write tools/draw '#!/usr/bin/env bash' "#${spdx#//}"
    write CMakeLists.txt "#${spdx#//}"
}

finds() {    # what mirror must say, alone, of the tree as it is now
    local said
    if said=$(bash "$mirror" "$tree"); then
        echo "mirror is content, where it should say: $1"; exit 1
    fi
    if [ "$(sed '$d' <<< "$said" | sed 's/ (.*//')" != "$1" ]; then
        printf 'mirror should say\n%s\nbut it says\n%s\n' "$1" "$said"; exit 1
    fi
    checked=$((checked + 1))
    clean_tree
}

clean_tree
bash "$mirror" "$tree"

rm "$tree/tests/world/step.cpp"
finds 'no test: include/ansatz/world/step.hpp'
rm "$tree/tests/motion/streams.cpp"
finds 'no test: include/ansatz/motion/print.hpp'

write chapters/1-motion/1.6.1-explicit_euler.cpp "$spdx" 'World w{SemiExplicitEulerLike{}};'
finds 'not mentioned: include/ansatz/motion/explicit_euler.hpp'
rm -r "$tree/docs" "$tree/chapters"
finds 'not mentioned: include/ansatz/world/step.hpp'
mkdir "$tree/chapters/7-water"
finds 'not mentioned: include/ansatz/water/surface/grid.hpp'

write include/ansatz/water.hpp "$spdx" '#include <ansatz/water/surface.hpp>'
finds 'not in its umbrella: include/ansatz/water/surface/grid.hpp'
write include/ansatz/motion/print.hpp "$spdx" '// not in the umbrella:'
finds 'not in its umbrella: include/ansatz/motion/print.hpp'
rm "$tree/include/ansatz/water.hpp"
finds 'no umbrella: include/ansatz/water/'

for tag in '.' '.slow' '!''mayfail' '!''shouldfail' '!''hide'; do
    write tests/water/grid.cpp "$spdx" "TEST_CASE(\"a grid\", \"[water][$tag]\") {}"
    finds 'switched off: tests/water/grid.cpp:2'
done
for line in '#''if 0' '#  ''if false' 'SKIP''();' 'SKIP''("");' 'TEST(Grid, DISABLE''D_holds) {}'; do
    write chapters/1-motion/1.1-laws.cpp "$spdx" '' "    $line"
    finds 'switched off: chapters/1-motion/1.1-laws.cpp:3'
done
for property in DISABLE''D WILL_''FAIL; do
    write tests/CMakeLists.txt "#${spdx#//}" "set_tests_properties(grid PROPERTIES $property ON)"
    finds 'switched off: tests/CMakeLists.txt:2'
done

write include/ansatz/motion/stage.hpp '#pragma once' "$spdx"
finds 'no SPDX line: include/ansatz/motion/stage.hpp'
for source in tests/water/grid.cpp chapters/1-motion/1.1-laws.cpp cmake/Install.cmake CMakeLists.txt; do
    write "$source" 'nothing'
    finds "no SPDX line: $source"
done
write tools/draw '#!/usr/bin/env bash'
finds 'no SPDX line: tools/draw'

write include/ansatz/motion/stage.hpp "$spdx" $(seq 400)
finds 'too long: include/ansatz/motion/stage.hpp'

write tools/notes 'no program, so nothing is asked of it'
bash "$mirror" "$tree" > /dev/null
echo "$checked faults, each named alone"
