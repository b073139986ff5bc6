# The scripts of plots/ become headers, so that a program needs no file but itself to draw: plots/<name>.gp is the text
# plots::<name>, in plots/<name>.hpp of the build folder.
file(GLOB scripts CONFIGURE_DEPENDS plots/*.gp)
foreach(script IN LISTS scripts)
    cmake_path(GET script STEM name)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script})
    file(READ ${script} text)
    file(
        CONFIGURE OUTPUT plots/${name}.hpp @ONLY
        CONTENT "// From programs/plots/${name}.gp.
#pragma once

namespace plots {
inline constexpr char ${name}[] = R\"gnuplot(${text})gnuplot\";
}
"
    )
endforeach()
