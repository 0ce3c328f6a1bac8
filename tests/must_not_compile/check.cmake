# SPDX-License-Identifier: BSL-1.0
# A mistake must not compile, and the compiler must say so in our sentence, first.
#
#   cmake -D FILE=<mistake.cpp> -D COMPILER=<g++ or clang++> [what compiler.cmake reads] -P check.cmake
#
# A file holds the mistake and its mended form, and says what is expected, each line at most once an error:
#
#   // expect: World has no integrator; add one, e.g. SemiImplicitEuler
#   // expect(g++): words of g++ alone; expect(clang++): of any clang
#   // expect note: words that may stand anywhere in the output, where a compiler has no better place for them
#   // at most: 3 errors
#   #ifdef ANSATZ_MISTAKE
#   ...
#   #else
#   ...
#   #endif
#
# Checked: without ANSATZ_MISTAKE it compiles without a warning (which mended.cmake may have found for many at once);
# with it, it does not compile, the first error of all holds one of the expected sentences, each expected sentence stands
# in some error, and there are not too many errors.

include(${CMAKE_CURRENT_LIST_DIR}/compiler.cmake)
cmake_path(GET FILE FILENAME name)

# A CMake list is split at semicolons that are not in brackets, so both are replaced wherever text becomes a list.
function(to_lines text result)
    string(REPLACE ";" "," text "${text}")
    string(REPLACE "[" "(" text "${text}")
    string(REPLACE "]" ")" text "${text}")
    string(REPLACE "\\\"" "\"" text "${text}")    # clang 14 escapes the quotes inside a sentence
    string(REPLACE "\\" "/" text "${text}")
    string(REPLACE "\n" ";" text "${text}")
    set(${result} "${text}" PARENT_SCOPE)
endfunction()

function(fail reason)
    message("--- the compiler's whole output:\n${output}---")    # by itself: an error's text would be wrapped
    message(FATAL_ERROR "${name} with ${compiler_name}: ${reason}")
endfunction()

# ------------------------------------------------------------------ what the file expects
set(output "(not called)")
file(READ ${FILE} text)
if(NOT text MATCHES "ANSATZ_MISTAKE")
    fail("it never asks for ANSATZ_MISTAKE, so it holds no mistake")
endif()
to_lines("${text}" lines)
set(expected)
set(noted)
set(at_most)
foreach(line IN LISTS lines)
    if(line MATCHES "^// expect(\\((.+)\\))?: *(.*[^ ]) *$")
        if("${CMAKE_MATCH_2}" STREQUAL "" OR "${CMAKE_MATCH_2}" STREQUAL "${family}")
            list(APPEND expected "${CMAKE_MATCH_3}")
        endif()
    elseif(line MATCHES "^// expect note: *(.*[^ ]) *$")
        list(APPEND noted "${CMAKE_MATCH_1}")
    elseif(line MATCHES "^// at most: *([0-9]+) errors?")
        set(at_most ${CMAKE_MATCH_1})
    endif()
endforeach()
if(NOT expected)
    fail("it has no line \"// expect: <sentence>\" for ${family}")
endif()

# ------------------------------------------------------------------ the two compilations
cmake_path(GET FILE STEM stem)
if(NOT EXISTS "${PRECOMPILED}/mended/${stem}.mended")    # not found clean among others (mended.cmake)
    execute_process(COMMAND ${COMPILER} ${flags} -Wall -Wextra -Werror ${FILE}
        RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT status EQUAL 0)
        fail("the mended form (without ANSATZ_MISTAKE) does not compile cleanly")
    endif()
endif()

execute_process(COMMAND ${COMPILER} ${flags} -DANSATZ_MISTAKE ${FILE}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(status EQUAL 0)
    fail("the mistake compiles")
endif()

# ------------------------------------------------------------------ what the compiler said
to_lines("${output}" lines)
set(errors)
foreach(line IN LISTS lines)
    if(line MATCHES "^[^ ].*: (fatal )?error: ")
        list(APPEND errors "${line}")
    endif()
endforeach()
list(LENGTH errors count)
if(count EQUAL 0)
    fail("the compiler failed (${status}) without an error")
endif()

foreach(sentence IN LISTS expected)
    string(FIND "${errors}" "${sentence}" position)
    if(position EQUAL -1)
        fail("no error says \"${sentence}\"")
    endif()
endforeach()
foreach(words IN LISTS noted)
    string(FIND "${output}" "${words}" position)
    if(position EQUAL -1)
        fail("nothing in the output says \"${words}\"")
    endif()
endforeach()
set(before 0)
set(ours NO)
while(NOT ours)
    list(GET errors ${before} error)
    foreach(sentence IN LISTS expected)
        string(FIND "${error}" "${sentence}" position)
        if(NOT position EQUAL -1)
            set(ours YES)
        endif()
    endforeach()
    if(NOT ours)
        math(EXPR before "${before} + 1")
    endif()
endwhile()
if(before GREATER 0)
    fail("the sentence comes after ${before} other error(s), where it must be the first")
endif()
if(at_most AND count GREATER at_most)
    fail("${count} errors, where the file allows ${at_most}")
endif()

math(EXPR further "${count} - 1")
message("${name} with ${compiler_name}: the sentence is the first error; ${further} further error(s)")
