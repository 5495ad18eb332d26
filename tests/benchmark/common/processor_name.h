#pragma once

#include <string>

namespace graze::benchmark {

/// The processor, as the system names it.
std::string processor_name();

}  // namespace graze::benchmark
