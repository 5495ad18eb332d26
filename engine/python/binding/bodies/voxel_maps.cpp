#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/bodies/voxel_maps.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/voxels.h>
#include <graze/engine/python/binding/values/shapes.h>

#include <graze/bvh/error.h>

#include <memory>

namespace graze::python {
namespace {

/// Holds rows (i, j, k), or one.
struct Indices {
  explicit Indices(py::handle argument, const char* name) {
    const auto array = py::module_::import("graze._arrays")
                           .attr("voxels")(argument, name)
                           .cast<py::array_t<std::uint16_t>>();
    const std::uint16_t* at = array.data();
    all.reserve(static_cast<std::size_t>(array.shape(0)));
    for (py::ssize_t i = 0; i < array.shape(0); ++i, at += 3)
      all.push_back({at[0], at[1], at[2]});
  }

  std::vector<Voxel> all;
};

Voxel voxel_from(py::handle argument, const char* name) {
  const Indices indices(argument, name);
  if (indices.all.size() != 1) throw InputError(std::string(name) + ": is one voxel (i, j, k)");
  return indices.all[0];
}

py::object array_of_voxels(std::vector<Voxel>&& voxels) {
  return array_over<std::uint16_t>(std::move(voxels), 3);
}

std::unique_ptr<SharedMap> make_map(py::handle origin, py::handle edge, py::handle counts,
                                    py::handle indices) {
  const VoxelGrid grid = grid_from(origin, edge, counts);
  auto made = std::make_unique<SharedMap>(VoxelMap(grid));
  if (indices.is_none()) return made;
  const Indices full(indices, "indices");
  made->map.add(full.all);
  return made;
}

py::object contains_of(SharedMap& shared, py::handle argument) {
  const Indices indices(argument, "voxels");
  auto answers = new_array<bool>({static_cast<py::ssize_t>(indices.all.size())});
  bool* says = answers.mutable_data();
  shared.ask([&](const VoxelMap& map) {
    for (const Voxel& voxel : indices.all)
      *says++ = map.contains(voxel);
  });
  return answers;
}

using MapType = py::class_<SharedMap, std::shared_ptr<SharedMap>>;

void add_changes(MapType& type) {
  const auto add_all = [&](const char* name, const char* text,
                           void (VoxelMap::*change)(std::span<const Voxel>)) {
    type.def(
        name,
        [change](SharedMap& shared, py::handle argument) {
          const Indices indices(argument, "voxels");
          shared.ask([&](VoxelMap& map) { (map.*change)(indices.all); });
        },
        text, py::arg("voxels"));
  };
  add_all("add",
          "add(self, voxels)\n--\n\nFills voxels, of the shape (n, 3) or (3,). Raises InputError "
          "for one that is not of the grid, and then fills none.",
          &VoxelMap::add);
  add_all("remove",
          "remove(self, voxels)\n--\n\nEmpties voxels likewise; those that are not there stay so.",
          &VoxelMap::remove);
  const auto add_block = [&](const char* name, const char* text,
                             void (VoxelMap::*change)(const Voxel&, const Voxel&)) {
    type.def(
        name,
        [change](SharedMap& shared, py::handle first, py::handle last) {
          const Voxel from = voxel_from(first, "first");
          const Voxel to = voxel_from(last, "last");
          shared.ask([&](VoxelMap& map) { (map.*change)(from, to); });
        },
        text, py::arg("first"), py::arg("last"));
  };
  add_block("add_block",
            "add_block(self, first, last)\n--\n\nFills all voxels from one to another, both "
            "included, as a leaf of an octree is.",
            &VoxelMap::add_block);
  add_block("remove_block", "remove_block(self, first, last)\n--\n\nEmpties them likewise.",
            &VoxelMap::remove_block);
}

void add_views(MapType& type) {
  type.def_property_readonly(
      "origin",
      [](const SharedMap& shared) { return array_of(Eigen::Vector3d(shared.map.grid().origin)); },
      "The grid's least corner, metres, (3,).");
  type.def_property_readonly(
      "edge", [](const SharedMap& shared) { return shared.map.grid().edge; },
      "Of a voxel, metres.");
  type.def_property_readonly(
      "counts",
      [](const SharedMap& shared) {
        const auto& counts = shared.map.grid().counts;
        return py::make_tuple(counts[0], counts[1], counts[2]);
      },
      "Voxels of the grid along x, y and z.");
  type.def(
      "indices",
      [](SharedMap& shared) {
        return array_of_voxels(shared.ask([](const VoxelMap& map) { return map.voxels(); }));
      },
      "indices(self)\n--\n\nThe full voxels, ascending: uint16 of the shape (k, 3).");
  type.def("contains", &contains_of,
           "contains(self, voxels)\n--\n\nWhich of n voxels are full: n bools.", py::arg("voxels"));
  type.def(
      "part",
      [](SharedMap& shared, py::handle argument) {
        const Voxel voxel = voxel_from(argument, "voxel");
        return shared.ask([&](const VoxelMap& map) { return map.part(voxel); });
      },
      "part(self, voxel)\n--\n\nThe number by which contacts know a voxel. Raises StaleIdError for "
      "one that is not full.",
      py::arg("voxel"));
  type.def(
      "voxel",
      [](SharedMap& shared, py::handle argument) {
        const std::size_t part = count_from(argument, "part");
        if (part > 0xffffffff) throw InputError("part: is no number of a part");
        const Voxel voxel = shared.ask(
            [&](const VoxelMap& map) { return map.voxel(static_cast<std::uint32_t>(part)); });
        return py::make_tuple(voxel.i, voxel.j, voxel.k);
      },
      "voxel(self, part)\n--\n\nAnd back: (i, j, k).", py::arg("part"));
  type.def(
      "box", [](const SharedMap& shared) { return object_of(shared.map.box()); },
      "box(self)\n--\n\nThe shape of each voxel.");
  type.def("__len__", [](SharedMap& shared) {
    return shared.ask([](const VoxelMap& map) { return map.size(); });
  });
  type.def("__reduce__", [](const py::object& self) {
    return py::make_tuple(py::type::of(self),
                          py::make_tuple(self.attr("origin"), self.attr("edge"),
                                         self.attr("counts"), self.attr("indices")()));
  });
}

}  // namespace

void add_voxel_maps(py::module_& module) {
  MapType type(module, "VoxelMap",
               R"(Which voxels of a grid are full: an occupancy map as one body of a World.

    VoxelMap(origin, edge, counts, indices=None)
    VoxelMap(*voxels)

of what find_voxels() returns. Voxels are rows (i, j, k) of whole numbers: cubes of `edge` metres from `origin` on,
`counts` along x, y and z. A body has the map as it was when it was added; contacts and rays name voxels as parts. Can be
pickled; parts are then numbered anew.

Raises InputError for a grid that is none.

>>> blocks = graze.VoxelMap([0, 0, 0], 0.1, (100, 100, 100))
>>> blocks.add_block((0, 0, 0), (99, 99, 0))
>>> len(blocks)
10000
>>> world = graze.World()
>>> ids = world.add(blocks, kind="static"), world.add((graze.Sphere([0, 0, 0], 0.5), raised))
>>> world.move(ids[1], graze.parse_pose("1 0 0 5 0 1 0 5 0 0 1 0.5"))
>>> len(world.update().begun)
1
)");
  type.def(py::init(&make_map),
           "__init__(self, origin, edge, counts, indices=None)\n--\n\nSee the class.",
           py::arg("origin"), py::arg("edge"), py::arg("counts"), py::arg("indices") = py::none());
  add_changes(type);
  add_views(type);
}

}  // namespace graze::python
