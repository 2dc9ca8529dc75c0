// The one driver of long calls: independent pieces of work on several threads, with progress and a way to stop.
#pragma once

#include <cstddef>

#include "pendula/control.hpp"

namespace pendula {

/// A long call, as all of its threads see it.
struct LongCall {
    const Control& control;
    double units;  ///< of work, in all
    long long done = 0;
    bool is_stopped = false;
};

/// One thread of a long call, as the work on it sees it.
class Thread {
  public:
    Thread(LongCall& call, bool is_caller) noexcept : call_(call), is_caller_(is_caller) {}

    /// Tells how much work has been done since the last report.
    void report(double units) noexcept {
        __atomic_fetch_add(&call_.done, static_cast<long long>(units), __ATOMIC_RELAXED);
    }
    /// False once the call is to stop. Only the thread that made the call asks the caller.
    bool goes_on() noexcept;

  private:
    LongCall& call_;
    bool is_caller_;
};

Refusal check(const Control& control) noexcept;

/// Calls work(context, thread, piece) for every piece below n, by as many threads as asked for or as can be had; returns when all
/// are done. Which thread takes which piece is left to chance, so work must not depend on it.
using Work = void (*)(const void* context, Thread& thread, std::size_t piece);
Outcome for_each_piece(std::size_t n, double units, const Control& control, Work work, const void* context) noexcept;

/// The same for a lambda (Thread&, std::size_t piece).
template <class Function>
Outcome for_each_piece(std::size_t n, double units, const Control& control, const Function& work) noexcept {
    const auto call = [](const void* context, Thread& thread, std::size_t piece) {
        (*static_cast<const Function*>(context))(thread, piece);
    };
    return for_each_piece(n, units, control, call, &work);
}

}  // namespace pendula
