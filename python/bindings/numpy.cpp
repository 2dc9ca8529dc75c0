#include "numpy.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "pendula/validate.hpp"

namespace pendula::python {

namespace {

struct Numpy {
    nb::object array_type, asarray, array2string, can_cast, empty, float64, moveaxis;
};

/// Never destroyed: the interpreter is gone before the process's static objects are.
const Numpy& numpy() {
    static const Numpy* const cached = [] {
        const auto module = nb::module_::import_("numpy");
        const auto get = [&](const char* name) { return nb::object(module.attr(name)); };
        return new Numpy{get("ndarray"), get("asarray"), get("array2string"), get("can_cast"),
                         get("empty"),   get("float64"), get("moveaxis")};
    }();
    return *cached;
}

bool is_plain_array(nb::handle given) { return reinterpret_cast<PyObject*>(Py_TYPE(given.ptr())) == numpy().array_type.ptr(); }

/// Whether it is a masked array, or a list or tuple with one in it.
bool is_masked(nb::handle given) {
    if (nb::isinstance<nb::list>(given) || nb::isinstance<nb::tuple>(given)) {
        for (const nb::handle element : given)
            if (!PyFloat_CheckExact(element.ptr()) && !PyLong_CheckExact(element.ptr()) && is_masked(element)) return true;
        return false;
    }
    return nb::isinstance(given, numpy().array_type) &&
           nb::isinstance(given, nb::module_::import_("numpy.ma").attr("MaskedArray"));
}

bool is_native_double(const Py_buffer& view) {
    const char* const format = view.format ? view.format : "B";
    return std::strcmp(*format == '@' || *format == '=' ? format + 1 : format, "d") == 0;
}

nb::object new_array(const Shape& shape) {
    const auto lengths = nb::steal(PyTuple_New(static_cast<Py_ssize_t>(shape.size())));
    for (std::size_t i = 0; i < shape.size(); ++i)
        PyTuple_SetItem(lengths.ptr(), static_cast<Py_ssize_t>(i), PyLong_FromSsize_t(shape[i]));
    return numpy().empty(lengths);
}

[[noreturn]] void refuse_type(const std::string& message) { throw nb::type_error(message.c_str()); }

std::string as_typed(nb::handle value) { return nb::repr(value).c_str(); }

std::string as_printed(nb::handle value) { return nb::str(value).c_str(); }

}  // namespace

std::size_t size_of(const Shape& shape) {
    std::size_t product = 1;
    for (const Py_ssize_t length : shape) product *= static_cast<std::size_t>(length);
    return product;
}

std::string text(const Shape& shape) {
    std::string joined = "(";
    for (std::size_t i = 0; i < shape.size(); ++i) joined += (i ? ", " : "") + std::to_string(shape[i]);
    return joined + (shape.size() == 1 ? ",)" : ")");
}

Reals::Reals(nb::handle given) {
    if (PyFloat_Check(given.ptr())) {
        scalar_ = PyFloat_AsDouble(given.ptr());
        return;
    }
    try {
        convert(given);
    } catch (nb::python_error& error) {
        if (error.matches(PyExc_TypeError) || error.matches(PyExc_ValueError) || error.matches(PyExc_OverflowError))
            refused_ = nb::borrow(given);
        else
            failure_ = std::current_exception();
    } catch (...) {
        failure_ = std::current_exception();
    }
}

void Reals::convert(nb::handle given) {
    if (PyLong_Check(given.ptr())) {
        scalar_ = PyLong_AsDouble(given.ptr());
        if (scalar_ == -1 && PyErr_Occurred()) throw nb::python_error();
        return;
    }
    if (is_plain_array(given)) {
        look_at(nb::borrow(given));
        if (view_) return;
    }
    if (is_masked(given)) {
        refused_ = nb::borrow(given);
        return;
    }
    const nb::object array = numpy().asarray(given);
    if (nb::cast<bool>(numpy().can_cast(array.attr("dtype"), numpy().float64, "same_kind")))
        look_at(numpy().asarray(array, numpy().float64));
    else
        refused_ = array;
}

/// Leaves `view_` empty where the array is not one of native doubles.
void Reals::look_at(nb::object array) {
    auto view = std::make_unique<Py_buffer>();
    if (PyObject_GetBuffer(array.ptr(), view.get(), PyBUF_STRIDED_RO | PyBUF_FORMAT) != 0) {
        PyErr_Clear();  // of an array of dates, which has no format
        return;
    }
    view_.reset(view.release());
    if (!is_native_double(*view_)) {
        view_.reset();
        return;
    }
    array_ = std::move(array);
}

const Reals& Reals::named(const char* name, const char* what) const {
    name_ = name;
    if (failure_) std::rethrow_exception(failure_);
    if (!refused_.is_valid()) return *this;
    if (is_masked(refused_))
        refuse_type(std::string(name) + " must be " + what +
                    ", got a masked array, whose masks would be ignored; numpy.ma.filled puts values in their places, and "
                    "compressed() leaves them out");
    std::string got;
    if (nb::isinstance(refused_, numpy().array_type)) {
        const nb::object shown = numpy().array2string(refused_, nb::arg("threshold") = 4, nb::arg("edgeitems") = 2);
        got = as_printed(nb::object(refused_.attr("dtype"))) + ' ' + as_printed(shown);
    } else {
        got = as_printed(nb::object(refused_.type().attr("__name__")));
        const std::string value = as_typed(refused_);
        got += ' ' + (value.size() <= 80 ? value : value.substr(0, 77) + "...");
    }
    refuse_type(std::string(name) + " must be " + what + ", got " + got);
}

Shape Reals::shape() const {
    if (!view_) return {};
    return {view_->shape, view_->shape + view_->ndim};
}

Py_ssize_t Reals::step(int axis, int ndim) const {
    if (!view_) return 0;
    const int own = axis - (ndim - view_->ndim);
    return own < 0 || view_->shape[own] == 1 ? 0 : view_->strides[own];
}

double Number::named(const char* name) const {
    const Shape shape = given.named(name, "a real number").shape();
    if (!shape.empty()) refuse_type(std::string(name) + " must be a real number, got an array of shape " + text(shape));
    double value;
    std::memcpy(&value, given.data(), sizeof value);
    return value;
}

std::size_t Name::among(const char* name, std::span<const char* const> names) const {
    std::string listed;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (PyUnicode_Check(given.ptr()) && PyUnicode_CompareWithASCIIString(given.ptr(), names[i]) == 0) return i;
        listed += (i ? ", " : "") + std::string(names[i]);
    }
    std::string message = std::string(name) + " must be one of " + listed + ", got " + as_typed(given);
    if (PyUnicode_Check(given.ptr())) {
        nb::list all;
        for (const char* each : names) all.append(each);
        const nb::object near = nb::module_::import_("difflib").attr("get_close_matches")(given, all, 1);
        if (nb::len(near) > 0) message += "; did you mean " + as_typed(nb::object(near[0])) + "?";
    }
    throw std::invalid_argument(message);
}

int Threads::number() const {
    if (given.is_none()) return 0;
    const double value = Number{Reals(given)}.named("threads");
    if (!(value >= 1 && value <= threads_limit && value == static_cast<int>(value)))
        require(
            Refusal{.reason = Refusal::Reason::whole, .name = "threads", .value = value, .least = 1, .most = threads_limit});
    return static_cast<int>(value);
}

Output::Output(const Shape& shape) : size_(size_of(shape)) {
    if (shape.empty()) return;
    array_ = new_array(shape);
    if (PyObject_GetBuffer(array_.ptr(), &view_, PyBUF_CONTIG) != 0) throw nb::python_error();
}

Output::~Output() {
    if (view_.obj) PyBuffer_Release(&view_);
}

nb::object Output::value() const { return array_.is_valid() ? array_ : numpy().float64(scalar_); }

nb::object Output::rows_last() const { return numpy().moveaxis(array_, 0, -1); }

nb::object as_int8(const nb::object& values) { return values.attr("astype")("int8"); }

Shape broadcast(std::span<const Reals* const> arguments) {
    std::vector<Shape> shapes;
    for (const Reals* each : arguments)
        if (!each->is_scalar()) shapes.push_back(each->shape());
    Shape common;
    for (const Shape& shape : shapes) common.insert(common.begin(), std::max(common.size(), shape.size()) - common.size(), 1);
    for (const Shape& shape : shapes) {
        const std::size_t lead = common.size() - shape.size();
        for (std::size_t i = 0; i < shape.size(); ++i) {
            Py_ssize_t& length = common[lead + i];
            if (length == 1) length = shape[i];
            if (shape[i] == 1 || shape[i] == length) continue;
            std::string message = "arguments cannot be broadcast together: ";
            const char* comma = "";
            for (const Reals* each : arguments) {
                if (each->is_scalar()) continue;
                message += comma + std::string(each->name()) + " has shape " + text(each->shape());
                comma = ", ";
            }
            throw std::invalid_argument(message);
        }
    }
    return common;
}

}  // namespace pendula::python
