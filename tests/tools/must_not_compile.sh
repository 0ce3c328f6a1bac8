# SPDX-License-Identifier: BSL-1.0
# tests/must_not_compile/check.cmake accepts a mistake that is named well, and rejects what it must, for the right reason.
set -euo pipefail

check_script=$1/tests/must_not_compile/check.cmake
mkdir -p "$ANSATZ_SCRATCH"
mistake=$ANSATZ_SCRATCH/mistake.cpp
checked=0

check() { "$CMAKE" -D FILE="$mistake" -D COMPILER="$CXX" -P "$check_script" 2>&1; }

accepts() {    # what it must say besides
    local said
    if ! said=$(check); then printf 'rejected, and should not be:\n%s\n' "$said"; exit 1; fi
    if [[ $said != *"$1"* ]]; then printf 'it should say "%s":\n%s\n' "$1" "$said"; exit 1; fi
    checked=$((checked + 1))
}
rejects() {    # the reason that it must give
    local said
    if said=$(check); then printf 'accepted, and should be rejected because "%s":\n%s\n' "$1" "$said"; exit 1; fi
    if [[ $(tr -s ' \n' ' ' <<< "$said") != *"$1"* ]]; then
        printf 'rejected, but not because "%s":\n%s\n' "$1" "$said"; exit 1
    fi
    checked=$((checked + 1))
}

mistake_is() { printf '%s\n' "$@" > "$mistake"; }

# The library, the mistake as a user makes it beside its mended form, and an error of another kind.
world='template <class... Policies> struct World {
    static_assert(sizeof...(Policies) > 0, "World has no integrator; add one, e.g. \"Euler\" [1.6]");
};'
use='#ifdef ANSATZ_MISTAKE
World<> pool;
#else
World<int> pool;
#endif'
other='#ifdef ANSATZ_MISTAKE
Vector other;
#endif'
sentence='// expect: World has no integrator; add one, e.g. "Euler" [1.6]'

mistake_is "$sentence" "$world" "$use"
accepts 'the sentence is the first error; 0 further error(s)'
mistake_is "$sentence" '// expect: Vector' "$world" "$use" "$other"
accepts 'the sentence is the first error; 1 further error(s)'
mistake_is "$sentence" '// at most: 2 errors' "$world" "$use" "$other"
accepts 'the sentence is the first error; 1 further error(s)'

mistake_is "$sentence" '// at most: 1 error' "$world" "$use" "$other"
rejects '2 errors, where the file allows 1'
mistake_is "$sentence" "$world" "$other" "$use"
rejects 'the sentence comes after 1 other error(s), where it must be the first'
mistake_is "$sentence" "$world" "${use/World<>/World<char>}"
rejects 'the mistake compiles'
mistake_is '// expect: World has no broadphase' "$world" "$use"
rejects 'no error says "World has no broadphase"'
mistake_is "$sentence" '// expect: World has no broadphase' "$world" "$use"
rejects 'no error says "World has no broadphase"'
mistake_is "$sentence" "$world" "$use" 'void unused() { int nobody; }'
rejects 'does not compile cleanly'
mistake_is "$world" "$use"
rejects 'it has no line "// expect: <sentence>"'
mistake_is '// expect(another compiler): World' "$world" "$use"
rejects 'it has no line "// expect: <sentence>"'
mistake_is "$sentence" "$world" 'World<> pool;'
rejects 'it never asks for ANSATZ_MISTAKE'

# The sentence in the quoted source, or in a note, is not the compiler's error.
mistake_is "$sentence" '#ifdef ANSATZ_MISTAKE' "Vector other; ${sentence/expect: /}" '#endif'
rejects 'no error says "World has no integrator'

echo "$checked cases judged rightly"
