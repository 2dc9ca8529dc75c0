// Independent pieces of work on several threads, with progress and a way to stop.
#pragma once

#include <cstddef>

#include "pendula/ensemble.hpp"

namespace pendula {

/// What a piece of work sees of the whole: it reports units done, and asks now and then whether to go on.
class Progress {
  public:
    Progress(const Control& control, double units) noexcept : control_(control), units_(units) {}

    void report(double units) noexcept { __atomic_fetch_add(&done_, static_cast<long long>(units), __ATOMIC_RELAXED); }

    /// False once the call is to stop. Only the thread that called asks the caller.
    bool proceeds(bool is_caller) noexcept;

  private:
    const Control& control_;
    double units_;
    long long done_ = 0;
    bool is_stopped_ = false;
};

/// Calls work(context, piece, is_caller) for every piece below n, by as many threads as asked for or as can be had; returns
/// when all are done. Which thread takes which piece is left to chance, so work must not depend on it.
using Work = void (*)(void* context, std::size_t piece, bool is_caller);
void for_each_piece(std::size_t n, int threads, Progress& progress, Work work, void* context) noexcept;

}  // namespace pendula
