# The JSON of solve has the keys that its readers count on, and numbers that agree with each other; a file that is none is
# refused with its line and column. PROGRAM writes it into SCRATCH, and nothing else.
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/json_checks.cmake)
set(systems ${SCRATCH}_systems)
file(MAKE_DIRECTORY ${systems})
file(WRITE ${systems}/katsura.txt "4
u0 + 2*u1 + 2*u2 + 2*u3 - 1;
u0^2 + 2*u1^2 + 2*u2^2 + 2*u3^2 - u0;
2*u0*u1 + 2*u1*u2 + 2*u2*u3 - u1;
2*u0*u2 + u1**2 + 2*u1*u3 - u2;
")
run_for_json(katsura.json ${systems}/katsura.txt --prove)
expect(PHCpack format)
expect(u3 unknowns 3)
expect(8 total_degree)
expect(8 multihomogeneous)
expect("" mixed_volume)
expect(total-degree start)
foreach(key paths finite distinct proved_distinct proved_bound)
    expect(8 ${key})
endforeach()
foreach(key at_infinity singular failed cancelled singular_roots undecided duplicates contradictions)
    expect(0 ${key})
endforeach()
expect(ON complete)
expect_length(8 roots)
expect_length(4 roots 0 unknowns)
expect_length(2 roots 0 unknowns u0)
expect(ON roots 0 certificate exists)
expect(OFF roots 0 singular)
expect_numbers(AT roots 0 KEYS residual condition path multiplicity)
expect_numbers(KEYS tracking_seconds seconds real proved_real)

# eigenvectors (1, x, y) by groups that the file names; a complete set, real roots alone
file(WRITE ${systems}/eigenvectors.txt "INPUT
variable_group l;
variable_group x, y; % of the vector
function f1, f2, f3;
f1 = 2 + x - l;
f2 = 1 + 3*x + y - l*x;
f3 = x + 4*y - l*y;
END;
")
run_for_json(eigenvectors.json ${systems}/eigenvectors.txt --prove --real --start multihomogeneous --seed 3)
expect(Bertini format)
expect(multihomogeneous start)
expect(4 total_degree)
foreach(key multihomogeneous paths distinct real proved_real)
    expect(3 ${key})
endforeach()
expect(ON complete)
expect_length(3 roots)
expect(real roots 2 certificate reality)

function(expect_refusal text expected)
    file(WRITE ${systems}/wrong.txt "${text}")
    execute_process(
        COMMAND ${PROGRAM} wrong.txt
        WORKING_DIRECTORY ${systems} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE error
    )
    if(NOT status EQUAL 2 OR NOT output STREQUAL "" OR NOT error STREQUAL "solve: wrong.txt: ${expected}\n")
        message(SEND_ERROR "should end with status 2 and say\n${expected}\nbut ended with ${status} and said\n${error}")
    endif()
endfunction()
expect_refusal("1\nx + \n;" "line 3, column 1 = ;: a number, a variable or ( must stand here")
expect_refusal("variable_group x;\nfunction f;\nf = y;\n"
               "line 3, column 5 = y;: is no name yet: variables and constants are declared before they are used, subfunctions get their sums")
expect_refusal("1 2\nx*y - 1;\n" "equations = 1: must be 2")
expect_refusal("1\nx^2 + 2*i*x + 1;\n" "coefficient in equation 0 = (0,2): must be real")
file(REMOVE_RECURSE ${systems})
