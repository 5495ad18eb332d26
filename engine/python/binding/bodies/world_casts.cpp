#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/rays.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/queries/rigid_contacts.h>
#include <graze/engine/python/binding/values/motions.h>

#include <graze/engine/world/world_batch.h>

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace graze::python {
namespace {

/// Holds the arrays of BodyRayHits, which threads without Python's lock fill.
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

py::object body_hits(const std::vector<BodyRayHit>& all) {
  BodyHitColumns columns(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    columns.set(i, all[i]);
  return columns.result();
}

py::object body_cast_ray_all(SharedWorld& shared, py::handle origins, py::handle directions,
                             py::handle max_distance, py::handle filter, py::handle role,
                             py::handle threads, py::handle progress) {
  static const ResultType kLists("BodyRayHitLists");
  const Rays rays(origins, directions, max_distance);
  const BodyQuerySettings settings = query_settings(filter, role);
  const Batch batch(threads, progress);
  if (!rays.is_many()) {
    return body_hits(
        shared.ask([&](World& world) { return world.cast_ray_all(rays[0], settings); }));
  }
  std::vector<std::vector<BodyRayHit>> found(rays.size());
  ask_world_for_all(
      shared, rays.size(), batch,
      [&](const World& world, std::size_t i) { found[i] = world.cast_ray_all(rays[i], settings); },
      [&] { rays.blame(); });
  const auto [hits, offsets] = joined(found);
  return kLists(body_hits(hits), offsets);
}

/// Says what casts in a world are asked.
struct CastQuestion {
  CastQuestion(py::handle shape, py::handle motion_argument, py::handle clearance,
               py::handle tolerance, py::handle budget, py::handle filter, py::handle role)
      : placed(shape, "shape"),
        motions(motion_argument, "motion"),
        contact(contact_settings(clearance, tolerance, budget)),
        settings(query_settings(filter, role)) {
    if (PyTuple_Check(shape.ptr()) != 0)
      throw py::type_error("shape: has no pose; its motion says where it is");
  }

  ShapeInMotions in_motions() const { return {placed.shape(), motions.all()}; }

  Placed placed;
  Motions motions;
  RigidContactSettings contact;
  BodyQuerySettings settings;
};

py::object cast_result(const BodyCast& found) {
  static const ResultType kType("BodyCast");
  return kType(number_of(found.id), result_of(found.contact), found.part);
}

py::object cast_results(const std::vector<BodyCast>& found) {
  static const ResultType kType("BodyCasts");
  std::vector<BodyId> ids;
  std::vector<RigidContact> contacts;
  ids.reserve(found.size());
  contacts.reserve(found.size());
  for (const BodyCast& cast : found) {
    ids.push_back(cast.id);
    contacts.push_back(cast.contact);
  }
  return kType(array_of_ids(ids), result_of(contacts),
               numbers_of<std::uint32_t>(found, [](const BodyCast& cast) { return cast.part; }));
}

/// Returns the answer where no body is met: the motion is free.
BodyCast no_body_met() {
  return {BodyId{}, {RigidStatus::Free, 1, 1, false}};
}

py::object body_cast(SharedWorld& shared, py::handle shape, py::handle motion, py::handle clearance,
                     py::handle tolerance, py::handle budget, py::handle filter, py::handle role,
                     py::handle threads, py::handle progress) {
  const CastQuestion asked(shape, motion, clearance, tolerance, budget, filter, role);
  const Batch batch(threads, progress);
  const ShapeInMotions moved = asked.in_motions();  // what a mesh needs for it is made once
  if (!asked.motions.is_many()) {
    const auto found = shared.ask([&](World& world) {
      return world.cast({moved.shape, moved.motions[0]}, asked.contact, asked.settings);
    });
    return found ? cast_result(*found) : py::none();
  }
  std::vector<BodyCast> rows;
  ask_world_in_batch(shared, batch, [&](const World& world, const BatchSettings& settings) {
    const auto found = cast(world, moved, asked.contact, asked.settings, settings);
    rows.reserve(found.size());
    for (const std::optional<BodyCast>& met : found)
      rows.push_back(met.value_or(no_body_met()));
  });
  return cast_results(rows);
}

py::object body_cast_all(SharedWorld& shared, py::handle shape, py::handle motion,
                         py::handle clearance, py::handle tolerance, py::handle budget,
                         py::handle filter, py::handle role, py::handle threads,
                         py::handle progress) {
  static const ResultType kLists("BodyCastLists");
  const CastQuestion asked(shape, motion, clearance, tolerance, budget, filter, role);
  const Batch batch(threads, progress);
  const ShapeInMotions moved = asked.in_motions();
  if (!asked.motions.is_many()) {
    py::list all;
    for (const BodyCast& found : shared.ask([&](World& world) {
           return world.cast_all({moved.shape, moved.motions[0]}, asked.contact, asked.settings);
         }))
      all.append(cast_result(found));
    return all;
  }
  std::vector<std::vector<BodyCast>> found;
  ask_world_in_batch(shared, batch, [&](const World& world, const BatchSettings& settings) {
    found = cast_all(world, moved, asked.contact, asked.settings, settings);
  });
  const auto [casts, offsets] = joined(found);
  return kLists(cast_results(casts), offsets);
}

}  // namespace

void add_world_casts(py::module_& module) {
  py::class_<SharedWorld> type(module.attr("World"));
  const double infinity = std::numeric_limits<double>::infinity();
  const auto none = [](const char* name) { return py::arg(name) = py::none(); };
  const auto threads = [] { return py::arg("threads") = 0; };
  type.def("cast_rays", &body_cast_rays,
           "cast_rays(self, origins, directions, max_distance=1e999, *, filter=None, role=None, "
           "threads=0, progress=None)\n--\n\nThe body that each ray meets first, and where: "
           "BodyRayHits. Arguments are those of graze.cast_rays(). Raises InputError, with its "
           "index, for a ray that is none.",
           py::arg("origins"), py::arg("directions"), py::arg("max_distance") = infinity,
           py::kw_only(), none("filter"), none("role"), threads(), none("progress"));
  type.def("cast_ray_all", &body_cast_ray_all,
           "cast_ray_all(self, origins, directions, max_distance=1e999, *, filter=None, "
           "role=None, threads=0, progress=None)\n--\n\nWhere a ray first meets each body that "
           "it meets, by distance: BodyRayHits; of many rays BodyRayHitLists. Raises as "
           "cast_rays() does.",
           py::arg("origins"), py::arg("directions"), py::arg("max_distance") = infinity,
           py::kw_only(), none("filter"), none("role"), threads(), none("progress"));
  const auto clearance = [] { return py::arg("clearance") = 0.0; };
  const auto tolerance = [] { return py::arg("tolerance") = 1e-6; };
  const auto budget = [] { return py::arg("budget") = std::size_t{1} << 24; };
  type.def("cast", &body_cast,
           "cast(self, shape, motion, *, clearance=0.0, tolerance=1e-06, budget=16777216, "
           "filter=None, role=None, threads=0, progress=None)\n--\n\nThe body to which a shape "
           "in rigid motion comes first, a BodyCast, or None. None is missed. With RigidMotions, "
           "or a list of motions, BodyCasts: arrays, of which those that meet no body are free. "
           "Raises InputError, PoseError with the index of the motion, and what first_contact() "
           "raises.",
           py::arg("shape"), py::arg("motion"), py::kw_only(), clearance(), tolerance(), budget(),
           none("filter"), none("role"), threads(), none("progress"));
  type.def("cast_all", &body_cast_all,
           "cast_all(self, shape, motion, *, clearance=0.0, tolerance=1e-06, budget=16777216, "
           "filter=None, role=None, threads=0, progress=None)\n--\n\nAll bodies that it comes "
           "to, each asked as if it were alone: a list of each BodyCast, by time; of many motions "
           "BodyCastLists. Raises as cast() does.",
           py::arg("shape"), py::arg("motion"), py::kw_only(), clearance(), tolerance(), budget(),
           none("filter"), none("role"), threads(), none("progress"));
}

}  // namespace graze::python
