#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace graze::python {
namespace {

/// Returns what `ask(world, placed)` answers for the shape in each of its poses.
template <typename Answer, typename Ask>
std::vector<Answer> ask_in_poses(SharedWorld& shared, const Placed& placed, py::handle threads,
                                 py::handle progress, const Ask& ask) {
  static_cast<void>(placed.shape());  // the shape of a mesh is made once, before threads ask
  std::vector<Answer> answers(placed.poses().size());
  ask_world_for_all(
      shared, answers.size(), Batch(threads, progress),
      [&](const World& world, std::size_t i) { answers[i] = ask(world, placed.shape_at(i)); },
      [&] { placed.check_poses(); });
  return answers;
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

/// Returns the answer where no body is: an infinite distance.
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
}

}  // namespace graze::python
