# SPDX-License-Identifier: BSL-1.0
#
# Makes the skeleton of an exercise from its solution, so that the two cannot drift apart:
#
#     // task 1: todo(1);          becomes the line after the colon;
#     x += v * dt;                 the lines of the answer are left out,
#     // end of task 1             and so is this one.
/^ *\/\/ task [0-9]+: / {
    indent = $0; sub(/\/\/.*/, "", indent)
    line = $0; sub(/^ *\/\/ task [0-9]+: /, "", line)
    print indent line
    inside = 1
    next
}
/^ *\/\/ end of task [0-9]+/ { inside = 0; next }
!inside { print }
