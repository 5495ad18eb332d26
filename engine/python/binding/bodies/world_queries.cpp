#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/values/motions.h>

#include <graze/bvh/value/element_error.h>

#include <limits>
#include <optional>

namespace graze::python {
namespace {

Placed single_shape(py::handle argument) {
  Placed placed(argument, "shape");
  if (placed.poses().is_many()) throw InputError("shape: many poses are not taken");
  return placed;
}

bool is_converged(const ShapeDistance& gap) {
  return gap.status == PairStatus::Converged;
}

py::object distances_of(const std::vector<BodyDistance>& found) {
  static const ResultType kType("BodyDistances");
  std::vector<BodyId> ids;
  ids.reserve(found.size());
  for (const BodyDistance& near : found)
    ids.push_back(near.id);
  return kType(
      array_of_ids(ids),
      numbers_of<double>(found, [](const auto& near) { return near.distance.distance; }),
      points_of(found, [](const auto& near) { return near.distance.point_a; }),
      points_of(found, [](const auto& near) { return near.distance.point_b; }),
      points_of(found, [](const auto& near) { return near.distance.normal; }),
      numbers_of<std::uint32_t>(found, [](const auto& near) { return near.part; }),
      numbers_of<double>(found, [](const auto& near) { return near.distance.lower_bound; }),
      numbers_of<bool>(found, [](const auto& near) { return is_converged(near.distance); }));
}

py::object find_touching(SharedWorld& shared, py::handle shape, py::handle filter,
                         py::handle role) {
  if (const auto other = world_from(shape))
    return pairs_touching(shared, *other, pair_settings(filter, role));
  const Placed placed = single_shape(shape);
  const BodyQuerySettings settings = query_settings(filter, role);
  return array_of_ids(
      shared.ask([&](World& world) { return world.find_touching(placed.shape_at(0), settings); }));
}

py::object find_within(SharedWorld& shared, py::handle shape, py::handle clearance,
                       py::handle filter, py::handle role) {
  const double metres = number_from(clearance, "clearance");
  if (const auto other = world_from(shape))
    return pairs_within(shared, *other, metres, pair_settings(filter, role));
  const Placed placed = single_shape(shape);
  const BodyQuerySettings settings = query_settings(filter, role);
  return distances_of(shared.ask(
      [&](World& world) { return world.find_within(placed.shape_at(0), metres, settings); }));
}

py::object find_closest(SharedWorld& shared, py::handle shape, py::handle filter, py::handle role) {
  static const ResultType kType("BodyDistance");
  if (const auto other = world_from(shape))
    return closest_pair(shared, *other, pair_settings(filter, role));
  const Placed placed = single_shape(shape);
  const BodyQuerySettings settings = query_settings(filter, role);
  const auto found =
      shared.ask([&](World& world) { return world.find_closest(placed.shape_at(0), settings); });
  if (!found) return py::none();
  return kType(number_of(found->id), found->distance.distance, array_of(found->distance.point_a),
               array_of(found->distance.point_b), array_of(found->distance.normal), found->part,
               found->distance.lower_bound, is_converged(found->distance));
}

py::object find_in_box(SharedWorld& shared, py::handle bounds, py::handle filter, py::handle role) {
  const Points corners(bounds, "bounds");
  if (corners.size() != 2) throw InputError("bounds: are two corners, of the shape (2, 3)");
  const BodyQuerySettings settings = query_settings(filter, role);
  return array_of_ids(shared.ask([&](World& world) {
    return world.find_in_box({corners[0], corners[1]}, settings);
  }));
}

using BodyHits = std::vector<std::optional<BodyRayHit>>;

py::object ray_hits_of(const BodyHits& hits) {
  static const ResultType kType("BodyRayHits");
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
      points_of(
          hits,
          [&](const auto& hit) -> Eigen::Vector3d { return hit ? hit->hit.normal : nowhere; }),
      numbers_of<std::uint32_t>(hits, [](const auto& hit) { return hit ? hit->part : 0; }),
      numbers_of<std::int64_t>(hits,
                               [](const auto& hit) {
                                 return hit && hit->hit.triangle != kNoTriangle
                                            ? static_cast<std::int64_t>(hit->hit.triangle)
                                            : -1;
                               }),
      numbers_of<std::uint16_t>(hits, [](const auto& hit) { return hit ? hit->hit.material : 0; }));
}

py::object body_cast_rays(SharedWorld& shared, py::handle origins_argument,
                          py::handle directions_argument, py::handle max_distance,
                          py::handle filter, py::handle role, py::handle progress) {
  const Points origins(origins_argument, "origins");
  const Points directions(directions_argument, "directions");
  const double length = number_from(max_distance, "max_distance");
  const std::size_t count = origins.is_many() ? origins.size() : directions.size();
  if (origins.is_many() && directions.is_many() && origins.size() != directions.size()) {
    throw InputError("directions: are not as many as origins");
  }
  const auto ray_at = [&](std::size_t i) {
    return Ray{origins[origins.is_many() ? i : 0], directions[directions.is_many() ? i : 0],
               length};
  };
  const BodyQuerySettings settings = query_settings(filter, role);
  const BatchSettings batch{.threads = 1, .on_progress = watcher(progress)};
  return ray_hits_of(shared.ask([&](World& world) {
    for (std::size_t i = 0; i < count; ++i)
      bvh::check_element("ray", i, "", [&](const char* what) { check_ray(ray_at(i), what); });
    BodyHits found(count);
    for_each_in_batch(count, kMostInAPart, batch, nullptr, [&](std::size_t i, Work&) {
      found[i] = world.cast_ray(ray_at(i), settings);
    });
    return found;
  }));
}

py::object body_cast_ray_all(SharedWorld& shared, py::handle origin, py::handle direction,
                             py::handle max_distance, py::handle filter, py::handle role) {
  const Ray ray{vector_from(origin, "origin"), vector_from(direction, "direction"),
                number_from(max_distance, "max_distance")};
  const BodyQuerySettings settings = query_settings(filter, role);
  const auto all = shared.ask([&](World& world) { return world.cast_ray_all(ray, settings); });
  return ray_hits_of(BodyHits(all.begin(), all.end()));
}

/// What a cast in a world is asked.
struct CastQuestion {
  CastQuestion(py::handle shape, py::handle motion_argument, py::handle clearance,
               py::handle tolerance, py::handle budget, py::handle filter, py::handle role)
      : placed(single_shape(shape)),
        motion(motion_from(motion_argument, "motion")),
        contact(contact_settings(clearance, tolerance, budget)),
        settings(query_settings(filter, role)) {
    if (PyTuple_Check(shape.ptr()) != 0)
      throw py::type_error("shape: has no pose; its motion says where it is");
  }

  Placed placed;
  RigidMotion motion;
  RigidContactSettings contact;
  BodyQuerySettings settings;
};

py::object cast_result(const BodyCast& found) {
  static const ResultType kType("BodyCast");
  return kType(number_of(found.id), result_of(found.contact), found.part);
}

py::object body_cast(SharedWorld& shared, py::handle shape, py::handle motion, py::handle clearance,
                     py::handle tolerance, py::handle budget, py::handle filter, py::handle role) {
  const CastQuestion asked(shape, motion, clearance, tolerance, budget, filter, role);
  const auto found = shared.ask([&](World& world) {
    return world.cast(asked.placed.shape(), asked.motion, asked.contact, asked.settings);
  });
  return found ? cast_result(*found) : py::none();
}

py::object body_cast_all(SharedWorld& shared, py::handle shape, py::handle motion,
                         py::handle clearance, py::handle tolerance, py::handle budget,
                         py::handle filter, py::handle role) {
  const CastQuestion asked(shape, motion, clearance, tolerance, budget, filter, role);
  py::list all;
  for (const BodyCast& found : shared.ask([&](World& world) {
         return world.cast_all(asked.placed.shape(), asked.motion, asked.contact, asked.settings);
       }))
    all.append(cast_result(found));
  return all;
}

}  // namespace

BodyQuerySettings query_settings(py::handle filter, py::handle role) {
  BodyQuerySettings settings;
  if (!filter.is_none()) settings.filter = filter_from(filter);
  if (!role.is_none()) settings.role = role_from(role);
  return settings;
}

namespace {

void add_rays_and_casts(py::class_<SharedWorld>& type) {
  const double infinity = std::numeric_limits<double>::infinity();
  type.def("cast_rays", &body_cast_rays,
           "cast_rays(self, origins, directions, max_distance=1e999, *, filter=None, role=None, "
           "progress=None)\n--\n\nThe body that each ray meets first, and where: BodyRayHits. "
           "Raises InputError, with its index, for a ray that is none.",
           py::arg("origins"), py::arg("directions"), py::arg("max_distance") = infinity,
           py::kw_only(), py::arg("filter") = py::none(), py::arg("role") = py::none(),
           py::arg("progress") = py::none());
  type.def("cast_ray_all", &body_cast_ray_all,
           "cast_ray_all(self, origin, direction, max_distance=1e999, *, filter=None, "
           "role=None)\n--\n\nWhere one ray first meets each body that it meets, by distance: "
           "BodyRayHits.",
           py::arg("origin"), py::arg("direction"), py::arg("max_distance") = infinity,
           py::kw_only(), py::arg("filter") = py::none(), py::arg("role") = py::none());
  const auto add_cast = [&](const char* name, auto* function, const char* text) {
    type.def(name, function, text, py::arg("shape"), py::arg("motion"), py::kw_only(),
             py::arg("clearance") = 0.0, py::arg("tolerance") = 1e-6,
             py::arg("budget") = std::size_t{1} << 24, py::arg("filter") = py::none(),
             py::arg("role") = py::none());
  };
  add_cast("cast", &body_cast,
           "cast(self, shape, motion, *, clearance=0.0, tolerance=1e-06, budget=16777216, "
           "filter=None, role=None)\n--\n\nThe body to which a shape in rigid motion comes first, "
           "a BodyCast, or None. None is missed.");
  add_cast("cast_all", &body_cast_all,
           "cast_all(self, shape, motion, *, clearance=0.0, tolerance=1e-06, budget=16777216, "
           "filter=None, role=None)\n--\n\nAll bodies that it comes to, each asked as if it were "
           "alone: a list of BodyCasts, by time.");
}

}  // namespace

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
  type.def("find_touching", &find_touching,
           "find_touching(self, shape, *, filter=None, role=None)\n--\n\nThe bodies that touch a "
           "shape that is none of them, as they are now: ids, ascending. Of another World, or "
           "(world, pose), the pairs of a body of this world and one of it, (k, 2), of those that "
           "their filters let meet, or with `filter` False of all.",
           py::arg("shape"), py::kw_only(), filter(), role());
  type.def("find_within", &find_within,
           "find_within(self, shape, clearance, *, filter=None, role=None)\n--\n\nThe bodies whose "
           "distance to a shape is at most the clearance, metres: BodyDistances; of another World "
           "BodyPairDistances.",
           py::arg("shape"), py::arg("clearance"), py::kw_only(), filter(), role());
  type.def("find_closest", &find_closest,
           "find_closest(self, shape, *, filter=None, role=None)\n--\n\nThe body whose distance is "
           "least, a BodyDistance, or None; of another World a BodyPairDistance.",
           py::arg("shape"), py::kw_only(), filter(), role());
  type.def("find_in_box", &find_in_box,
           "find_in_box(self, bounds, *, filter=None, role=None)\n--\n\nThe bodies whose boxes "
           "share a point with one, of the "
           "shape (2, 3): ids, ascending.",
           py::arg("bounds"), py::kw_only(), filter(), role());
  add_rays_and_casts(type);
}

}  // namespace graze::python
