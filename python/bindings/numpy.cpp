#include "numpy.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace pendula::python {

namespace {

struct Numpy {
    nb::object empty, float64;
};

/// Never destroyed: the interpreter is gone before the process's static objects are.
const Numpy& numpy() {
    static const Numpy* const cached = [] {
        const auto module = nb::module_::import_("numpy");
        return new Numpy{module.attr("empty"), module.attr("float64")};
    }();
    return *cached;
}

std::string text(const Shape& shape) {
    std::string joined = "(";
    for (std::size_t i = 0; i < shape.size(); ++i) joined += (i ? ", " : "") + std::to_string(shape[i]);
    return joined + (shape.size() == 1 ? ",)" : ")");
}

void open(Py_buffer& view, nb::handle array, int flags) {
    if (PyObject_GetBuffer(array.ptr(), &view, flags) != 0) throw nb::python_error();
}

}  // namespace

Operand::Operand(nb::handle value) {
    if (PyFloat_Check(value.ptr()))
        scalar_ = PyFloat_AsDouble(value.ptr());
    else
        open(view_, value, PyBUF_STRIDED_RO);
}

Operand::~Operand() {
    if (view_.obj) PyBuffer_Release(&view_);
}

Py_ssize_t Operand::step(int axis, int ndim) const {
    const int own = axis - (ndim - view_.ndim);
    return own < 0 || view_.shape[own] == 1 ? 0 : view_.strides[own];
}

Output::Output(const Shape& shape) {
    if (shape.empty()) return;
    const auto lengths = nb::steal(PyTuple_New(static_cast<Py_ssize_t>(shape.size())));
    for (std::size_t i = 0; i < shape.size(); ++i)
        PyTuple_SetItem(lengths.ptr(), static_cast<Py_ssize_t>(i), PyLong_FromSsize_t(shape[i]));
    array_ = numpy().empty(lengths);
    open(view_, array_, PyBUF_CONTIG);
}

Output::~Output() {
    if (view_.obj) PyBuffer_Release(&view_);
}

nb::object Output::value() const { return array_ ? array_ : numpy().float64(scalar_); }

Shape broadcast(std::initializer_list<Shape> shapes) {
    Shape common;
    for (const Shape& shape : shapes) common.insert(common.begin(), std::max(common.size(), shape.size()) - common.size(), 1);
    for (const Shape& shape : shapes) {
        const std::size_t lead = common.size() - shape.size();
        for (std::size_t i = 0; i < shape.size(); ++i) {
            Py_ssize_t& length = common[lead + i];
            if (length == 1) length = shape[i];
            if (shape[i] == 1 || shape[i] == length) continue;
            std::string message = "arguments cannot be broadcast together: their shapes are";
            for (const Shape& each : shapes) message += ' ' + text(each);
            throw std::invalid_argument(message);
        }
    }
    return common;
}

}  // namespace pendula::python
