# Every model file of the examples: equilibria are found and proved to be all, and the other subcommands of `equilibria` do
# what they say; files that are no models are refused with line and column. PROGRAM writes into SCRATCH.
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/json_checks.cmake)
cmake_path(GET SOURCE PARENT_PATH programs)
set(models ${programs}/../examples/models)
file(GLOB files ${models}/*.json)
if(NOT files)
    message(FATAL_ERROR "no model files in ${models}")
endif()
foreach(file IN LISTS files)
    run_for_json(proof.json prove ${file})
    expect(ON proof complete)
    expect(0 failed)
    expect(0 proof contradictions)
endforeach()

set(pendulum ${models}/rotating_double_pendulum.json)
run_for_json(roots.json solve ${pendulum} --set omega=3,alpha=0.4)
expect(3.0 parameters omega)
expect(16 distinct)
expect(t2 unknowns 1)
run_for_json(roots.json solve ${pendulum} --start polyhedral --threads 2 --seed 4)
expect(12 real)
run_for_json(events.json events ${pendulum} --vary omega=0:5)
expect_length(10 events)
expect(ON complete)
run_for_json(diagram.json diagram ${pendulum} --vary omega=0:3)
expect_length(10 events)
expect(0 failed_paths)
run_for_json(locus.json locus ${pendulum} --x alpha=0:1 --y omega=0:5 --lines 4)
expect_length(2 cusps)
expect_length(7 regions)
expect(ON evidence complete)
run_for_json(sweep.json sweep ${pendulum} --grid alpha=0.2:0.8:3,omega=0.5:4:4)
expect(12 done)
expect(0 failed)

function(expect_refusal line)
    execute_process(COMMAND ${PROGRAM} ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE error)
    if(NOT status EQUAL 2 OR NOT out STREQUAL "" OR NOT error STREQUAL "${line}\n")
        message(SEND_ERROR "${ARGN}: status ${status}, '${out}', '${error}' and not '${line}'")
    endif()
endfunction()
file(WRITE ${SCRATCH}/wrong.json "{\n  \"angles\": [\"t\"],\n  \"potential\": \"cos(t) + a\"\n}\n")
expect_refusal(
    "equilibria solve: ${SCRATCH}/wrong.json: potential, line 3, column 26 = a: no name a: must be one of t" solve
    ${SCRATCH}/wrong.json
)
expect_refusal("equilibria solve: FILE: must be given: a model as JSON" solve)
expect_refusal("equilibria: slove: must be solve, prove, events, diagram, locus, sweep or export" slove)
expect_refusal("equilibria: SUBCOMMAND: must be solve, prove, events, diagram, locus, sweep or export")
expect_refusal("equilibria events: --vary speed: must be alpha, ratio or omega" events ${pendulum} --vary speed=0:1)
expect_refusal(
    "equilibria events: --vary omega=5:0: must be NAME=LOW:HIGH, finite, with LOW < HIGH" events ${pendulum} --vary omega=5:0
)
expect_refusal("equilibria solve: --set omega=fast: must be NAME=VALUE, commas between, finite" solve ${pendulum} --set omega=fast)
expect_refusal(
    "equilibria locus: --y alpha=0:1: must be another parameter than that of --x" locus ${pendulum} --x alpha=0:1 --y alpha=0:1
)

# what is exported is read back by the program of systems from files
foreach(format phcpack bertini julia macaulay2)
    execute_process(
        COMMAND ${PROGRAM} export ${pendulum} --format ${format} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY
    )
    if(NOT text MATCHES "c2")
        message(SEND_ERROR "export as ${format}: ${text}")
    endif()
endforeach()
