#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/queries/manifolds.h>

#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/mesh_intersection.h>
#include <graze/engine/mesh/separating_translation.h>
#include <graze/engine/world/manifold.h>

namespace graze::python {
namespace {

/// Returns where the contacts of each answer begin in the list of all.
template <typename Answer, typename Size>
py::array_t<std::int64_t> offsets_of(const std::vector<Answer>& answers, const Size& size) {
  auto offsets = new_array<std::int64_t>({static_cast<py::ssize_t>(answers.size()) + 1});
  std::int64_t* offset = offsets.mutable_data();
  *offset = 0;
  for (const Answer& answer : answers) {
    offset[1] = offset[0] + static_cast<std::int64_t>(size(answer));
    ++offset;
  }
  return offsets;
}

/// Returns the contacts of all answers, one behind the other.
py::object mesh_contacts(const std::vector<MeshContacts>& answers) {
  static const ResultType kType("MeshContacts");
  std::vector<MeshContact> all;
  std::vector<Eigen::Vector3d> corners;
  std::vector<std::int64_t> offsets{0};
  bool is_complete = true;
  for (const MeshContacts& found : answers) {
    is_complete = is_complete && found.completeness == Completeness::Complete;
    for (const MeshContact& contact : found.contacts) {
      all.push_back(contact);
      const auto own = found.points_of(contact);
      corners.insert(corners.end(), own.begin(), own.end());
      offsets.push_back(static_cast<std::int64_t>(corners.size()));
    }
  }
  return kType(points_of(all, [](const auto& contact) { return contact.point; }),
               points_of(all, [](const auto& contact) { return contact.point_a; }),
               points_of(all, [](const auto& contact) { return contact.point_b; }),
               points_of(all, [](const auto& contact) { return contact.normal; }),
               numbers_of<double>(all, [](const auto& contact) { return contact.depth; }),
               array_over<double>(std::move(corners), 3),
               array_over<std::int64_t>(std::move(offsets)), is_complete);
}

py::object contacts_of_meshes(const PlacedPair& pair, const ContactSettings& settings,
                              const Batch& batch, Work* work) {
  static const ResultType kMany("MeshContactLists");
  const auto answers = ask_all<MeshContacts>(pair, batch, work, [&](std::size_t i, Work* own) {
    return find_contacts(pair.a.mesh_at(i), pair.b.mesh_at(i), settings, own);
  });
  py::object all = mesh_contacts(answers);
  if (!pair.is_many()) return all;
  return kMany(
      std::move(all), offsets_of(answers, [](const auto& found) { return found.contacts.size(); }),
      numbers_of<bool>(
          answers, [](const auto& found) { return found.completeness == Completeness::Complete; }));
}

py::object contacts_of_shapes(const PlacedPair& pair, const ManifoldSettings& settings,
                              const Batch& batch, Work* work) {
  static const ResultType kMany("ShapeContactLists");
  const auto answers = ask_all<Manifold>(pair, batch, work, [&](std::size_t i, Work* own) {
    return find_contacts(pair.a.shape_at(i), pair.b.shape_at(i), settings, own);
  });
  std::vector<ShapeContact> all;
  for (const Manifold& found : answers)
    all.insert(all.end(), found.begin(), found.end());
  py::object contacts = result_of(all);
  if (!pair.is_many()) return contacts;
  return kMany(std::move(contacts),
               offsets_of(answers, [](const Manifold& found) { return found.size(); }));
}

py::object contacts_of(py::handle a, py::handle b, py::handle limit, py::handle margin,
                       py::handle sides_a, py::handle sides_b, py::handle threads,
                       py::handle progress, py::handle work_argument) {
  const PlacedPair pair(a, b);
  const Batch batch(threads, progress);
  Work* work = work_from(work_argument);
  if (pair.are_meshes() && margin.is_none() && sides_a.is_none() && sides_b.is_none())
    return contacts_of_meshes(pair, {.limit = limit_from(limit)}, batch, work);
  if (!limit.is_none()) throw InputError("limit: is for two meshes without a margin or sides");
  const ManifoldSettings settings{.margin = margin.is_none() ? 0 : number_from(margin, "margin"),
                                  .sides_a = sides_from(sides_a, "sides_a"),
                                  .sides_b = sides_from(sides_b, "sides_b")};
  return contacts_of_shapes(pair, settings, batch, work);
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

py::object result_of_intersection(MeshIntersection&& found) {
  static const ResultType kType("MeshIntersection");
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

/// Returns one intersection for each pose.
py::object intersections_of(py::handle a, py::handle b, py::handle threads, py::handle progress,
                            py::handle work) {
  const PlacedPair pair(a, b);
  pair.require_meshes("find_intersection");
  auto answers = ask_all<MeshIntersection>(
      pair, Batch(threads, progress), work_from(work), [&](std::size_t i, Work* own) {
        return find_intersection(pair.a.mesh_at(i), pair.b.mesh_at(i), {}, own);
      });
  if (!pair.is_many()) return result_of_intersection(std::move(answers[0]));
  py::list all;
  for (MeshIntersection& found : answers)
    all.append(result_of_intersection(std::move(found)));
  return all;
}

py::object separations_of(py::handle a, py::handle b, py::handle direction, py::handle threads,
                          py::handle progress, py::handle work) {
  static const ResultType kSingle("SeparatingTranslation");
  static const ResultType kMany("SeparatingTranslations");
  const PlacedPair pair(a, b);
  pair.require_meshes("separating_translation");
  std::optional<Eigen::Vector3d> along;
  if (!direction.is_none()) along = vector_from(direction, "direction");
  const auto answers = ask_all<SeparatingTranslation>(
      pair, Batch(threads, progress), work_from(work), [&](std::size_t i, Work* own) {
        const PlacedMeshView mesh_a = pair.a.mesh_at(i);
        const PlacedMeshView mesh_b = pair.b.mesh_at(i);
        return along ? separating_translation(mesh_a, mesh_b, *along, own)
                     : separating_translation(mesh_a, mesh_b, own);
      });
  if (!pair.is_many()) {
    const SeparatingTranslation& found = answers[0];
    return kSingle(found.distance, array_of(found.direction), array_of(found.translation),
                   array_of(found.pose_b));
  }
  auto poses = new_array<double>({static_cast<py::ssize_t>(answers.size()), 4, 4});
  double* at = poses.mutable_data();
  for (const SeparatingTranslation& found : answers) {
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column)
        *at++ = found.pose_b.matrix()(row, column);
    }
  }
  return kMany(numbers_of<double>(answers, [](const auto& found) { return found.distance; }),
               points_of(answers, [](const auto& found) { return found.direction; }),
               points_of(answers, [](const auto& found) { return found.translation; }),
               std::move(poses));
}

constexpr const char* kContactsText =
    R"(find_contacts(a, b, *, limit=None, margin=None, sides_a=None, sides_b=None, threads=0, progress=None, work=None)
--

Where two placed meshes or shapes meet, and how deep they are in each other.

Of two meshes MeshContacts: one contact for each connected piece of their intersection, the deepest first. `point`,
`point_a`, `point_b` and `normal`, from A to B, have the shape (k, 3), `depth` (k,); the corners of the intersection
of contact i are corners[offsets[i]:offsets[i + 1]]. At most `limit` contacts; `is_complete` says whether these are
all. With many poses, as of intersects(), MeshContactLists, or ShapeContactLists: all contacts in one result, and where
those of each pose begin.

Where one is another shape than a mesh, or with a `margin`, metres, be it 0, ShapeContacts: points for a solver, of each
region at most four, with features that persist. With a margin contacts begin when the two are so near. `sides_a` and
`sides_b` say what of a mesh counts beside its surface: "surface", "solid", or ("one_sided", thickness in metres).

Raises what intersects() raises, InputError for a margin that is none, MeshError for sides that the mesh cannot have (a
solid that is open or inside out), with the edge or triangle, and UnsupportedPairError for two half-spaces.

>>> contacts = graze.find_contacts(bolt, (nut, pose))
>>> bool((contacts.depth >= 0).all())
True
>>> box = graze.Box([1, 1, 1])
>>> graze.find_contacts(box, (box, raised)).depth
array([0.5, 0.5, 0.5, 0.5])
)";

constexpr const char* kIntersectionText =
    R"(find_intersection(a, b, *, threads=0, progress=None, work=None)
--

Where the surfaces of two placed meshes meet, exactly in all but the rounded positions: a MeshIntersection of points,
segments, curves, polygons and patches. Empty if and only if intersects() is False. With many poses a list of them.

Raises what intersects() raises.

>>> met = graze.find_intersection(bolt, (nut, pose))
>>> bool(met.is_closed.all())
True
)";

constexpr const char* kSeparatingText =
    R"(separating_translation(a, b, direction=None, *, threads=0, progress=None, work=None)
--

A translation of B after which two meshes are apart: a SeparatingTranslation of `distance`, `direction`, `translation` and
`pose_b`. Along a direction of any length it is the last contact; without one the shortest that is found, which is no
less than the smallest one. With many poses SeparatingTranslations: arrays.

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
             py::arg("threads") = 0, py::arg("progress") = py::none(),
             py::arg("work") = py::none());
  module.def("find_intersection", &intersections_of, kIntersectionText, py::arg("a"), py::arg("b"),
             py::kw_only(), py::arg("threads") = 0, py::arg("progress") = py::none(),
             py::arg("work") = py::none());
  module.def("separating_translation", &separations_of, kSeparatingText, py::arg("a"), py::arg("b"),
             py::arg("direction") = py::none(), py::kw_only(), py::arg("threads") = 0,
             py::arg("progress") = py::none(), py::arg("work") = py::none());
}

}  // namespace graze::python
