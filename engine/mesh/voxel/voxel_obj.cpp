#include <graze/engine/mesh/voxel/voxel_format.h>
#include <charconv>
#include <string>
#include <vector>

namespace graze::mesh_io {
namespace {

/// Returns a double in 17 digits, which identify it. Unlike printf, to_chars knows no locale.
std::string text_of(double value) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 17);
  return {text.data(), end.ptr};
}

class ObjBoxFile : public BoxFile {
 public:
  ObjBoxFile(files::OutputFile& file, const VoxelGrid& grid) : file_(file) {
    for (int axis = 0; axis < 3; ++axis) {
      for (std::uint32_t i = 0; i <= grid.counts[axis]; ++i)
        planes_[axis].push_back(' ' + text_of(grid.plane(axis, i)));
    }
    file_.append("# voxels, metres\n");
  }

  void add_corner(const std::array<std::uint32_t, 3>& planes) override {
    file_.append("v");
    for (int axis = 0; axis < 3; ++axis)
      file_.append(planes_[axis][planes[axis]]);
    file_.append("\n");
  }

  void add_quad(const std::array<std::uint64_t, 4>& corners) override {
    std::array<char, 96> line{'f'};
    char* end = line.data() + 1;
    for (const std::uint64_t corner : corners) {
      *end++ = ' ';
      end = std::to_chars(end, line.data() + line.size(), corner + 1).ptr;
    }
    *end++ = '\n';
    file_.append({line.data(), end});
  }

 private:
  files::OutputFile& file_;
  std::array<std::vector<std::string>, 3> planes_;  ///< the planes as text, which corners repeat
};

}  // namespace

std::unique_ptr<BoxFile> begin_obj(files::OutputFile& file, const VoxelGrid& grid, BoxCounts) {
  return std::make_unique<ObjBoxFile>(file, grid);
}

}  // namespace graze::mesh_io
