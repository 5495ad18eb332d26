#include <graze/bvh/error.h>
#include <graze/engine/cases/case_mesh_file.h>
#include <graze/engine/cases/case_meshes.h>
#include <graze/engine/cases/text/inside_folder.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/file_bytes.h>
#include <graze/engine/mesh/load_mesh.h>

namespace graze {
namespace {

namespace fs = std::filesystem;

std::string hash_of(const fs::path& file, const std::string& name) {
  mesh_io::require_regular_file(file, name);
  return files::sha256_of(mesh_io::read_file(file, name));
}

void require_hash(const CaseMeshFile& file, const std::string& hash) {
  if (hash == file.sha256) return;
  throw CaseError("the file " + mesh_io::quoted(file.path) + " has the SHA-256 " + hash + ", not " +
                  file.sha256);
}

}  // namespace

Mesh load_case_mesh(const CaseMeshFile& file, const fs::path& folder) {
  const fs::path path = cases::find_inside(folder, file.path, "case");
  require_hash(file, hash_of(path, mesh_io::printable(file.path)));
  return load_mesh(path);
}

Mesh CaseMeshes::load(const CaseMeshFile& file, const fs::path& folder) {
  const fs::path path = cases::find_inside(folder, file.path, "case");
  auto at = known_.find(path);
  if (at == known_.end()) {
    at = known_.emplace(path, Known{file.sha256, load_case_mesh(file, folder)}).first;
  }
  require_hash(file, at->second.sha256);
  return at->second.mesh;
}

CaseMesh case_mesh_of_file(const fs::path& folder, const std::string& path, const Pose& pose) {
  const fs::path real = cases::find_inside(folder, path, "case");
  CaseMesh mesh(load_mesh(real), pose);
  mesh.file = {path, hash_of(real, mesh_io::printable(path))};
  return mesh;
}

}  // namespace graze
