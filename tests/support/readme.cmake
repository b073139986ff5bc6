# README shows the quickstart as it is, and what it prints:
#   the ```cpp block after <!-- quickstart -->  is SOURCE between // [quickstart] and // [/quickstart],
#   the ```text block after <!-- quickstart output -->  is the output of PROGRAM.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_example.cmake)

file(READ ${README} readme)
file(READ ${SOURCE} text)
between(before README.md "${readme}" "<!-- quickstart -->" "```cpp\n")
between(documented README.md "${readme}" "<!-- quickstart -->${before}```cpp\n" "\n```")
between(code ${SOURCE} "${text}" "// [quickstart]\n" "// [/quickstart]")
compare(README.md "${documented}" "${code}")

between(before README.md "${readme}" "<!-- quickstart output -->" "```text\n")
between(documented README.md "${readme}" "<!-- quickstart output -->${before}```text\n" "\n```")
run_example()
compare(README.md "${documented}" "${output}")
