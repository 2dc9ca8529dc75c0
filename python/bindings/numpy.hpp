// What crosses between Python and the core: numbers of any type, shape and strides coming in, arrays of float64 going out. What
// is not legal is refused by the argument's name, which the caster of an argument does not know: it keeps the fault for the
// function.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>

#include <exception>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace pendula::python {

namespace nb = nanobind;

using Shape = std::vector<Py_ssize_t>;

std::size_t size_of(const Shape& shape);

/// "(2, 3)", as Python prints tuples.
std::string text(const Shape& shape);

/// Real numbers as doubles in memory: a float or an int, or an array that is only looked at if it holds native float64, and
/// converted if numpy converts its type safely (`same_kind`). Text, objects, complex numbers, dates and masked arrays are
/// refused.
class Reals {
  public:
    Reals() = default;
    explicit Reals(nb::handle given);

    /// Throws TypeError, with the argument's name and what was given, where that is not what it must be. Comes before all else.
    const Reals& named(const char* name, const char* what = "real numbers") const;

    bool is_scalar() const { return !view_; }
    Shape shape() const;
    /// As `named` was told it; empty for a default.
    const char* name() const { return name_; }
    std::size_t size() const { return view_ ? static_cast<std::size_t>(view_->len / view_->itemsize) : 1; }
    /// Bytes from one element to the next along axis `axis` of a broadcast over `ndim` axes; 0 where it repeats.
    Py_ssize_t step(int axis, int ndim) const;
    const char* data() const { return view_ ? static_cast<const char*>(view_->buf) : reinterpret_cast<const char*>(&scalar_); }
    /// As Python keeps them: a float, or the array.
    nb::object value() const { return view_ ? array_ : nb::float_(scalar_); }

  private:
    struct Release {
        void operator()(Py_buffer* view) const {
            PyBuffer_Release(view);
            delete view;
        }
    };

    void convert(nb::handle given);
    void look_at(nb::object array);

    double scalar_ = 0;
    mutable const char* name_ = "";
    nb::object array_;
    std::unique_ptr<Py_buffer, Release> view_;  // some exporters point into it: it stays where it is
    nb::object refused_;                        // what is not real numbers
    std::exception_ptr failure_;                // of an array that numpy could not make
};

/// A single real number.
struct Number {
    Reals given;
    double named(const char* name) const;
};

/// One of some names.
struct Name {
    nb::object given;
    /// Its place in a list. Throws ValueError with the list, and the nearest name, where it is not there.
    std::size_t among(const char* name, std::span<const char* const> names) const;
};

/// A whole number of threads, or None for as many as there are processors, which the core calls 0.
struct Threads {
    nb::object given;
    int number() const;
};

/// A new C-contiguous array of float64. Without axes it becomes a numpy.float64, as results of ufuncs do.
class Output {
  public:
    explicit Output(const Shape& shape);
    ~Output();
    Output(Output&&) = delete;

    char* data() { return view_.obj ? static_cast<char*>(view_.buf) : reinterpret_cast<char*>(&scalar_); }
    std::span<double> values() { return {reinterpret_cast<double*>(data()), size_}; }
    nb::object value() const;
    /// With the first axis moved to the end.
    nb::object rows_last() const;

  private:
    std::size_t size_ = 1;
    double scalar_ = 0;
    nb::object array_;
    Py_buffer view_{};
};

/// An array of float64 as a result.
struct Array {
    nb::object value;
};

/// A regime, or an array of int8.
struct Regimes {
    nb::object value;
};

/// A float, or an array of float64.
struct Value {
    nb::object value;
};

/// Whole numbers in float64 as int8.
nb::object as_int8(const nb::object& values);

/// numpy's broadcasting rule. Throws std::invalid_argument with the names and the shapes where they do not fit.
Shape broadcast(std::span<const Reals* const> arguments);

/// How a caster hands an argument over whatever it is.
template <class T>
struct Take {
    static T from(nb::handle given) { return {nb::borrow(given)}; }
};
template <>
struct Take<Reals> {
    static Reals from(nb::handle given) { return Reals(given); }
};
template <>
struct Take<Number> {
    static Number from(nb::handle given) { return {Reals(given)}; }
};

}  // namespace pendula::python

namespace nanobind::detail {

// Functions take None too, to refuse it by the argument's name.
#define PENDULA_ARGUMENT(Type, name)                                            \
    template <>                                                                 \
    struct has_arg_defaults<pendula::python::Type> : std::true_type {};         \
    template <>                                                                 \
    struct type_caster<pendula::python::Type> {                                 \
        NB_TYPE_CASTER(pendula::python::Type, const_name(name))                 \
        bool from_python(handle given, std::uint32_t, cleanup_list*) noexcept { \
            value = pendula::python::Take<Value>::from(given);                  \
            return true;                                                        \
        }                                                                       \
    }
PENDULA_ARGUMENT(Reals, "numpy.typing.ArrayLike");
PENDULA_ARGUMENT(Number, "float");
PENDULA_ARGUMENT(Name, "str");
PENDULA_ARGUMENT(Threads, "int");
#undef PENDULA_ARGUMENT

#define PENDULA_RESULT(Type, name)                                                                       \
    template <>                                                                                          \
    struct type_caster<pendula::python::Type> {                                                          \
        NB_TYPE_CASTER(pendula::python::Type, const_name(name))                                          \
        static handle from_cpp(const pendula::python::Type& result, rv_policy, cleanup_list*) noexcept { \
            return object(result.value).release();                                                       \
        }                                                                                                \
    }
PENDULA_RESULT(Array, "numpy.typing.NDArray[numpy.float64]");
PENDULA_RESULT(Value, "float | numpy.typing.NDArray[numpy.float64]");
PENDULA_RESULT(Regimes, "pendula._core.Regime | numpy.typing.NDArray[numpy.int8]");
#undef PENDULA_RESULT

}  // namespace nanobind::detail
