// The driver of all long calls: independent pieces of work on several threads, with progress and cancellation.
#pragma once

#include <cstddef>

#include "pendula/control.hpp"

namespace pendula {

/// The state of a long call that its threads share.
struct LongCall {
    const Control& control;
    double units;  ///< of work, the total
    long long done = 0;
    bool is_stopped = false;
};

/// A thread that works for a long call, as the work sees it.
class Thread {
  public:
    Thread(LongCall& call, bool is_caller) noexcept : call_(call), is_caller_(is_caller) {}

    /// Adds the units of work since the last report.
    void report(double units) noexcept { __atomic_fetch_add(&call_.done, static_cast<long long>(units), __ATOMIC_RELAXED); }
    /// False if the call is to stop. Only the thread that made the call invokes `proceed`.
    bool goes_on() noexcept;

  private:
    LongCall& call_;
    bool is_caller_;
};

/// Refuses an illegal number of threads.
Refusal check(const Control& control) noexcept;

/// Calls work(context, thread, piece) for every piece from 0 to n - 1, and returns when all calls have returned. Uses as many
/// threads as requested, or fewer if they cannot be created. Results must not depend on which thread works on which piece,
/// since that varies from call to call.
using Work = void (*)(const void* context, Thread& thread, std::size_t piece);
Outcome for_each_piece(std::size_t n, double units, const Control& control, Work work, const void* context) noexcept;

/// The same for a function object with arguments (Thread&, std::size_t piece).
template <class Function>
Outcome for_each_piece(std::size_t n, double units, const Control& control, const Function& work) noexcept {
    const auto call = [](const void* context, Thread& thread, std::size_t piece) {
        (*static_cast<const Function*>(context))(thread, piece);
    };
    return for_each_piece(n, units, control, call, &work);
}

}  // namespace pendula
