#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>

#include <graze/bvh/value/element_error.h>
#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/distance.h>

#include <string>
#include <type_traits>
#include <utility>

namespace graze::python {
namespace {

/// Holds one mesh in one pose and the points that it is asked about.
struct PointQuestion {
  PointQuestion(py::handle mesh, py::handle points_argument)
      : placed(placed_mesh(mesh, "mesh")), points(points_argument, "points") {
    if (placed.poses().is_many()) throw InputError("mesh: many poses are not taken beside points");
  }

  /// Throws for the first point that is not finite.
  void blame() const {
    for (std::size_t i = 0; points.is_many() && i < points.size(); ++i) {
      bvh::at_element("point", i, [&] {
        if (!points[i].allFinite())
          throw InputError("points: point " + std::to_string(i) + " is not finite");
      });
    }
  }

  /// Returns what `one(mesh, point, work)` answers for a single point.
  template <typename One>
  auto single(Work* work, const One& one) const {
    const py::gil_scoped_release released;
    return one(placed.mesh_at(0), points[0], work);
  }

  /// Returns what `all(mesh, points, settings, work)` answers, the library's batch.
  template <typename All>
  auto many(const Batch& batch, Work* work, const All& all) const {
    const MatrixView<double> rows = points.matrix();
    std::invoke_result_t<const All&, PlacedMeshView, const MatrixView<double>&,
                         const BatchSettings&, Work*>
        answers;
    run_batch(
        batch, work,
        [&](const BatchSettings& settings, Work& sum) {
          answers = all(placed.mesh_at(0), rows, settings, &sum);
        },
        [this] { blame(); });
    return answers;
  }

  Placed placed;
  Points points;
};

py::object contains_of(py::handle mesh, py::handle points, py::handle threads, py::handle progress,
                       py::handle work) {
  const PointQuestion question(mesh, points);
  const Batch batch(threads, progress);
  if (!question.points.is_many()) {
    return py::bool_(
        question.single(work_from(work), [](const auto& placed, const auto& point, Work* own) {
          return contains(placed, point, own);
        }));
  }
  const auto answers =
      question.many(batch, work_from(work),
                    [](const auto& placed, const auto& rows, const BatchSettings& settings,
                       Work* own) { return contains_points(placed, rows, settings, own); });
  return numbers_of<bool>(answers, [](bool says) { return says; });
}

py::object nearest_of(py::handle mesh, py::handle points, py::handle threads, py::handle progress,
                      py::handle work) {
  static const ResultType kSingle("NearestPoint");
  static const ResultType kMany("NearestPoints");
  const PointQuestion question(mesh, points);
  const Batch batch(threads, progress);
  if (!question.points.is_many()) {
    const NearestPoint near =
        question.single(work_from(work), [](const auto& placed, const auto& point, Work* own) {
          return nearest_point(placed, point, own);
        });
    return kSingle(near.distance, array_of(near.point), near.triangle);
  }
  const auto answers =
      question.many(batch, work_from(work),
                    [](const auto& placed, const auto& rows, const BatchSettings& settings,
                       Work* own) { return nearest_points(placed, rows, settings, own); });
  // This makes one pass, as a million answers are more than a cache holds.
  const auto count = static_cast<py::ssize_t>(answers.size());
  auto distances = new_array<double>({count}), where = new_array<double>({count, 3});
  auto triangles = new_array<std::uint32_t>({count});
  double *distance = distances.mutable_data(), *row = where.mutable_data();
  std::uint32_t* triangle = triangles.mutable_data();
  for (const NearestPoint& near : answers) {
    *distance++ = near.distance;
    write(near.point, row);
    row += 3;
    *triangle++ = near.triangle;
  }
  return kMany(std::move(distances), std::move(where), std::move(triangles));
}

py::object signed_of(py::handle mesh, py::handle points, py::handle threads, py::handle progress,
                     py::handle work) {
  const PointQuestion question(mesh, points);
  const Batch batch(threads, progress);
  if (!question.points.is_many()) {
    return py::float_(
        question.single(work_from(work), [](const auto& placed, const auto& point, Work* own) {
          return signed_distance(placed, point, own);
        }));
  }
  auto answers =
      question.many(batch, work_from(work),
                    [](const auto& placed, const auto& rows, const BatchSettings& settings,
                       Work* own) { return signed_distances(placed, rows, settings, own); });
  return array_over<double>(std::move(answers));
}

constexpr const char* kContainsText =
    R"(contains(mesh, points, *, threads=0, progress=None, work=None)
--

Whether points lie on a closed placed mesh or are enclosed by it, by the even-odd rule: exactly.

`mesh` is a Mesh or (mesh, pose); `points` have the shape (3,), for which the answer is a bool, or (n, 3), metres:
an array of n bools, on all threads.

Raises MeshError for a mesh that is not closed, and InputError, with its index, for a point that is not finite.

>>> graze.contains(bolt, [[0, 0, 0], [1, 0, 0]])
array([ True, False])
)";

constexpr const char* kNearestText =
    R"(nearest_points(mesh, points, *, threads=0, progress=None, work=None)
--

The points of a placed mesh's surface that are nearest to other points: NearestPoints, whose `distance`, `point` and
`triangle` have the shapes (n,), (n, 3) and (n,); or for a point of the shape (3,) a NearestPoint.

Raises InputError, with its index, for a point that is not finite.

>>> near = graze.nearest_points(bolt, [[1, 0, 0], [0, 1, 0]])
>>> near.point.shape
(2, 3)
)";

constexpr const char* kSignedText =
    R"(signed_distances(mesh, points, *, threads=0, progress=None, work=None)
--

How far points are from a closed placed mesh's surface, metres, negative inside: an array of the shape (n,), or a
float for a point of the shape (3,).

Raises MeshError for a mesh that is not closed, and InputError, with its index, for a point that is not finite.

>>> graze.signed_distances(bolt, [0, 0, 0]) < 0
True
)";

}  // namespace

void add_points(py::module_& module) {
  const auto add = [&](const char* name, auto* function, const char* text) {
    module.def(name, function, text, py::arg("mesh"), py::arg("points"), py::kw_only(),
               py::arg("threads") = 0, py::arg("progress") = py::none(),
               py::arg("work") = py::none());
  };
  add("contains", &contains_of, kContainsText);
  add("nearest_points", &nearest_of, kNearestText);
  add("signed_distances", &signed_of, kSignedText);
}

}  // namespace graze::python
