// The throughput of this processor: independent multiplications and additions in its widest registers, and nothing else.
#include <benchmark/benchmark.h>

#include "arithmetic/pack.hpp"

namespace {

using Register = pendula::arithmetic::Pack<pendula::arithmetic::register_width>;

/// The numbers of independent chains are large enough to hide the latency of an operation, and small enough to fit in the
/// registers.
template <int products, int sums>
void pipes(benchmark::State& state) {
    constexpr int rounds = 1000;
    Register factor = Register{} + 1.0, step{}, product[products + 1]{}, sum[sums + 1]{};
    benchmark::DoNotOptimize(factor);
    benchmark::DoNotOptimize(step);
    for (auto _ : state) {
        for (int round = 0; round < rounds; ++round) {
            for (int i = 0; i < products; ++i) product[i] = product[i] * factor;
            for (int i = 0; i < sums; ++i) sum[i] = sum[i] + step;
        }
        benchmark::DoNotOptimize(product);
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * rounds * (products + sums) * pendula::arithmetic::register_width);
}
BENCHMARK(pipes<10, 0>)->Name("pipes/multiplications");
BENCHMARK(pipes<0, 10>)->Name("pipes/additions");
BENCHMARK(pipes<5, 5>)->Name("pipes/both");

}  // namespace
