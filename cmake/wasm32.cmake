# WebAssembly by clang and wasi-libc, as modules that import nothing: `cmake --toolchain cmake/wasm32.cmake`.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fno-exceptions -fno-rtti")
# No main: a library of exports, to be started by _initialize(). A chunk of an ensemble on its way needs more than the usual
# 64 KiB of stack.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-mexec-model=reactor -Wl,-z,stack-size=262144")
set(CMAKE_EXECUTABLE_SUFFIX_CXX .wasm)
