#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# cmake/Together.cmake: several sources compiled as one see each other's includes and nothing else of each other, and an
# include that is added to one of them is known in the next build, without configuring anew.
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
set(sources ${PROJECT_SOURCE_DIR}/one.cpp ${PROJECT_SOURCE_DIR}/two.cpp ${PROJECT_SOURCE_DIR}/alone.cpp)
ansatz_together(program sources BYTES 10000 INCLUDE "#include <string>" AFTER "static const int of_@name@ = @name@::answer();\n")
add_executable(program ${sources})
target_include_directories(program PRIVATE ${PROJECT_SOURCE_DIR})
END
printf '#include <cstdio>\nnamespace { int mine() { return 1; } }\nint answer() { return std::printf("one %%d\\n", mine()); }\n' > "$tree/one.cpp"
printf '#include <cstdio>\nnamespace { int mine() { return 2; } }\nint answer() { return std::printf("two %%d\\n", mine()); }\n' > "$tree/two.cpp"
printf '// Compiled alone: it has main.\nint main() {}\n' > "$tree/alone.cpp"
build() { cmake --build "$tree/build" > "$ANSATZ_SCRATCH/log" 2>&1 || { cat "$ANSATZ_SCRATCH/log"; echo "FAILED: $1"; exit 1; }; }
expect() { [ "$2" = "$3" ] || { printf 'FAILED: %s: expected "%s", got "%s"\n' "$1" "$2" "$3"; exit 1; }; }

cmake -G Ninja -S "$tree" -B "$tree/build" -DTOGETHER="$project/cmake/Together.cmake" > "$ANSATZ_SCRATCH/log" 2>&1 || { cat "$ANSATZ_SCRATCH/log"; exit 1; }
build "sources of one name beside each other"
expect "both answer" $'one 1\ntwo 2' "$("$tree/build/program")"
expect "two are one" 2 "$(find "$tree/build/CMakeFiles/program.dir" -name '*.o' | wc -l)"
build "again"
expect "nothing is built twice" 1 "$(grep -c 'no work to do' "$ANSATZ_SCRATCH/log")"

configured=$(stat -c %Y "$tree/build/build.ninja")
sleep 1
sed -i '1i #include <complex>' "$tree/two.cpp"
sed -i 's/return 2;/return int(std::complex<double>(3, 4).imag());/' "$tree/two.cpp"
build "an include that is added"
expect "the changed one answers" $'one 1\ntwo 4' "$("$tree/build/program")"
expect "nothing was configured anew" "$configured" "$(stat -c %Y "$tree/build/build.ninja")"
