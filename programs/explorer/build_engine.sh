#!/bin/sh
# The engine of the explorer as WebAssembly: programs/explorer/build_engine.sh FOLDER writes FOLDER/engine.wasm.
# Needs Debian's clang-19, lld-19, libc++-19-dev-wasm32, libc++abi-19-dev-wasm32, libclang-rt-19-dev-wasm32, wasi-libc, and the
# headers of Eigen, Boost, nlohmann/json and PEGTL. Objects stay in FOLDER/engine; units that did not change are not compiled again
# where ccache is installed; binaryen's wasm-opt, where it is, takes off another twelfth.
set -eu

test $# -eq 1 || { echo "usage: $0 FOLDER" >&2; exit 2; }
root=$(cd "$(dirname "$0")/../.." && pwd)
out=$1/engine
mkdir -p "$out/include"

compiler=$(command -v clang++-19) || { echo "$0: needs clang++-19" >&2; exit 1; }
if command -v ccache > /dev/null; then compiler="ccache $compiler"; fi

# Headers of the system that know no machine, and none else of /usr/include
for header in eigen3/Eigen boost nlohmann tao; do
    test -e /usr/include/$header || { echo "$0: needs the headers $header" >&2; exit 1; }
    ln -sfn /usr/include/$header "$out/include/$(basename $header)"
done

libraries=/usr/include/wasm32-wasi
flags="--target=wasm32-wasi -std=c++20 -nostdlibinc -nostdinc++ -isystem $root/programs/explorer/shims/include
    -isystem $libraries/c++/v1 -isystem $libraries -isystem $out/include -I$root/include -I$root/programs
    -msimd128 -fwasm-exceptions -fno-math-errno -ffp-contract=off -Wall -Wextra -Werror
    -DNDEBUG -DEQUILIBRIA_COMPILED -DEQUILIBRIA_NO_THREADS -DEQUILIBRIA_JSON_COMPILED
    -DBOOST_DISABLE_THREADS -DBOOST_SP_DISABLE_THREADS -DBOOST_NO_CXX98_FUNCTION_BASE -D_WASI_EMULATED_GETPID"

# Paths are tracked by one unit and branches followed by another, which are compiled for speed; all of them so make a locus a third
# faster and the engine half as large again. They come first: of functions that several units have the linker keeps the first.
fast="src/paths.cpp src/continuation_dense.cpp programs/explorer/engine_body_beam.cpp"
units=$(cd "$root" && ls src/*.cpp programs/support/json.cpp programs/support/buckling_cases.cpp programs/equilibria_command/documents.cpp \
    programs/explorer/engine*.cpp programs/explorer/shims/*.cpp | grep -vxF "$(printf '%s\n' $fast)")
export compiler flags root out fast
for unit in $fast $units; do echo "$unit"; done | xargs -P "${JOBS:-$(nproc)}" -I{} sh -ec '
    case " $fast " in *" {} "*) level=-O3 ;; *) level=-Oz ;; esac
    nice $compiler $flags $level -c "$root/{}" -o "$out/$(echo {} | tr / _).o"'

for unit in $fast $units; do echo "$out/$(echo "$unit" | tr / _).o"; done > "$out/objects"
clang++-19 --target=wasm32-wasi -mexec-model=reactor -fwasm-exceptions "@$out/objects" -lwasi-emulated-getpid -lc-printscan-long-double \
    -o "$out/engine.wasm" -Wl,--gc-sections,--strip-all,-z,stack-size=4194304 \
    -Wl,--export=engine_alloc,--export=engine_free,--export=engine_run,--export=engine_error
if command -v wasm-opt > /dev/null; then
    nice wasm-opt -O2 --enable-exception-handling --enable-simd --enable-reference-types --enable-multivalue \
        --enable-mutable-globals --enable-sign-ext --enable-nontrapping-float-to-int "$out/engine.wasm" -o "$out/smaller.wasm"
    mv "$out/smaller.wasm" "$out/engine.wasm"
fi
mv "$out/engine.wasm" "$1/engine.wasm"
