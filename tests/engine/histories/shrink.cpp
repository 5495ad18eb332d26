#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/engine/histories/player.h"

namespace graze::tests {
namespace {

History without(const History& history, std::size_t first, std::size_t count) {
  History rest{history.setting, {}};
  const auto& all = history.operations;
  const auto at = static_cast<std::ptrdiff_t>(first);
  const auto end = static_cast<std::ptrdiff_t>(std::min(first + count, all.size()));
  rest.operations.assign(all.begin(), all.begin() + at);
  rest.operations.insert(rest.operations.end(), all.begin() + end, all.end());
  return rest;
}

}  // namespace

History shrunk(History history, Fault fault) {
  const auto cut = [&](const Failure& failure) { history.operations.resize(failure.at + 1); };
  if (const auto failure = play(history, nullptr, fault)) cut(*failure);
  for (std::size_t length = std::max<std::size_t>(1, history.operations.size() / 2);; length /= 2) {
    for (std::size_t first = 0; first < history.operations.size();) {
      const History rest = without(history, first, length);
      const auto failure = play(rest, nullptr, fault);
      if (failure) {
        history = rest;
        cut(*failure);
      } else {
        first += length;
      }
    }
    if (length == 1) return history;
  }
}

std::string keep(const History& history, const std::string& name) {
  const std::filesystem::path folder = GRAZE_FAILED_HISTORIES_DIR;
  std::filesystem::create_directories(folder);
  const std::string path = (folder / (name + ".txt")).string();
  std::ofstream out(path);
  write_history(history, out);
  std::printf(
      "%zu operations that fail are in %s; play them again with\n"
      "  GRAZE_HISTORY=%s ctest --test-dir build/release -R HistoriesKept.PlaysAFile\n",
      history.operations.size(), path.c_str(), path.c_str());
  return path;
}

}  // namespace graze::tests
