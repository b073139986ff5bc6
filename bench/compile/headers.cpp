// The quickstart's includes alone.
#include <cstdio>
#include <equilibria/enumerate/enumerate.hpp>
#include <iostream>

int main() {}
