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

struct Choice {
    const Kernels* kernels = nullptr;
    bool is_available = false;
};

Choice choose() noexcept {
#ifdef __wasm__  // a module without imports has no environment variables
    const char* const asked = nullptr;
#else
    const char* const asked = std::getenv("PENDULA_ISA");
#endif
    Choice choice{.is_available = !asked};
    // The instruction sets of the processor are offered from the widest to the narrowest.
    const auto offer = [&](const Kernels& kernels) {
        if (!choice.kernels) choice.kernels = &kernels;
        if (asked && std::strcmp(asked, kernels.name) == 0) choice = {&kernels, true};
    };
#ifdef PENDULA_HAS_AVX512
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) offer(avx512::kernels);
#endif
#ifdef PENDULA_HAS_AVX2
    if (__builtin_cpu_supports("avx2")) offer(avx2::kernels);
#endif
    offer(baseline::kernels);
    return choice;
}

const Choice& choice() noexcept {
    static const Choice chosen = choose();
    return chosen;
}

}  // namespace

const Kernels& dispatch() noexcept { return *choice().kernels; }

bool is_choice_available() noexcept { return choice().is_available; }

}  // namespace pendula::kernels
