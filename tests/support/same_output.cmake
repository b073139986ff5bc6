# Two programs, ONE and OTHER, print the same.
foreach(program IN ITEMS ONE OTHER)
    execute_process(COMMAND ${${program}} OUTPUT_VARIABLE printed_${program} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(printed_ONE STREQUAL "" OR NOT printed_ONE STREQUAL printed_OTHER)
    message(FATAL_ERROR "${ONE} prints\n${printed_ONE}and ${OTHER}\n${printed_OTHER}")
endif()
