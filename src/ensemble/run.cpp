#include "ensemble/run.hpp"

#ifndef __wasm__
#include <pthread.h>
#include <time.h>
#include <unistd.h>
#endif

namespace pendula {
namespace {

/// The pieces of work of a call. Each thread takes the next one when it has finished its last.
struct Pool {
    LongCall& call;
    std::size_t n;
    Work work;
    const void* context;
    std::size_t next = 0;
    int running = 0;

    void take_all(bool is_caller) noexcept {
        for (Thread thread(call, is_caller); thread.goes_on();) {
            const std::size_t piece = __atomic_fetch_add(&next, std::size_t{1}, __ATOMIC_RELAXED);
            if (piece >= n) return;
            work(context, thread, piece);
        }
    }
};

#ifdef __wasm__  // WebAssembly has one thread

void run(Pool& pool, int) noexcept { pool.take_all(true); }

#else

void run(Pool& pool, int threads) noexcept {
    pthread_t helpers[threads_limit];
    const long wanted = threads > 0 ? threads : sysconf(_SC_NPROCESSORS_ONLN);
    int helping = 0;
    const auto help = [](void* p) -> void* {
        auto& shared = *static_cast<Pool*>(p);
        shared.take_all(false);
        __atomic_fetch_sub(&shared.running, 1, __ATOMIC_RELEASE);
        return nullptr;
    };
    while (helping < threads_limit && helping + 1 < wanted && static_cast<std::size_t>(helping) + 1 < pool.n) {
        __atomic_fetch_add(&pool.running, 1, __ATOMIC_RELAXED);
        if (pthread_create(&helpers[helping], nullptr, help, &pool) != 0) {  // fewer threads give the same results
            __atomic_fetch_sub(&pool.running, 1, __ATOMIC_RELAXED);
            break;
        }
        ++helping;
    }
    pool.take_all(true);
    Thread caller(pool.call, true);
    while (__atomic_load_n(&pool.running, __ATOMIC_ACQUIRE) > 0 && caller.goes_on()) {
        const timespec pause{0, 1'000'000};
        nanosleep(&pause, nullptr);
    }
    for (int i = 0; i < helping; ++i) pthread_join(helpers[i], nullptr);
}

#endif

}  // namespace

bool Thread::goes_on() noexcept {
    if (is_caller_) {
        const auto done = static_cast<double>(__atomic_load_n(&call_.done, __ATOMIC_RELAXED));
        if (!call_.control.proceed(call_.units > 0 ? done / call_.units : 1))
            __atomic_store_n(&call_.is_stopped, true, __ATOMIC_RELAXED);
    }
    return !__atomic_load_n(&call_.is_stopped, __ATOMIC_RELAXED);
}

Refusal check(const Control& control) noexcept {
    if (control.threads >= 0 && control.threads <= threads_limit) return {};
    return {.reason = Refusal::Reason::whole,
            .name = "threads",
            .value = static_cast<double>(control.threads),
            .least = 0,
            .most = threads_limit};
}

Outcome for_each_piece(std::size_t n, double units, const Control& control, Work work, const void* context) noexcept {
    if (const auto refusal = check(control)) return refusal;
    LongCall call{control, units};
    Pool pool{call, n, work, context};
    run(pool, control.threads);
    return call.is_stopped ? Outcome::Kind::stopped : Outcome::Kind::done;
}

}  // namespace pendula
