#include <graze/bvh/error.h>
#include <graze/engine/cli/files/case_folder.h>
#include <graze/engine/cli/files/mesh_copies.h>
#include <graze/engine/files/output_file.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/mesh/io/file_bytes.h>

namespace graze::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFolder = "meshes";
constexpr std::size_t kDigits = 12;

}  // namespace

Case MeshCopies::refer(Case query) const {
  refer(query.a, mesh_a_);
  if (query.b) refer(*query.b, mesh_b_);
  return query;
}

void MeshCopies::refer(CaseShape& shape, const std::string& file) const {
  auto* mesh = std::get_if<CaseMesh>(&shape);
  if (mesh == nullptr || file.empty()) return;
  try {
    const fs::path source(file);
    const std::string bytes = mesh_io::read_file(file, file);
    const std::string sum = files::sha256_of(bytes);
    const std::string name = name_part(source.stem().string()) + "-" + sum.substr(0, kDigits) +
                             source.extension().string();
    const fs::path target = folder_ / kFolder / name;
    std::error_code error;
    if (!fs::exists(target, error)) {
      fs::create_directories(target.parent_path(), error);
      files::write_file(target, bytes);
    }
    mesh->file = CaseMeshFile{(fs::path(kFolder) / name).generic_string(), sum};
  } catch (const Error&) {  // then the case holds the mesh itself
  }
}

}  // namespace graze::cli
