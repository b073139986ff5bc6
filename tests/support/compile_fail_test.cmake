# compile_fail.cmake accepts a file refused for the announced reason, and nothing else.
cmake_minimum_required(VERSION 3.25)

function(check program verdict)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/compile_fail_test.cpp)
    file(WRITE ${source} "${program}")
    execute_process(
        COMMAND
            ${CMAKE_COMMAND} -DCOMPILER=${COMPILER} -DFLAGS=${FLAGS} -DINCLUDES=${INCLUDES} -DSOURCE=${source}
            -P ${CMAKE_CURRENT_LIST_DIR}/compile_fail.cmake
        RESULT_VARIABLE status ERROR_VARIABLE said
    )
    if(verdict STREQUAL "accepted")
        if(NOT status EQUAL 0)
            message(FATAL_ERROR "should be accepted:\n${program}\nbut: ${said}")
        endif()
    elseif(status EQUAL 0 OR NOT said MATCHES "${verdict}")
        message(FATAL_ERROR "should be refused with '${verdict}':\n${program}\nbut: ${said}")
    endif()
endfunction()

set(refused "#ifndef EQUILIBRIA_CONTROL\nstatic_assert(false, \"name the angles\")\;\n#endif\n")
check("// expect: name the angles\n${refused}" accepted)
check("// expect: name the parameters\n${refused}" "the compiler should say")
check("${refused}" "announces no sentence")
check("// expect: name the angles\n" "must not compile, but it does")
check("// expect: name the angles\nstatic_assert(false, \"name the angles\")\;\n" "the control must compile")
