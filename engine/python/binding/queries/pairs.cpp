#include <graze/engine/python/binding/arguments/batch.h>
#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/pair_memories.h>

#include <graze/engine/mesh/pair.h>
#include <graze/engine/world/shape_pairs.h>

namespace graze::python {
namespace {

/// Asks about two meshes, two placed elements of a batch, or two shapes.
bool ask_intersects(const PlacedPair& pair, std::size_t index, Hit hit, PairMemory* memory,
                    Work* work) {
  if (!pair.are_meshes()) return intersects(pair.a.shape_at(index), pair.b.shape_at(index), work);
  const PlacedMeshView a = pair.a.mesh_at(index);
  const PlacedMeshView b = pair.b.mesh_at(index);
  if (memory != nullptr) return intersects(a, b, *memory, {.hit = hit}, work);
  return intersects(a, b, {.hit = hit}, work);
}

py::object intersects_of(py::handle a, py::handle b, py::handle hit_word,
                         py::handle memory_argument, py::handle threads, py::handle progress,
                         py::handle work_argument) {
  const PlacedPair pair(a, b);
  const Hit hit = hit_from(hit_word);
  Work* work = work_from(work_argument);
  if (!pair.are_meshes() && hit != Hit::Touching) {
    throw InputError("hit: of shapes only \"touching\" is known; convex ones are solid");
  }
  LockedMemory memory(memory_argument, pair);
  if (!pair.is_many()) {
    bool says = false;
    {
      const py::gil_scoped_release released;
      const auto lock = memory.lock();
      ask_and_blame([&] { says = ask_intersects(pair, 0, hit, memory.get(), work); },
                    [&] { pair.check_poses(); });
    }
    return py::bool_(says);
  }
  auto answers = new_array<bool>({static_cast<py::ssize_t>(pair.size())});
  bool* says = answers.mutable_data();
  const auto lock = memory.lock_for_batch();
  run_batch(
      pair.size(), memory.batch(threads, progress), work,
      [&](std::size_t i, Work& own) { says[i] = ask_intersects(pair, i, hit, memory.get(), &own); },
      [&] { pair.check_poses(); });
  return answers;
}

TrianglePairs ask_pairs(const PlacedPair& pair, std::size_t index,
                        const MemoryPairSettings& settings, PairMemory* memory, Work* work) {
  const PlacedMeshView a = pair.a.mesh_at(index);
  const PlacedMeshView b = pair.b.mesh_at(index);
  if (memory != nullptr) return find_triangle_pairs(a, b, *memory, settings, work);
  return find_triangle_pairs(a, b, {.limit = settings.limit, .touch = settings.touch}, work);
}

/// Asks about the one pose of a pair. Threads share the query where there is no limit.
TrianglePairs ask_one_pair(const PlacedPair& pair, const MemoryPairSettings& settings, int threads,
                           PairMemory* memory, Work* work) {
  if (threads == 1 || settings.limit != kNoLimit) return ask_pairs(pair, 0, settings, memory, work);
  const SharedPairSettings shared{.threads = threads, .touch = settings.touch};
  const PlacedMeshView a = pair.a.mesh_at(0), b = pair.b.mesh_at(0);
  return memory != nullptr ? find_triangle_pairs(a, b, *memory, shared, work)
                           : find_triangle_pairs(a, b, shared, work);
}

/// Returns lists one behind the other, and where each begins.
py::object lists_of(std::vector<TrianglePairs>&& found) {
  static const ResultType kType("TrianglePairLists");
  const auto count = static_cast<py::ssize_t>(found.size());
  auto offsets = new_array<std::int64_t>({count + 1});
  auto is_complete = new_array<bool>({count});
  std::int64_t* offset = offsets.mutable_data();
  bool* complete = is_complete.mutable_data();
  std::vector<TrianglePair> all;
  {
    const py::gil_scoped_release released;
    std::size_t total = 0;
    for (const TrianglePairs& pairs : found)
      total += pairs.size();
    all.reserve(total);
    for (const TrianglePairs& pairs : found) {
      *offset++ = static_cast<std::int64_t>(all.size());
      *complete++ = pairs.completeness == Completeness::Complete;
      all.insert(all.end(), pairs.begin(), pairs.end());
    }
    *offset = static_cast<std::int64_t>(all.size());
    std::vector<TrianglePairs>().swap(found);
  }
  return kType(array_over<std::uint32_t>(std::move(all), 2), std::move(offsets),
               std::move(is_complete));
}

py::object pairs_of(py::handle a, py::handle b, py::handle limit, py::handle touch,
                    py::handle memory_argument, py::handle threads, py::handle progress,
                    py::handle work_argument) {
  static const ResultType kType("TrianglePairs");
  const PlacedPair pair(a, b);
  pair.require_meshes("find_triangle_pairs");
  const MemoryPairSettings settings{.limit = limit_from(limit), .touch = touch_from(touch)};
  Work* work = work_from(work_argument);
  LockedMemory memory(memory_argument, pair);
  if (!pair.is_many()) {
    const int most = Batch(threads, progress).threads;
    TrianglePairs found;
    {
      const py::gil_scoped_release released;
      const auto lock = memory.lock();
      ask_and_blame([&] { found = ask_one_pair(pair, settings, most, memory.get(), work); },
                    [&] { pair.check_poses(); });
    }
    return kType(array_over<std::uint32_t>(std::move(found.pairs), 2),
                 found.completeness == Completeness::Complete);
  }
  std::vector<TrianglePairs> found(pair.size());
  const auto lock = memory.lock_for_batch();
  run_batch(
      pair.size(), memory.batch(threads, progress), work,
      [&](std::size_t i, Work& own) {
        found[i] = ask_pairs(pair, i, settings, memory.get(), &own);
      },
      [&] { pair.check_poses(); });
  return lists_of(std::move(found));
}

py::object interiors_of(py::handle a, py::handle b, py::handle threads, py::handle progress,
                        py::handle work_argument) {
  const PlacedPair pair(a, b);
  pair.require_meshes("interiors_intersect");
  Work* work = work_from(work_argument);
  if (!pair.is_many()) {
    bool says = false;
    {
      const py::gil_scoped_release released;
      ask_and_blame([&] { says = interiors_intersect(pair.a.mesh_at(0), pair.b.mesh_at(0), work); },
                    [&] { pair.check_poses(); });
    }
    return py::bool_(says);
  }
  auto answers = new_array<bool>({static_cast<py::ssize_t>(pair.size())});
  bool* says = answers.mutable_data();
  run_batch(
      pair.size(), Batch(threads, progress), work,
      [&](std::size_t i, Work& own) {
        says[i] = interiors_intersect(pair.a.mesh_at(i), pair.b.mesh_at(i), &own);
      },
      [&] { pair.check_poses(); });
  return answers;
}

constexpr const char* kIntersectsText =
    R"(intersects(a, b, *, hit='touching', memory=None, threads=0, progress=None, work=None)
--

Whether two placed meshes or shapes share a point: True if they do, touching included.

`a` and `b` are each a Mesh or a Shape, or a tuple of one and its pose: a rigid matrix of the shape (4, 4) or
(3, 4), metres. With poses of the shape (n, 4, 4) or (n, 3, 4) in one of them, or equally many in both, the
answer is an array of n bools: on all threads, or on as many as `threads` says. Exact for meshes. Meshes are
surfaces, unless `hit` is "solid"; "crossing" leaves out what merely touches.

`memory`, a PairMemory, saves time along a motion and changes no answer; many poses are then asked in their
order, on one thread. `progress` is called with (done, total), or is a bar with a method update(). Ctrl-C ends
a batch. `work` sums up what was done.

Raises PoseError for a pose that is not rigid, with its index; MeshError for "solid" and a mesh that is not
closed; InputError, a ValueError, for any other argument; TypeError for what is no mesh and no shape.

>>> graze.intersects(bolt, (nut, pose))
True
>>> far = np.eye(4)
>>> far[:3, 3] = 1, 0, 0
>>> graze.intersects(bolt, (nut, np.stack([pose, far])))
array([ True, False])
)";

constexpr const char* kPairsText =
    R"(find_triangle_pairs(a, b, *, limit=None, touch='include', memory=None, threads=0, progress=None, work=None)
--

All pairs of triangles of two placed meshes that share a point: TrianglePairs, whose `pairs` have the shape
(k, 2), ascending. At most `limit` of them; `is_complete` says whether that is all there is. With many poses,
as of intersects(), TrianglePairLists: all pairs in one array, and where those of each pose begin. `touch` may be
"exclude", which leaves out what merely touches. `threads` share many poses, or one pose without a limit: which
pairs come first is for one thread to say.

Raises what intersects() raises.

>>> found = graze.find_triangle_pairs(bolt, (nut, pose))
>>> found.pairs.shape[1], found.is_complete
(2, True)
)";

constexpr const char* kInteriorsText =
    R"(interiors_intersect(a, b, *, threads=0, progress=None, work=None)
--

Whether the open interiors of two closed meshes have a point in common: what merely touches does not overlap.
Many poses are asked as by intersects().

Raises MeshError, with the number of boundary edges, for a mesh that is not closed, and what intersects() raises.

>>> graze.interiors_intersect(bolt, (bolt, pose))
True
)";

}  // namespace

void add_pair_queries(py::module_& module) {
  module.def("intersects", &intersects_of, kIntersectsText, py::arg("a"), py::arg("b"),
             py::kw_only(), py::arg("hit") = "touching", py::arg("memory") = py::none(),
             py::arg("threads") = 0, py::arg("progress") = py::none(),
             py::arg("work") = py::none());
  module.def("find_triangle_pairs", &pairs_of, kPairsText, py::arg("a"), py::arg("b"),
             py::kw_only(), py::arg("limit") = py::none(), py::arg("touch") = "include",
             py::arg("memory") = py::none(), py::arg("threads") = 0,
             py::arg("progress") = py::none(), py::arg("work") = py::none());
  module.def("interiors_intersect", &interiors_of, kInteriorsText, py::arg("a"), py::arg("b"),
             py::kw_only(), py::arg("threads") = 0, py::arg("progress") = py::none(),
             py::arg("work") = py::none());
}

}  // namespace graze::python
