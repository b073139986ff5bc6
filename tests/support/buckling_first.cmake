# buckling --first: the critical point that the whole run finds first, to the digit, as the only one, with nothing that leaves it; of
# each direction where the case goes both ways. PROGRAM writes it into SCRATCH, and nothing else.
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/json_checks.cmake)

foreach(case lee_frame right_angle_frame)
    run_for_json(whole.json --case ${case} --elements 4)
    string(JSON load GET "${json}" critical_points 0 parameter)
    run_for_json(first.json --case ${case} --elements 4 --first)
    expect_length(1 critical_points)
    expect(${load} critical_points 0 parameter)
    expect_length(1 branches)
    expect(critical branches 0 end)
    expect_length(0 unexplained_steps)
endforeach()

run_for_json(both.json --case hinged_frame --elements 4 --order quadratic --first)
expect_length(2 branches)
foreach(k 0 1)
    expect(critical branches ${k} end)
    expect(${k} critical_points ${k} branch)
endforeach()

# a branch without one goes on to the end of its range; --at: one place, instead of the three that the case has
function(places expected)
    string(REGEX MATCHALL "\"at\": \"at [0-9]+\"" found "${json}")
    if(NOT found STREQUAL expected)
        message(SEND_ERROR "places ${found} and should be ${expected}")
    endif()
endfunction()
run_for_json(none.json --case bend --elements 4 --first)
expect_length(0 critical_points)
expect(window branches 0 end)
places("\"at\": \"at 300\";\"at\": \"at 450\";\"at\": \"at 600\"")
run_for_json(at.json --case bend --elements 4 --at 450)
places("\"at\": \"at 450\"")
