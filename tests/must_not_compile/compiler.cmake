# SPDX-License-Identifier: BSL-1.0
# How check.cmake and precompile.cmake call a compiler.
#
#   COMPILER            g++ or clang++, of any version
#   INCLUDES            folders, with | between them
#   SYSTEM_INCLUDES     the same, for what we do not want to be warned about
#   PRECOMPILED         the folder of the headers that precompile.cmake made for this compiler; without it all is read
#                       each time
#   FILE                the mistake: what it includes says which of the headers it gets
#
# Sets family (g++ or clang++), compiler_name and flags.

set(ENV{LC_ALL} C)    # the compilers' own words in English
cmake_path(GET COMPILER FILENAME compiler_name)
string(REGEX MATCH "clang\\+\\+|g\\+\\+" family ${compiler_name})

set(flags -std=c++20)
string(REPLACE "|" ";" folders "${INCLUDES}")
foreach(folder IN LISTS folders)
    list(APPEND flags -I ${folder})
endforeach()
string(REPLACE "|" ";" folders "${SYSTEM_INCLUDES}")
list(REMOVE_DUPLICATES folders)
foreach(folder IN LISTS folders)
    if(NOT folder STREQUAL "/usr/include")    # the compiler's own; named again, it would be searched too early
        list(APPEND flags -isystem ${folder})
    endif()
endforeach()

if(PRECOMPILED AND NOT MAKES_PRECOMPILED)
    file(STRINGS ${FILE} included REGEX "^#include <ansatz/(paths|soft_bodies|states|water)" LIMIT_COUNT 1)
    set(group bodies)
    if(included)
        string(REGEX MATCH "paths|soft_bodies|states|water" group "${included}")
    endif()
    if(NOT family STREQUAL "clang++")
        list(APPEND flags -Winvalid-pch -include ${PRECOMPILED}/${group}.hpp)
    else()    # clang++ 14 does not survive soft bodies and water in a precompiled header; what they stand on it does
        string(REGEX REPLACE "soft_bodies|water" "bodies" group ${group})
        list(APPEND flags -include-pch ${PRECOMPILED}/${group}.hpp.pch)
    endif()
endif()
list(APPEND flags -fsyntax-only)
if(family STREQUAL "clang++")
    list(APPEND flags -ferror-limit=0)
endif()
