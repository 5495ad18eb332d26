#include <graze/engine/python/binding/arguments/rays.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>

#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/world/shape_ray.h>

#include <limits>
#include <optional>

namespace graze::python {
namespace {

using Hits = std::vector<std::optional<RayHit>>;

/// A part has as many rays as the library's own batch takes; of that the binding asks no more than
/// what would have to be copied as a whole.
constexpr std::size_t kMostRaysInAPart = 4096;

/// Casts the rays from `begin` on, in order. For a mesh what its pose costs is computed once for
/// each part.
Hits cast_part(const Placed& placed, const Rays& rays, std::size_t begin, std::size_t end,
               Work* work) {
  Hits found;
  if (!placed.is_mesh()) {
    for (std::size_t i = begin; i < end; ++i)
      found.push_back(cast_ray(placed.shape_at(0), rays[i], work));
    return found;
  }
  std::vector<Ray> part;
  part.reserve(end - begin);
  for (std::size_t i = begin; i < end; ++i)
    part.push_back(rays[i]);
  cast_rays(placed.mesh_at(0), part, found, work);
  return found;
}

/// Holds the arrays of RayHits, which threads without Python's lock fill.
class HitColumns {
 public:
  explicit HitColumns(std::size_t count)
      : is_hit_(static_cast<py::ssize_t>(count)),
        distance_(static_cast<py::ssize_t>(count)),
        point_({static_cast<py::ssize_t>(count), py::ssize_t{3}}),
        normal_({static_cast<py::ssize_t>(count), py::ssize_t{3}}),
        triangle_(static_cast<py::ssize_t>(count)),
        material_(static_cast<py::ssize_t>(count)),
        is_hits_(is_hit_.mutable_data()),
        distances_(distance_.mutable_data()),
        points_(point_.mutable_data()),
        normals_(normal_.mutable_data()),
        triangles_(triangle_.mutable_data()),
        materials_(material_.mutable_data()) {}

  void set(std::size_t i, const std::optional<RayHit>& hit) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector3d nowhere(kNone, kNone, kNone);
    is_hits_[i] = hit.has_value();
    distances_[i] = hit ? hit->distance : std::numeric_limits<double>::infinity();
    write(hit ? hit->point : nowhere, points_ + 3 * i);
    write(hit ? hit->normal : nowhere, normals_ + 3 * i);
    triangles_[i] = hit && hit->triangle != kNoTriangle ? std::int64_t{hit->triangle} : -1;
    materials_[i] = hit ? hit->material : std::uint16_t{0};
  }

  py::object result() const {
    static const ResultType kType("RayHits");
    return kType(is_hit_, distance_, point_, normal_, triangle_, material_);
  }

 private:
  py::array_t<bool> is_hit_;
  py::array_t<double> distance_, point_, normal_;
  py::array_t<std::int64_t> triangle_;
  py::array_t<std::uint16_t> material_;
  bool* is_hits_;
  double *distances_, *points_, *normals_;
  std::int64_t* triangles_;
  std::uint16_t* materials_;
};

py::object hit_of(const std::optional<RayHit>& hit) {
  static const ResultType kType("RayHit");
  if (!hit) return py::none();
  const py::object triangle =
      hit->triangle == kNoTriangle ? py::object(py::none()) : py::int_(hit->triangle);
  return kType(hit->distance, array_of(hit->point), array_of(hit->normal), triangle, hit->material);
}

py::object cast_rays_of(py::handle mesh, py::handle origins, py::handle directions,
                        py::handle max_distance, py::handle threads, py::handle progress,
                        py::handle work_argument) {
  const Placed placed(mesh, "mesh");
  if (placed.poses().is_many()) throw InputError("mesh: many poses are not taken beside rays");
  const Rays rays(origins, directions, max_distance);
  Work* work = work_from(work_argument);
  const Batch batch(threads, progress);
  if (!rays.is_many()) {
    Hits hits;
    {
      const py::gil_scoped_release released;
      hits = cast_part(placed, rays, 0, 1, work);
    }
    return hit_of(hits[0]);
  }
  HitColumns columns(rays.size());
  run_batch(
      batch, work,
      [&](const BatchSettings& settings, Work& sum) {
        for_each_part_of_batch(rays.size(), kMostRaysInAPart, settings, &sum,
                               [&](std::size_t begin, std::size_t end, BatchRun& run, Work& own) {
                                 const Hits hits = cast_part(placed, rays, begin, end, &own);
                                 for (std::size_t i = 0; i < hits.size(); ++i)
                                   columns.set(begin + i, hits[i]);
                                 run.add(end - begin);
                               });
      },
      [&] { rays.blame(); });
  return columns.result();
}

py::object cast_ray_all_of(py::handle mesh, py::handle origins, py::handle directions,
                           py::handle max_distance, py::handle threads, py::handle progress,
                           py::handle work) {
  static const ResultType kMany("RayHitLists");
  const Placed placed = placed_mesh(mesh, "mesh");
  if (placed.poses().is_many()) throw InputError("mesh: many poses are not taken beside rays");
  const Rays rays(origins, directions, max_distance);
  const auto answers = ask_all<std::vector<RayHit>>(
      rays.is_many(), rays.size(), Batch(threads, progress), work_from(work),
      [&](std::size_t i, Work* own) { return cast_ray_all(placed.mesh_at(0), rays[i], own); },
      [&] { rays.blame(); });
  std::vector<std::int64_t> offsets{0};
  for (const auto& all : answers)
    offsets.push_back(offsets.back() + static_cast<std::int64_t>(all.size()));
  HitColumns columns(static_cast<std::size_t>(offsets.back()));
  std::size_t at = 0;
  for (const auto& all : answers) {
    for (const RayHit& hit : all)
      columns.set(at++, hit);
  }
  if (!rays.is_many()) return columns.result();
  return kMany(columns.result(), array_over<std::int64_t>(std::move(offsets)));
}

constexpr const char* kCastRaysText =
    R"(cast_rays(mesh, origins, directions, max_distance=1e999, *, threads=0, progress=None, work=None)
--

Where rays meet a placed mesh or shape first: nothing slips through between neighbouring triangles.

`origins` and `directions` have the shape (3,) or (n, 3); one may stand for all rays. Directions are of any length
but 0; `max_distance`, metres along the ray, is one or n. The answer is RayHits, whose `is_hit`, `distance`,
`point`, `normal` and `triangle` have n rows: where nothing is hit, inf, NaN and -1. For one ray it is a RayHit, or
None.

Raises InputError, with its index, for a ray that is not finite or has no direction.

>>> hits = graze.cast_rays(bolt, [[1, 0, 0], [1, 1, 1]], [-1, 0, 0])
>>> hits.is_hit
array([ True, False])
)";

constexpr const char* kCastRayAllText =
    R"(cast_ray_all(mesh, origins, directions, max_distance=1e999, *, threads=0, progress=None, work=None)
--

All triangles of a placed mesh that a ray meets, by distance: RayHits. Of many rays RayHitLists: all hits in one result,
and where those of each ray begin.

Raises what cast_rays() raises.

>>> len(graze.cast_ray_all(bolt, [1, 0.0001, 0], [-1, 0, 0]).distance) % 2
0
)";

}  // namespace

void add_rays(py::module_& module) {
  const double infinity = std::numeric_limits<double>::infinity();
  module.def("cast_rays", &cast_rays_of, kCastRaysText, py::arg("mesh"), py::arg("origins"),
             py::arg("directions"), py::arg("max_distance") = infinity, py::kw_only(),
             py::arg("threads") = 0, py::arg("progress") = py::none(),
             py::arg("work") = py::none());
  module.def("cast_ray_all", &cast_ray_all_of, kCastRayAllText, py::arg("mesh"), py::arg("origins"),
             py::arg("directions"), py::arg("max_distance") = infinity, py::kw_only(),
             py::arg("threads") = 0, py::arg("progress") = py::none(),
             py::arg("work") = py::none());
}

}  // namespace graze::python
