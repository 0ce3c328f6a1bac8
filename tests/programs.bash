# SPDX-License-Identifier: BSL-1.0
# What scripts share that compile programs of their own, tests/<module>/programs/*.cpp; they read it with `source`.

# Not an error: something that the test needs is not on this machine. ctest reports the test as skipped.
skip() {
    echo "skipped: $*"
    exit 0
}

# The compilers to look at, each once: g++ and clang++ where they are installed, and the one of the build.
found_compilers() {
    local name path
    local -A seen=()
    for name in g++ clang++ "${CXX:-c++}"; do
        path=$(command -v "$name") || continue
        if [ -z "${seen[$(readlink -f "$path")]:-}" ]; then
            seen[$(readlink -f "$path")]=yes
            echo "$path"
        fi
    done
}

# What goes before a compiler's command where ccache is there, as in the build (cmake/Ccache.cmake): what it keeps is
# what the compiler made of the same text with the same options. ctest says it, with | between the words.
IFS='|' read -ra launcher <<< "${ANSATZ_LAUNCHER:-}"

# A program of the library with the options of its exported target; what comes behind is added.
#   compile <compiler> <source> <output> [options...]
compile() {
    local compiler=$1 source=$2 output=$3 command machine
    shift 3
    # shellcheck disable=SC2154,SC2207 # the script that reads this sets project; the flags are words
    command=("$compiler" -std=c++20 -ffp-contract=off -fno-math-errno
        -I "$project" -I "$project/include" $(eigen_flags) "$@")
    if [ ${#launcher[@]} -eq 0 ]; then
        "${command[@]}" "$source" -o "$output"
        return
    fi
    # "native" means something else on another machine, and the cache may come from one: a name says which it is.
    case " $* " in
        *=native\ *)
            machine=$(cd / && "$compiler" "$@" "-###" -E -x c++ /dev/null 2>&1 | cksum)
            command+=("-DANSATZ_MACHINE=${machine%% *}")
            ;;
    esac
    # ccache keeps objects, not programs; with the list of what was included (-MD) it need not run the preprocessor.
    case " $* " in
        *" -c "*) "${launcher[@]}" "${command[@]}" -MD "$source" -o "$output" ;;
        *)
            "${launcher[@]}" "${command[@]}" -MD -c "$source" -o "$output.o" &&
                "${command[@]}" "$output.o" -o "$output"
            ;;
    esac
}
eigen_flags() {
    if [ -n "${EIGEN3_INCLUDE_DIR:-}" ]; then
        echo "-isystem $EIGEN3_INCLUDE_DIR"
    elif ! pkg-config --cflags-only-I eigen3 2> /dev/null | sed 's/-I */-isystem /g'; then
        echo "-isystem /usr/include/eigen3"
    fi
}

# Jobs in the background, at most as many as processors; `all_done` ends the script if one of them failed.
jobs_started=()
start() {
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
    "$@" &
    jobs_started+=($!)
}
all_done() {
    local job
    for job in "${jobs_started[@]}"; do wait "$job" || { echo "a job failed; its output is above"; exit 1; }; done
    jobs_started=()
}

# Compiles a program of the project with the compiler of the build and runs it, in the folder of the test.
#   run_program <source, from the project's folder> [options...]
run_program() {
    local source=$1 scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
    shift
    mkdir -p "$scratch"
    compile "${CXX:-c++}" "$project/$source" "$scratch/program" -O1 "$@"
    "$scratch/program"
}
