// Asks about worlds that stand in each other, such as a robot's in its cell's.

#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>

namespace graze::python {
namespace {

py::object gaps_of(const BodyPairDistance& found) {
  static const ResultType kType("BodyPairDistance");
  const ShapeDistance& gap = found.distance;
  return kType(number_of(found.a), number_of(found.b), gap.distance, array_of(gap.point_a),
               array_of(gap.point_b), array_of(gap.normal),
               py::make_tuple(found.part_a, found.part_b), gap.lower_bound,
               gap.status == PairStatus::Converged);
}

py::object gaps_of(const std::vector<BodyPairDistance>& all) {
  static const ResultType kType("BodyPairDistances");
  auto pairs = new_array<std::uint64_t>({static_cast<py::ssize_t>(all.size()), 2});
  std::uint64_t* at = pairs.mutable_data();
  for (const BodyPairDistance& found : all) {
    *at++ = number_of(found.a);
    *at++ = number_of(found.b);
  }
  return kType(
      std::move(pairs),
      numbers_of<double>(all, [](const auto& found) { return found.distance.distance; }),
      points_of(all, [](const auto& found) { return found.distance.point_a; }),
      points_of(all, [](const auto& found) { return found.distance.point_b; }),
      points_of(all, [](const auto& found) { return found.distance.normal; }),
      columns_of(all, {&BodyPairDistance::part_a, &BodyPairDistance::part_b}),
      numbers_of<double>(all, [](const auto& found) { return found.distance.lower_bound; }),
      numbers_of<bool>(
          all, [](const auto& found) { return found.distance.status == PairStatus::Converged; }));
}

}  // namespace

std::optional<PlacedWorld> world_from(py::handle argument) {
  if (py::isinstance<SharedWorld>(argument))
    return PlacedWorld{argument.cast<SharedWorld*>(), Pose::Identity()};
  if (PyTuple_CheckExact(argument.ptr()) == 0 || PyTuple_GET_SIZE(argument.ptr()) != 2) return {};
  const py::handle owner = PyTuple_GET_ITEM(argument.ptr(), 0);
  if (!py::isinstance<SharedWorld>(owner)) return {};
  return PlacedWorld{owner.cast<SharedWorld*>(),
                     pose_from(PyTuple_GET_ITEM(argument.ptr(), 1), "pose of world")};
}

WorldPairSettings pair_settings(py::handle filter, py::handle role) {
  WorldPairSettings settings;
  if (filter.is_none()) {
    settings.has_filters = true;
  } else if (PyBool_Check(filter.ptr()) != 0) {
    settings.has_filters = filter.cast<bool>();
  } else {
    throw InputError("filter: of two worlds their bodies' own count, or with False none");
  }
  if (!role.is_none()) settings.role = role_from(role);
  return settings;
}

py::object pairs_touching(SharedWorld& shared, const PlacedWorld& other,
                          const WorldPairSettings& settings) {
  const auto found = ask_both(shared, *other.shared, [&](World& world, World& within) {
    return world.find_touching(PlacedWorldView{within, other.pose}, settings);
  });
  auto pairs = new_array<std::uint64_t>({static_cast<py::ssize_t>(found.size()), 2});
  std::uint64_t* at = pairs.mutable_data();
  for (const WorldBodyPair& pair : found) {
    *at++ = number_of(pair.a);
    *at++ = number_of(pair.b);
  }
  return pairs;
}

py::object pairs_within(SharedWorld& shared, const PlacedWorld& other, double clearance,
                        const WorldPairSettings& settings) {
  return gaps_of(ask_both(shared, *other.shared, [&](World& world, World& within) {
    return world.find_within(PlacedWorldView{within, other.pose}, clearance, settings);
  }));
}

py::object closest_pair(SharedWorld& shared, const PlacedWorld& other,
                        const WorldPairSettings& settings) {
  const auto found = ask_both(shared, *other.shared, [&](World& world, World& within) {
    return world.find_closest(PlacedWorldView{within, other.pose}, settings);
  });
  return found ? gaps_of(*found) : py::none();
}

void add_world_pairs(py::module_& module) {
  py::class_<SharedWorld> type(module.attr("World"));
  type.def(
      "find_closest_pair",
      [](SharedWorld& shared, py::handle filter, py::handle role) {
        const WorldPairSettings settings = pair_settings(filter, role);
        const auto found =
            shared.ask([&](World& world) { return world.find_closest_pair(settings); });
        return found ? gaps_of(*found) : py::none();
      },
      "find_closest_pair(self, *, filter=None, role=None)\n--\n\nThe two bodies of this world that "
      "are least apart, of those that may meet; with `filter` False of all: a BodyPairDistance, or "
      "None.",
      py::kw_only(), py::arg("filter") = py::none(), py::arg("role") = py::none());
}

}  // namespace graze::python
