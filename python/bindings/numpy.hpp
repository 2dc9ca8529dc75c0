// What crosses between Python and the core: float64 arrays of any shape and strides coming in, new ones going out.
#pragma once

#include <nanobind/nanobind.h>

#include <vector>

namespace pendula::python {

namespace nb = nanobind;

using Shape = std::vector<Py_ssize_t>;

/// An argument as doubles in memory: a Python float, or an array of float64 that is only looked at.
class Operand {
  public:
    explicit Operand(nb::handle value);
    ~Operand();
    Operand(const Operand&) = delete;
    Operand& operator=(const Operand&) = delete;

    Shape shape() const { return {view_.shape, view_.shape + view_.ndim}; }
    /// Bytes from one element to the next along axis `axis` of a broadcast over `ndim` axes; 0 where it repeats.
    Py_ssize_t step(int axis, int ndim) const;
    char* data() { return view_.obj ? static_cast<char*>(view_.buf) : reinterpret_cast<char*>(&scalar_); }

  private:
    double scalar_ = 0;
    Py_buffer view_{};
};

/// A new C-contiguous array of float64. Without axes it becomes a numpy.float64, as results of ufuncs do.
class Output {
  public:
    explicit Output(const Shape& shape);
    ~Output();
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    char* data() { return view_.obj ? static_cast<char*>(view_.buf) : reinterpret_cast<char*>(&scalar_); }
    nb::object value() const;

  private:
    double scalar_ = 0;
    nb::object array_;
    Py_buffer view_{};
};

/// numpy's broadcasting rule. Throws std::invalid_argument with the shapes where they do not fit.
Shape broadcast(std::initializer_list<Shape> shapes);

}  // namespace pendula::python
