# SPDX-License-Identifier: BSL-1.0
# How check.cmake and precompile.cmake call a compiler.
#
#   COMPILER            g++ or clang++, of any version
#   INCLUDES            folders, with | between them
#   SYSTEM_INCLUDES     the same, for what we do not want to be warned about
#   PRECOMPILED         the header that precompile.cmake made for this compiler; without it all is read each time
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
    if(family STREQUAL "clang++")
        list(APPEND flags -include-pch ${PRECOMPILED}.pch)
    else()
        list(APPEND flags -Winvalid-pch -include ${PRECOMPILED})
    endif()
endif()
list(APPEND flags -fsyntax-only)
if(family STREQUAL "clang++")
    list(APPEND flags -ferror-limit=0)
endif()
