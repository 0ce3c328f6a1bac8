# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# what this machine has, what is missing, what to do about it
#
#   ./workbook doctor             fails where something needed is missing
#   ./workbook doctor --times     where the time of the last ./workbook test went, by kind, beside the one before
#   ./workbook doctor --checks    how many checks of each kind there are; nothing is built
#
# Those times are seconds of the clock, added up over all jobs; they are kept in build/logs/times.tsv.

fact() { printf '  %s  %s\n' "$(fit "$1" 18)" "$2"; }

# The version a thing tells of itself.
version_of() {
    local where=$2
    case $1 in
        "C++ compiler") "$where" --version 2>/dev/null | head -n 1 ;;
        "Python 3") "$where" --version 2>/dev/null | sed 's/Python //' ;;
        CMake) "$where" --version 2>/dev/null | sed -n '1s/cmake version //p' ;;
        "make or ninja") printf '%s %s' "${where##*/}" "$("$where" --version 2>/dev/null | sed -n '1s/GNU Make //p;1s/^\([0-9.]*\)$/\1/p' | head -n 1)" ;;
        Boost) sed -n 's/^#define BOOST_LIB_VERSION "\(.*\)"/\1/p' "${where%units/quantity.hpp}version.hpp" | tr _ . ;;
        Eigen) awk '/#define EIGEN_(WORLD|MAJOR|MINOR)_VERSION/ { printf "%s%s", sep, $3; sep = "." }' "${where%Core}src/Core/util/Macros.h" ;;
        Catch2) sed -n 's/.*CATCH_VERSION_\(MAJOR\|MINOR\|PATCH\|PATCHLEVEL\) \([0-9]*\).*/\2/p' "$(dirname "$where")"/catch*.hpp 2>/dev/null | head -n 3 | paste -s -d . - ;;
        nlohmann-json) sed -n 's/^#define NLOHMANN_JSON_VERSION_[A-Z]* \([0-9]*\).*/\1/p' "$where" "${where%/*}"/detail/abi_macros.hpp 2>/dev/null | head -n 3 | paste -s -d . - ;;
        # 1.9 is 190, 1.13 is 1130
        pugixml) awk 'sub(/.*define PUGIXML_VERSION +/, "") { one = $1 < 1000 ? 100 : 1000; printf "%d.%d", $1 / one, $1 % one / 10 }' "$where" ;;
        gnuplot) "$where" --version 2>/dev/null | sed 's/gnuplot //' ;;
        Graphviz) "$where" -V 2>&1 | sed 's/.*version \([0-9.]*\).*/\1/' ;;
        *) echo "is there" ;;
    esac
}

verb_doctor() {
    if [ $# -gt 1 ]; then complain "doctor takes one option at a time; what is '$2'? ./workbook help doctor"; return 2; fi
    if [ "$*" = --times ]; then
        times_table && return
        complain "no times are known yet; ./workbook test keeps them"
        return 1
    fi
    if [ "$*" = --checks ]; then
        "$ROOT/tools/checks" "$ROOT"
        return
    fi
    if [ $# -gt 0 ]; then complain "doctor takes no '$1'; ./workbook help doctor"; return 2; fi
    local name where package weight reason version missing=0
    heading "This machine"
    local system
    # shellcheck source=/dev/null
    system=$( (. /etc/os-release 2>/dev/null && printf '%s' "${PRETTY_NAME:-}") || uname -s)
    fact system "$system, $(uname -m)"
    fact processor "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1), $(nproc 2>/dev/null || echo '?') cores"
    fact memory "$(awk '/^MemTotal:/ { t = $2 } /^MemAvailable:/ { a = $2 } END { if (t) printf "%.1f GB, %.1f GB free", t / 1e6, a / 1e6; else print "unknown" }' /proc/meminfo 2>/dev/null)"
    fact disk "$(df -Pk . | awk 'NR == 2 { printf "%.1f GB free here", $4 / 1e6 }')"
    fact "compiles at once" "$(jobs_here) (CMAKE_BUILD_PARALLEL_LEVEL changes it)"

    echo
    heading "What the course needs"
    while IFS='|' read -r name where package weight reason; do
        if [ -n "$where" ]; then
            version=$(version_of "$name" "$where")
            printf '  %s  %sok%s       %s\n' "$(fit "$name" 18)" "$GREEN" "$PLAIN" "$(fit "${version:-is there}" $((WIDTH - 32)) | sed 's/ *$//')"
        else
            if [ "$weight" = needed ]; then missing=$((missing + 1)); fi
            printf '  %s  %s%s%s  %s; on Debian: apt-get install %s\n' "$(fit "$name" 18)" "$RED" "missing" "$PLAIN" "$reason" "$package"
        fi
    done <<< "$(needs)"
    cmake_is_new_enough || missing=$((missing + 1))
    compiler_is_new_enough || missing=$((missing + 1))

    echo
    heading "Times"
    fact "build folder" "$([ -f "$BUILD/CMakeCache.txt" ] && echo "$BUILD, configured" || echo "$BUILD, not configured yet")"
    if [ -f build/logs/durations.tsv ]; then
        # What a student waits for comes below, in words.
        grep -v -E '^(first verdict|save to verdict|known mistakes)' build/logs/durations.tsv | awk -F '\t' '{ last[$1] = $2; when[$1] = $3 } END { for (what in last) print what "\t" last[what] "\t" when[what] }' |
            sort | while IFS=$'\t' read -r name where reason; do fact "$name" "$(duration "$where") on $reason"; done
    else
        fact "last build" "none yet"
    fi
    verdict_facts
    clock_facts

    echo
    if [ "$missing" -gt 0 ]; then
        say "Something needed is missing. ./workbook installs it on Debian, or gives you the list."
        return 1
    fi
    say "Everything needed is here. ./workbook takes the tour."
}

# Presets of version 6 came with CMake 3.25.
cmake_is_new_enough() {
    local version
    version=$(cmake --version 2>/dev/null | sed -n "1s/[^0-9]*//p")
    if [ -z "$version" ] || [ "$(printf '3.25\n%s\n' "$version" | sort -V | head -n 1)" = 3.25 ]; then return 0; fi
    printf '  %s  %stoo old%s  %s: 3.25 or newer is needed; a newer one comes from cmake.org or from pip\n' "$(fit CMake 18)" "$RED" "$PLAIN" "$version"
    return 1
}

# C++20 as the library uses it starts with g++ 12 and clang 14: asked by compiling, not by version.
compiler_is_new_enough() {
    local compiler=${CXX:-}
    [ -z "$compiler" ] && compiler=$(find_need command c++ g++ clang++)
    [ -z "$compiler" ] && return 0
    local start
    start=$(now)
    if echo '#include <concepts>
#include <span>
#include <numbers>
template <class T> concept Scaled = requires(T t) { { t * 2.0 } -> std::convertible_to<T>; };
template <auto V> struct Value {};
struct Literal { double x; };
Value<Literal{std::numbers::pi}> value;
static_assert(Scaled<double>);
int main() {}' | "$compiler" -std=c++20 -fsyntax-only -x c++ - > /dev/null 2>&1; then
        fact "C++20" "compiles, $(duration $(($(now) - start)))"
        return 0
    fi
    printf '  %s  %stoo old%s  %s: the library needs g++ 12 or clang 14; CXX=<another> chooses one\n' "$(fit "C++20" 18)" "$RED" "$PLAIN" "$compiler"
    return 1
}

# How long a student waits: for the first verdict on an exercise, which builds what all of them share, and for those after
# each save. The latter is measured with a skeleton, compiled, linked and tested just now: nobody's answer is touched.
verdict_facts() {
    local id start
    remembered "first verdict" "of an exercise that was never tested here before"
    remembered "known mistakes" "more, once, after the first verdict that a test failed"
    id=$(exercise_index | cut -d "$SEP" -f 2 | while IFS= read -r id; do [ -x "$BUILD/exercises/$id/others" ] && { echo "$id"; break; }; done)
    if [ -z "$id" ]; then
        remembered "save to verdict" "of your answer; ./workbook verify builds what measures it anew"
        return
    fi
    # shellcheck disable=SC2034  # build_quietly reads it
    local ID=$id
    # The first build may have other things to do; the second is what a save costs.
    if build_quietly "measuring" "exercise.$id.measured" && touch "$BUILD/exercises/$id/measured/student.cpp"; then
        start=$(now)
        if build_quietly "measuring" "exercise.$id.measured" && verdicts_of "$BUILD/exercises/$id/measured"; then
            fact "save to verdict" "$(duration $(($(now) - start))) ($id's skeleton, compiled and tested just now; 3 s are promised on an idle machine)"
            return
        fi
    fi
    fact "save to verdict" "not measured: $id does not build (build/logs/exercise.log)"
}
remembered() { # <what> <in words>: the last time that was measured, with its words
    local took
    if took=$(last_duration "$1"); then fact "$1" "$(duration "$took") ($2)"
    else fact "$1" "not measured yet: ./workbook exercise does it"; fi
}
verdicts_of() {
    local name
    # shellcheck source=/dev/null
    . "$ROOT/tools/exercises/judge.sh"
    list_tests "$1" student || return 1
    while IFS=$'\t' read -r _ name _; do run_test "$1" student "$name"; done <<< "$LISTED"
}

# What bends measurements of time on this machine.
clock_facts() {
    local governor=/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor
    fact "load now" "$(cut -d ' ' -f 1-3 /proc/loadavg 2>/dev/null || uptime) (cost tables want it near 0)"
    if grep -q -m 1 '^flags.* hypervisor' /proc/cpuinfo 2>/dev/null; then
        fact "virtual machine" "yes: neighbours disturb times; trust minima and ratios"
    fi
    [ -r $governor ] && [ "$(cat $governor)" != performance ] &&
        fact "frequency" "governor $(cat $governor); 'performance' gives quieter times"
    return 0
}
