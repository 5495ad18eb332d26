#include "tests/benchmark/common/processor_name.h"

#include <fstream>

namespace graze::benchmark {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  }
  return "unknown";
}

}  // namespace graze::benchmark
