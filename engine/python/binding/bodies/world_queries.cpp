#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/values/motions.h>

#include <limits>
#include <optional>

namespace graze::python {
namespace {

Placed single_shape(py::handle argument) {
  Placed placed(argument, "shape");
  if (placed.poses().is_many()) throw InputError("shape: many poses are not taken");
  return placed;
}

py::object distances_of(const std::vector<BodyDistance>& found) {
  static const ResultType kType("BodyDistances");
  std::vector<BodyId> ids;
  ids.reserve(found.size());
  for (const BodyDistance& near : found)
    ids.push_back(near.id);
  return kType(array_of_ids(ids),
               numbers_of<double>(found, [](const auto& near) { return near.distance.distance; }),
               points_of(found, [](const auto& near) { return near.distance.point_a; }),
               points_of(found, [](const auto& near) { return near.distance.point_b; }),
               points_of(found, [](const auto& near) { return near.distance.normal; }));
}

py::object find_touching(SharedWorld& shared, py::handle shape, py::handle filter,
                         py::handle role) {
  const Placed placed = single_shape(shape);
  const BodyQuerySettings settings = query_settings(filter, role);
  return array_of_ids(
      shared.ask([&](World& world) { return world.find_touching(placed.shape_at(0), settings); }));
}

py::object find_within(SharedWorld& shared, py::handle shape, py::handle clearance,
                       py::handle filter, py::handle role) {
  const Placed placed = single_shape(shape);
  const double metres = number_from(clearance, "clearance");
  const BodyQuerySettings settings = query_settings(filter, role);
  return distances_of(shared.ask(
      [&](World& world) { return world.find_within(placed.shape_at(0), metres, settings); }));
}

py::object find_closest(SharedWorld& shared, py::handle shape, py::handle filter, py::handle role) {
  static const ResultType kType("BodyDistance");
  const Placed placed = single_shape(shape);
  const BodyQuerySettings settings = query_settings(filter, role);
  const auto found =
      shared.ask([&](World& world) { return world.find_closest(placed.shape_at(0), settings); });
  if (!found) return py::none();
  return kType(number_of(found->id), found->distance.distance, array_of(found->distance.point_a),
               array_of(found->distance.point_b), array_of(found->distance.normal));
}

py::object find_in_box(SharedWorld& shared, py::handle bounds, py::handle filter, py::handle role) {
  const Points corners(bounds, "bounds");
  if (corners.size() != 2) throw InputError("bounds: are two corners, of the shape (2, 3)");
  const BodyQuerySettings settings = query_settings(filter, role);
  return array_of_ids(shared.ask([&](World& world) {
    return world.find_in_box({corners[0], corners[1]}, settings);
  }));
}

py::object body_cast_rays(SharedWorld& shared, py::handle origins_argument,
                          py::handle directions_argument, py::handle max_distance,
                          py::handle filter, py::handle role) {
  static const ResultType kType("BodyRayHits");
  const Points origins(origins_argument, "origins");
  const Points directions(directions_argument, "directions");
  const double length = number_from(max_distance, "max_distance");
  const std::size_t count = origins.is_many() ? origins.size() : directions.size();
  if (origins.is_many() && directions.is_many() && origins.size() != directions.size()) {
    throw InputError("directions: are not as many as origins");
  }
  const BodyQuerySettings settings = query_settings(filter, role);
  const auto hits = shared.ask([&](World& world) {
    std::vector<std::optional<BodyRayHit>> found(count);
    for (std::size_t i = 0; i < count; ++i) {
      found[i] = world.cast_ray(
          {origins[origins.is_many() ? i : 0], directions[directions.is_many() ? i : 0], length},
          settings);
    }
    return found;
  });
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d nowhere(kNone, kNone, kNone);
  std::vector<BodyId> ids;
  ids.reserve(hits.size());
  for (const auto& hit : hits)
    ids.push_back(hit ? hit->id : BodyId{});
  return kType(
      numbers_of<bool>(hits, [](const auto& hit) { return hit.has_value(); }), array_of_ids(ids),
      numbers_of<double>(hits,
                         [](const auto& hit) {
                           return hit ? hit->hit.distance : std::numeric_limits<double>::infinity();
                         }),
      points_of(hits,
                [&](const auto& hit) -> Eigen::Vector3d { return hit ? hit->hit.point : nowhere; }),
      points_of(hits, [&](const auto& hit) -> Eigen::Vector3d {
        return hit ? hit->hit.normal : nowhere;
      }));
}

py::object body_cast(SharedWorld& shared, py::handle shape, py::handle motion, py::handle filter,
                     py::handle role) {
  static const ResultType kType("BodyCast");
  const Placed placed = single_shape(shape);
  const RigidMotion course = motion_from(motion, "motion");
  const BodyQuerySettings settings = query_settings(filter, role);
  const auto found =
      shared.ask([&](World& world) { return world.cast(placed.shape(), course, {}, settings); });
  if (!found) return py::none();
  return kType(number_of(found->id), result_of(found->contact));
}

}  // namespace

BodyQuerySettings query_settings(py::handle filter, py::handle role) {
  BodyQuerySettings settings;
  if (!filter.is_none()) settings.filter = filter_from(filter);
  if (!role.is_none()) settings.role = role_from(role);
  return settings;
}

void add_world_queries(py::module_& module) {
  py::class_<SharedWorld> type(module.attr("World"));
  const auto filter = [] { return py::arg("filter") = py::none(); };
  const auto role = [] { return py::arg("role") = py::none(); };
  type.def(
      "bodies",
      [](SharedWorld& shared, py::handle of_filter, py::handle of_role) {
        const BodyQuerySettings settings = query_settings(of_filter, of_role);
        return array_of_ids(shared.ask([&](World& world) { return world.bodies(settings); }));
      },
      "bodies(self, *, filter=None, role=None)\n--\n\nThe ids of all bodies, or of those that are "
      "asked for, ascending.",
      py::kw_only(), filter(), role());
  type.def(
      "pairs",
      [](SharedWorld& shared) {
        return array_of_pairs(shared.ask([](World& world) { return world.pairs(); }));
      },
      "pairs(self)\n--\n\nAll pairs that touched at the last update, ascending, of the shape (k, "
      "2).");
  type.def(
      "touching",
      [](SharedWorld& shared, std::uint64_t id) {
        return array_of_ids(
            shared.ask([&](World& world) { return world.touching(id_of<BodyId>(id)); }));
      },
      "touching(self, id)\n--\n\nThe bodies that one touched at the last update, ascending.",
      py::arg("id"));
  type.def(
      "contacts",
      [](SharedWorld& shared) {
        return result_of(shared.ask([](World& world) { return world.contacts(); }));
      },
      "contacts(self)\n--\n\nThe contacts of all solid pairs that touch or are near: "
      "WorldContacts. Raises InputError while "
      "changes wait for an update.");
  type.def("find_touching", &find_touching,
           "find_touching(self, shape, *, filter=None, role=None)\n--\n\nThe bodies that touch a "
           "shape that is none of them, as "
           "they are now: ids, ascending.",
           py::arg("shape"), py::kw_only(), filter(), role());
  type.def("find_within", &find_within,
           "find_within(self, shape, clearance, *, filter=None, role=None)\n--\n\nThe bodies whose "
           "distance to a shape is at most "
           "the clearance, metres: BodyDistances.",
           py::arg("shape"), py::arg("clearance"), py::kw_only(), filter(), role());
  type.def("find_closest", &find_closest,
           "find_closest(self, shape, *, filter=None, role=None)\n--\n\nThe body whose distance is "
           "least, a BodyDistance, or None.",
           py::arg("shape"), py::kw_only(), filter(), role());
  type.def("find_in_box", &find_in_box,
           "find_in_box(self, bounds, *, filter=None, role=None)\n--\n\nThe bodies whose boxes "
           "share a point with one, of the "
           "shape (2, 3): ids, ascending.",
           py::arg("bounds"), py::kw_only(), filter(), role());
  type.def("cast_rays", &body_cast_rays,
           "cast_rays(self, origins, directions, max_distance=1e999, *, filter=None, "
           "role=None)\n--\n\nThe body that each ray meets "
           "first, and where: BodyRayHits.",
           py::arg("origins"), py::arg("directions"),
           py::arg("max_distance") = std::numeric_limits<double>::infinity(), py::kw_only(),
           filter(), role());
  type.def("cast", &body_cast,
           "cast(self, shape, motion, *, filter=None, role=None)\n--\n\nThe body to which a shape "
           "in rigid motion comes first, a "
           "BodyCast, or None. None is missed.",
           py::arg("shape"), py::arg("motion"), py::kw_only(), filter(), role());
}

}  // namespace graze::python
