# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# What the course needs, whether it is there, and how to get it. Things are recognised by what they
# are (a command, a header, a file), not by the package system, so that every system can be asked.

# name | how it is recognised | Debian's package | needed, wanted or docs | what for
# What is for the docs only ./workbook docs asks for.
NEEDS='C++ compiler|command c++ g++ clang++|g++|needed|to compile everything
CMake|command cmake|cmake|needed|to configure the build
make or ninja|command ninja make|make|needed|to run the build
Boost|header boost/units/quantity.hpp|libboost-dev|needed|units, graphs, odeint, multiprecision
Eigen|header eigen3/Eigen/Core Eigen/Core|libeigen3-dev|needed|vectors and sparse solvers
Catch2|header catch2/catch.hpp catch2/catch_all.hpp|catch2|needed|the tests
nlohmann-json|header nlohmann/json.hpp|nlohmann-json3-dev|needed|cost tables as JSON
pugixml|header pugixml.hpp|libpugixml-dev|needed|state machines in files
Google Benchmark|header benchmark/benchmark.h|libbenchmark-dev|needed|what accuracy costs
Python 3|command python3|python3|needed|what reads and writes the pages, the exercises, the logs
gnuplot|command gnuplot|gnuplot-nox|wanted|the pictures; without it they are skipped
Graphviz|command dot|graphviz|wanted|the pictures of state machines; without it they are skipped
Doxygen (docs)|command doxygen|doxygen|docs|only for the site of ./workbook docs
theme (docs)|file '"${ANSATZ_DOXYGEN_THEME:-/usr/share/doxygen-awesome-css}"'/doxygen-awesome.css|doxygen-awesome-css|docs|only for the look of that site
MathJax 2 (docs)|file '"${ANSATZ_MATHJAX:-/usr/share/javascript/mathjax}"'/MathJax.js|libjs-mathjax|docs|only for the formulas of that site'

# Where headers are looked for: the usual places, and where the compiler and CMake were told to look.
include_folders() {
    local prefix
    printf '%s\n' /usr/include /usr/local/include /opt/homebrew/include /opt/local/include
    printf '%s\n' "${CPATH:-}:${CPLUS_INCLUDE_PATH:-}" | tr : '\n' | grep .
    printf '%s\n' "${CMAKE_PREFIX_PATH:-}:${Boost_ROOT:-}:${Eigen3_ROOT:-}" | tr : '\n' | grep . | while IFS= read -r prefix; do
        echo "$prefix/include"
    done
}

# Where the named thing is, or nothing.
find_need() {
    local kind=$1 name folder
    shift
    for name in "$@"; do
        if [ "$kind" = command ]; then
            command -v "$name" && return 0
            continue
        elif [ "$kind" = file ]; then
            if [ -f "$name" ]; then echo "$name"; return 0; fi
            continue
        fi
        while IFS= read -r folder; do
            if [ -e "$folder/$name" ]; then echo "$folder/$name"; return 0; fi
        done <<< "$(include_folders)"
    done
    return 1
}

# Every need as "name|where or empty|package|needed or wanted|what for".
needs() {
    local name how package weight reason where
    while IFS='|' read -r name how package weight reason; do
        # shellcheck disable=SC2086  # the words of `how` are arguments
        where=$(find_need $how)
        printf '%s|%s|%s|%s|%s\n' "$name" "$where" "$package" "$weight" "$reason"
    done <<< "$NEEDS"
}

# Those of them that a purpose asks for: the course (everything but what is for the docs), or docs (only that).
needs_for() { needs | awk -F '|' -v purpose="$1" '($4 == "docs") == (purpose == "docs")'; }

# The packages of what is missing for a purpose, one line.
missing_packages() { needs_for "$1" | awk -F '|' '$2 == "" { printf "%s%s", sep, $3; sep = " " }'; }

# provide [docs]: says what is missing and, as far as this machine lets us, installs it. Fails where the course, or the
# site, cannot go on.
provide() {
    local purpose=${1:-course} packages table
    packages=$(missing_packages "$purpose")
    [ -z "$packages" ] && return 0
    table=$(needs_for "$purpose")
    heading "Missing here"
    printf '%s\n' "$table" | awk -F '|' '$2 == "" { printf "  %-18s %s\n", $1, $5 }'
    if ! command -v apt-get > /dev/null; then
        say "This system has no apt-get, so please install these with its own package system (the names are Debian's): $packages. Then run the same command again."
    elif install_packages "$packages" && [ -z "$(missing_packages "$purpose")" ]; then
        return 0
    fi
    # Only pictures would be missing: that is no reason to stop.
    if ! needs_for "$purpose" | awk -F '|' '$2 == "" && $4 != "wanted" { found = 1 } END { exit !found }'; then
        say "The course goes on without pictures."
        return 0
    fi
    return 1
}

# shellcheck disable=SC2086  # the packages are words
install_packages() {
    local packages=$1 rights='' by_hand
    by_hand="apt-get update && apt-get install --no-install-recommends $packages"
    if [ "$(id -u)" -ne 0 ]; then
        by_hand="sudo sh -c '$by_hand'"
        if ! command -v sudo > /dev/null; then
            say "Installing needs root's rights, and there is no sudo here. As root, run:"
            printf '  %s\n' "apt-get update && apt-get install --no-install-recommends $packages"
            return 1
        fi
        if [ "$YES" = true ]; then rights='sudo -n'
        elif [ -t 0 ] && [ -t 1 ]; then
            local answer
            say "May I install them with sudo (it may ask for your password)?"
            printf '  %s\n[Y/n] ' "sudo apt-get install --no-install-recommends $packages"
            read -r answer
            case $answer in
                '' | [Yy]*) rights=sudo ;;
                *) say "Nothing was installed. To do it by hand:"; printf '  %s\n' "$by_hand"; return 1 ;;
            esac
        else
            say "Nobody is here to be asked for sudo's rights. Run this, or ./workbook --yes where sudo asks no password:"
            printf '  %s\n' "$by_hand"
            return 1
        fi
    fi

    mkdir -p build/logs
    local log=build/logs/apt.log start
    start=$(now)
    echo "installing: $packages"
    # sudo -v first, in the foreground: a password prompt must not hide behind the progress line.
    if [ "$rights" = sudo ] && ! sudo -v; then say "sudo refused. To do it by hand:"; printf '  %s\n' "$by_hand"; return 1; fi
    {
        # A fresh system has no lists at all; old lists name versions that are gone.
        $rights apt-get update &&
            $rights env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $packages
    } < /dev/null 2>&1 | tee "$log" | while IFS= read -r line; do
        case $line in Get:* | Unpacking* | "Setting up"*) progress "  $line" ;; esac
    done
    local status=${PIPESTATUS[0]}
    clear_progress
    if [ "$status" -ne 0 ]; then
        complain "apt-get could not install everything:"
        { grep -E '^(E|W):' "$log" || tail -n 3 "$log"; } | head -n 5 >&2
        say "The whole log: $log. To try by hand:"
        printf '  %s\n' "$by_hand"
        return 1
    fi
    echo "installed in $(duration $(($(now) - start)))"
}
