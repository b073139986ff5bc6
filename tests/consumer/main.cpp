// What a first program of a user looks like, however the library came to it.
#include <cstdio>
#include <equilibria/version.hpp>

int main() { std::puts("equilibria " EQUILIBRIA_VERSION_STRING); }
