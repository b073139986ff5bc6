# Runs PROGRAM in the empty folder SCRATCH, so that the files it may write do no harm, and sets `output`.
function(run_example)
    file(REMOVE_RECURSE ${SCRATCH})
    file(MAKE_DIRECTORY ${SCRATCH})
    execute_process(
        COMMAND ${PROGRAM} WORKING_DIRECTORY ${SCRATCH} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY
    )
    set(output "${output}" PARENT_SCOPE)
endfunction()

# `documented`, found in `where`, must be `actual`, but for blank lines at the end.
function(compare where documented actual)
    string(REGEX REPLACE "[ \n]+$" "" documented "${documented}")
    string(REGEX REPLACE "[ \n]+$" "" actual "${actual}")
    if(NOT documented STREQUAL actual)
        message(FATAL_ERROR "${where} has\n${documented}\n--- but should have\n${actual}\n---")
    endif()
endfunction()

# Sets `result` to what stands between `begin` and the next `end` in `text`; `where` is for the error message.
function(between result where text begin end)
    string(FIND "${text}" "${begin}" at)
    if(NOT at EQUAL -1)
        string(LENGTH "${begin}" length)
        math(EXPR at "${at} + ${length}")
        string(SUBSTRING "${text}" ${at} -1 text)
        string(FIND "${text}" "${end}" at)
    endif()
    if(at EQUAL -1)
        message(FATAL_ERROR "${where} lacks what should stand between '${begin}' and '${end}'")
    endif()
    string(SUBSTRING "${text}" 0 ${at} text)
    set(${result} "${text}" PARENT_SCOPE)
endfunction()
