#include <graze/engine/cases/case_error.h>
#include <graze/engine/cases/case_mesh_file.h>
#include <graze/engine/cases/sha256.h>
#include <graze/engine/mesh/io/file_bytes.h>
#include <graze/engine/mesh/io/source.h>
#include <graze/engine/mesh/load_mesh.h>

#include <algorithm>
#include <system_error>

namespace graze {
namespace {

namespace fs = std::filesystem;

/// The file's path, once it is sure to lie in the folder.
fs::path find_inside(const fs::path& folder, const std::string& path) {
  const std::string quoted = mesh_io::quoted(path);
  const fs::path relative(path);
  if (path.empty() || path.find('\0') != path.npos) {
    throw CaseError("the path " + quoted + " names no file");
  }
  if (!relative.is_relative() || relative.has_root_name()) {
    throw CaseError("the path " + quoted + " is absolute; files lie in the folder of the case");
  }
  if (std::find(relative.begin(), relative.end(), "..") != relative.end() ||
      path.find('\\') != path.npos) {
    throw CaseError("the path " + quoted + " leads out of the folder of the case");
  }
  std::error_code error;
  const fs::path root = fs::canonical(folder.empty() ? "." : folder, error);
  if (error) throw CaseError(folder.string() + ": " + error.message());
  fs::path real = fs::weakly_canonical(root / relative, error);
  if (error) throw CaseError(quoted + ": " + error.message());
  const auto [end_of_root, ignored] =
      std::mismatch(root.begin(), root.end(), real.begin(), real.end());
  if (end_of_root != root.end()) {
    throw CaseError("the path " + quoted + " is a link out of the folder of the case");
  }
  return real;
}

std::string hash_of(const fs::path& file, const std::string& name) {
  mesh_io::require_regular_file(file, name);
  return cases::sha256_of(mesh_io::read_file(file, name));
}

}  // namespace

Mesh load_case_mesh(const CaseMeshFile& file, const fs::path& folder) {
  const fs::path path = find_inside(folder, file.path);
  const std::string hash = hash_of(path, mesh_io::printable(file.path));
  if (hash != file.sha256) {
    throw CaseError("the file " + mesh_io::quoted(file.path) + " has the SHA-256 " + hash +
                    ", not " + file.sha256);
  }
  return load_mesh(path);
}

CaseMesh case_mesh_of_file(const fs::path& folder, const std::string& path, const Pose& pose) {
  fs::path real = find_inside(folder, path);
  CaseMesh mesh(load_mesh(real), pose);
  mesh.file = {path, hash_of(real, mesh_io::printable(path))};
  return mesh;
}

}  // namespace graze
