#include <graze/engine/python/binding/arguments/arrays.h>
#include <graze/engine/python/binding/module.h>

#include <graze/bvh/error.h>
#include <graze/engine/mesh/fit.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/pose_text.h>
#include <graze/engine/print.h>
#include <graze/engine/python/binding/arguments/batch.h>
#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/arguments/settings.h>

#include <memory>
#include <span>
#include <string>

namespace graze::python {
namespace {

/// Returns rows of three that follow each other in memory, as the library takes them without a
/// copy.
template <typename Row, typename Number>
std::span<const Row> rows_of(const py::array& array) {
  static_assert(sizeof(Row) == 3 * sizeof(Number));
  return {reinterpret_cast<const Row*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

py::array vertices_from(py::handle argument) {
  return py::module_::import("graze._arrays")
      .attr("rows_of_doubles")(argument, "vertices")
      .cast<py::array>();
}

Mesh make_mesh(py::handle vertices, py::handle triangles, py::handle materials);

/// Returns a mesh of something that has vertices and faces: a mesh of trimesh, say, or of this
/// package.
Mesh mesh_like(py::handle other) {
  if (py::isinstance<Mesh>(other)) return other.cast<const Mesh&>();
  if (!py::hasattr(other, "vertices") || !py::hasattr(other, "faces")) {
    throw py::type_error(std::string("vertices: ") + Py_TYPE(other.ptr())->tp_name +
                         " has no members vertices and faces, and no triangles are given");
  }
  return make_mesh(other.attr("vertices"), other.attr("faces"), py::none());
}

/// Returns a mesh with what its triangles are made of.
Mesh mesh_of_materials(const py::array& points, py::handle triangles, py::handle materials) {
  const py::module_ arrays = py::module_::import("graze._arrays");
  const auto indices = arrays.attr("rows_of_unsigned")(triangles, "triangles").cast<py::array>();
  const auto numbers =
      arrays.attr("shorts")(materials, "materials").cast<py::array_t<std::uint16_t>>();
  const py::gil_scoped_release released;
  return {rows_of<Eigen::Vector3d, double>(points),
          rows_of<TriangleIndices, std::uint32_t>(indices),
          std::span<const std::uint16_t>(numbers.data(), static_cast<std::size_t>(numbers.size()))};
}

Mesh make_mesh(py::handle vertices, py::handle triangles, py::handle materials) {
  if (triangles.is_none()) {
    if (!materials.is_none()) throw InputError("materials: are for triangles that are given");
    return mesh_like(vertices);
  }
  const py::array points = vertices_from(vertices);
  if (!materials.is_none()) return mesh_of_materials(points, triangles, materials);
  const py::array indices = py::module_::import("graze._arrays")
                                .attr("rows_of_indices")(triangles, "triangles")
                                .cast<py::array>();
  const bool is_signed = indices.dtype().kind() == 'i';
  const py::gil_scoped_release released;
  const auto positions = rows_of<Eigen::Vector3d, double>(points);
  return is_signed ? Mesh(positions, rows_of<Eigen::Vector3i, int>(indices))
                   : Mesh(positions, rows_of<TriangleIndices, std::uint32_t>(indices));
}

/// Returns a view of numbers that the mesh keeps, for as long as the view lives.
template <typename Number, typename Row>
py::array view_of(const py::object& mesh, std::span<const Row> rows) {
  py::array_t<Number> view({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}},
                           reinterpret_cast<const Number*>(rows.data()), mesh);
  view.attr("setflags")(false);
  return view;
}

/// Returns a view of one number each in the same way.
template <typename Number>
py::array list_of(const py::object& mesh, std::span<const Number> numbers) {
  py::array_t<Number> view({static_cast<py::ssize_t>(numbers.size())}, numbers.data(), mesh);
  view.attr("setflags")(false);
  return view;
}

py::object topology_of(const Mesh& mesh) {
  static const ResultType kType("Topology");
  const Topology* topology = nullptr;
  {
    const py::gil_scoped_release released;
    topology = &mesh.topology();
  }
  return kType(topology->welded_vertices, topology->components, topology->degenerate_triangles,
               topology->duplicate_triangles, topology->boundary_edges, topology->is_closed);
}

py::object bounds_of(const Mesh& mesh) {
  auto bounds = new_array<double>({2, 3});
  write(mesh.bounds().min, bounds.mutable_data());
  write(mesh.bounds().max, bounds.mutable_data() + 3);
  return bounds;
}

Mesh deformed(const Mesh& mesh, py::handle vertices) {
  const py::array points = vertices_from(vertices);
  const py::gil_scoped_release released;
  return mesh.deformed(rows_of<Eigen::Vector3d, double>(points));
}

py::object poses_of_file(py::handle argument) {
  const std::string path = path_from(argument);
  std::vector<Pose> poses;
  {
    const py::gil_scoped_release released;
    poses = load_poses(path);
  }
  auto array = new_array<double>({static_cast<py::ssize_t>(poses.size()), 4, 4});
  double* entry = array.mutable_data();
  for (const Pose& pose : poses) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j)
        *entry++ = pose.matrix()(i, j);
    }
  }
  return array;
}

void add_pose_texts(py::module_& module) {
  module.def(
      "parse_pose",
      [](const std::string& text) {
        const Pose pose = parse_pose(text, "text");
        return array_of_matrix(pose.matrix().data());
      },
      R"(parse_pose(text)
--

A pose of 12 numbers, the rows of [R | t], separated by blanks or commas, each rounded once: of the shape (4, 4).

Raises PoseError for what is no rigid pose.

>>> graze.parse_pose("1 0 0 5  0 1 0 6  0 0 1 7")[:3, 3]
array([5., 6., 7.])
)",
      py::arg("text"));
  module.def(
      "pose_text", [](py::handle pose) { return to_text(pose_from(pose, "pose")); },
      R"(pose_text(pose)
--

The 12 numbers of a pose as parse_pose() and load_poses() read them: the same pose to the last bit.

>>> graze.pose_text(raised)
'1 0 0 0 0 1 0 0 0 0 1 1.5'
)",
      py::arg("pose"));
}

constexpr const char* kMeshText =
    R"(A triangle mesh in metres, which does not change. Its trees are built when a query first walks them.

    Mesh(vertices, triangles, materials=None)

`vertices` have the shape (n, 3), numbers of any kind that float64 holds without loss; `triangles` are indices
into them, whole numbers of the shape (m, 3). Both are copied once. Degenerate and duplicate triangles are
accepted, and counted by `topology`. `materials` are a number from 0 to 65535 for each triangle, which contacts of
shapes and hits of rays carry.

    Mesh(other)

of anything with members `vertices` and `faces`, such as a mesh of trimesh.

A mesh can be pickled: one that comes to a process again and again is built there once. Two are equal if they
are the same mesh, not if they look alike.

Raises MeshError, which names the element, for a coordinate that is not finite, an index out of range or no
triangles; InputError for other shapes and kinds of numbers.

>>> corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
>>> mesh = graze.Mesh(corners, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
>>> mesh
Mesh(4 vertices, 4 triangles)
>>> mesh.topology.is_closed
True
)";

constexpr const char* kLoadMeshText = R"(load_mesh(path)
--

Reads a mesh from an OBJ, STL, PLY or OFF file, chosen by the file name's ending. Coordinates are metres.

Raises MeshError with the file and the line or byte for whatever cannot be read.

>>> graze.load_mesh("data/meshes/nowhere.stl")
Traceback (most recent call last):
    ...
graze.MeshError: data/meshes/nowhere.stl: cannot be read: No such file or directory
)";

constexpr const char* kLoadPosesText = R"(load_poses(path)
--

Reads poses, of the shape (n, 4, 4): a text file of one a line, 12 numbers, the rows of [R | t], or an array that
numpy has saved.

Raises PoseError, naming `file:line`, for what is no rigid pose.
)";

/// Adds the arrays that are as they were given.
void add_arrays(py::class_<Mesh, std::shared_ptr<Mesh>>& type) {
  type.def_property_readonly(
      "vertices",
      [](const py::object& self) {
        return view_of<double>(self, self.cast<const Mesh&>().vertices());
      },
      "The vertices as they were given, metres: float64 of the shape (n, 3), not to be written to. "
      "No copy.");
  type.def_property_readonly(
      "triangles",
      [](const py::object& self) {
        return view_of<std::uint32_t>(self, self.cast<const Mesh&>().triangles());
      },
      "The triangles as they were given: uint32 of the shape (m, 3), not to be written to. No "
      "copy.");
  type.def_property_readonly(
      "faces",
      [](const py::object& self) {
        return view_of<std::uint32_t>(self, self.cast<const Mesh&>().triangles());
      },
      "The same as triangles, by the name that other packages know.");
  type.def_property_readonly(
      "materials",
      [](const py::object& self) -> py::object {
        const auto materials = self.cast<const Mesh&>().materials();
        if (materials.empty()) return py::none();
        return list_of(self, materials);
      },
      "What triangles are made of, as it was given: uint16 of the shape (m,), not to be written "
      "to; "
      "or None. No copy.");
}

/// Adds what follows from these arrays.
void add_findings(py::class_<Mesh, std::shared_ptr<Mesh>>& type) {
  type.def(
      "welded",
      [](const py::object& self) {
        const auto& mesh = self.cast<const Mesh&>();
        std::span<const std::uint32_t> welded;
        {
          const py::gil_scoped_release released;
          welded = mesh.welded();
        }
        return list_of(self, welded);
      },
      "welded(self)\n--\n\nFor each vertex the lowest index of a vertex in the same position: "
      "uint32 of the shape (n,).");
  type.def(
      "component_vertices",
      [](const py::object& self) {
        const auto& mesh = self.cast<const Mesh&>();
        std::span<const std::uint32_t> vertices;
        {
          const py::gil_scoped_release released;
          vertices = mesh.component_vertices();
        }
        return list_of(self, vertices);
      },
      "component_vertices(self)\n--\n\nOne vertex of each of the topology's components, "
      "ascending: uint32.");
  type.def_property_readonly(
      "bounds", &bounds_of,
      "The smallest box around all vertices in use, metres: its least and its greatest "
      "corner, of the shape (2, 3).");
  type.def_property_readonly(
      "topology", &topology_of,
      "What the triangles form once equal positions are one vertex: a Topology.");
  type.def(
      "signed_volume",
      [](const Mesh& mesh) {
        const py::gil_scoped_release released;
        return signed_volume(mesh);
      },
      R"(signed_volume(self)
--

What the surface of a closed mesh encloses, m^3: positive if its triangles are counter-clockwise seen from outside.

>>> bolt.signed_volume() > 0
True
)");
}

void add_members(py::class_<Mesh, std::shared_ptr<Mesh>>& type) {
  type.def(py::init(&make_mesh),
           "__init__(self, vertices, triangles=None, materials=None)\n--\n\nSee the class.",
           py::arg("vertices"), py::arg("triangles") = py::none(),
           py::arg("materials") = py::none());
  add_arrays(type);
  add_findings(type);
  type.def("deformed", &deformed, py::arg("vertices"), R"(deformed(self, vertices)
--

The mesh with its vertices elsewhere: as many, in the same order, between the same triangles. Its trees are
fitted, which takes a fraction of the time of building them.

Raises MeshError for another number of vertices or a coordinate that is not finite.
)");
  type.def("__eq__", [](const Mesh& mesh, py::handle other) {
    return py::isinstance<Mesh>(other) && mesh == other.cast<const Mesh&>();
  });
  type.def("__reduce__", [](const py::object& self) {
    return py::module_::import("graze._pickles").attr("reduce_mesh")(self);
  });
  type.def("__repr__", [](const Mesh& mesh) {
    return "Mesh(" + std::to_string(mesh.vertices().size()) + " vertices, " +
           std::to_string(mesh.triangles().size()) + " triangles)";
  });
  type.def("__hash__", [](const Mesh& mesh) {
    return reinterpret_cast<std::size_t>(mesh.vertices().data()) >> 4;
  });
}

}  // namespace

void add_meshes(py::module_& module) {
  py::class_<Mesh, std::shared_ptr<Mesh>> type(module, "Mesh", kMeshText);
  add_members(type);
  module.def(
      "load_mesh",
      [](py::handle path) {
        const std::string name = path_from(path);
        const py::gil_scoped_release released;
        return load_mesh(name);
      },
      kLoadMeshText, py::arg("path"));
  module.def("load_poses", &poses_of_file, kLoadPosesText, py::arg("path"));
  add_pose_texts(module);
  module.def(
      "prepare",
      [](const Mesh& mesh, py::handle queries, py::handle work) {
        const PrepareSettings settings{
            .queries = word_from<PreparedFor>(
                queries, "queries", {{"pairs", PreparedFor::Pairs}, {"all", PreparedFor::All}})};
        Work* counters = work_from(work);
        const py::gil_scoped_release released;
        prepare(mesh, settings, counters);
      },
      R"(prepare(mesh, *, queries='pairs', work=None)
--

Builds now, with all threads, what queries would build of the mesh's trees as they walk them.

`queries` is "pairs" for those on two meshes, or "all". Changes no answer.

>>> graze.prepare(bolt, queries="all")
)",
      py::arg("mesh"), py::kw_only(), py::arg("queries") = "pairs", py::arg("work") = py::none());
}

}  // namespace graze::python
