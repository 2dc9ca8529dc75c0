#include "parallel.hpp"

#ifndef __wasm__
#include <pthread.h>
#include <time.h>
#include <unistd.h>
#endif

namespace pendula {
namespace {

struct Pool {
    std::size_t n;
    Work work;
    void* context;
    std::size_t next = 0;
    int running = 0;

    void take_all(bool is_caller) noexcept {
        for (;;) {
            const std::size_t piece = __atomic_fetch_add(&next, std::size_t{1}, __ATOMIC_RELAXED);
            if (piece >= n) return;
            work(context, piece, is_caller);
        }
    }
};

}  // namespace

bool Progress::proceeds(bool is_caller) noexcept {
    if (is_caller && control_.proceed) {
        const auto done = static_cast<double>(__atomic_load_n(&done_, __ATOMIC_RELAXED));
        if (!control_.proceed(control_.context, units_ > 0 ? done / units_ : 1))
            __atomic_store_n(&is_stopped_, true, __ATOMIC_RELAXED);
    }
    return !__atomic_load_n(&is_stopped_, __ATOMIC_RELAXED);
}

#ifdef __wasm__  // one thread is all there is

void for_each_piece(std::size_t n, int, Progress&, Work work, void* context) noexcept { Pool{n, work, context}.take_all(true); }

#else

void for_each_piece(std::size_t n, int threads, Progress& progress, Work work, void* context) noexcept {
    constexpr int most = 256;
    pthread_t helpers[most];
    Pool pool{n, work, context};
    const long wanted = threads > 0 ? threads : sysconf(_SC_NPROCESSORS_ONLN);
    int helping = 0;
    const auto help = [](void* p) -> void* {
        auto& shared = *static_cast<Pool*>(p);
        shared.take_all(false);
        __atomic_fetch_sub(&shared.running, 1, __ATOMIC_RELEASE);
        return nullptr;
    };
    while (helping < most && helping + 1 < wanted && static_cast<std::size_t>(helping) + 1 < n) {
        __atomic_fetch_add(&pool.running, 1, __ATOMIC_RELAXED);
        if (pthread_create(&helpers[helping], nullptr, help, &pool) != 0) {  // those that cannot be had are done without
            __atomic_fetch_sub(&pool.running, 1, __ATOMIC_RELAXED);
            break;
        }
        ++helping;
    }
    pool.take_all(true);
    while (__atomic_load_n(&pool.running, __ATOMIC_ACQUIRE) > 0 && progress.proceeds(true)) {
        const timespec pause{0, 1'000'000};
        nanosleep(&pause, nullptr);
    }
    for (int i = 0; i < helping; ++i) pthread_join(helpers[i], nullptr);
}

#endif

}  // namespace pendula
