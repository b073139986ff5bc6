# All headers of ROOT together, in reverse order: a header that counts on an earlier one does not compile, nor one whose
# names hide another's. And a function in a header that lacks `inline`, which two units would define: it is a strong symbol.
# Where headers come with their definitions, nothing but reading them is asked for; what they instantiate is compiled by
# ARCHIVES, whose strong symbols are as many as there are functions marked EQUILIBRIA_INLINE. BINARY is this script's own.
# SYSTEM_INCLUDES: of the libraries behind opt-in headers; LEFT_OUT: names of those headers whose libraries are missing.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${BINARY})
file(MAKE_DIRECTORY ${BINARY})
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
string(REPLACE "|" ";" includes "${INCLUDES}")
list(TRANSFORM includes PREPEND -I)
string(REPLACE "|" ";" system_includes "${SYSTEM_INCLUDES}")
list(TRANSFORM system_includes PREPEND -idirafter)
list(APPEND includes ${system_includes})
string(REPLACE "|" ";" archives "${ARCHIVES}")
set(ENV{LC_ALL} C)

file(GLOB_RECURSE headers RELATIVE ${ROOT}/include ${ROOT}/include/equilibria/*.hpp)
list(FILTER headers EXCLUDE REGEX "/mpi[^/]*[.]hpp$")  # need MPI's own; their functions are marked or members
if(LEFT_OUT)
    list(FILTER headers EXCLUDE REGEX "/(${LEFT_OUT})[.]hpp$")
endif()
list(REVERSE headers)

function(write_unit name last)
    list(TRANSFORM ARGN REPLACE "(.+)" "#include <\\1>\n")
    string(JOIN "" text ${ARGN})
    file(WRITE ${BINARY}/${name}.cpp "${text}${last}")
endfunction()

# Sets `out` to the names of strong symbols of `files`, but for the mark of a unit's kind (core/compiled.hpp) and the tables
# of virtual functions, which Clang makes strong beside a class's first virtual function, and GCC weak.
function(strong_symbols out)
    execute_process(COMMAND ${NM} -C --defined-only ${ARGN} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "[0-9a-f]+ [TDBR] [^\n]+" symbols "${symbols}")
    list(TRANSFORM symbols REPLACE "^[0-9a-f]+ . " "")
    list(FILTER symbols EXCLUDE REGEX "^this_unit_uses_equilibria_")
    list(FILTER symbols EXCLUDE REGEX "^(vtable|typeinfo|typeinfo name) for ")
    list(REMOVE_DUPLICATES symbols)
    set(${out} ${symbols} PARENT_SCOPE)
endfunction()

# GCC and Clang instantiate templates at the end of a unit, which -Wfatal-errors makes them not reach.
set(sentence "every header was read")
write_unit(with_definitions "static_assert(false, \"${sentence}\");\n" ${headers})
execute_process(
    COMMAND ${COMPILER} ${flags} ${includes} -Wfatal-errors -fsyntax-only ${BINARY}/with_definitions.cpp
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said
)
string(FIND "${said}" "${sentence}" at)
if(status EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "headers with their definitions, in reverse order, cannot be read:\n${said}")
endif()

list(FILTER headers EXCLUDE REGEX "_definitions[.]hpp$")
write_unit(without_definitions "" ${headers})
execute_process(
    COMMAND ${COMPILER} ${flags} ${includes} -O0 -DEQUILIBRIA_COMPILED -c ${BINARY}/without_definitions.cpp
            -o ${BINARY}/without_definitions.o
    COMMAND_ERROR_IS_FATAL ANY
)
strong_symbols(symbols ${BINARY}/without_definitions.o)
if(symbols)
    message(FATAL_ERROR "functions in headers without `inline`: ${symbols}")
endif()

file(GLOB_RECURSE files ${ROOT}/include/equilibria/*.hpp)
list(FILTER files EXCLUDE REGEX "core/compiled[.]hpp$")
set(marked 0)
foreach(file IN LISTS files)
    file(STRINGS ${file} lines REGEX "EQUILIBRIA_INLINE")
    list(LENGTH lines number)
    math(EXPR marked "${marked} + ${number}")
endforeach()
strong_symbols(symbols ${archives})
list(LENGTH symbols number)
if(NOT number EQUAL marked)
    list(JOIN symbols "\n" symbols)
    message(FATAL_ERROR "${marked} functions are marked EQUILIBRIA_INLINE, but the compiled library defines ${number}:\n${symbols}")
endif()
