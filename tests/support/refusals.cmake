# PROGRAM refuses what the comment at the end of SOURCE lists, each with one line on stderr, nothing on stdout, status 2
# and no file left in SCRATCH:
#   /* Refused:
#   <arguments>
#       <the line>
#   */
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_example.cmake)

file(READ ${SOURCE} text)
between(listed ${SOURCE} "${text}" "\n/* Refused:\n" "*/")
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
set(refusals 0)
while(listed MATCHES "^([^ \n][^\n]*)\n    ([^\n]+)\n(.*)$")
    separate_arguments(arguments UNIX_COMMAND "${CMAKE_MATCH_1}")
    set(expected "${CMAKE_MATCH_2}")
    set(listed "${CMAKE_MATCH_3}")
    math(EXPR refusals "${refusals} + 1")
    execute_process(
        COMMAND ${PROGRAM} ${arguments}
        WORKING_DIRECTORY ${SCRATCH} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE error
    )
    if(NOT status EQUAL 2 OR NOT output STREQUAL "" OR NOT error STREQUAL "${expected}\n")
        message(SEND_ERROR "${arguments}: should end with status 2 and say\n${expected}\n"
                           "but ended with ${status} and said\n${output}${error}")
    endif()
endwhile()
if(refusals EQUAL 0 OR NOT listed STREQUAL "")
    message(SEND_ERROR "${SOURCE}: cannot read this list of refusals: ${listed}")
endif()
file(GLOB left ${SCRATCH}/*)
if(left)
    message(SEND_ERROR "files are left: ${left}")
endif()
