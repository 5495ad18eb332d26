#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/benchmark/world_batches/questions.h"

namespace graze::benchmark {

/// Another library's world of the same bodies, asked in a loop.
class BatchPeer {
 public:
  virtual ~BatchPeer() = default;
  virtual std::string name() const = 0;
  /// How many elements meet something, or how many of the nearest bodies touch; nothing if the
  /// library has no such question.
  virtual std::optional<std::size_t> ask(Question question, const Questions& all) = 0;
};

std::unique_ptr<BatchPeer> make_bullet(const Questions& all);
std::unique_ptr<BatchPeer> make_fcl(const Questions& all);

}  // namespace graze::benchmark
