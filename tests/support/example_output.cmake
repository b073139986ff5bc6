# What PROGRAM prints is the comment at the end of SOURCE: /* Output: ... */
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_example.cmake)

file(READ ${SOURCE} text)
between(documented ${SOURCE} "${text}" "\n/* Output:\n" "*/")
run_example()
compare(${SOURCE} "${documented}" "${output}")
