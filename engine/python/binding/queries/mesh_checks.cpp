#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>

#include <graze/engine/mesh/mesh_health.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/mesh/volume_query.h>

namespace graze::python {
namespace {

py::object edges_of(const std::vector<FaultyEdge>& edges) {
  auto array = new_array<std::uint32_t>({static_cast<py::ssize_t>(edges.size()), 4});
  std::uint32_t* at = array.mutable_data();
  for (const FaultyEdge& edge : edges) {
    *at++ = edge.vertices[0];
    *at++ = edge.vertices[1];
    *at++ = edge.triangle;
    *at++ = edge.triangle_count;
  }
  return array;
}

py::object check_of(const Mesh& mesh, py::handle progress, py::handle work_argument) {
  static const ResultType kType("MeshHealth");
  const CheckSettings settings{.on_progress = watcher(progress)};
  Work* work = work_from(work_argument);
  MeshHealth health;
  {
    const py::gil_scoped_release released;
    health = check(mesh, settings, work);
  }
  std::vector<std::array<std::uint32_t, 2>> duplicates;
  duplicates.reserve(health.duplicate_triangles.size());
  for (const DuplicateTriangle& duplicate : health.duplicate_triangles)
    duplicates.push_back({duplicate.triangle, duplicate.earlier});
  std::vector<std::array<std::uint32_t, 3>> parts;
  parts.reserve(health.inside_out_parts.size());
  for (const InsideOutPart& part : health.inside_out_parts)
    parts.push_back({part.triangle, part.triangle_count, part.depth});
  return kType(edges_of(health.open_edges), edges_of(health.non_manifold_edges),
               edges_of(health.turned_edges),
               array_over<std::uint32_t>(std::move(health.degenerate_triangles)),
               array_over<std::uint32_t>(std::move(duplicates), 2),
               array_over<std::uint32_t>(std::move(parts), 3),
               array_over<std::uint32_t>(std::move(health.self_intersections.pairs), 2));
}

bool self_intersects_of(const Mesh& mesh, py::handle work_argument) {
  Work* work = work_from(work_argument);
  const py::gil_scoped_release released;
  return self_intersects(mesh, work);
}

py::object self_pairs_of(const Mesh& mesh, py::handle kind, py::handle limit,
                         py::handle work_argument) {
  static const ResultType kType("TrianglePairs");
  const SelfSettings settings{
      .kind = word_from<SelfPairKind>(
          kind, "kind",
          {{"intersecting", SelfPairKind::Intersecting}, {"neighbour", SelfPairKind::Neighbour}}),
      .limit = limit_from(limit)};
  Work* work = work_from(work_argument);
  TrianglePairs found;
  {
    const py::gil_scoped_release released;
    found = find_self_pairs(mesh, settings, work);
  }
  return kType(array_over<std::uint32_t>(std::move(found.pairs), 2),
               found.completeness == Completeness::Complete);
}

/// Takes a box along the axes, a turned one, or a ball, as the library finds triangles in them.
TriangleList triangles_in(const Placed& mesh, py::handle volume, const TriangleSettings& settings,
                          Work* work) {
  if (PyTuple_Check(volume.ptr()) == 0 && !py::isinstance<Shape>(volume)) {
    const Points corners(volume, "volume");
    if (corners.size() != 2)
      throw InputError("volume: is neither two corners, of the shape (2, 3), nor a shape");
    const py::gil_scoped_release released;
    return find_triangles(mesh.mesh_at(0), Aabb{corners[0], corners[1]}, settings, work);
  }
  const Placed placed(volume, "volume");
  if (placed.poses().is_many()) throw InputError("volume: many poses are not taken");
  const Pose pose = placed.poses()[0];
  const py::gil_scoped_release released;
  if (const Box* box = placed.shape().as<Box>()) {
    return find_triangles(mesh.mesh_at(0), Obb{pose, box->half_extents}, settings, work);
  }
  if (const Sphere* ball = placed.shape().as<Sphere>()) {
    placed.check_poses();
    return find_triangles(mesh.mesh_at(0), Sphere{place(pose, ball->centre), ball->radius},
                          settings, work);
  }
  throw InputError(std::string("volume: is a ") + name_of(placed.shape().kind()) +
                   ", neither a box nor a sphere");
}

py::object find_triangles_of(py::handle mesh, py::handle volume, py::handle limit,
                             py::handle work) {
  static const ResultType kType("TriangleList");
  const Placed placed = placed_mesh(mesh, "mesh");
  if (placed.poses().is_many()) throw InputError("mesh: many poses are not taken");
  TriangleList found = triangles_in(placed, volume, {.limit = limit_from(limit)}, work_from(work));
  return kType(array_over<std::uint32_t>(std::move(found.triangles)),
               found.completeness == Completeness::Complete);
}

constexpr const char* kCheckText = R"(check(mesh, *, progress=None, work=None)
--

All that is wrong with a mesh, and where, exactly: a MeshHealth of arrays, all of them empty in a healthy mesh.

`progress` is called with (done, total), or is a bar with a method update(); Ctrl-C ends the check.

>>> graze.check(bolt).is_healthy
True
>>> graze.check(graze.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])).open_edges
array([[0, 1, 0, 1],
       [0, 2, 0, 1],
       [1, 2, 0, 1]], dtype=uint32)
)";

}  // namespace

void add_mesh_checks(py::module_& module) {
  module.def("check", &check_of, kCheckText, py::arg("mesh"), py::kw_only(),
             py::arg("progress") = py::none(), py::arg("work") = py::none());
  module.def("self_intersects", &self_intersects_of, R"(self_intersects(mesh, *, work=None)
--

Whether two triangles of a mesh intersect: they share more than the welded vertex or edge that they have in common.

>>> graze.self_intersects(bolt)
False
)",
             py::arg("mesh"), py::kw_only(), py::arg("work") = py::none());
  module.def("find_self_pairs", &self_pairs_of,
             R"(find_self_pairs(mesh, *, kind='intersecting', limit=None, work=None)
--

All pairs of triangles of a mesh that intersect, or with `kind` "neighbour" those that share just a vertex or an edge:
TrianglePairs.

>>> len(graze.find_self_pairs(bolt).pairs)
0
)",
             py::arg("mesh"), py::kw_only(), py::arg("kind") = "intersecting",
             py::arg("limit") = py::none(), py::arg("work") = py::none());
  module.def("find_triangles", &find_triangles_of,
             R"(find_triangles(mesh, volume, *, limit=None, work=None)
--

All triangles of a placed mesh that share a point with a volume, exactly: a TriangleList, ascending. The volume is a
box along the axes, its two corners of the shape (2, 3), or a placed Box or Sphere.

Raises InputError for any other shape, and what intersects() raises.

>>> graze.find_triangles(bolt, graze.Sphere([0, 0, 0.02], 0.0001)).triangles.dtype
dtype('uint32')
)",
             py::arg("mesh"), py::arg("volume"), py::kw_only(), py::arg("limit") = py::none(),
             py::arg("work") = py::none());
}

}  // namespace graze::python
