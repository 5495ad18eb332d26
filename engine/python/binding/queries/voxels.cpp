#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/queries/voxels.h>

#include <graze/engine/mesh/voxels.h>
#include <graze/engine/mesh/write_voxels.h>

#include <limits>

namespace graze::python {
namespace {

py::object voxels_of(py::handle mesh, py::handle resolution, py::handle fill, py::handle max_voxels,
                     py::handle threads, py::handle progress, py::handle work_argument) {
  static const ResultType kType("Voxels");
  const Placed placed = placed_mesh(mesh, "mesh");
  if (placed.poses().is_many()) throw InputError("mesh: many poses are not taken");
  const std::size_t count = count_from(resolution, "resolution");
  if (count < 1 || count > 65535)
    throw InputError("resolution: " + std::to_string(count) + " is not from 1 to 65535");
  const VoxelSettings settings{
      .resolution = static_cast<std::uint32_t>(count),
      .fill = word_from<VoxelFill>(fill, "fill",
                                   {{"surface", VoxelFill::Surface}, {"solid", VoxelFill::Solid}}),
      .threads = Batch(threads, progress).threads,
      .max_voxels = max_voxels.is_none() ? std::numeric_limits<std::uint64_t>::max()
                                         : count_from(max_voxels, "max_voxels"),
      .on_progress = watcher(progress)};
  Work* work = work_from(work_argument);
  Voxels found;
  {
    const py::gil_scoped_release released;
    found = find_voxels(placed.mesh_at(0), settings, work);
  }
  const auto& counts = found.grid.counts;
  return kType(array_of(found.grid.origin), found.grid.edge,
               py::make_tuple(counts[0], counts[1], counts[2]),
               array_over<std::uint16_t>(std::move(found.voxels), 3));
}

void write_voxels_of(py::handle path, py::handle argument, py::handle progress) {
  if (PyTuple_Check(argument.ptr()) == 0 || py::len(argument) != 4)
    throw py::type_error("voxels: are no graze.Voxels");
  const auto members = py::reinterpret_borrow<py::tuple>(argument);
  Voxels voxels{.grid = grid_from(members[0], members[1], members[2]), .voxels = {}};
  const auto indices = py::module_::import("graze._arrays")
                           .attr("voxels")(members[3], "indices")
                           .cast<py::array_t<std::uint16_t>>();
  const std::uint16_t* at = indices.data();
  voxels.voxels.reserve(static_cast<std::size_t>(indices.shape(0)));
  for (py::ssize_t i = 0; i < indices.shape(0); ++i, at += 3)
    voxels.voxels.push_back({at[0], at[1], at[2]});
  const std::string file = path_from(path);
  const VoxelWriteSettings settings{.on_progress = watcher(progress)};
  const py::gil_scoped_release released;
  write_voxels(file, voxels, settings);
}

constexpr const char* kVoxelsText =
    R"(find_voxels(mesh, *, resolution=64, fill='surface', max_voxels=None, threads=0, progress=None, work=None)
--

All voxels that a placed mesh's surface touches, exactly, or with `fill` "solid" those inside a closed one, too: Voxels.
`resolution` is how many there are along the longest side of its bounds, 1 to 65535; more than `max_voxels` are an error,
found before they fill the memory.

Raises InputError, and MeshError for the solid of a mesh that is not closed.

>>> voxels = graze.find_voxels(bolt, resolution=8)
>>> voxels.indices.shape[1], max(voxels.counts)
(3, 8)
)";

constexpr const char* kWriteText = R"(write_voxels(path, voxels, *, progress=None)
--

Writes voxels, as find_voxels() returns them, to an OBJ or a PLY file, chosen by its name: each a closed box of six quads.

Raises MeshError, naming the file, for another ending or a file that cannot be written, which then stays as it was; and
InputError for voxels that are not ascending, or none.

>>> graze.write_voxels("voxels.stl", graze.find_voxels(bolt, resolution=8))
Traceback (most recent call last):
    ...
graze.MeshError: voxels.stl: voxels are written to files named .obj or .ply
)";

}  // namespace

VoxelGrid grid_from(py::handle origin, py::handle edge, py::handle counts) {
  if (!PySequence_Check(counts.ptr()) || py::len(counts) != 3)
    throw InputError("counts: are no three whole numbers");
  VoxelGrid grid{
      .origin = vector_from(origin, "origin"), .edge = number_from(edge, "edge"), .counts = {}};
  const auto sequence = py::reinterpret_borrow<py::sequence>(counts);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t count = count_from(sequence[axis], "counts");
    grid.counts[axis] = static_cast<std::uint32_t>(std::min(count, std::size_t{0xffffffff}));
  }
  grid.check();
  return grid;
}

void add_voxels(py::module_& module) {
  module.def("find_voxels", &voxels_of, kVoxelsText, py::arg("mesh"), py::kw_only(),
             py::arg("resolution") = 64, py::arg("fill") = "surface",
             py::arg("max_voxels") = py::none(), py::arg("threads") = 0,
             py::arg("progress") = py::none(), py::arg("work") = py::none());
  module.def("write_voxels", &write_voxels_of, kWriteText, py::arg("path"), py::arg("voxels"),
             py::kw_only(), py::arg("progress") = py::none());
}

}  // namespace graze::python
