#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/text_cursor.h>
#include <graze/engine/mesh/voxel/voxel_format.h>
#include <string>

namespace graze::mesh_io {
namespace {

constexpr std::array<VoxelFormat, 2> kFormats = {{{".obj", begin_obj}, {".ply", begin_ply}}};

}  // namespace

const VoxelFormat& voxel_format_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  std::string why =
      extension.empty() ? "no extension" : "unknown extension " + mesh_io::quoted(extension);
  why += ", voxels are written to";
  for (const VoxelFormat& format : kFormats) {
    if (is_keyword(extension, format.extension)) return format;
    why += ' ';
    why += format.extension;
  }
  const std::string name = printable(path.string());
  fail({name, {}}, why);
}

}  // namespace graze::mesh_io
