// Long calls: other threads run meanwhile, and Ctrl-C ends them.
#pragma once

#include <optional>

#include "numpy.hpp"

namespace pendula::python {

/// Throws what the handler of a pending signal raises: KeyboardInterrupt for Ctrl-C. Takes the GIL for it.
inline void heed_signals() {
    const nb::gil_scoped_acquire held;
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
}

/// Releases the GIL while it lives, and looks for signals as the work goes on.
class LongCall {
  public:
    /// So many evaluations, of some microseconds at most, are to come.
    explicit LongCall(Py_ssize_t evaluations) {
        constexpr Py_ssize_t few = 256;  // as quick as letting go of the GIL
        if (evaluations > few) released_.emplace();
    }

    void worked(Py_ssize_t evaluations) {
        left_ -= evaluations;
        if (left_ > 0) return;
        left_ = interval;
        heed_signals();
    }

  private:
    static constexpr Py_ssize_t interval = 1 << 14;  // some 0.1 s
    Py_ssize_t left_ = interval;
    std::optional<nb::gil_scoped_release> released_;
};

}  // namespace pendula::python
