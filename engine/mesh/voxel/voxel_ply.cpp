#include <graze/engine/mesh/voxel/voxel_format.h>
#include <bit>
#include <string>

namespace graze::mesh_io {
namespace {

/// Puts little-endian bytes, whatever the machine.
template <typename Bits>
char* put(char* at, Bits bits) {
  for (std::size_t i = 0; i < sizeof(Bits); ++i)
    *at++ = static_cast<char>(bits >> (8 * i) & 0xff);
  return at;
}

class PlyBoxFile : public BoxFile {
 public:
  PlyBoxFile(files::OutputFile& file, const VoxelGrid& grid, BoxCounts counts)
      : file_(file), grid_(grid) {
    file_.append("ply\nformat binary_little_endian 1.0\ncomment voxels, metres\nelement vertex " +
                 std::to_string(counts.corners) +
                 "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                 std::to_string(counts.quads) +
                 "\nproperty list uchar uint vertex_indices\nend_header\n");
  }

  void add_corner(const std::array<std::uint32_t, 3>& planes) override {
    std::array<char, 24> bytes;
    char* end = bytes.data();
    for (int axis = 0; axis < 3; ++axis)
      end = put(end, std::bit_cast<std::uint64_t>(grid_.plane(axis, planes[axis])));
    file_.append({bytes.data(), end});
  }

  void add_quad(const std::array<std::uint64_t, 4>& corners) override {
    std::array<char, 17> bytes{4};
    char* end = bytes.data() + 1;
    for (const std::uint64_t corner : corners)
      end = put(end, static_cast<std::uint32_t>(corner));
    file_.append({bytes.data(), end});
  }

 private:
  files::OutputFile& file_;
  const VoxelGrid& grid_;
};

}  // namespace

std::unique_ptr<BoxFile> begin_ply(files::OutputFile& file, const VoxelGrid& grid,
                                   BoxCounts counts) {
  return std::make_unique<PlyBoxFile>(file, grid, counts);
}

}  // namespace graze::mesh_io
