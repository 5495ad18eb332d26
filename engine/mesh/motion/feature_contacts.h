#pragma once

#include <graze/engine/mesh/motion/mesh_path_data.h>

#include <optional>
#include <vector>

namespace graze {

/// The contacts that are kept: the earliest of all, or of each pair of features its first.
enum class KeptContacts { Earliest, All };

/// Gathers the contacts of the pairs of triangles that it is told of.
class FeatureContacts {
 public:
  FeatureContacts(const FirstContactSettings& settings, KeptContacts kept)
      : settings_(settings), kept_(kept) {}

  /// Ask all pairs of features that the pair of triangles has to ask, and whether they cross at the
  /// start. The second is for one mesh with itself, where features in common meet nothing.
  void ask(const MeshPathAccess::Data& a, const MeshPathAccess::Data& b, TrianglePair pair);
  void ask_of_one_mesh(const MeshPathAccess::Data& mesh, TrianglePair pair);

  /// Returns the earliest contact.
  std::optional<MeshFirstContact> first() const {
    return found_.empty() ? std::nullopt : std::optional(found_.front());
  }
  /// Returns all contacts, by pairs of triangles, then kinds of features, then their places.
  /// Nothing may be asked afterwards.
  std::vector<MeshFirstContact> take_all();

 private:
  enum class Meshes { Two, One };
  void ask_pair(const MeshPathAccess::Data& a, const MeshPathAccess::Data& b, TrianglePair pair,
                Meshes meshes);
  void ask_start(const MeshPathAccess::Data& a, const MeshPathAccess::Data& b, TrianglePair pair,
                 bool have_common_vertices);
  template <typename FeatureA, typename FeatureB>
  void ask_features(const FeatureA& a, const FeatureB& b, const MeshFirstContact& which);
  void take(const MeshFirstContact& contact);

  /// Returns the last time at which contacts are looked for.
  double limit() const {
    return kept_ == KeptContacts::All || found_.empty() ? 1 : found_.front().time;
  }

  FirstContactSettings settings_;
  KeptContacts kept_;
  std::vector<MeshFirstContact> found_;  ///< one contact, or all
};

}  // namespace graze
