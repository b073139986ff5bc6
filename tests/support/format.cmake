# Checks that each C++ file under ROOT is laid out as .clang-format says, by the version that Debian 12 and 13 both have
# (another one would lay out other lines). CTest calls it skipped where that version is not installed.
set(program clang-format-19)
find_program(clang_format ${program})
if(NOT clang_format)
    message(STATUS "skipped: ${program} is not installed")
    return()
endif()
set(files)
foreach(folder include tests examples programs bench python)
    file(GLOB_RECURSE found ${ROOT}/${folder}/*.hpp ${ROOT}/${folder}/*.cpp)
    list(APPEND files ${found})
endforeach()
if(NOT files)
    message(FATAL_ERROR "no C++ file under ${ROOT}")
endif()
execute_process(
    COMMAND ${clang_format} --dry-run --Werror --ferror-limit=5 ${files}
    RESULT_VARIABLE result
    ERROR_VARIABLE errors
)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "run ${program} -i on these files:\n${errors}")
endif()
