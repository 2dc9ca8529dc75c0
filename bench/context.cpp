// The versions of what is measured, for the head of docs/benchmarks.md.
#include <benchmark/benchmark.h>
#include <gsl/gsl_version.h>

#include <boost/version.hpp>
#include <string>

#include "kernels/dispatch.hpp"

namespace {

[[maybe_unused]] const bool is_added = [] {
#ifdef __clang__
    benchmark::AddCustomContext("Compiler", "clang " __clang_version__);
#else
    benchmark::AddCustomContext("Compiler", "g++ " __VERSION__);
#endif
    benchmark::AddCustomContext("Boost",
                                std::to_string(BOOST_VERSION / 100000) + '.' + std::to_string(BOOST_VERSION / 100 % 1000));
    benchmark::AddCustomContext("GSL", GSL_VERSION);
    benchmark::AddCustomContext("pendula", PENDULA_VERSION);
    benchmark::AddCustomContext("kernels", pendula::kernels::dispatch().name);
    return true;
}();

}  // namespace
