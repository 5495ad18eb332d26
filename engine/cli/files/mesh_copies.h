#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include <graze/engine/cases/case.h>

namespace graze::cli {

/// Keeps the files of two meshes beside cases that are about all of them: cases of whole meshes
/// would be megabytes each.
class MeshCopies {
 public:
  /// Takes the folder of the cases; the copies go into a folder below it.
  MeshCopies(std::filesystem::path folder, std::string mesh_a, std::string mesh_b)
      : folder_(std::move(folder)), mesh_a_(std::move(mesh_a)), mesh_b_(std::move(mesh_b)) {}

  /// Returns the case with its meshes named by files there, which are copied if need be: their
  /// names hold a part of their sums. A case stays as it was where that cannot be done, or where it
  /// has no mesh.
  Case refer(Case query) const;

 private:
  void refer(CaseShape& shape, const std::string& file) const;

  std::filesystem::path folder_;
  std::string mesh_a_;
  std::string mesh_b_;
};

}  // namespace graze::cli
