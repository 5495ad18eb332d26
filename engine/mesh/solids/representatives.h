#pragma once

// This is private to engine/mesh.

#include <graze/engine/mesh/mesh.h>

#include <cstdint>
#include <functional>
#include <set>
#include <unordered_set>
#include <vector>

namespace graze {

/// The triangles of a mesh of which it is known whether they touch something, and some that stand
/// for all others: triangles that touch nothing and hang together by such triangles lie on one side
/// of it.
class Representatives {
 public:
  explicit Representatives(const Mesh& mesh) : mesh_(mesh) {}

  void add_touched(std::uint32_t index) { touched_.insert(index); }

  /// Returns the triangles that touch something, ascending.
  const std::set<std::uint32_t>& touched() const { return touched_; }

  /// Returns one triangle at least of each set of connected untouched ones that has one for which
  /// `is_wanted(index)`, ascending. Those that are not wanted connect. It is to be called once,
  /// when all touched ones are known.
  std::set<std::uint32_t> untouched(const std::function<bool(std::uint32_t)>& is_wanted);

  /// Returns all wanted triangles that an untouched one stands for, itself among them; ascending.
  std::set<std::uint32_t> connected(std::uint32_t index,
                                    const std::function<bool(std::uint32_t)>& is_wanted) const;

 private:
  /// Adds a wanted triangle that hangs together with the vertex, unless the vertex has been seen.
  void add_near(std::uint32_t vertex, const std::function<bool(std::uint32_t)>& is_wanted,
                std::set<std::uint32_t>& found);

  const Mesh& mesh_;
  std::set<std::uint32_t> touched_;
  std::unordered_set<std::uint32_t> seen_;  ///< welded vertices
};

}  // namespace graze
