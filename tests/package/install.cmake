# SPDX-License-Identifier: BSL-1.0
# Installs ${BUILD} into ${PREFIX}, a fresh folder, and holds the installed headers against ${SOURCE}/include.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

file(GLOB_RECURSE ours RELATIVE ${SOURCE}/include ${SOURCE}/include/*)
file(GLOB_RECURSE theirs RELATIVE ${PREFIX}/include ${PREFIX}/include/*)
if(NOT ours STREQUAL theirs)
    message(FATAL_ERROR "The installed headers are not those of include/:\n  here: ${ours}\n  installed: ${theirs}")
endif()

# Whoever takes the folder elsewhere must still find everything.
file(GLOB_RECURSE package_files ${PREFIX}/*.cmake ${PREFIX}/*.pc)
foreach(file IN LISTS package_files)
    file(READ ${file} text)
    foreach(place SOURCE BUILD PREFIX)
        string(FIND "${text}" "${${place}}/" position)
        if(NOT position EQUAL -1)
            message(FATAL_ERROR "${file} names a folder of this machine: ${${place}}")
        endif()
    endforeach()
endforeach()
list(LENGTH theirs count)
message("${count} headers installed")
