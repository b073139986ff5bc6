# Configures, builds and runs the project in tests/consumer/WAY against the tree SOURCE, or against a copy installed from
# the build tree BUILT, or against what the recipes of scripts/packaging/ make. TARGET: equilibria or compiled. BINARY is this script's own. A user who asks for no warning must
# see none. REFUSED: what the linker has to say, where the project must not link. FLAGS: those of the tree BUILT, so that
# a LAUNCHER that remembers what it compiled does not compile the library once more for each project.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${BINARY})
set(prefix ${BINARY}/installed)

if(WAY MATCHES "find_package|pkg_config|cps|mixed|other_flags")
    execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILT} --prefix ${prefix} COMMAND_ERROR_IS_FATAL ANY)
    file(GLOB_RECURSE files ${prefix}/*.cmake ${prefix}/*.pc ${prefix}/*.cps)
    foreach(file IN LISTS files)
        file(READ ${file} text)
        foreach(tree IN ITEMS ${SOURCE} ${BUILT})
            string(FIND "${text}" "${tree}/" at)
            if(NOT at EQUAL -1)
                message(FATAL_ERROR "${file} is not relocatable: it names ${tree}")
            endif()
        endforeach()
    endforeach()
endif()

# Packages of the headers are made as their managers would.
if(WAY STREQUAL "conan")
    execute_process(
        COMMAND ${PYTHON} ${SOURCE}/tests/consumer/conan/recipe.py ${SOURCE} ${prefix} ${VERSION} ${GENERATOR} ${COMPILER}
        COMMAND_ERROR_IS_FATAL ANY
    )
elseif(WAY STREQUAL "vcpkg")
    execute_process(
        COMMAND
            ${CMAKE_COMMAND} -DSOURCE=${SOURCE} -DFOLDER=${prefix} -DVERSION=${VERSION} -DGENERATOR=${GENERATOR}
            -DCOMPILER=${COMPILER} -P ${SOURCE}/tests/consumer/vcpkg/port.cmake
        COMMAND_ERROR_IS_FATAL ANY
    )
    string(APPEND prefix /packages)
endif()

execute_process(
    COMMAND
        ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE}/tests/consumer/${WAY} -B ${BINARY}/build
        -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCMAKE_PREFIX_PATH=${prefix}
        -DCMAKE_COMPILE_WARNING_AS_ERROR=ON -DCMAKE_CXX_EXTENSIONS=OFF -DCMAKE_BUILD_TYPE=None "-DCMAKE_CXX_FLAGS=${FLAGS}"
        "-DCMAKE_POSITION_INDEPENDENT_CODE=${PIC}" -DEQUILIBRIA_TREE=${SOURCE} -DEQUILIBRIA_TARGET=${TARGET} -DEQUILIBRIA_EXPECTED_VERSION=${VERSION}
    COMMAND_ERROR_IS_FATAL ANY
)
if(REFUSED)
    execute_process(
        COMMAND ${CMAKE_COMMAND} --build ${BINARY}/build OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE status
    )
    if(status EQUAL 0 OR NOT said MATCHES "${REFUSED}")
        message(FATAL_ERROR "the project must not link, for the reason '${REFUSED}':\n${said}")
    endif()
    return()
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BINARY}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${BINARY}/build/consumer COMMAND_ERROR_IS_FATAL ANY)
