# SPDX-License-Identifier: BSL-1.0
# A user without CMake: pkg_config.sh <compiler> <prefix> <folder for the program>
set -euo pipefail
compiler=$1 prefix=$2 folder=$3
here=$(dirname "${BASH_SOURCE[0]}")

export PKG_CONFIG_PATH=$prefix/share/pkgconfig
flags=$(pkg-config --cflags ansatz)
for flag in -ffp-contract=off -fno-math-errno; do
    [[ " $flags " == *" $flag "* ]] || { echo "ansatz.pc has lost $flag: $flags"; exit 1; }
done

# ccache, where it is there, keeps objects and not programs: so the two steps.
IFS='|' read -ra launcher <<< "${ANSATZ_LAUNCHER:-}"
# shellcheck disable=SC2086  (the flags are words)
for program in engine pool; do
    built=$folder/${program}_of_pkg_config
    "${launcher[@]}" "$compiler" -std=c++20 $flags -MD -c "$here/$program.cpp" -o "$built.o"
    "$compiler" -std=c++20 $flags "$built.o" -o "$built"
    "$folder/${program}_of_pkg_config"
done
