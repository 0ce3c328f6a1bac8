# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# what the verbs are, or how one of them is used
#
#   ./workbook help               all verbs
#   ./workbook help costs         one of them; ./workbook costs --help says the same

verb_help() {
    local verb
    if [ $# -gt 1 ]; then complain "help takes one verb; what is '$2'?"; return 2; fi
    if [ $# -gt 0 ]; then
        verb=$1
        if [ ! -f "$ROOT/tools/workbook.d/verbs/${verb##*/}.sh" ]; then
            complain "there is no verb '$verb'$(did_you_mean "$verb" "$(verbs)")"
            return 2
        fi
        help_of "${verb##*/}"
        echo
        echo "With every verb: --help (-h) shows its help, --yes (-y) answers yes where something would be installed."
        return 0
    fi
    heading "./workbook [verb] [arguments]"
    say "The one command of Ansatz. Without a verb it takes the tour of the course. --yes answers yes where something would be installed."
    echo
    for verb in $(verbs); do
        printf '  %s%s%s  %s\n' "$BOLD" "$(fit "$verb" 9)" "$PLAIN" "$(fit "$(help_of "$verb" | head -n 1)" $((WIDTH - 14)) | sed 's/ *$//')"
    done
    echo
    echo "./workbook help <verb> says more."
    say "An update (git pull) that stops at a file which you edited: git stash, git pull, git stash pop. Or ./workbook reset <name>, which puts your answer aside."
}
