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

# models on which lists and curves were not what they are said to be
set(cases ${SCRATCH}.cases)
file(MAKE_DIRECTORY ${cases})
function(write_case name)
    string(JOIN "," text ${ARGN})
    file(WRITE ${cases}/${name}.json "{${text}}")
endfunction()
write_case(flat [=["coordinates":["x"]]=] [=["potential":"x^4"]=])
run_for_json(roots.json solve ${cases}/flat.json)
expect(3 multiplicities 0)
expect(ON multiplicities_proved 0)
write_case(far [=["coordinates":["x"]]=] [=["parameters":{"a":1}]=] [=["potential":"a*x^4 - x^2"]=])
run_for_json(events.json events ${cases}/far.json --vary a=-1:3)
expect_length(1 events)
expect("from infinity" events 0 kind)
expect(2 events 0 from_infinity)
expect(2 events 0 change_by_index 0)
expect(ON complete)
run_for_json(diagram.json diagram ${cases}/far.json --vary a=-1:3)
expect_length(4 branches)
expect(ON complete)
write_case(saddle [=["coordinates":["x","y"]]=] [=["parameters":{"a":1}]=] [=["potential":"x*y + a*x"]=])
run_for_json(diagram.json diagram ${cases}/saddle.json --vary a=-0.9:0.7)
expect_length(1 branches)
expect(range branches 0 ends 0)
expect(range branches 0 ends 1)
write_case(turn [=["angles":["t"]]=] [=["parameters":{"a":1}]=] [=["potential":"a*cos(t) + a^2*sin(2*t)"]=])
run_for_json(diagram.json diagram ${cases}/turn.json --vary a=-0.3:0.3)
expect_length(4 branches)
expect(continuum events 0 kind)
write_case(
    hub
    [=["angles":["a","b"]]=]
    [=["parameters":{"omega":4,"e":0.2}]=]
    [=["definitions":{"r1":"e + sin(a)","r2":"r1 + 0.7*sin(b)"}]=]
    [=["potential":"-29.43*cos(a) - 13.734*cos(b) - omega^2*(r1^2 + 2*r2^2)/2"]=]
)
run_for_json(locus.json locus ${cases}/hub.json --x e=0:1 --y omega=0:8 --lines 4)
expect_length(3 curves)
expect_length(5 regions)
expect(ON evidence complete)
write_case(
    linkage
    [=["angles":["a","b","c"]]=]
    [=["parameters":{"P":1,"w":0.02}]=]
    [=["potential":"3 - cos(a) - cos(a - b) - cos(b - c) + P*(cos(a) + cos(b) + cos(c)) + w*sin(c)"]=]
)
run_for_json(locus.json locus ${cases}/linkage.json --x w=-1:1 --y P=0:4 --lines 4)
expect_length(12 cusps)
expect_length(7 curves)
expect(ON evidence complete)
write_case(
    crane
    [=["angles":["a","b","c"]]=]
    [=["parameters":{"P":0.8,"w":0.1}]=]
    [=["potential":"3 - cos(a) - cos(a - b) - cos(b - c) + P*(cos(a) + cos(b) + cos(c)) - w*(sin(a) + sin(b) + sin(c))"]=]
)
run_for_json(locus.json locus ${cases}/crane.json --x w=-1:1 --y P=0.05:3 --lines 4)
expect_length(27 cusps)
expect(ON evidence complete)
foreach(k RANGE 26)
    string(JSON w GET "${json}" cusps ${k} w)
    string(JSON residual GET "${json}" cusps ${k} residual)
    if(w GREATER 1 OR w LESS -1 OR residual GREATER 1e-9)
        message(SEND_ERROR "a cusp at w = ${w} with the residual ${residual}")
    endif()
endforeach()
run_for_json(locus.json locus ${models}/cusp_catastrophe.json --x a=-2:3 --y b=-2.5:2)
expect_length(1 cusps)
expect_length(2 regions)
expect(ON evidence complete)
run_for_json(locus.json locus ${models}/swallowtail_catastrophe.json --set c=-0.2 --x a=-2:1 --y b=-1:1)
expect_length(2 cusps)
expect(ON evidence complete)
run_for_json(locus.json locus ${models}/elliptic_umbilic.json --x b=-2:2 --y c=-3:3)
expect_length(2 cusps)
expect(ON evidence complete)
run_for_json(locus.json locus ${models}/hyperbolic_umbilic.json --set c=-0.3 --x a=-2:2 --y b=-2:1)
expect_length(2 cusps)
expect_length(4 regions)
expect(ON evidence complete)

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
write_case(tilted [=["angles":["t"]]=] [=["parameters":{"tilt":0.2}]=] [=["potential":"cos(t) + sin(tilt)*sin(t)"]=])
expect_refusal(
    "equilibria events: parameter = tilt: must enter the model's equations as a polynomial to be varied: give what it enters, such as sin(tilt), a parameter of its own"
    events ${cases}/tilted.json --vary tilt=0:1
)
write_case(idle [=["angles":["a","b"]]=] [=["potential":"cos(a)"]=])
expect_refusal("equilibria solve: unknown = b: must enter the potential, and not by a constant slope alone" solve ${cases}/idle.json)
expect_refusal("equilibria solve: FILE: must be given: a model as JSON" solve)
expect_refusal("equilibria: slove: must be solve, prove, events, diagram, locus, sweep, motion or export" slove)
expect_refusal("equilibria: SUBCOMMAND: must be solve, prove, events, diagram, locus, sweep, motion or export")
expect_refusal("equilibria events: --vary speed: must be alpha, ratio or omega" events ${pendulum} --vary speed=0:1)
expect_refusal(
    "equilibria events: --vary omega=5:0: must be NAME=LOW:HIGH, finite, with LOW < HIGH" events ${pendulum} --vary omega=5:0
)
expect_refusal("equilibria solve: --set omega=fast: must be NAME=VALUE, commas between, finite" solve ${pendulum} --set omega=fast)
expect_refusal(
    "equilibria locus: --y alpha=0:1: must be another parameter than that of --x" locus ${pendulum} --x alpha=0:1 --y alpha=0:1
)

set(elastic ${models}/elastic_pendulum.json)
set(mechanism ${models}/holonomic_mechanism.json)
run_for_json(motion.json motion ${elastic} --start t=0.3,x=1 --rates v=0.25 --until 2 --points 5)
expect(finished status)
expect(v rates 1)
expect(lagrange2 formulation)
expect_length(5 points)
expect(0.5 points 1 t)
expect(0.25 points 0 velocity 1)
expect_numbers(AT points 4 KEYS kinetic potential work dissipated balance)
run_for_json(motion.json motion ${mechanism} --start q1=0.966,q2=0.449 --set decay=0.7 --formulation hamilton --points 2)
expect(finished status)
expect(hamilton formulation)
string(JSON balance GET "${json}" largest_balance)
if(balance GREATER 1e-10)
    message(SEND_ERROR "the energy balance of the mechanism's motion is ${balance}")
endif()
run_for_json(roots.json solve ${mechanism})
expect(stable equilibria 0 verdict)
expect(unstable equilibria 3 verdict)
expect_length(4 equilibria 0 poles)
run_for_json(roots.json solve ${mechanism} --set decay=0.7)
expect("" equilibria 0 verdict)
run_for_json(roots.json solve ${elastic})
expect(marginal equilibria 0 verdict)
execute_process(
    COMMAND ${PROGRAM} motion ${elastic} --start x=1 --until 1 --points 3 --csv - OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY
)
if(NOT text MATCHES "^t,q1,q2,q1_rate,q2_rate,p1,p2,kinetic,potential,work,dissipated,balance\n0,0,1,0,0,[^\n]+\n0.5,[^\n]+\n1,[^\n]+\n$")
    message(SEND_ERROR "CSV of a motion: ${text}")
endif()
execute_process(
    COMMAND ${PROGRAM} motion ${elastic} --start x=1 --until 40 OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY
)
if(NOT text MATCHES "every 10th of 201 points; --csv has all\n\nlagrange2: finished at t = 4")
    message(SEND_ERROR "table of a motion: ${text}")
endif()
execute_process(COMMAND ${PROGRAM} motion ${elastic} --points 2 RESULT_VARIABLE status OUTPUT_VARIABLE text)
if(NOT status EQUAL 1 OR NOT text MATCHES "the mass matrix is singular at t = 1e-06")
    message(SEND_ERROR "motion without a mass: ${status}, ${text}")
endif()
expect_refusal(
    "equilibria motion: ${pendulum}: must have \"kinetic_energy\" and \"rates\": the model does not move" motion ${pendulum}
)
expect_refusal("equilibria motion: --start y: must be t or x" motion ${elastic} --start y=1)
expect_refusal("equilibria motion: --start x: must be named once" motion ${elastic} --start x=1,x=2)
expect_refusal("equilibria motion: --rates x: must be w or v" motion ${elastic} --rates x=1)
expect_refusal("equilibria motion: --rates w: must be NAME=VALUE, commas between, finite" motion ${elastic} --rates w)
expect_refusal("equilibria motion: --until 0: must be a positive number" motion ${elastic} --until 0)
expect_refusal("equilibria motion: --points 1: must be an integer from 2 to 1000000" motion ${elastic} --points 1)
expect_refusal("equilibria motion: --formulation newton: must be lagrange2 or hamilton" motion ${elastic} --formulation newton)
expect_refusal(
    "equilibria motion: --tolerance 1: must be a number from 1e-15 to 1, 1 excluded" motion ${elastic} --tolerance 1
)
file(WRITE ${SCRATCH}/wrong.json "{\n  \"angles\": [\"t\"],\n  \"potential\": \"cos(t)\",\n  \"rates\": [\"w\"],\n  \"kinetic_energy\": \"w\"\n}\n")
expect_refusal(
    "equilibria motion: ${SCRATCH}/wrong.json: kinetic_energy, line 5, column 22 = no quadratic form: must be a quadratic form in the rates: a sum of products of two rates each, times anything without rates"
    motion ${SCRATCH}/wrong.json
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
