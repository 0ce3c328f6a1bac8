# SPDX-License-Identifier: BSL-1.0
# The compositions of the fuzzer are drawn when the build is configured, those of one space in one source: about 6 s of the compiler
# each. Two dozen are always played in, for a minute together, and under the sanitizers by `.ci/run solids-sanitize`; others and for
# longer are asked for. The test of the planted faults has a composition of its own.
set(ANSATZ_FUZZ_COMPOSITIONS 24 CACHE STRING "How many compositions the fuzzer of worlds plays scenes in")
set(ANSATZ_FUZZ_DRAW 1 CACHE STRING "Which ones: the seed that draws them")
set(compositions ${PROJECT_SOURCE_DIR}/tools/workshop/compositions.py)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${compositions})
if(ANSATZ_PYTHON AND ANSATZ_FUZZ_COMPOSITIONS GREATER 0)
    execute_process(COMMAND ${ANSATZ_PYTHON} ${compositions} ${CMAKE_CURRENT_BINARY_DIR}/fuzz
            --count ${ANSATZ_FUZZ_COMPOSITIONS} --seed ${ANSATZ_FUZZ_DRAW}
        OUTPUT_VARIABLE drawn OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    string(REPLACE "\n" ";" drawn "${drawn}")
    list(APPEND sources ${drawn})
elseif(NOT ANSATZ_PYTHON)
    ansatz_left_out("the fuzzer of worlds" python3 python3)
endif()
