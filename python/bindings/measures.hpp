// What the package offers of the core's measures: which settings each has, and in which words its choices are.
#pragma once

#include <array>

#include "pendula/measure.hpp"

namespace pendula::python {

/// The methods of the strobe map, the default first.
inline constexpr Method strobe_methods[] = {Method::taylor, Method::rk4};
inline constexpr const char* strobe_method_names[] = {method_names[static_cast<int>(Method::taylor)],
                                                      method_names[static_cast<int>(Method::rk4)]};

constexpr bool uses(const Setting& setting, Measure measure) noexcept { return setting.measures & bits_of({measure}); }

/// A setting of one measure, with the default that it has there.
struct OwnSetting {
    const Setting* setting;
    double otherwise;
};

}  // namespace pendula::python
