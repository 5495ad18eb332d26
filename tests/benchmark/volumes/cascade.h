#pragma once

#include <graze/engine/mesh/pair.h>

#include <cstdint>

namespace graze::benchmark {

/// Two separations in a row: the first is cheap, the second is asked about what the first lets
/// through. By what is measured here it saves nothing, so that the library has none.
template <typename First, typename Second>
class Cascade {
 public:
  Cascade(const First& first, const Second& second) : first_(first), second_(second) {}

  bool are_apart(std::uint32_t a, std::uint32_t b) const {
    return first_.are_apart(a, b) || second_.are_apart(a, b);
  }
  bool is_first_larger(std::uint32_t a, std::uint32_t b) const {
    return first_.is_first_larger(a, b);
  }

 private:
  First first_;
  Second second_;
};

/// What intersects() and find_triangle_pairs() answer, spheres being tried before `second`.
bool intersects_by_cascade(const PlacedMeshView& a, const PlacedMeshView& b, Volume second,
                           Work& work);
TrianglePairs find_pairs_by_cascade(const PlacedMeshView& a, const PlacedMeshView& b, Volume second,
                                    Work& work);

}  // namespace graze::benchmark
