include(CheckLinkerFlag)
check_linker_flag(CXX "-static-libstdc++;-static-libgcc" EQUILIBRIA_STATIC_RUNTIME)

# Programs and examples are built and tested alike.
# An executable `name` from the given sources; linked to the library as a whole, if not to the target that `library` names;
# optimised as `level` says, if not as the library.
# Where a package that the first one needs is missing, it is left out, and
# the variable `built` says so.
function(equilibria_program name source built)
    file(READ ${source} text)
    if((text MATCHES "\"support/options.hpp\"" AND NOT TARGET command_line)
       OR (text MATCHES "<equilibria/io/results/" AND NOT TARGET json_documents))
        message(STATUS "Leaving out ${name}: it needs CLI11 and nlohmann_json")
        set(${built} OFF PARENT_SCOPE)
        return()
    endif()
    if(NOT library)
        set(library equilibria::compiled)
    endif()
    add_executable(${name} ${source} ${ARGN})
    target_link_libraries(
        ${name}
        PRIVATE ${library} $<TARGET_NAME_IF_EXISTS:command_line> $<TARGET_NAME_IF_EXISTS:json_documents>
    )
    if(EQUILIBRIA_MPI AND text MATCHES "\"support/ranks.hpp\"")
        target_link_libraries(${name} PRIVATE MPI::MPI_CXX)
        target_compile_definitions(${name} PRIVATE EQUILIBRIA_MPI)
    endif()
    equilibria_warnings(${name})
    equilibria_read_first(${source} ${ARGN})
    equilibria_native(${name} ${level})
    if(EQUILIBRIA_NATIVE AND EQUILIBRIA_STATIC_RUNTIME)
        # a run of a millisecond need not wait for the C++ library's relocations, which take half of one
        target_link_options(${name} PRIVATE -static-libstdc++ -static-libgcc)
    endif()
    set(${built} ON PARENT_SCOPE)
endfunction()

# A CTest case that runs tests/support/<script>.cmake on the program `name`, in a folder of its own: cases run side by side.
function(equilibria_program_test test name source script)
    add_test(
        NAME ${test}
        COMMAND
            ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${name}> -DSOURCE=${source}
            -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/${name}/${script} -DREADME=${PROJECT_SOURCE_DIR}/README.md
            -P ${PROJECT_SOURCE_DIR}/tests/support/${script}.cmake
    )
endfunction()

# A source that ends with its output, or with what it refuses, is held to it.
function(equilibria_output_tests test name source)
    file(READ ${source} text)
    if(text MATCHES "\n/\\* Output:\n")
        equilibria_program_test(${test} ${name} ${source} example_output)
    endif()
    if(text MATCHES "\n/\\* Refused:\n")
        equilibria_program_test(${test}/refusals ${name} ${source} refusals)
    endif()
endfunction()
