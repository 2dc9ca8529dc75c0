#include "calls.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

#include "broadcast.hpp"

namespace pendula::python {

bool Signals::go_on() {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return true;
    last_ = now;
    const nb::gil_scoped_acquire held;
    return PyErr_CheckSignals() == 0;
}

Members::Members(const Pendulums& pendulums, std::span<const NamedReals> others)
    : pendulums_(pendulums), others_(others.begin(), others.end()) {
    std::vector<const Reals*> arguments;
    for (const Reals& values : pendulums) arguments.push_back(&values);
    for (const NamedReals& other : others_) arguments.push_back(other.values);
    shape_ = broadcast(arguments);
    ensemble_.size = size_of(shape_);
    for (std::size_t k = 0; k < parameter_count; ++k) ensemble_.*parameters[k].column = column(pendulums[k]);
}

Column column_of(const Reals& values, const Shape& shape, std::vector<double>& copy) {
    if (values.size() == 1) return load(values.data());
    const int ndim = static_cast<int>(shape.size());
    std::vector<Axis<1>> axes;
    bool is_contiguous = reinterpret_cast<std::uintptr_t>(values.data()) % alignof(double) == 0;
    Py_ssize_t step = sizeof(double);
    for (int d = ndim; d-- > 0;) {
        const Py_ssize_t length = shape[static_cast<std::size_t>(d)];
        axes.insert(axes.begin(), {length, {values.step(d, ndim)}});
        is_contiguous = is_contiguous && (length == 1 || values.step(d, ndim) == step);
        step *= length;
    }
    if (is_contiguous) return std::span(reinterpret_cast<const double*>(values.data()), size_of(shape));
    copy.reserve(size_of(shape));
    walk<1>(axes, {const_cast<char*>(values.data())}, [&](const Places<1>& at) {
        copy.push_back(load(at[0]));
        return true;
    });
    return std::span<const double>(copy);
}

Shape Members::with_rows(std::size_t rows) const {
    Shape all{static_cast<Py_ssize_t>(rows)};
    all.insert(all.end(), shape_.begin(), shape_.end());
    return all;
}

void Members::require(const Refusal& refusal) const {
    if (!refusal) return;
    const Reals* argument = nullptr;
    for (std::size_t k = 0; k < parameter_count; ++k)
        if (std::string_view(parameters[k].name) == refusal.name) argument = &pendulums_[k];
    for (const NamedReals& other : others_)
        if (std::string_view(other.name) == refusal.name) argument = other.values;
    // What the core counts follows from arguments of other names here.
    constexpr std::pair<std::string_view, const char*> others_names[] = {{"steps_per_row", "every/dt"},
                                                                         {"steps_to_first", "t[0]/dt"},
                                                                         {"history_rows", "rows"},
                                                                         {"swept", "the parameter along the last axis"}};
    const char* name = "";
    for (const auto& [core, own] : others_names)
        if (core == refusal.name) name = own;
    if (refusal.reason == Refusal::Reason::memory) throw std::bad_alloc();
    Refusal alone = refusal;
    alone.member = Refusal::no_member;
    const std::string description = describe(alone, Language::en, name);
    throw std::invalid_argument(refusal.member == Refusal::no_member ? description
                                                                     : at_place(description, argument, shape_, refusal.member));
}

std::string at_place(const std::string& description, const Reals* argument, const Shape& shape, std::size_t member) {
    if (shape.empty()) return description;
    Shape index(shape.size());
    for (std::size_t d = shape.size(); d-- > 0; member /= static_cast<std::size_t>(shape[d]))
        index[d] = static_cast<Py_ssize_t>(member % static_cast<std::size_t>(shape[d]));
    const Shape own = argument ? argument->shape() : Shape{};
    if (own.empty()) return "pendulum at index " + text(index) + ": " + description;
    index.erase(index.begin(), index.end() - static_cast<std::ptrdiff_t>(own.size()));
    for (std::size_t d = 0; d < own.size(); ++d)
        if (own[d] == 1) index[d] = 0;
    return description + " at index " + text(index);
}

namespace {

/// Without a branch for each element, so that looking through a large array costs no more than reading it.
bool are_finite(const char* at, const Axis<1>& axis) {
    bool found = false;
    for (Py_ssize_t i = 0; i < axis.length; ++i) found |= !std::isfinite(load(at + i * axis.step[0]));
    return !found;
}

}  // namespace

void require_all(const char* name, const Reals& values, Rule rule) {
    const auto require = [&](double value, std::size_t element) {
        if (satisfies(rule, value)) return;
        const Refusal refusal{.reason = Refusal::Reason::interval, .name = name, .value = value, .rule = rule};
        throw std::invalid_argument(at_place(describe(refusal), &values, values.shape(), element));
    };
    if (values.is_scalar()) return require(load(values.data()), 0);
    const Shape shape = values.shape();
    const int ndim = static_cast<int>(shape.size());
    std::vector<Axis<1>> axes;
    for (int d = 0; d < ndim; ++d) axes.push_back({shape[static_cast<std::size_t>(d)], {values.step(d, ndim)}});
    const Axis<1> last = axes.empty() ? Axis<1>{} : axes.back();
    if (!axes.empty()) axes.pop_back();

    std::size_t passed = 0;
    walk<1>(axes, {const_cast<char*>(values.data())}, [&](const Places<1>& at) {
        if (rule != Rule::finite || !are_finite(at[0], last))
            for (Py_ssize_t i = 0; i < last.length; ++i)
                require(load(at[0] + i * last.step[0]), passed + static_cast<std::size_t>(i));
        passed += static_cast<std::size_t>(last.length);
        return true;
    });
}

void warn_of_nan(const char* what, std::span<const double> values, std::size_t rows) {
    if (values.empty()) return;
    const std::size_t size = values.size() / rows;
    std::size_t first = rows, count = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        bool is_nan = false;
        for (const double value : values.subspan(row * size, size)) is_nan |= std::isnan(value);
        if (is_nan && first == rows) first = row;
    }
    if (first == rows) return;
    for (const double value : values.last(size)) count += std::isnan(value);  // once lost, a motion stays so
    const std::string message = std::string(what) + ": the motion of " + std::to_string(count) + " of " + std::to_string(size) +
                                (size == 1 ? " pendulum" : " pendulums") + " leaves the doubles; results are nan" +
                                (rows > 1 ? " from row " + std::to_string(first) + " on" : "");
    constexpr int caller_of_the_package = 3;  // behind the function of the package and what wraps it
    if (PyErr_WarnEx(PyExc_RuntimeWarning, message.c_str(), caller_of_the_package) != 0) throw nb::python_error();
}

}  // namespace pendula::python
