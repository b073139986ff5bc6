// What Debian's compiler-rt for WebAssembly was compiled to ask for, and its C library does not have.
#include <cstdint>

extern "C" {

std::uintptr_t __stack_chk_guard = 0x5bd1e995u;
[[noreturn]] void __stack_chk_fail() { __builtin_trap(); }
}
