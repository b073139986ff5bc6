// MUMPS' one function, which loads the library at its first call: linked, the library and its BLAS would be loaded at
// every start of the program, and take longer for it than the program for a small frame.
#ifdef EQUILIBRIA_WITH_MUMPS
#include <dlfcn.h>
#include <dmumps_c.h>

#include <stdexcept>
#include <string>

namespace {

using Function = void (*)(DMUMPS_STRUC_C*);

Function loaded() {
    void* library = dlopen(EQUILIBRIA_MUMPS_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    void* function = library ? dlsym(library, "dmumps_c") : nullptr;
    if (!function) throw std::runtime_error("MUMPS: " + std::string(dlerror()));
    return reinterpret_cast<Function>(function);
}

}  // namespace

extern "C" void dmumps_c(DMUMPS_STRUC_C* data) {
    static const Function function = loaded();
    function(data);
}
#endif
