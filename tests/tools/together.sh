#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# cmake/Together.cmake: several sources compiled as one see each other's includes and nothing else of each other, and an
# include that is added to one of them is known in the next build, without configuring anew. One that asks where it lies is
# compiled alone.
#
#   together.sh <the project's folder>     with ANSATZ_SCRATCH in the environment, as ctest sets it
set -euo pipefail
project=${1:?the project folder}
tree=${ANSATZ_SCRATCH:?a folder for this test}/a\ project
rm -rf "$ANSATZ_SCRATCH" && mkdir -p "$tree"
for tool in cmake ninja; do
    if ! command -v "$tool" > /dev/null; then echo "skipped: no $tool (on Debian: apt install cmake ninja-build)"; exit; fi
done

cat > "$tree/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(together LANGUAGES CXX)
include(${TOGETHER})
set(sources ${PROJECT_SOURCE_DIR}/one.cpp ${PROJECT_SOURCE_DIR}/two.cpp ${PROJECT_SOURCE_DIR}/alone.cpp ${PROJECT_SOURCE_DIR}/place.cpp)
ansatz_together(program sources BYTES 10000 INCLUDE "#include <string>" AFTER "static const int of_@name@ = @name@::answer();\n")
add_executable(program ${sources})
target_include_directories(program PRIVATE ${PROJECT_SOURCE_DIR})
END
printf '#include <cstdio>\nnamespace { int mine() { return 1; } }\nint answer() { return std::printf("one %%d\\n", mine()); }\n' > "$tree/one.cpp"
printf '#include <cstdio>\nnamespace { int mine() { return 2; } }\nint answer() { return std::printf("two %%d\\n", mine()); }\n' > "$tree/two.cpp"
printf '// Compiled alone: it has main.\nint main() {}\n' > "$tree/alone.cpp"
printf '#include <cstdio>\nextern const char* const place;\nconst char* const place = __FILE__;\n' > "$tree/place.cpp"
build() { cmake --build "$tree/build" > "$ANSATZ_SCRATCH/log" 2>&1 || { cat "$ANSATZ_SCRATCH/log"; echo "FAILED: $1"; exit 1; }; }
expect() { [ "$2" = "$3" ] || { printf 'FAILED: %s: expected "%s", got "%s"\n' "$1" "$2" "$3"; exit 1; }; }

cmake -G Ninja -S "$tree" -B "$tree/build" -DTOGETHER="$project/cmake/Together.cmake" > "$ANSATZ_SCRATCH/log" 2>&1 || { cat "$ANSATZ_SCRATCH/log"; exit 1; }
build "sources of one name beside each other"
expect "both answer" $'one 1\ntwo 2' "$("$tree/build/program")"
expect "two are one, and two are alone" 3 "$(find "$tree/build/CMakeFiles/program.dir" -name '*.o' | wc -l)"
build "again"
expect "nothing is built twice" 1 "$(grep -c 'no work to do' "$ANSATZ_SCRATCH/log")"

configured=$(stat -c %Y "$tree/build/build.ninja")
sleep 1
sed -i '1i #include <complex>' "$tree/two.cpp"
sed -i 's/return 2;/return int(std::complex<double>(3, 4).imag());/' "$tree/two.cpp"
build "an include that is added"
expect "the changed one answers" $'one 1\ntwo 4' "$("$tree/build/program")"
expect "nothing was configured anew" "$configured" "$(stat -c %Y "$tree/build/build.ninja")"

# A group that holds a file which compiles like a larger one is cut: each file is compiled once, as before, and no other group is
# another for it, so that what was compiled of those is found in the ccache.
tree=$ANSATZ_SCRATCH/groups
mkdir -p "$tree"
cat > "$tree/CMakeLists.txt" <<'END_OF_PROJECT'
cmake_minimum_required(VERSION 3.25)
project(groups LANGUAGES NONE)
include(${TOGETHER})
file(GLOB sources ${PROJECT_SOURCE_DIR}/*.cpp)
ansatz_together(of sources BYTES 1000)
END_OF_PROJECT
for name in a b c d e f; do printf '%300s\n' "// $name" > "$tree/$name.cpp"; done
groups() {    # a line for each group, with its files
    rm -rf "$tree/build"
    cmake -G Ninja -S "$tree" -B "$tree/build" -DTOGETHER="$project/cmake/Together.cmake" > "$ANSATZ_SCRATCH/log" 2>&1 || { cat "$ANSATZ_SCRATCH/log"; exit 1; }
    (cd "$tree/build/together" && for file in *[0-9].cpp; do echo "$file: $(sed -n 's/^#include "\(.\)\.cpp"$/\1/p' "$file" | paste -s -d ' ')"; done)
}
expect "by their size" $'of_1.cpp: a b c\nof_2.cpp: d e f' "$(groups)"
cp "$tree/build/together/of_2.cpp" "$ANSATZ_SCRATCH/before"
# Together with this line the first three have more bytes than a group holds; it does not count.
printf '// Compiles like 1 kB: it is said for this test, at some length, so that the line by itself would push a file out of its group.\n%300s\n' "// b" > "$tree/b.cpp"
expect "the heavy one is cut" $'of_1.cpp: a\nof_1_2.cpp: b c\nof_2.cpp: d e f' "$(groups)"
cmp "$tree/build/together/of_2.cpp" "$ANSATZ_SCRATCH/before"
printf '// Compiles like 9 kB: it fills several parts by itself.\n%300s\n' "// b" > "$tree/b.cpp"
expect "no part is empty" $'of_1.cpp: a\nof_1_2.cpp: b\nof_1_3.cpp: c\nof_2.cpp: d e f' "$(groups)"
