#pragma once

#include <cstddef>
#include <functional>

namespace graze::compare {

/// Calls `work` on as many threads (0: as there are processors) as there is work for, this one
/// among them, and then throws what the first that failed threw. Each calls it once; `stop` is to
/// end the others' loops.
void run_on_threads(std::size_t threads, std::size_t most, const std::function<void()>& work,
                    const std::function<void()>& stop);

}  // namespace graze::compare
