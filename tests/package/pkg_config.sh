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

# shellcheck disable=SC2086  (the flags are words)
for program in engine pool; do
    "$compiler" -std=c++20 $flags "$here/$program.cpp" -o "$folder/${program}_of_pkg_config"
    "$folder/${program}_of_pkg_config"
done
