#include <graze/bvh/value/number_text.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/queries/pair_memories.h>

#include <graze/engine/mesh/distance.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_separation.h>

#include <cmath>

namespace graze::python {
namespace {

DistanceSettings settings_from(py::handle hint) {
  if (hint.is_none()) return {};
  if (!PySequence_Check(hint.ptr()) || py::len(hint) != 2)
    throw InputError("hint: is no pair of triangles");
  const auto sequence = py::reinterpret_borrow<py::sequence>(hint);
  const std::size_t a = count_from(sequence[0], "hint");
  const std::size_t b = count_from(sequence[1], "hint");
  if (a > 0xffffffffu || b > 0xffffffffu) throw InputError("hint: an index is out of range");
  return {.hint = TrianglePair{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)}};
}

py::object mesh_distances(const PlacedPair& pair, const DistanceSettings& settings,
                          LockedMemory& memory, const Batch& batch, Work* work) {
  static const ResultType kSingle("MeshDistance");
  static const ResultType kMany("MeshDistances");
  const auto lock = memory.lock_for_batch();
  const auto answers = ask_all<MeshDistance>(pair, batch, work, [&](std::size_t i, Work* own) {
    const PlacedMeshView a = pair.a.mesh_at(i);
    const PlacedMeshView b = pair.b.mesh_at(i);
    return memory.get() == nullptr ? distance(a, b, settings, own)
                                   : distance(a, b, *memory.get(), settings, own);
  });
  if (!pair.is_many()) {
    const MeshDistance& gap = answers[0];
    return kSingle(gap.distance, array_of(gap.point_a), array_of(gap.point_b),
                   py::make_tuple(gap.pair.a, gap.pair.b));
  }
  return kMany(numbers_of<double>(answers, [](const auto& gap) { return gap.distance; }),
               points_of(answers, [](const auto& gap) { return gap.point_a; }),
               points_of(answers, [](const auto& gap) { return gap.point_b; }),
               index_pairs_of(answers, [](const auto& gap) { return gap.pair; }));
}

ShapeDistance ask_shapes(const PlacedPair& pair, std::size_t index, Work* work) {
  return distance(pair.a.shape_at(index), pair.b.shape_at(index), work);
}

py::object shape_distances(const PlacedPair& pair, const Batch& batch, Work* work) {
  static const ResultType kSingle("ShapeDistance");
  static const ResultType kMany("ShapeDistances");
  const auto answers = ask_all<ShapeDistance>(
      pair, batch, work, [&](std::size_t i, Work* own) { return ask_shapes(pair, i, own); });
  const auto is_converged = [](const ShapeDistance& gap) {
    return gap.status == PairStatus::Converged;
  };
  if (!pair.is_many()) {
    const ShapeDistance& gap = answers[0];
    return kSingle(gap.distance, gap.lower_bound, array_of(gap.point_a), array_of(gap.point_b),
                   array_of(gap.normal), is_converged(gap));
  }
  return kMany(numbers_of<double>(answers, [](const auto& gap) { return gap.distance; }),
               numbers_of<double>(answers, [](const auto& gap) { return gap.lower_bound; }),
               points_of(answers, [](const auto& gap) { return gap.point_a; }),
               points_of(answers, [](const auto& gap) { return gap.point_b; }),
               points_of(answers, [](const auto& gap) { return gap.normal; }),
               numbers_of<bool>(answers, is_converged));
}

py::object distance_of(py::handle a, py::handle b, py::handle hint, py::handle memory_argument,
                       py::handle threads, py::handle progress, py::handle work_argument) {
  const PlacedPair pair(a, b);
  Work* work = work_from(work_argument);
  LockedMemory memory(memory_argument, pair);
  const Batch batch = memory.batch(threads, progress);
  if (pair.are_meshes()) return mesh_distances(pair, settings_from(hint), memory, batch, work);
  if (!hint.is_none()) throw InputError("hint: is for two meshes");
  return shape_distances(pair, batch, work);
}

bool ask_within(const PlacedPair& pair, std::size_t index, double clearance, PairMemory* memory,
                Work* work) {
  if (!pair.are_meshes()) {
    const ShapeDistance gap = ask_shapes(pair, index, work);
    return (gap.status == PairStatus::Converged ? gap.distance : gap.lower_bound) <= clearance;
  }
  const PlacedMeshView a = pair.a.mesh_at(index);
  const PlacedMeshView b = pair.b.mesh_at(index);
  return memory == nullptr ? within(a, b, clearance, {}, work)
                           : within(a, b, clearance, *memory, {}, work);
}

py::object within_of(py::handle a, py::handle b, py::handle clearance_argument,
                     py::handle memory_argument, py::handle threads, py::handle progress,
                     py::handle work_argument) {
  const PlacedPair pair(a, b);
  const double clearance = number_from(clearance_argument, "clearance");
  if (!(clearance >= 0))
    throw InputError("clearance: " + bvh::number_text(clearance) + " is no distance");
  Work* work = work_from(work_argument);
  LockedMemory memory(memory_argument, pair);
  const Batch batch = memory.batch(threads, progress);
  const auto lock = memory.lock_for_batch();
  const auto answers = ask_all<char>(pair, batch, work, [&](std::size_t i, Work* own) {
    return static_cast<char>(ask_within(pair, i, clearance, memory.get(), own));
  });
  if (!pair.is_many()) return py::bool_(answers[0] != 0);
  return numbers_of<bool>(answers, [](char says) { return says != 0; });
}

py::object separation_of_shapes(py::handle a, py::handle b, py::handle threads, py::handle progress,
                                py::handle work) {
  static const ResultType kSingle("ShapeSeparation");
  static const ResultType kMany("ShapeSeparations");
  const PlacedPair pair(a, b);
  const auto answers = ask_all<ShapeSeparation>(
      pair, Batch(threads, progress), work_from(work), [&](std::size_t i, Work* own) {
        return find_separation(pair.a.shape_at(i), pair.b.shape_at(i), own);
      });
  const auto is_converged = [](const ShapeSeparation& found) {
    return found.status == PairStatus::Converged;
  };
  if (!pair.is_many()) {
    const ShapeSeparation& found = answers[0];
    return kSingle(found.distance, array_of(found.point_a), array_of(found.point_b),
                   array_of(found.normal), is_converged(found));
  }
  return kMany(numbers_of<double>(answers, [](const auto& found) { return found.distance; }),
               points_of(answers, [](const auto& found) { return found.point_a; }),
               points_of(answers, [](const auto& found) { return found.point_b; }),
               points_of(answers, [](const auto& found) { return found.normal; }),
               numbers_of<bool>(answers, is_converged));
}

constexpr const char* kDistanceText =
    R"(distance(a, b, *, hint=None, memory=None, threads=0, progress=None, work=None)
--

How far apart two placed meshes or shapes are, metres, and where. `a`, `b`, poses, `memory`, `threads`, `progress`
and `work` are as of intersects().

Of two meshes a MeshDistance: `distance`, which is 0 if and only if intersects() is True, the nearest points
`point_a` and `point_b`, and the triangles `pair` that they lie in. With many poses MeshDistances, which has arrays
of the shapes (n,), (n, 3), (n, 3) and (n, 2). `hint` is a pair of triangles to look at first; it changes no result.
Where one is another shape than a mesh a ShapeDistance, or ShapeDistances, with a `lower_bound` that is proved.

Raises what intersects() raises, and InputError for a hint that is out of range.

>>> gap = graze.distance(bolt, (nut, far))
>>> round(gap.distance, 3), gap.point_a.shape
(0.987, (3,))
)";

constexpr const char* kWithinText =
    R"(within(a, b, clearance, *, memory=None, threads=0, progress=None, work=None)
--

Whether distance(a, b) is at most `clearance`, metres, without finding it. A bool, or with many poses an array.

Raises what distance() raises, and InputError for a clearance that is negative or NaN.

>>> graze.within(bolt, (nut, far), 0.5)
False
)";

constexpr const char* kSeparationText =
    R"(find_separation(a, b, *, threads=0, progress=None, work=None)
--

The signed distance of two convex shapes, metres: a ShapeSeparation, whose `distance` is minus the depth where they
reach past each other. With many poses ShapeSeparations: arrays.

Raises UnsupportedPairError for a mesh, which is a surface, and for two half-spaces that intersect.

>>> ball = graze.Sphere([0, 0, 0], 1)
>>> at = np.eye(4)
>>> at[0, 3] = 1.5
>>> graze.find_separation(ball, (ball, at)).distance
-0.5
)";

}  // namespace

void add_distances(py::module_& module) {
  module.def("distance", &distance_of, kDistanceText, py::arg("a"), py::arg("b"), py::kw_only(),
             py::arg("hint") = py::none(), py::arg("memory") = py::none(), py::arg("threads") = 0,
             py::arg("progress") = py::none(), py::arg("work") = py::none());
  module.def("within", &within_of, kWithinText, py::arg("a"), py::arg("b"), py::arg("clearance"),
             py::kw_only(), py::arg("memory") = py::none(), py::arg("threads") = 0,
             py::arg("progress") = py::none(), py::arg("work") = py::none());
  module.def("find_separation", &separation_of_shapes, kSeparationText, py::arg("a"), py::arg("b"),
             py::kw_only(), py::arg("threads") = 0, py::arg("progress") = py::none(),
             py::arg("work") = py::none());
}

}  // namespace graze::python
