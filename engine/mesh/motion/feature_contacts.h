#pragma once

#include <graze/engine/mesh/motion/mesh_path_data.h>

namespace graze {

/// The earliest contact of those that it is told of.
class EarliestContact {
 public:
  explicit EarliestContact(const FirstContactSettings& settings) : settings_(settings) {}

  /// Asks all pairs of features that the pair of triangles has to ask, and whether they cross at
  /// t = 0; of one mesh with itself, where features in common meet nothing.
  void ask(const MeshPathAccess::Data& a, const MeshPathAccess::Data& b, TrianglePair pair);
  void ask_of_one_mesh(const MeshPathAccess::Data& mesh, TrianglePair pair);

  const std::optional<MeshFirstContact>& first() const { return first_; }

 private:
  enum class Meshes { Two, One };
  void ask_pair(const MeshPathAccess::Data& a, const MeshPathAccess::Data& b, TrianglePair pair,
                Meshes meshes);
  void ask_start(const MeshPathAccess::Data& a, const MeshPathAccess::Data& b, TrianglePair pair,
                 bool have_common_vertices);
  template <typename FeatureA, typename FeatureB>
  void ask_features(const FeatureA& a, const FeatureB& b, const MeshFirstContact& which);
  void take(const MeshFirstContact& contact);

  FirstContactSettings settings_;
  std::optional<MeshFirstContact> first_;
};

}  // namespace graze
