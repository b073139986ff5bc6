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
expect(8 mixed_volume)
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

# systems of the literature: all roots are found and proved, and by Bezout's or Bernstein's theorem there is no other that is isolated
file(WRITE ${systems}/cyclic5.txt "5
a + b + c + d + f;
a*b + b*c + c*d + d*f + f*a;
a*b*c + b*c*d + c*d*f + d*f*a + f*a*b;
a*b*c*d + b*c*d*f + c*d*f*a + d*f*a*b + f*a*b*c;
a*b*c*d*f - 1;
")
file(WRITE ${systems}/eco6.txt "6
(x1 + x1*x2 + x2*x3 + x3*x4 + x4*x5)*x6 - 1;
(x2 + x1*x3 + x2*x4 + x3*x5)*x6 - 2;
(x3 + x1*x4 + x2*x5)*x6 - 3;
(x4 + x1*x5)*x6 - 4;
x5*x6 - 5;
x1 + x2 + x3 + x4 + x5 + 1;
")
file(WRITE ${systems}/katsura5.txt "6
u0 + 2*(u1 + u2 + u3 + u4 + u5) - 1;
u0^2 + 2*(u1^2 + u2^2 + u3^2 + u4^2 + u5^2) - u0;
2*(u0*u1 + u1*u2 + u2*u3 + u3*u4 + u4*u5) - u1;
2*(u0*u2 + u1*u3 + u2*u4 + u3*u5) + u1^2 - u2;
2*(u0*u3 + u1*u2 + u1*u4 + u2*u5) - u3;
2*(u0*u4 + u1*u3 + u1*u5) + u2^2 - u4;
")
foreach(known cyclic5/70/polyhedral/70/10/ON eco6/16/polyhedral/16/4/ON katsura5/32/total-degree/32/16/ON)
    string(REPLACE "/" ";" known "${known}")
    list(GET known 0 name)
    run_for_json(${name}.json ${systems}/${name}.txt --prove --threads 2)
    foreach(at_key 1/paths 2/start 3/finite 3/distinct 3/proved_distinct 4/real 4/proved_real 5/complete)
        string(REPLACE "/" ";" at_key "${at_key}")
        list(GET at_key 0 at)
        list(GET at_key 1 key)
        list(GET known ${at} value)
        expect(${value} ${key})
    endforeach()
    foreach(key singular failed cancelled)
        expect(0 ${key})
    endforeach()
endforeach()

# all roots of katsura-5 from one, by loops of its constants, with what ended the search
run_for_json(monodromy.json ${systems}/katsura5.txt --start monodromy --prove)
expect(monodromy start)
expect(32 distinct)
expect(ON complete)

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
expect_refusal("1 2\nx*y - 1;\n" "1 equation in 2 unknowns: must be as many equations as unknowns")
expect_refusal("3 2\nx*y - 1;\nx - y;\nx;\n" "3 equations in 2 unknowns: must be as many equations as unknowns")
expect_refusal("2\nx*y - 1;\n2*x - 2*x;\n" "equation 2 is 0: must not vanish identically")
expect_refusal("2\nx*y - 1;\n3 - 3*x*y;\n"
               "equation 2 is equation 1, times a number: no two may be the same, for then no root is isolated")
expect_refusal("1\nx^2 + 2*i*x + 1;\n" "equation 1 has complex coefficients: must be real")
file(REMOVE_RECURSE ${systems})
