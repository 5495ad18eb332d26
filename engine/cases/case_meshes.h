#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <graze/engine/cases/case.h>

namespace graze {

/// Meshes of files that several cases name: each file is read once, however many cases are about
/// it, and their meshes are handles to one. For one thread at a time.
class CaseMeshes {
 public:
  /// As load_case_mesh(), and with its errors. A file that was read before is not read again,
  /// whatever has become of it since.
  Mesh load(const CaseMeshFile& file, const std::filesystem::path& folder);

 private:
  struct Known {
    std::string sha256;
    Mesh mesh;
  };
  std::map<std::filesystem::path, Known> known_;
};

}  // namespace graze
