#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/rays.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/queries/rigid_contacts.h>
#include <graze/engine/python/binding/values/motions.h>

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace graze::python {
namespace {

/// Where many poses have no meaning.
Placed single_shape(py::handle argument) {
  Placed placed(argument, "shape");
  if (placed.poses().is_many()) throw InputError("shape: many poses are not taken");
  return placed;
}

/// What `ask(world, placed)` answers for the shape in each of its poses.
template <typename Answer, typename Ask>
std::vector<Answer> ask_in_poses(SharedWorld& shared, const Placed& placed, py::handle threads,
                                 py::handle progress, const Ask& ask) {
  static_cast<void>(placed.shape());  // of a mesh it is made once, before threads ask
  std::vector<Answer> answers(placed.poses().size());
  ask_world_for_all(
      shared, answers.size(), Batch(threads, progress),
      [&](const World& world, std::size_t i) { answers[i] = ask(world, placed.shape_at(i)); },
      [&] { placed.check_poses(); });
  return answers;
}

/// Where the list of each begins, and the end of the last, as an array; and all in one.
template <typename T>
std::pair<std::vector<T>, py::object> joined(const std::vector<std::vector<T>>& lists) {
  std::vector<std::int64_t> offsets{0};
  std::vector<T> all;
  for (const std::vector<T>& list : lists) {
    all.insert(all.end(), list.begin(), list.end());
    offsets.push_back(static_cast<std::int64_t>(all.size()));
  }
  return {std::move(all), array_over<std::int64_t>(std::move(offsets))};
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

/// Where no body is, its distance is infinite.
BodyDistance no_body() {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d nowhere(kNone, kNone, kNone);
  BodyDistance none{};
  none.distance.distance = none.distance.lower_bound = std::numeric_limits<double>::infinity();
  none.distance.point_a = none.distance.point_b = none.distance.normal = nowhere;
  none.distance.status = PairStatus::Converged;
  return none;
}

py::object find_touching(SharedWorld& shared, py::handle shape, py::handle filter, py::handle role,
                         py::handle threads, py::handle progress) {
  static const ResultType kLists("BodyLists");
  if (const auto other = world_from(shape))
    return pairs_touching(shared, *other, pair_settings(filter, role));
  const Placed placed(shape, "shape");
  const BodyQuerySettings settings = query_settings(filter, role);
  if (!placed.poses().is_many()) {
    return array_of_ids(shared.ask(
        [&](World& world) { return world.find_touching(placed.shape_at(0), settings); }));
  }
  const auto [ids, offsets] = joined(ask_in_poses<std::vector<BodyId>>(
      shared, placed, threads, progress, [&](const World& world, const PlacedShape& at) {
        return world.find_touching(at, settings);
      }));
  return kLists(array_of_ids(ids), offsets);
}

py::object find_within(SharedWorld& shared, py::handle shape, py::handle clearance,
                       py::handle filter, py::handle role, py::handle threads,
                       py::handle progress) {
  static const ResultType kLists("BodyDistanceLists");
  const double metres = number_from(clearance, "clearance");
  if (const auto other = world_from(shape))
    return pairs_within(shared, *other, metres, pair_settings(filter, role));
  const Placed placed(shape, "shape");
  const BodyQuerySettings settings = query_settings(filter, role);
  if (!placed.poses().is_many()) {
    return distances_of(shared.ask(
        [&](World& world) { return world.find_within(placed.shape_at(0), metres, settings); }));
  }
  const auto [found, offsets] = joined(ask_in_poses<std::vector<BodyDistance>>(
      shared, placed, threads, progress, [&](const World& world, const PlacedShape& at) {
        return world.find_within(at, metres, settings);
      }));
  return kLists(distances_of(found), offsets);
}

py::object find_closest(SharedWorld& shared, py::handle shape, py::handle filter, py::handle role,
                        py::handle threads, py::handle progress) {
  static const ResultType kType("BodyDistance");
  if (const auto other = world_from(shape))
    return closest_pair(shared, *other, pair_settings(filter, role));
  const Placed placed(shape, "shape");
  const BodyQuerySettings settings = query_settings(filter, role);
  if (placed.poses().is_many()) {
    return distances_of(ask_in_poses<BodyDistance>(
        shared, placed, threads, progress, [&](const World& world, const PlacedShape& at) {
          return world.find_closest(at, settings).value_or(no_body());
        }));
  }
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

/// The arrays of BodyRayHits, which threads without Python's lock fill.
class BodyHitColumns {
 public:
  explicit BodyHitColumns(std::size_t count)
      : is_hit_(static_cast<py::ssize_t>(count)),
        id_(static_cast<py::ssize_t>(count)),
        distance_(static_cast<py::ssize_t>(count)),
        point_({static_cast<py::ssize_t>(count), py::ssize_t{3}}),
        normal_({static_cast<py::ssize_t>(count), py::ssize_t{3}}),
        part_(static_cast<py::ssize_t>(count)),
        triangle_(static_cast<py::ssize_t>(count)),
        material_(static_cast<py::ssize_t>(count)),
        is_hits_(is_hit_.mutable_data()),
        ids_(id_.mutable_data()),
        distances_(distance_.mutable_data()),
        points_(point_.mutable_data()),
        normals_(normal_.mutable_data()),
        parts_(part_.mutable_data()),
        triangles_(triangle_.mutable_data()),
        materials_(material_.mutable_data()) {}

  void set(std::size_t i, const std::optional<BodyRayHit>& found) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const RayHit none{
        std::numeric_limits<double>::infinity(), {kNone, kNone, kNone}, {kNone, kNone, kNone}};
    const RayHit& hit = found ? found->hit : none;
    is_hits_[i] = found.has_value();
    ids_[i] = number_of(found ? found->id : BodyId{});
    distances_[i] = hit.distance;
    write(hit.point, points_ + 3 * i);
    write(hit.normal, normals_ + 3 * i);
    parts_[i] = found ? found->part : 0;
    triangles_[i] = hit.triangle == kNoTriangle ? -1 : std::int64_t{hit.triangle};
    materials_[i] = hit.material;
  }

  py::object result() const {
    static const ResultType kType("BodyRayHits");
    return kType(is_hit_, id_, distance_, point_, normal_, part_, triangle_, material_);
  }

 private:
  py::array_t<bool> is_hit_;
  py::array_t<std::uint64_t> id_;
  py::array_t<double> distance_, point_, normal_;
  py::array_t<std::uint32_t> part_;
  py::array_t<std::int64_t> triangle_;
  py::array_t<std::uint16_t> material_;
  bool* is_hits_;
  std::uint64_t* ids_;
  double *distances_, *points_, *normals_;
  std::uint32_t* parts_;
  std::int64_t* triangles_;
  std::uint16_t* materials_;
};

py::object body_cast_rays(SharedWorld& shared, py::handle origins, py::handle directions,
                          py::handle max_distance, py::handle filter, py::handle role,
                          py::handle threads, py::handle progress) {
  const Rays rays(origins, directions, max_distance);
  const BodyQuerySettings settings = query_settings(filter, role);
  BodyHitColumns columns(rays.size());
  ask_world_for_all(
      shared, rays.size(), Batch(threads, progress),
      [&](const World& world, std::size_t i) { columns.set(i, world.cast_ray(rays[i], settings)); },
      [&] { rays.blame(); });
  return columns.result();
}

py::object body_cast_ray_all(SharedWorld& shared, py::handle origin, py::handle direction,
                             py::handle max_distance, py::handle filter, py::handle role) {
  const Ray ray{vector_from(origin, "origin"), vector_from(direction, "direction"),
                number_from(max_distance, "max_distance")};
  const BodyQuerySettings settings = query_settings(filter, role);
  const auto all = shared.ask([&](World& world) { return world.cast_ray_all(ray, settings); });
  BodyHitColumns columns(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    columns.set(i, all[i]);
  return columns.result();
}

/// What a cast in a world is asked.
struct CastQuestion {
  CastQuestion(py::handle shape, py::handle motion_argument, py::handle clearance,
               py::handle tolerance, py::handle budget, py::handle filter, py::handle role)
      : placed(single_shape(shape)),
        motions(motion_argument, "motion"),
        contact(contact_settings(clearance, tolerance, budget)),
        settings(query_settings(filter, role)) {
    if (PyTuple_Check(shape.ptr()) != 0)
      throw py::type_error("shape: has no pose; its motion says where it is");
  }

  Placed placed;
  Motions motions;
  RigidContactSettings contact;
  BodyQuerySettings settings;
};

py::object cast_result(const BodyCast& found) {
  static const ResultType kType("BodyCast");
  return kType(number_of(found.id), result_of(found.contact), found.part);
}

/// Where no body is met, the motion is free.
py::object cast_results(const std::vector<std::optional<BodyCast>>& found) {
  static const ResultType kType("BodyCasts");
  constexpr RigidContact kFree{RigidStatus::Free, 1, 1, false};
  std::vector<BodyId> ids;
  std::vector<RigidContact> contacts;
  for (const auto& cast : found) {
    ids.push_back(cast ? cast->id : BodyId{});
    contacts.push_back(cast ? cast->contact : kFree);
  }
  return kType(
      array_of_ids(ids), result_of(contacts),
      numbers_of<std::uint32_t>(found, [](const auto& cast) { return cast ? cast->part : 0; }));
}

py::object body_cast(SharedWorld& shared, py::handle shape, py::handle motion, py::handle clearance,
                     py::handle tolerance, py::handle budget, py::handle filter, py::handle role,
                     py::handle threads, py::handle progress) {
  const CastQuestion asked(shape, motion, clearance, tolerance, budget, filter, role);
  const auto ask = [&](const World& world, std::size_t i) {
    return world.cast(asked.placed.shape(), asked.motions[i], asked.contact, asked.settings);
  };
  const Batch batch(threads, progress);
  if (asked.motions.is_many()) {
    static_cast<void>(asked.placed.shape());  // made once, before threads ask for it
    std::vector<std::optional<BodyCast>> found(asked.motions.size());
    ask_world_for_all(shared, found.size(), batch,
                      [&](const World& world, std::size_t i) { found[i] = ask(world, i); }, {});
    return cast_results(found);
  }
  const auto found = shared.ask([&](World& world) { return ask(world, 0); });
  return found ? cast_result(*found) : py::none();
}

py::object body_cast_all(SharedWorld& shared, py::handle shape, py::handle motion,
                         py::handle clearance, py::handle tolerance, py::handle budget,
                         py::handle filter, py::handle role) {
  const CastQuestion asked(shape, motion, clearance, tolerance, budget, filter, role);
  if (asked.motions.is_many()) throw InputError("motion: many motions are not taken");
  py::list all;
  for (const BodyCast& found : shared.ask([&](World& world) {
         return world.cast_all(asked.placed.shape(), asked.motions[0], asked.contact,
                               asked.settings);
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
           "threads=0, progress=None)\n--\n\nThe body that each ray meets first, and where: "
           "BodyRayHits. Arguments are those of graze.cast_rays(). Raises InputError, with its "
           "index, for a ray that is none.",
           py::arg("origins"), py::arg("directions"), py::arg("max_distance") = infinity,
           py::kw_only(), py::arg("filter") = py::none(), py::arg("role") = py::none(),
           py::arg("threads") = 0, py::arg("progress") = py::none());
  type.def("cast_ray_all", &body_cast_ray_all,
           "cast_ray_all(self, origin, direction, max_distance=1e999, *, filter=None, "
           "role=None)\n--\n\nWhere one ray first meets each body that it meets, by distance: "
           "BodyRayHits.",
           py::arg("origin"), py::arg("direction"), py::arg("max_distance") = infinity,
           py::kw_only(), py::arg("filter") = py::none(), py::arg("role") = py::none());
  const auto clearance = [] { return py::arg("clearance") = 0.0; };
  const auto tolerance = [] { return py::arg("tolerance") = 1e-6; };
  const auto budget = [] { return py::arg("budget") = std::size_t{1} << 24; };
  type.def("cast", &body_cast,
           "cast(self, shape, motion, *, clearance=0.0, tolerance=1e-06, budget=16777216, "
           "filter=None, role=None, threads=0, progress=None)\n--\n\nThe body to which a shape in "
           "rigid motion comes first, a BodyCast, or None. None is missed. With a list of motions "
           "BodyCasts: arrays, of which those that meet no body are free.",
           py::arg("shape"), py::arg("motion"), py::kw_only(), clearance(), tolerance(), budget(),
           py::arg("filter") = py::none(), py::arg("role") = py::none(), py::arg("threads") = 0,
           py::arg("progress") = py::none());
  type.def("cast_all", &body_cast_all,
           "cast_all(self, shape, motion, *, clearance=0.0, tolerance=1e-06, budget=16777216, "
           "filter=None, role=None)\n--\n\nAll bodies that it comes to, each asked as if it were "
           "alone: a list of each BodyCast, by time.",
           py::arg("shape"), py::arg("motion"), py::kw_only(), clearance(), tolerance(), budget(),
           py::arg("filter") = py::none(), py::arg("role") = py::none());
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
  const auto threads = [] { return py::arg("threads") = 0; };
  const auto progress = [] { return py::arg("progress") = py::none(); };
  type.def("find_touching", &find_touching,
           "find_touching(self, shape, *, filter=None, role=None, threads=0, "
           "progress=None)\n--\n\nThe bodies that touch a shape that is none of them, as they are "
           "now: ids, ascending; of a shape in n poses BodyLists. Of another World, or (world, "
           "pose), the pairs of a body of this world and one of it, (k, 2), of those that their "
           "filters let meet, or with `filter` False of all.",
           py::arg("shape"), py::kw_only(), filter(), role(), threads(), progress());
  type.def("find_within", &find_within,
           "find_within(self, shape, clearance, *, filter=None, role=None, threads=0, "
           "progress=None)\n--\n\nThe bodies whose distance to a shape is at most the clearance, "
           "metres: BodyDistances; of a shape in n poses BodyDistanceLists, of another World "
           "BodyPairDistances.",
           py::arg("shape"), py::arg("clearance"), py::kw_only(), filter(), role(), threads(),
           progress());
  type.def("find_closest", &find_closest,
           "find_closest(self, shape, *, filter=None, role=None, threads=0, "
           "progress=None)\n--\n\nThe body whose distance is least, a BodyDistance, or None; of a "
           "shape in n poses BodyDistances with n rows, of which those without a body have the "
           "distance inf; of another World a BodyPairDistance.",
           py::arg("shape"), py::kw_only(), filter(), role(), threads(), progress());
  type.def("find_in_box", &find_in_box,
           "find_in_box(self, bounds, *, filter=None, role=None)\n--\n\nThe bodies whose boxes "
           "share a point with one, of the "
           "shape (2, 3): ids, ascending.",
           py::arg("bounds"), py::kw_only(), filter(), role());
  add_rays_and_casts(type);
}

}  // namespace graze::python
