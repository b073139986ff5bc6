# rotating_chain --checkpoint: interrupted it says so in one line and ends with status 130, resumed it gives the result of
# a run that was never interrupted; the file of another run is refused and stays as it is.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
function(run)
    execute_process(
        COMMAND ${ARGN}
        WORKING_DIRECTORY ${SCRATCH} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE error
    )
    foreach(variable status output error)
        set(${variable} "${${variable}}" PARENT_SCOPE)
    endforeach()
endfunction()
# What must not differ: all but the times and the number of threads.
function(read_result variable name)
    file(READ ${SCRATCH}/${name} text)
    string(REGEX REPLACE "\"(threads|tracking_seconds|seconds)\": [^\n]*\n" "" text "${text}")
    set(${variable} "${text}" PARENT_SCOPE)
endfunction()

set(chain ${PROGRAM} --links 7 --omega 1.7)
run(${chain} --json whole.json)
read_result(whole whole.json)

# interrupted ever later, until it gets to its end
set(interruptions 0)
foreach(tenths RANGE 1 300)
    math(EXPR seconds "${tenths} / 10")
    math(EXPR rest "${tenths} % 10")
    run(timeout --preserve-status -s INT ${seconds}.${rest}
        ${chain} --checkpoint chain.ckpt --json resumed.json --threads 2
    )
    if(status EQUAL 0)
        break()
    endif()
    # on a loaded machine the signal may come before the program has begun
    if(status EQUAL 130 AND "${output}${error}" STREQUAL "")
        continue()
    endif()
    set(done "rotating_chain: interrupted, [0-9]+ of 16384 paths are finished")
    if(NOT status EQUAL 130 OR NOT output STREQUAL ""
       OR NOT error MATCHES "^${done}; the same command goes on from chain.ckpt\n$")
        message(FATAL_ERROR "interrupted: ended with ${status} and said ${output}${error}")
    endif()
    if(EXISTS ${SCRATCH}/resumed.json)
        message(FATAL_ERROR "interrupted: wrote JSON")
    endif()
    math(EXPR interruptions "${interruptions} + 1")
endforeach()
if(interruptions EQUAL 0)
    message(STATUS "too fast to be interrupted")
endif()
read_result(resumed resumed.json)
if(NOT resumed STREQUAL whole)
    message(FATAL_ERROR "the resumed run differs from the one that was never interrupted")
endif()

file(SHA256 ${SCRATCH}/chain.ckpt before)
function(expect_refusal expected)
    run(${ARGN} --checkpoint chain.ckpt)
    if(NOT status EQUAL 2 OR NOT output STREQUAL "" OR NOT error MATCHES "^rotating_chain: --checkpoint chain.ckpt: ${expected}")
        message(SEND_ERROR "should have refused with '${expected}', but ended with ${status} and said ${output}${error}")
    endif()
    file(SHA256 ${SCRATCH}/chain.ckpt after)
    if(NOT after STREQUAL before)
        message(SEND_ERROR "'${expected}': the file was changed")
    endif()
endfunction()
expect_refusal("is of another run: its seed is 1, this run's is 2;" ${chain} --seed 2)
expect_refusal("is of another run: its parameters.14. is 1.7[0-9]*, this run's is 1.8" ${PROGRAM} --links 7 --omega 1.8)
expect_refusal("is of another run: its model is .*RotatingChain .7 angles.*, this run's is .*RotatingChain .6 angles" ${PROGRAM} --links 6)
run(truncate -s -1 chain.ckpt)
file(SHA256 ${SCRATCH}/chain.ckpt before)
expect_refusal("is truncated: [0-9]+ bytes were committed, [0-9]+ are there\n$" ${chain})
