# SPDX-License-Identifier: BSL-1.0
#
# The names of the macros that an answer defines or undefines, one a line, in itself and in the files beside it that it
# includes: what follows the answer is to mean what it says.
#
#   awk -f macros.awk <answer.hpp>

# A directive may go on in the next line, and may have comments between its words.
function scan(file,    line, more, status, folder, name) {
    if (file in seen) return
    seen[file] = 1
    folder = file; sub(/[^\/]*$/, "", folder)
    while ((status = (getline line < file)) > 0) {
        sub(/\r$/, "", line)
        while (line ~ /\\$/ && (getline more < file) > 0) { sub(/\r$/, "", more); line = substr(line, 1, length(line) - 1) more }
        while (match(line, /\/\*([^*]|\*+[^*\/])*\*+\//)) line = substr(line, 1, RSTART - 1) " " substr(line, RSTART + RLENGTH)
        if (line !~ /^[ \t\f\v]*(#|%:)/) continue
        sub(/^[ \t\f\v]*(#|%:)[ \t\f\v]*/, "", line)
        if (line ~ /^(define|undef)[ \t\f\v]/) {
            sub(/^(define|undef)[ \t\f\v]+/, "", line)
            if (match(line, /^[A-Za-z_][A-Za-z_0-9]*/)) {
                name = substr(line, 1, RLENGTH)
                if (!(name in told)) print name
                told[name] = 1
            }
        } else if (match(line, /^include[ \t\f\v]*"[^"]*"/)) {
            line = substr(line, 1, RLENGTH - 1); sub(/^[^"]*"/, "", line)
            scan(line ~ /^\// ? line : folder line)
        }
    }
    close(file)
}
BEGIN { for (i = 1; i < ARGC; i++) scan(ARGV[i]) }
