#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/files/file_error.h>
#include <graze/engine/files/output_file.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/voxel/voxel_corners.h>
#include <graze/engine/mesh/voxel/voxel_format.h>
#include <graze/engine/mesh/write_voxels.h>
#include <iterator>
#include <string>

namespace graze {
namespace {

/// The largest number of vertices that a Mesh can have, and so that load_mesh() can read.
constexpr std::uint64_t kMaxCorners = 0x7fffffff;

/// The quads of a box, counter-clockwise seen from outside; corner x + 2 y + 4 z of the box is at
/// x, y, z in {0, 1}.
constexpr int kQuads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                              {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

bool is_within(const VoxelGrid& grid, const Voxel& voxel) {
  return voxel.i < grid.counts[0] && voxel.j < grid.counts[1] && voxel.k < grid.counts[2];
}

void check_voxels(const Voxels& voxels) {
  voxels.grid.check();
  if (voxels.empty()) throw InputError("no voxels to write");
  for (std::size_t n = 0; n < voxels.size(); ++n) {
    if (!is_within(voxels.grid, voxels.voxels[n])) {
      throw InputError("voxel " + std::to_string(n) + ": not within the grid",
                       {.element = "voxel", .index = n});
    }
    if (n > 0 && !(voxels.voxels[n - 1] < voxels.voxels[n])) {
      throw InputError("voxel " + std::to_string(n) + ": not above the one before it",
                       {.element = "voxel", .index = n});
    }
  }
}

void check_count(const std::filesystem::path& path, std::uint64_t count, std::uint64_t most,
                 const char* what) {
  if (count <= most) return;
  const std::string name = mesh_io::printable(path.string());
  mesh_io::fail({name, {}}, std::to_string(count) + " " + what + ", a mesh has room for " +
                                std::to_string(most));
}

/// Adds to a file of boxes, and reports how far it has come.
class ReportingBoxFile {
 public:
  ReportingBoxFile(mesh_io::BoxFile& boxes, mesh_io::BoxCounts counts,
                   const VoxelWriteSettings& settings)
      : boxes_(boxes), settings_(settings), total_(counts.corners + counts.quads) {}

  void add_corner(const std::array<std::uint32_t, 3>& planes) {
    boxes_.add_corner(planes);
    count();
  }

  void add_quad(const std::array<std::uint64_t, 4>& corners) {
    boxes_.add_quad(corners);
    count();
  }

 private:
  static constexpr std::uint64_t kInterval = std::uint64_t{1} << 16;

  void count() {
    ++done_;
    const bool is_due = done_ % kInterval == 0 || done_ == total_;
    if (!is_due || !settings_.on_progress) return;
    bvh::in_users_arithmetic([&] { settings_.on_progress(done_, total_); });
  }

  mesh_io::BoxFile& boxes_;
  const VoxelWriteSettings& settings_;
  std::uint64_t total_;
  std::uint64_t done_ = 0;
};

void add_quads(const Voxels& voxels, const mesh_io::VoxelCorners& corners,
               ReportingBoxFile& boxes) {
  mesh_io::VoxelCornerNumbers numbers(corners);
  for (const Voxel& voxel : voxels) {
    const std::array<std::uint64_t, 8>& number = numbers.of(voxel);
    for (const auto& quad : kQuads)
      boxes.add_quad({number[quad[0]], number[quad[1]], number[quad[2]], number[quad[3]]});
  }
}

}  // namespace

void write_voxels(const std::filesystem::path& path, const Voxels& voxels,
                  const VoxelWriteSettings& settings) {
  bvh::in_standard_arithmetic([&] {
    const mesh_io::VoxelFormat& format = mesh_io::voxel_format_of(path);
    check_voxels(voxels);
    check_count(path, voxels.size(), kMaxWrittenVoxels, "voxels");
    const mesh_io::VoxelCorners corners(voxels);
    check_count(path, corners.size(), kMaxCorners, "corners");
    try {
      files::OutputFile file(path);
      const mesh_io::BoxCounts counts{corners.size(), std::size(kQuads) * voxels.size()};
      const auto boxes = format.begin(file, voxels.grid, counts);
      ReportingBoxFile reporting(*boxes, counts, settings);
      corners.for_each([&](const auto& planes) { reporting.add_corner(planes); });
      add_quads(voxels, corners, reporting);
      file.finish();
    } catch (const files::FileError& error) {
      throw MeshError(error.what(), error.place());
    }
  });
}

}  // namespace graze
