#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include <graze/engine/cases/case.h>

namespace graze::cli {

/// The files of two meshes beside cases that are about all of them: cases of whole meshes would be
/// megabytes each.
class MeshCopies {
 public:
  /// `folder` is that of the cases; the copies go into a folder below it.
  MeshCopies(std::filesystem::path folder, std::string mesh_a, std::string mesh_b)
      : folder_(std::move(folder)), mesh_a_(std::move(mesh_a)), mesh_b_(std::move(mesh_b)) {}

  /// The case with its meshes named by files there, which are copied if need be: their names hold a
  /// part of their sums. As it was where that cannot be done, and for what is no mesh.
  Case refer(Case query) const;

 private:
  void refer(CaseShape& shape, const std::string& file) const;

  std::filesystem::path folder_;
  std::string mesh_a_;
  std::string mesh_b_;
};

}  // namespace graze::cli
