// What a job costs before it does anything: the least work worth handing to parallel_for is some
// hundred times this.

#include <benchmark/benchmark.h>
#include <mien/parallel.h>

namespace {

void EmptyJobs(benchmark::State& state) {
  const int jobs = 1000;
  const mien::Threads threads{.count = int(state.range(0))};
  for (auto _ : state) {
    mien::parallel_for(jobs, threads, [](int i) { benchmark::DoNotOptimize(i); });
  }
  state.SetItemsProcessed(state.iterations() * jobs);
}
BENCHMARK(EmptyJobs)->ArgName("threads")->Arg(1)->Arg(2)->Arg(0)->UseRealTime();

}  // namespace
