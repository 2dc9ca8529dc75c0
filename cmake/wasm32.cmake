# WebAssembly with clang and wasi-libc, for modules without imports: `cmake --toolchain cmake/wasm32.cmake`.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fno-exceptions -fno-rtti")
# A library of exported functions without main; the host calls _initialize() first. The integration of a chunk needs more than
# the default stack of 64 KiB.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-mexec-model=reactor -Wl,-z,stack-size=262144")
set(CMAKE_EXECUTABLE_SUFFIX_CXX .wasm)
