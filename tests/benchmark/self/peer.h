#pragma once

#include <graze/engine/mesh/mesh.h>

#include <cstddef>
#include <memory>

namespace graze::benchmark {

/// Another library's search for the self-intersections of one mesh.
class SelfPeer {
 public:
  virtual ~SelfPeer() = default;

  /// How many pairs of triangles it finds. All that is made for that is made anew each time.
  virtual std::size_t count_pairs() = 0;

  /// Whether there is any. Likewise.
  virtual bool is_any() = 0;
};

#ifdef GRAZE_HAS_CGAL
/// Null for a mesh that CGAL's halfedges cannot hold.
std::unique_ptr<SelfPeer> make_cgal_self(const Mesh& mesh);
#endif

}  // namespace graze::benchmark
