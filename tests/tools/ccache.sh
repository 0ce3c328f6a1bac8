#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# cmake/Ccache.cmake: two checkouts share what one has compiled, and each sees changes of its own files, whatever the
# name of the folder is.
#
#   ccache.sh <the project's folder>     with ANSATZ_SCRATCH in the environment, as ctest sets it
set -euo pipefail
project=${1:?the project folder}
scratch=${ANSATZ_SCRATCH:?a folder for this test}
for tool in ccache cmake ninja; do
    if ! command -v "$tool" > /dev/null; then echo "skipped: no $tool (on Debian: apt install ccache cmake ninja-build)"; exit; fi
done
rm -rf "$scratch" && mkdir -p "$scratch"
export CCACHE_DIR=$scratch/cache
unset CCACHE_DISABLE CXXFLAGS

said() { cmake --build "$1/build" > "$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }; "$1/build/program"; }
expect() { # <what> <wanted> <got>
    [ "$2" = "$3" ] || { echo "FAILED: $1: expected \"$2\", got \"$3\""; exit 1; }
}
# How often ccache found what it was asked for.
hits() { ccache --print-stats | awk '$1 == "direct_cache_hit" || $1 == "preprocessed_cache_hit" { n += $2 } END { print n + 0 }'; }

for name in plain "with a space" 'with#' "with'"; do
    for checkout in one two; do
        tree="$scratch/$checkout/$name"
        mkdir -p "$tree/include"
        cat > "$tree/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(checkout LANGUAGES CXX)
include(${CCACHE_CMAKE})
add_executable(program program.cpp)
target_include_directories(program PRIVATE include)
target_compile_options(program PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
target_precompile_headers(program PRIVATE <cstdio> [["precompiled.hpp"]])
END
        printf '#pragma once\n#include <string_view>\n' > "$tree/include/precompiled.hpp"
        printf '#include "said.hpp"\n#include <cstdio>\nint main() { std::puts(said); }\n' > "$tree/program.cpp"
        printf '#pragma once\ninline const char* said = "%s";\n' "$name" > "$tree/include/said.hpp"
        cmake -G Ninja -S "$tree" -B "$tree/build" -DCMAKE_BUILD_TYPE=Release -DCCACHE_CMAKE="$project/cmake/Ccache.cmake" > "$scratch/log" 2>&1 \
            || { cat "$scratch/log"; exit 1; }
        before=$(hits)
        expect "in $tree" "$name" "$(said "$tree")"
        if [ "$checkout $name" = "two plain" ]; then expect "the second checkout finds what the first compiled, its precompiled header too" $((before + 2)) "$(hits)"; fi
        printf '#pragma once\ninline const char* said = "changed in %s";\n' "$checkout" > "$tree/include/said.hpp"
        expect "after a change of a header in $tree" "changed in $checkout" "$(said "$tree")"
        printf '#pragma once\ninline const char* said = "%s";\n' "$name" > "$tree/include/said.hpp"
        expect "after the change back in $tree" "$name" "$(said "$tree")"
    done
done
