#include "kernels/dispatch.hpp"

#include <cstdlib>
#include <cstring>

namespace pendula::kernels {

namespace baseline {
extern const Kernels kernels;
}
#ifdef PENDULA_HAS_AVX2
namespace avx2 {
extern const Kernels kernels;
}
#endif
#ifdef PENDULA_HAS_AVX512
namespace avx512 {
extern const Kernels kernels;
}
#endif

namespace {

#if defined PENDULA_HAS_AVX2 || defined PENDULA_HAS_AVX512
const Kernels& choose() noexcept {
    const char* forced = std::getenv("PENDULA_ISA");
    const auto wants = [forced](const Kernels& k) { return !forced || std::strcmp(forced, k.name) == 0; };
#ifdef PENDULA_HAS_AVX512
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && wants(avx512::kernels))
        return avx512::kernels;
#endif
#ifdef PENDULA_HAS_AVX2
    if (__builtin_cpu_supports("avx2") && wants(avx2::kernels)) return avx2::kernels;
#endif
    return baseline::kernels;
}
#else  // no choice, and no environment to read: a WebAssembly module imports nothing
const Kernels& choose() noexcept { return baseline::kernels; }
#endif

}  // namespace

const Kernels& dispatch() noexcept {
    static const Kernels& chosen = choose();
    return chosen;
}

}  // namespace pendula::kernels
