#pragma once

#include <span>
#include <vector>

#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// Keeps engines for many cases in a row: a pair of meshes that was asked about before is not
/// loaded again. The last few pairs are kept, which are the same if they are handles to the same
/// meshes (CaseMeshes). The engines must outlive it. As many threads may ask them as before.
class SharedLoads {
 public:
  explicit SharedLoads(std::span<const EngineEntry> engines);

  /// Returns the engines, under the names of those that this was made of.
  std::span<const EngineEntry> engines() const { return engines_; }

 private:
  std::vector<EngineEntry> engines_;
};

}  // namespace graze::compare
