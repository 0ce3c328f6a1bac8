#!/bin/sh
# SPDX-License-Identifier: BSL-1.0
#
# In front of a compiler's call: it reads, instantiates and warns, and makes no code. The object is an empty file, so that the
# build knows that this was done.
for argument; do
    [ "${previous:-}" = -o ] && object=$argument
    previous=$argument
done
"$@" -fsyntax-only && : > "$object"
