// Compiled once, where the installed Catch2 brings no library with a main function of its own.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
