# SPDX-License-Identifier: BSL-1.0
# Several sources compiled as one. Most of a compiler's time for a test or a section goes into what its neighbours need too: the
# headers, the same worlds. So files are compiled several at a time, each in a namespace of its own, with the includes of all before
# them: 0.6 of the time for tests (springs 0.58, motion 0.60, measured), 0.4 for sections (four of chapter 7).
# A file that cannot stand in a namespace says so in a line of its own, "// Compiled alone: why".

# What compiles many worlds needs memory: no more at a time than the machine has room for.
cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)    # MiB
math(EXPR at_a_time "${memory} / 3000")
if(at_a_time LESS 1)
    set(at_a_time 1)
endif()
set_property(GLOBAL APPEND PROPERTY JOB_POOLS together=${at_a_time})

set(together_includes ${CMAKE_CURRENT_LIST_DIR}/TogetherIncludes.cmake)
include(${together_includes})

# Replaces the files of a list by sources that hold several of them; those that stand alone stay.
#   BYTES    a source holds no more
#   INCLUDE  what each source includes besides
#   AFTER    a line behind each file, in which @name@ is its namespace and @place@ its place in the project
function(ansatz_together program sources_variable)
    cmake_parse_arguments(PARSE_ARGV 2 of "" "BYTES;INCLUDE;AFTER" "")
    set(alone)
    set(groups 0)
    set(bytes 0)
    foreach(source IN LISTS ${sources_variable})
        get_source_file_property(not_precompiled ${source} SKIP_PRECOMPILE_HEADERS)
        file(STRINGS ${source} apart LIMIT_COUNT 1
            REGEX "^// Compiled alone: |^namespace (ansatz|std|Eigen|Catch|boost)|^template <> ")
        if(not_precompiled OR apart)
            list(APPEND alone ${source})
            continue()
        endif()
        file(SIZE ${source} size)
        math(EXPR bytes "${bytes} + ${size}")
        if(groups EQUAL 0 OR bytes GREATER of_BYTES)
            math(EXPR groups "${groups} + 1")
            set(bytes ${size})
            set(places_${groups})
            set(text_${groups})
        endif()
        cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE place)
        list(APPEND places_${groups} ${place})
        string(MAKE_C_IDENTIFIER ${place} name)
        string(CONFIGURE "${of_AFTER}" line @ONLY)
        string(APPEND text_${groups} "namespace ${name} {\n#include \"${place}\"\n}\n${line}")
    endforeach()
    set(together)
    if(groups GREATER 0)
        foreach(group RANGE 1 ${groups})
            set(file ${CMAKE_CURRENT_BINARY_DIR}/together/${program}_${group}.cpp)
            set(includes ${CMAKE_CURRENT_BINARY_DIR}/together/${program}_${group}_includes.hpp)
            file(CONFIGURE OUTPUT ${file} CONTENT "#include \"${program}_${group}_includes.hpp\"\n\n${text_${group}}" @ONLY)
            ansatz_write_includes(${includes} "${places_${group}}" "${of_INCLUDE}") # for who looks at sources while configuring
            list(TRANSFORM places_${group} PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE of_group)
            list(JOIN places_${group} : places)
            add_custom_command(OUTPUT ${includes}
                COMMAND ${CMAKE_COMMAND} -D PROJECT_SOURCE_DIR=${PROJECT_SOURCE_DIR} -D OUT=${includes}
                    -D "PLACES=${places}" -D "FIRST=${of_INCLUDE}" -P ${together_includes}
                DEPENDS ${of_group} ${together_includes} COMMENT "" VERBATIM)
            set_source_files_properties(${file} PROPERTIES OBJECT_DEPENDS ${includes})
            list(APPEND together ${file} ${includes})
        endforeach()
    endif()
    set(${sources_variable} ${together} ${alone} PARENT_SCOPE)
endfunction()
