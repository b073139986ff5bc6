// Never compiled: it lets CMake compute the include directories of a user of the library.
