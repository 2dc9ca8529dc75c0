#include "trajectories.hpp"

#include "checks.hpp"
#include "elementwise.hpp"
#include "ensembles.hpp"

namespace pendula::python {

namespace {

/// Raises ValueError for the first argument that is outside its interval, or that the method cannot take.
void check(const nb::tuple& arguments, int method, double tolerance) {
    const Columns all = columns(arguments);
    require_members(all);
    // Nothing else has a say in what can be done with what.
    Broadcast<4, 0> arrays({all[3], all[4], all[5], all[6]});
    elementwise(arrays, [=](double beta, double torque, double drive_amplitude, double drive_frequency) {
        validate(Problem{.pendulum = {1, beta, torque, drive_amplitude, drive_frequency, 0},
                         .method = static_cast<Method>(method),
                         .schedule = schedule({1, 1, 1}),
                         .tolerance = tolerance});
        return std::array<double, 0>{};
    });
}

nb::object characteristic_time_of(const nb::tuple& arguments) {
    Broadcast<member_columns, 1> arrays(columns(arguments));
    return elementwise(arrays, [](double theta0, double omega0, double alpha, double beta, double torque,
                                  double drive_amplitude, double drive_frequency, double drive_phase) {
        const Pendulum pendulum{alpha, beta, torque, drive_amplitude, drive_frequency, drive_phase};
        return std::array{characteristic_time(pendulum, {theta0, omega0})};
    })[0];
}

/// Rows and steps per row.
nb::tuple rows_and_steps(nb::handle dt, nb::handle every, nb::handle until) {
    Broadcast<3, 2> arrays({dt, every, until});
    require_all("dt", arrays.inputs[0], Rule::positive);
    require_all("every", arrays.inputs[1], Rule::positive);
    require_all("until", arrays.inputs[2], Rule::positive);
    const auto [rows, steps] = elementwise(arrays, [](double step, double between, double last) {
        const Problem problem{.schedule = schedule({step, between, last})};
        validate(problem);
        return std::array{problem.schedule.rows, problem.schedule.steps_per_row};
    });
    return nb::make_tuple(rows, steps);
}

double value_of(std::span<const double> values, std::size_t member) { return values[values.size() == 1 ? 0 : member]; }

Problem problem_of(const Ensemble& e, std::size_t i, Method method, double tolerance, const EnsembleTimes& times) {
    const double every = value_of(times.every, i);
    return {.pendulum = {value_of(e.alpha, i), value_of(e.beta, i), value_of(e.torque, i), value_of(e.drive_amplitude, i),
                         value_of(e.drive_frequency, i), value_of(e.drive_phase, i)},
            .initial = {value_of(e.theta, i), value_of(e.omega, i)},
            .method = method,
            .schedule = {every, static_cast<double>(times.rows), times.steps_per_row, every / times.steps_per_row},
            .tolerance = tolerance};
}

/// Member after member by `advance`, from t = 0: a pendulum alone, or methods that ensembles do not have.
bool solve_each(const Ensemble& ensemble, Method method, double tolerance, const EnsembleTimes& times, const Control& control,
                const EnsembleRows& to) {
    constexpr std::size_t block = 256;
    constexpr double step_budget = 1 << 18;  // some 10 ms
    Sample samples[block];
    for (std::size_t member = 0; member < ensemble.size; ++member) {
        Trajectory run = begin(problem_of(ensemble, member, method, tolerance, times));
        for (std::size_t at = member; !run.is_finished();) {
            const std::size_t n = advance(run, block, samples, step_budget);
            for (std::size_t i = 0; i < n; ++i, at += ensemble.size) {
                to.theta[at] = samples[i].theta;
                to.omega[at] = samples[i].omega;
                to.turns[at] = samples[i].turns;
            }
            if (!control.proceed(control.context, 0)) return false;
        }
    }
    return true;
}

/// theta, omega and turns as an array (3, rows, size). Arguments are checked, contiguous, and of 1 or `size` values.
nb::object solve(const nb::tuple& arguments, nb::handle first, nb::handle every, Py_ssize_t size, Py_ssize_t rows,
                 double steps_per_row, int method_number, double tolerance, int threads) {
    const auto method = static_cast<Method>(method_number);
    Members members(columns(arguments), size);
    Operand starts(first), intervals(every);
    const EnsembleTimes times{values_of(starts), values_of(intervals), static_cast<std::size_t>(rows), steps_per_row};
    Output output({3, rows, size});
    auto* const to = reinterpret_cast<double*>(output.data());
    const EnsembleRows out{to, to + rows * size, to + 2 * rows * size};
    const bool is_of_ensembles = method == Method::rk4 || method == Method::taylor;
    run_long(threads, [&](const Control& control) {
        return !is_of_ensembles || (size == 1 && times.first[0] == 0)
                   ? solve_each(members.ensemble, method, tolerance, times, control, out)
                   : pendula::solve(members.ensemble, method, tolerance, times, control, out);
    });
    return output.value();
}

}  // namespace

void define_trajectories(nb::module_& module) {
    module.def("check", check, nb::arg("arguments"), nb::arg("method"), nb::arg("tolerance"));
    module.def("characteristic_time", characteristic_time_of, nb::arg("arguments"));
    module.def("schedule", rows_and_steps, nb::arg("dt"), nb::arg("every"), nb::arg("until"));
    module.def("solve", solve, nb::arg("arguments"), nb::arg("first"), nb::arg("every"), nb::arg("size"), nb::arg("rows"),
               nb::arg("steps_per_row"), nb::arg("method"), nb::arg("tolerance"), nb::arg("threads"));
}

}  // namespace pendula::python
