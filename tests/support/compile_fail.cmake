# SOURCE must not compile, and the compiler must say every sentence that the file announces:
#   // expect: <sentence>
# With EQUILIBRIA_CONTROL defined the same file must compile: so it is refused for that reason and no other.
cmake_minimum_required(VERSION 3.25)

separate_arguments(flags UNIX_COMMAND "${FLAGS} -fsyntax-only")
string(REPLACE "|" ";" includes "${INCLUDES}")
list(TRANSFORM includes PREPEND -I)
set(ENV{LC_ALL} C)

execute_process(
    COMMAND ${COMPILER} ${flags} ${includes} -DEQUILIBRIA_CONTROL ${SOURCE}
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said
)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "the control must compile, but the compiler said:\n${said}")
endif()

execute_process(
    COMMAND ${COMPILER} ${flags} ${includes} ${SOURCE}
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said
)
if(status EQUAL 0)
    message(FATAL_ERROR "the file must not compile, but it does: ${SOURCE}")
endif()

file(STRINGS ${SOURCE} expectations REGEX "^ *// expect: ")
if(NOT expectations)
    message(FATAL_ERROR "the file announces no sentence ('// expect: ...'): ${SOURCE}")
endif()
foreach(expectation IN LISTS expectations)
    string(REGEX REPLACE "^ *// expect: " "" sentence "${expectation}")
    string(FIND "${said}" "${sentence}" at)
    if(at EQUAL -1)
        message(FATAL_ERROR "the compiler should say\n  ${sentence}\nbut it said\n${said}")
    endif()
endforeach()
