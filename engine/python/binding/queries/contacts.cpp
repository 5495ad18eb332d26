#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/queries/manifolds.h>

#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/mesh_intersection.h>
#include <graze/engine/mesh/separation.h>
#include <graze/engine/world/manifold.h>

namespace graze::python {
namespace {

PlacedPair single_pair(py::handle a, py::handle b, const char* query) {
  PlacedPair pair(a, b);
  if (pair.is_many()) throw InputError(std::string(query) + "() takes one pose");
  return pair;
}

py::object mesh_contacts(MeshContacts&& found) {
  static const ResultType kType("MeshContacts");
  const auto& all = found.contacts;
  auto offsets = new_array<std::int64_t>({static_cast<py::ssize_t>(all.size()) + 1});
  std::vector<Eigen::Vector3d> corners;
  std::int64_t* offset = offsets.mutable_data();
  for (const MeshContact& contact : all) {
    *offset++ = static_cast<std::int64_t>(corners.size());
    const auto own = found.points_of(contact);
    corners.insert(corners.end(), own.begin(), own.end());
  }
  *offset = static_cast<std::int64_t>(corners.size());
  return kType(points_of(all, [](const auto& contact) { return contact.point; }),
               points_of(all, [](const auto& contact) { return contact.point_a; }),
               points_of(all, [](const auto& contact) { return contact.point_b; }),
               points_of(all, [](const auto& contact) { return contact.normal; }),
               numbers_of<double>(all, [](const auto& contact) { return contact.depth; }),
               array_over<double>(std::move(corners), 3), std::move(offsets),
               found.completeness == Completeness::Complete);
}

py::object contacts_of(py::handle a, py::handle b, py::handle limit, py::handle margin,
                       py::handle sides_a, py::handle sides_b, py::handle work_argument) {
  const PlacedPair pair = single_pair(a, b, "find_contacts");
  Work* work = work_from(work_argument);
  if (pair.are_meshes() && margin.is_none() && sides_a.is_none() && sides_b.is_none()) {
    const ContactSettings settings{.limit = limit_from(limit)};
    MeshContacts found;
    {
      const py::gil_scoped_release released;
      ask_and_blame(
          [&] { found = find_contacts(pair.a.mesh_at(0), pair.b.mesh_at(0), settings, work); },
          [&] { pair.check_poses(); });
    }
    return mesh_contacts(std::move(found));
  }
  if (!limit.is_none()) throw InputError("limit: is for two meshes without a margin or sides");
  const ManifoldSettings settings{.margin = margin.is_none() ? 0 : number_from(margin, "margin"),
                                  .sides_a = sides_from(sides_a, "sides_a"),
                                  .sides_b = sides_from(sides_b, "sides_b")};
  Manifold found;
  {
    const py::gil_scoped_release released;
    ask_and_blame(
        [&] { found = find_contacts(pair.a.shape_at(0), pair.b.shape_at(0), settings, work); },
        [&] { pair.check_poses(); });
  }
  return result_of(std::vector<ShapeContact>(found.begin(), found.end()));
}

py::object features_of(const std::vector<IntersectionPoint>& points,
                       Feature IntersectionPoint::*feature) {
  return numbers_of<std::uint8_t>(points, [&](const IntersectionPoint& point) {
    return static_cast<std::uint8_t>(point.*feature);
  });
}

py::object polygons_of(const MeshIntersection& found) {
  auto array = new_array<std::int64_t>({static_cast<py::ssize_t>(found.polygons.size()), 6});
  std::int64_t* at = array.mutable_data();
  for (const IntersectionPolygon& polygon : found.polygons) {
    for (std::uint32_t corner = 0; corner < 6; ++corner)
      *at++ =
          corner < polygon.corner_count ? static_cast<std::int64_t>(polygon.corners[corner]) : -1;
  }
  return array;
}

py::object intersection_of(py::handle a, py::handle b, py::handle work_argument) {
  static const ResultType kType("MeshIntersection");
  const PlacedPair pair = single_pair(a, b, "find_intersection");
  pair.require_meshes("find_intersection");
  Work* work = work_from(work_argument);
  MeshIntersection found;
  {
    const py::gil_scoped_release released;
    ask_and_blame(
        [&] { found = find_intersection(pair.a.mesh_at(0), pair.b.mesh_at(0), {}, work); },
        [&] { pair.check_poses(); });
  }
  using Segment = IntersectionSegment;
  using Curve = IntersectionCurve;
  using Patch = IntersectionPatch;
  using Polygon = IntersectionPolygon;
  using Touching = TouchingPoint;
  return kType(points_of(found.points, [](const auto& point) { return point.position; }),
               features_of(found.points, &IntersectionPoint::feature_a),
               features_of(found.points, &IntersectionPoint::feature_b),
               columns_of(found.segments, {&Segment::from, &Segment::to}),
               columns_of(found.segments, {&Segment::first_pair, &Segment::pair_count}),
               columns_of(found.curves, {&Curve::first_segment, &Curve::segment_count}),
               numbers_of<bool>(found.curves, [](const Curve& curve) { return curve.is_closed; }),
               polygons_of(found),
               columns_of(found.polygons, {&Polygon::first_pair, &Polygon::pair_count}),
               columns_of(found.patches, {&Patch::first_polygon, &Patch::polygon_count}),
               numbers_of<std::uint32_t>(found.touching_points,
                                         [](const auto& touch) { return touch.point; }),
               columns_of(found.touching_points, {&Touching::first_pair, &Touching::pair_count}),
               array_over<std::uint32_t>(std::move(found.pairs), 2));
}

py::object separation_of(py::handle a, py::handle b, py::handle direction,
                         py::handle work_argument) {
  static const ResultType kType("Separation");
  const PlacedPair pair = single_pair(a, b, "separating_translation");
  pair.require_meshes("separating_translation");
  std::optional<Eigen::Vector3d> way;
  if (!direction.is_none()) way = vector_from(direction, "direction");
  Work* work = work_from(work_argument);
  Separation found;
  {
    const py::gil_scoped_release released;
    const PlacedMeshView mesh_a = pair.a.mesh_at(0);
    const PlacedMeshView mesh_b = pair.b.mesh_at(0);
    found = way ? separating_translation(mesh_a, mesh_b, *way, work)
                : separating_translation(mesh_a, mesh_b, work);
  }
  return kType(found.distance, array_of(found.direction), array_of(found.translation),
               array_of(found.pose_b));
}

constexpr const char* kContactsText =
    R"(find_contacts(a, b, *, limit=None, margin=None, sides_a=None, sides_b=None, work=None)
--

Where two placed meshes or shapes meet, and how deep they are in each other.

Of two meshes MeshContacts: one contact for each connected piece of their intersection, the deepest first. `point`,
`point_a`, `point_b` and `normal`, from A to B, have the shape (k, 3), `depth` (k,); the corners of the intersection
of contact i are corners[offsets[i]:offsets[i + 1]]. At most `limit` contacts; `is_complete` says whether these are
all.

Where one is another shape than a mesh, or with a `margin`, metres, ShapeContacts: points for a solver, of each
region at most four, with features that persist. With a margin contacts begin when the two are so near. `sides_a` and
`sides_b` say what of a mesh counts beside its surface: "surface", "solid", or ("one_sided", thickness in metres).

Raises what intersects() raises, InputError for a margin that is none, and UnsupportedPairError for two half-spaces.

>>> contacts = graze.find_contacts(bolt, (nut, pose))
>>> bool((contacts.depth >= 0).all())
True
>>> box = graze.Box([1, 1, 1])
>>> graze.find_contacts(box, (box, raised)).depth
array([0.5, 0.5, 0.5, 0.5])
)";

constexpr const char* kIntersectionText = R"(find_intersection(a, b, *, work=None)
--

Where the surfaces of two placed meshes meet, exactly in all but the rounded positions: a MeshIntersection of points,
segments, curves, polygons and patches. Empty if and only if intersects() is False.

Raises what intersects() raises.

>>> met = graze.find_intersection(bolt, (nut, pose))
>>> bool(met.is_closed.all())
True
)";

constexpr const char* kSeparatingText =
    R"(separating_translation(a, b, direction=None, *, work=None)
--

A translation of B after which two meshes are apart: a Separation of `distance`, `direction`, `translation` and
`pose_b`. Along a direction of any length it is the last contact; without one the shortest that is found, which is no
less than the smallest one.

Raises InputError for a direction that is zero or not finite, and what intersects() raises.

>>> away = graze.separating_translation(bolt, (nut, pose))
>>> graze.intersects(bolt, (nut, away.pose_b))
False
)";

}  // namespace

py::object result_of(const std::vector<ShapeContact>& contacts) {
  static const ResultType kType("ShapeContacts");
  auto features = new_array<std::uint64_t>({static_cast<py::ssize_t>(contacts.size()), 2});
  std::uint64_t* feature = features.mutable_data();
  for (const ShapeContact& contact : contacts) {
    *feature++ = contact.feature.a;
    *feature++ = contact.feature.b;
  }
  auto materials = new_array<std::uint16_t>({static_cast<py::ssize_t>(contacts.size()), 2});
  std::uint16_t* material = materials.mutable_data();
  for (const ShapeContact& contact : contacts) {
    *material++ = contact.material_a;
    *material++ = contact.material_b;
  }
  return kType(
      points_of(contacts, [](const auto& contact) { return contact.point; }),
      points_of(contacts, [](const auto& contact) { return contact.point_a; }),
      points_of(contacts, [](const auto& contact) { return contact.point_b; }),
      points_of(contacts, [](const auto& contact) { return contact.normal; }),
      numbers_of<double>(contacts, [](const auto& contact) { return contact.depth; }),
      std::move(features),
      numbers_of<std::uint32_t>(contacts, [](const auto& contact) { return contact.region; }),
      std::move(materials));
}

void add_contacts(py::module_& module) {
  module.def("find_contacts", &contacts_of, kContactsText, py::arg("a"), py::arg("b"),
             py::kw_only(), py::arg("limit") = py::none(), py::arg("margin") = py::none(),
             py::arg("sides_a") = py::none(), py::arg("sides_b") = py::none(),
             py::arg("work") = py::none());
  module.def("find_intersection", &intersection_of, kIntersectionText, py::arg("a"), py::arg("b"),
             py::kw_only(), py::arg("work") = py::none());
  module.def("separating_translation", &separation_of, kSeparatingText, py::arg("a"), py::arg("b"),
             py::arg("direction") = py::none(), py::kw_only(), py::arg("work") = py::none());
}

}  // namespace graze::python
