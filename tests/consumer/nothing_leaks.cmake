# A project that builds us as a part of itself gets one target: no flags, no tests, nothing else.
foreach(property COMPILE_OPTIONS COMPILE_DEFINITIONS LINK_OPTIONS)
    get_target_property(leaked equilibria::equilibria INTERFACE_${property})
    if(leaked)
        message(FATAL_ERROR "equilibria leaks ${property}: ${leaked}")
    endif()
endforeach()

get_property(folders DIRECTORY ${EQUILIBRIA_TREE} PROPERTY SUBDIRECTORIES)
get_property(targets DIRECTORY ${EQUILIBRIA_TREE} PROPERTY BUILDSYSTEM_TARGETS)
if(folders OR NOT targets STREQUAL "equilibria")
    message(FATAL_ERROR "equilibria brings more than its library: ${folders} ${targets}")
endif()
