# SPDX-License-Identifier: BSL-1.0
# The includes of several sources, each once, as a header before their namespaces (Together.cmake). It is made anew whenever one
# of them changes, and written only where it is another, so that an include which is added is known in the same build.
#
#   cmake -D PROJECT_SOURCE_DIR=<of the sources> -D OUT=<header> -D "PLACES=<sources in it, with : between them>"
#         -D "FIRST=<a line before them>" -P TogetherIncludes.cmake

function(ansatz_write_includes out places first)
    set(includes ${first})
    foreach(place IN LISTS places)
        file(STRINGS ${PROJECT_SOURCE_DIR}/${place} of_place REGEX "^#include ")
        list(APPEND includes ${of_place})
    endforeach()
    list(REMOVE_DUPLICATES includes)
    list(JOIN includes "\n" includes)
    file(CONFIGURE OUTPUT ${out} CONTENT "#pragma once\n${includes}\n" @ONLY)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
    string(REPLACE : ";" places "${PLACES}")
    ansatz_write_includes(${OUT} "${places}" "${FIRST}")
endif()
