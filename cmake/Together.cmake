# SPDX-License-Identifier: BSL-1.0
# Several sources compiled as one. Most of a compiler's time for a test or a section goes into what its neighbours need too: the
# headers, the same worlds. So files are compiled several at a time, each in a namespace of its own, with the includes of all before
# them: 0.6 of the time for tests (springs 0.58, motion 0.60, measured), 0.4 for sections (four of chapter 7).
# A file that cannot stand in a namespace says so in a line of its own, "// Compiled alone: why". One that asks where it lies
# (__FILE__) is compiled alone, too: what ccache shares between checkouts would tell it where another one lies.

# What compiles many worlds needs memory: no more at a time than the machine has room for.
cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)    # MiB
math(EXPR at_a_time "${memory} / 4500")
if(at_a_time LESS 1)
    set(at_a_time 1)
endif()
set_property(GLOBAL APPEND PROPERTY JOB_POOLS together=${at_a_time})

set(together_includes ${CMAKE_CURRENT_LIST_DIR}/TogetherIncludes.cmake)
include(${together_includes})

# What a file weighs in its group: its size in bytes, unless a line of its own says that it compiles like a larger one,
# "// Compiles like 25 kB: why". 100 kB of tests are two to four minutes for one processor; so a file that takes half a minute by
# itself, without the headers, compiles like some 15 to 25 kB. That line is not counted in the size: writing it must not push a file
# into the next group.
function(ansatz_weight source size_variable weight_variable)
    file(SIZE ${source} size)
    set(weight ${size})
    file(STRINGS ${source} said LIMIT_COUNT 1 REGEX "^// Compiles like [0-9]+ kB: ")
    if(said MATCHES "like ([0-9]+) kB")
        math(EXPR weight "1000 * ${CMAKE_MATCH_1}")
        string(LENGTH "${said}" length)
        math(EXPR size "${size} - ${length} - 1")
    endif()
    set(${size_variable} ${size} PARENT_SCOPE)
    set(${weight_variable} ${weight} PARENT_SCOPE)
endfunction()

# For each file of a group the part of it that it belongs to, 1 where the group weighs no more than the limit. One that weighs more
# is cut where its parts weigh about the same, and no file moves to another group: what is compiled of those stays in the ccache.
#   ansatz_cut(<limit> <variable for the numbers> <the group's files>...)
function(ansatz_cut limit parts_variable)
    set(weights)
    set(total 0)
    foreach(source IN LISTS ARGN)
        ansatz_weight(${source} size weight)
        list(APPEND weights ${weight})
        math(EXPR total "${total} + ${weight}")
    endforeach()
    math(EXPR wanted "(${total} + ${limit} - 1) / ${limit}")
    set(parts)
    set(part 0)
    set(last -1)
    set(before 0)
    foreach(weight IN LISTS weights)
        # Where the middle of the file lies, in parts of the whole. One that a large file leaves empty has no number.
        math(EXPR place "${wanted} * (2 * ${before} + ${weight}) / (2 * ${total})")
        if(NOT place EQUAL last)
            math(EXPR part "${part} + 1")
            set(last ${place})
        endif()
        list(APPEND parts ${part})
        math(EXPR before "${before} + ${weight}")
    endforeach()
    set(${parts_variable} ${parts} PARENT_SCOPE)
endfunction()

# Writes a source that holds several, <stem>.cpp, and its includes; the variable is given the names of both.
#   ansatz_write_together(<stem> <after> <include> <variable> <the files>...)
function(ansatz_write_together stem after include written_variable)
    set(text)
    set(places)
    foreach(source IN LISTS ARGN)
        cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE place)
        list(APPEND places ${place})
        string(MAKE_C_IDENTIFIER ${place} name)
        string(CONFIGURE "${after}" line @ONLY)
        string(APPEND text "namespace ${name} {\n#include \"${place}\"\n}\n${line}")
    endforeach()
    set(file ${CMAKE_CURRENT_BINARY_DIR}/together/${stem}.cpp)
    set(includes ${CMAKE_CURRENT_BINARY_DIR}/together/${stem}_includes.hpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "#include \"${stem}_includes.hpp\"\n\n${text}" @ONLY)
    ansatz_write_includes(${includes} "${places}" "${include}") # for who looks at sources while configuring
    list(JOIN places : joined)
    add_custom_command(OUTPUT ${includes}
        COMMAND ${CMAKE_COMMAND} -D PROJECT_SOURCE_DIR=${PROJECT_SOURCE_DIR} -D OUT=${includes}
            -D "PLACES=${joined}" -D "FIRST=${include}" -P ${together_includes}
        DEPENDS ${ARGN} ${together_includes} COMMENT "" VERBATIM)
    set_source_files_properties(${file} PROPERTIES OBJECT_DEPENDS ${includes})
    set(${written_variable} ${file} ${includes} PARENT_SCOPE)
endfunction()

# Replaces the files of a list by sources that hold several of them; those that stand alone stay.
#   BYTES    a source holds no more, and weighs no more (above): <program>_<n>.cpp, and <program>_<n>_<part>.cpp of one that is cut
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
            REGEX "__FILE__|^// Compiled alone: |^namespace (ansatz|std|Eigen|Catch|boost)|^template <> ")
        if(not_precompiled OR apart)
            list(APPEND alone ${source})
            continue()
        endif()
        ansatz_weight(${source} size weight)
        math(EXPR bytes "${bytes} + ${size}")
        if(groups EQUAL 0 OR bytes GREATER of_BYTES)
            math(EXPR groups "${groups} + 1")
            set(bytes ${size})
            set(group_${groups})
        endif()
        list(APPEND group_${groups} ${source})
    endforeach()
    set(together)
    if(groups GREATER 0)
        foreach(group RANGE 1 ${groups})
            ansatz_cut(${of_BYTES} parts ${group_${group}})
            foreach(source part IN ZIP_LISTS group_${group} parts)
                list(APPEND part_${group}_${part} ${source})
            endforeach()
            list(REMOVE_DUPLICATES parts)
            foreach(part IN LISTS parts)
                set(stem ${program}_${group})
                if(part GREATER 1)
                    string(APPEND stem _${part})
                endif()
                ansatz_write_together(${stem} "${of_AFTER}" "${of_INCLUDE}" written ${part_${group}_${part}})
                list(APPEND together ${written})
            endforeach()
        endforeach()
    endif()
    set(${sources_variable} ${together} ${alone} PARENT_SCOPE)
endfunction()
