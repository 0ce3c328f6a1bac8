# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0

# The program that runs a section: its own, or that of all sections of its chapter (chapters/CMakeLists.txt), whichever is newer.
# Either takes the section's number as its first word; section_program <folder of the build> <its source>, e.g.
# chapters/7-water/7.1-height_map.cpp
section_program() {
    local name=${2##*/} folder=${2%/*} own all
    own=$1/chapters/section_${name%%-*}
    folder=${folder##*/}
    all=$1/chapters/sections_${folder#*-}
    if [ -x "$all" ] && { [ ! -x "$own" ] || [ "$all" -nt "$own" ]; } && "$all" --has "${name%%-*}"; then echo "$all"
    elif [ -x "$own" ]; then echo "$own"
    fi
}

# Whether a section's picture shows times that it measured, which are never the same twice: kept as it was once, and not compared.
shows_measured_times() { [ "${1##*/}" = 7.svg ]; }
