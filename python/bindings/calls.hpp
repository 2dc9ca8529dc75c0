// Calls of the core: pendulums as it takes them, what it refuses told by the index in the caller's array, and long calls,
// during which other threads run and that Ctrl-C ends.
#pragma once

#include <nanobind/stl/tuple.h>

#include <array>
#include <chrono>
#include <deque>
#include <optional>
#include <utility>

#include "numpy.hpp"
#include "pendula/ensemble.hpp"
#include "pendula/validate.hpp"

namespace pendula::python {

/// Looks for signals ten times a second. What a handler raised stays set in this thread.
class Signals {
  public:
    bool go_on();

  private:
    std::chrono::steady_clock::time_point last_{};
};

/// Calls `proceed` after some milliseconds of evaluations, of some microseconds at most.
class Paced {
  public:
    explicit Paced(const Proceed& proceed) : proceed_(proceed) {}
    bool after(std::size_t evaluations) {
        done_ += evaluations;
        if (done_ < interval) return true;
        done_ = 0;
        return proceed_(0);
    }

  private:
    static constexpr std::size_t interval = 1 << 12;
    const Proceed& proceed_;
    std::size_t done_ = 0;
};

/// Calls work(proceed), which takes so many evaluations of some microseconds at most, without the GIL if they are many. Raises
/// what the handler of a signal raised if that stopped it. Returns what the core refused, if anything.
template <class Work>
Refusal run_long(std::size_t evaluations, const Work& work) {
    constexpr std::size_t few = 256;  // as quick as letting go of the GIL
    Signals signals;
    Outcome outcome;
    {
        std::optional<nb::gil_scoped_release> released;
        if (evaluations > few) released.emplace();
        outcome = work(Proceed([&signals](double) { return signals.go_on(); }));
    }
    if (outcome.kind == Outcome::Kind::stopped) throw nb::python_error();
    return outcome.refusal;
}

/// The arguments of a pendulum, in the order of `parameters`.
using Pendulums = std::array<Reals, parameter_count>;

/// An argument that is no parameter, and its name.
struct NamedReals {
    const char* name;
    const Reals* values;
};

/// As `Parameters` of the package keeps them.
nb::typed<nb::tuple, Value, nb::ellipsis> values_of(const Pendulums& pendulums);

/// Values as a column that broadcasts to a shape: where they lie if they lie one behind the other, else copied.
Column column_of(const Reals& values, const Shape& shape, std::vector<double>& copy);

/// Evaluations of what is long at any size.
inline constexpr std::size_t many = static_cast<std::size_t>(-1);

/// Pendulums in columns of one value or of one each, and the shape in which the caller has them.
class Members {
  public:
    /// Further arguments run over the members too.
    explicit Members(const Pendulums& pendulums, std::span<const NamedReals> others = {});

    const Shape& shape() const { return shape_; }
    const Ensemble& ensemble() const { return ensemble_; }
    std::size_t size() const { return ensemble_.size; }

    /// The values of an argument as a column; it must outlive this.
    Column column(const Reals& values) { return column_of(values, shape_, copies_.emplace_back()); }

    /// (rows, ...): `shape` behind a first axis.
    Shape with_rows(std::size_t rows) const;

    /// Raises ValueError, or MemoryError, with what is wrong in words and with the index of the value.
    void require(const Refusal& refusal) const;

  private:
    const Pendulums& pendulums_;
    std::vector<NamedReals> others_;
    Shape shape_;
    std::deque<std::vector<double>> copies_;
    Ensemble ensemble_;
};

/// "alpha must be positive and finite, got 0 at index (1, 2)", in the shape of the argument; where it is one number for all
/// pendulums "pendulum at index (1,): …", in their common shape.
std::string at_place(const std::string& description, const Reals* argument, const Shape& shape, std::size_t member);

/// Raises ValueError for the first value outside an interval.
void require_all(const char* name, const Reals& values, Rule rule);

/// Raises ValueError for the first member that `check(member)` refuses.
template <class Check>
void require_each(const Members& members, const Check& check) {
    for (std::size_t member = 0; member < members.size(); ++member) {
        Refusal refusal = check(member);
        refusal.member = member;
        members.require(refusal);
    }
}

/// A RuntimeWarning for members that have a NaN among their values [row, member].
void warn_of_nan(const char* what, std::span<const double> values, std::size_t rows);

/// Defines a function whose last arguments are the parameters, by name and with their defaults; the first of them, initial
/// angle and velocity, have none. bind(Pendulums&, first arguments...).
template <class... First, class Function, class... Extra>
void define(nb::module_& module, const char* name, Function function, const Extra&... extra) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        const auto argument = [](const Parameter& p) { return nb::arg(p.name) = p.otherwise; };
        module.def(
            name,
            [function](First... first, std::conditional_t<(void(I), true), Reals, void>... values) {
                Pendulums pendulums{std::move(values)...};
                for (std::size_t k = 0; k < parameter_count; ++k) pendulums[k].named(parameters[k].name);
                return function(pendulums, std::move(first)...);
            },
            extra..., argument(parameters[I])...);
    }(std::make_index_sequence<parameter_count>());
}

// The parts of the extension module.
void define_closed_form(nb::module_& module);
void define_solve(nb::module_& module);
void define_crossings(nb::module_& module);
void define_measures(nb::module_& module);
void define_replay(nb::module_& module);

/// The closed form: theta in [-pi, pi), omega and turns, over the broadcast of pendulums and times.
std::tuple<Array, Array, Array> states(const Reals& theta0, const Reals& omega0, const Reals& alpha, const Reals& t);

}  // namespace pendula::python
