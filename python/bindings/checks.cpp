#include "checks.hpp"

#include <cmath>
#include <stdexcept>

#include "broadcast.hpp"

namespace pendula::python {

namespace {

/// Without a branch for each element, so that looking through a large array costs no more than reading it.
bool are_finite(const char* at, const Axis<1>& axis) {
    bool found = false;
    for (Py_ssize_t i = 0; i < axis.length; ++i) found |= !std::isfinite(load(at + i * axis.step[0]));
    return !found;
}

std::string index_text(Py_ssize_t flat, const Shape& shape) {
    std::string text;
    for (std::size_t i = shape.size(); i-- > 0; flat /= shape[i])
        text = std::to_string(flat % shape[i]) + (text.empty() ? "" : ", ") + text;
    return shape.size() == 1 ? text + ',' : text;
}

}  // namespace

void require_all(const std::string& name, Operand& values, Rule rule) {
    const Shape shape = values.shape();
    const int ndim = static_cast<int>(shape.size());
    std::vector<Axis<1>> axes;
    for (int d = 0; d < ndim; ++d) axes.push_back({shape[static_cast<std::size_t>(d)], {values.step(d, ndim)}});
    const Axis<1> last = axes.empty() ? Axis<1>{} : axes.back();
    if (!axes.empty()) axes.pop_back();

    Py_ssize_t passed = 0;
    walk<1>(axes, {values.data()}, [&](const Places<1>& at) {
        if (rule == Rule::finite && are_finite(at[0], last)) {
            passed += last.length;
            return;
        }
        for (Py_ssize_t i = 0; i < last.length; ++i, ++passed) {
            const double value = load(at[0] + i * last.step[0]);
            if (satisfies(rule, value)) continue;
            const std::string where = ndim == 0 ? "" : " at index (" + index_text(passed, shape) + ')';
            throw std::invalid_argument(complaint(name, value, rule) + where);
        }
    });
}

}  // namespace pendula::python
