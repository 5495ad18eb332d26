#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <graze/engine/cases/case.h>

namespace graze {

/// Keeps meshes of files that several cases name: each file is read once, however many cases are
/// about it, and their meshes are handles to one. One thread may use it at a time.
class CaseMeshes {
 public:
  /// Does what load_case_mesh() does, with its errors. A file that was read before is not read
  /// again, whatever has become of it since.
  Mesh load(const CaseMeshFile& file, const std::filesystem::path& folder);

 private:
  struct Known {
    std::string sha256;
    Mesh mesh;
  };
  std::map<std::filesystem::path, Known> known_;
};

}  // namespace graze
