# SPDX-License-Identifier: BSL-1.0
#
# Makes the skeleton of an exercise from its solution, so that the two cannot drift apart:
#
#     // task 1: todo(1);          becomes the line after the colon;
#     x += v * dt;                 the lines of the answer are left out,
#     // end of task 1             and so is this one.
#
# With -v solved=1 the first task is left as it is solved, with 2 the first two, and so on.
/^ *\/\/ task [0-9]+: / {
    task = $0; sub(/^ *\/\/ task /, "", task)
    if (task + 0 <= solved + 0) next
    indent = $0; sub(/\/\/.*/, "", indent)
    line = $0; sub(/^ *\/\/ task [0-9]+: /, "", line)
    print indent line
    inside = 1
    next
}
/^ *\/\/ end of task [0-9]+/ { inside = 0; next }
!inside { print }
