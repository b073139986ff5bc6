# The CSV of mechanism_motion in three formulations: the same header but for the multipliers, a line for each time, and the
# angles of section 1 of Vesovic and Radulovic (2022) at the times 1 and 10.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
foreach(formulation lagrange2 lagrange1 hamilton)
    execute_process(
        COMMAND ${PROGRAM} --formulation ${formulation} --t-end 10 --csv motion.csv
        WORKING_DIRECTORY ${SCRATCH} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY
    )
    file(STRINGS ${SCRATCH}/motion.csv lines)
    list(LENGTH lines count)
    if(NOT count EQUAL 12)
        message(SEND_ERROR "${formulation}: ${count} lines instead of 12")
    endif()
    set(header "t,q1,q2,q1_rate,q2_rate,p1,p2,x1,y1,x2,y2,x3,y3,kinetic,potential,work,dissipated,balance")
    if(formulation STREQUAL "lagrange1")
        string(APPEND header ",lambda1,lambda2,lambda3,lambda4,drift")
    endif()
    list(GET lines 0 first)
    if(NOT first STREQUAL header)
        message(SEND_ERROR "${formulation}: the header is ${first}")
    endif()
    foreach(row "2;^1,1.39500807540[0-9]*,0.06690095319[0-9]*," "11;^10,1.54821236275[0-9]*,0.10411482945[0-9]*,")
        list(GET row 0 number)
        list(GET row 1 expected)
        list(GET lines ${number} line)
        if(NOT line MATCHES "${expected}")
            message(SEND_ERROR "${formulation}: line ${number} is ${line}")
        endif()
    endforeach()
endforeach()
