#include "ensembles.hpp"

#include <chrono>

#include "checks.hpp"

namespace pendula::python {

namespace {

using Clock = std::chrono::steady_clock;

/// Looks for signals some times a second. What a handler raised stays set in this thread.
bool proceed(void* context, double) noexcept {
    auto& last = *static_cast<Clock::time_point*>(context);
    const auto now = Clock::now();
    if (now - last < std::chrono::milliseconds(100)) return true;
    last = now;
    const nb::gil_scoped_acquire held;
    return PyErr_CheckSignals() == 0;
}

}  // namespace

Columns columns(const nb::tuple& arguments) {
    Columns all;
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = arguments[k];
    return all;
}

void require_members(const Columns& columns) {
    constexpr std::array names = {"theta0", "omega0",          "alpha",           "beta",
                                  "torque", "drive_amplitude", "drive_frequency", "drive_phase"};
    constexpr std::array rules = {Rule::finite, Rule::finite, Rule::positive,     Rule::not_negative,
                                  Rule::finite, Rule::finite, Rule::not_negative, Rule::finite};
    for (std::size_t k = 0; k < columns.size(); ++k) {
        Operand values(columns[k]);
        require_all(names[k], values, rules[k]);
    }
}

std::span<const double> values_of(Operand& contiguous) {
    std::size_t size = 1;
    for (const Py_ssize_t length : contiguous.shape()) size *= static_cast<std::size_t>(length);
    return {reinterpret_cast<const double*>(contiguous.data()), size};
}

Members::Members(const Columns& c, Py_ssize_t size)
    : values{Operand(c[0]), Operand(c[1]), Operand(c[2]), Operand(c[3]),
             Operand(c[4]), Operand(c[5]), Operand(c[6]), Operand(c[7])},
      ensemble{static_cast<std::size_t>(size), values_of(values[0]), values_of(values[1]),
               values_of(values[2]),           values_of(values[3]), values_of(values[4]),
               values_of(values[5]),           values_of(values[6]), values_of(values[7])} {}

void run_long(int threads, const std::function<bool(const Control&)>& work) {
    auto last = Clock::now();
    bool is_done;
    {
        const nb::gil_scoped_release released;
        is_done = work({threads, proceed, &last});
    }
    if (!is_done) throw nb::python_error();
}

}  // namespace pendula::python
