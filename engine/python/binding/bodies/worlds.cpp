#include <graze/engine/python/binding/arguments/batch.h>
#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/bodies/compounds.h>
#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/queries/manifolds.h>
#include <graze/engine/python/binding/values/motions.h>
#include <graze/engine/python/binding/values/shapes.h>

#include <graze/bvh/value/element_error.h>

#include <memory>

namespace graze::python {
namespace {

py::object add_bodies(SharedWorld& shared, py::handle shape, py::handle kind, py::handle filter,
                      py::handle role, py::handle margin, py::handle detection, py::handle sides,
                      py::handle user_data) {
  const PlacedBody placed(shape);
  const BodySettings settings{.kind = kind_from(kind),
                              .filter = filter.is_none() ? Filter{} : filter_from(filter),
                              .user_data = count_from(user_data, "user_data"),
                              .role = role_from(role),
                              .margin = number_from(margin, "margin"),
                              .sides = sides_from(sides, "sides"),
                              .detection = detection_from(detection)};
  placed.check_poses();
  const auto ids = shared.ask([&](World& world) {
    std::vector<BodyId> added;
    added.reserve(placed.poses().size());
    try {
      const std::shared_ptr<const BodyShape> body_shape = placed.shape();
      for (std::size_t i = 0; i < placed.poses().size(); ++i)
        added.push_back(world.add(PlacedBodyShape{body_shape, placed.poses()[i]}, settings));
    } catch (const std::exception&) {
      for (const BodyId id : added)
        world.remove(id);
      throw;
    }
    return added;
  });
  if (placed.poses().is_many()) return array_of_ids(ids);
  return py::int_(number_of(ids[0]));
}

void move_bodies(SharedWorld& shared, py::handle argument, py::handle where) {
  const Ids<BodyId> ids(argument);
  if (!ids.is_many && py::isinstance<RigidMotion>(where)) {
    const auto& motion = where.cast<const RigidMotion&>();
    shared.ask([&](World& world) { world.move(ids.all[0], motion); });
    return;
  }
  const Poses poses(where, "poses");
  if (poses.is_many() != ids.is_many || poses.size() != ids.all.size()) {
    throw InputError("poses: are " + std::to_string(poses.size()) + ", and there are " +
                     std::to_string(ids.all.size()) + " ids");
  }
  shared.ask([&](World& world) {
    std::vector<Pose> all;
    all.reserve(poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i)
      all.push_back(poses[i]);
    world.move(ids.all, all);
  });
}

py::object poses_of(SharedWorld& shared, py::handle argument) {
  const Ids<BodyId> ids(argument);
  if (!ids.is_many)
    return array_of(shared.ask([&](World& world) { return world.pose(ids.all[0]); }));
  auto array = new_array<double>({static_cast<py::ssize_t>(ids.all.size()), 4, 4});
  double* at = array.mutable_data();
  shared.ask([&](World& world) {
    for (std::size_t i = 0; i < ids.all.size(); ++i) {
      bvh::at_element("id", i, [&] {
        const Pose& pose = world.pose(ids.all[i]);
        for (int row = 0; row < 4; ++row) {
          for (int column = 0; column < 4; ++column)
            *at++ = pose.matrix()(row, column);
        }
      });
    }
  });
  return array;
}

/// Keeps what an update says from the next one.
struct KeptUpdate {
  std::vector<BodyPair> begun, ended, moved, begun_near, ended_near;
  std::vector<BodyContact> contacts;
  std::vector<BodyFirstContact> first_contacts;
  WorldWork work;
  std::vector<std::uint64_t> contact_ids;  ///< set if contacts are tracked
};

template <typename T>
std::vector<T> kept(std::span<const T> all) {
  return {all.begin(), all.end()};
}

py::object first_contacts_of(const std::vector<BodyFirstContact>& contacts) {
  static const ResultType kType("BodyFirstContacts");
  const auto count = static_cast<py::ssize_t>(contacts.size());
  std::vector<BodyPair> pairs;
  auto low = new_array<double>({count}), high = new_array<double>({count});
  auto points = new_array<double>({count, 3}), normals = new_array<double>({count, 3});
  auto is_hit = new_array<bool>({count}), is_at_start = new_array<bool>({count});
  pairs.reserve(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const BodyFirstContact& contact = contacts[i];
    pairs.push_back(contact.pair);
    low.mutable_data()[i] = contact.contact.low;
    high.mutable_data()[i] = contact.contact.high;
    is_hit.mutable_data()[i] = contact.contact.status == RigidStatus::Hit;
    is_at_start.mutable_data()[i] = contact.is_at_start;
    write(contact.point, points.mutable_data() + 3 * i);
    write(contact.normal, normals.mutable_data() + 3 * i);
  }
  return kType(array_of_pairs(pairs), is_hit, low, high, is_at_start, points, normals,
               columns_of(contacts, {&BodyFirstContact::part_a, &BodyFirstContact::part_b}));
}

constexpr std::pair<const char*, std::uint64_t WorldWork::*> kCounters[] = {
    {"pairs_filtered", &WorldWork::pairs_filtered},
    {"pairs_at_rest", &WorldWork::pairs_at_rest},
    {"pairs_asleep", &WorldWork::pairs_asleep},
    {"pairs_apart", &WorldWork::pairs_apart},
    {"shape_tests", &WorldWork::shape_tests},
    {"gaps_measured", &WorldWork::gaps_measured},
    {"pairs_near", &WorldWork::pairs_near},
    {"contacts_found", &WorldWork::contacts_found},
    {"contacts_skipped", &WorldWork::contacts_skipped},
    {"islands_merged", &WorldWork::islands_merged},
    {"islands_split", &WorldWork::islands_split},
    {"island_steps", &WorldWork::island_steps},
    {"pairs_swept", &WorldWork::pairs_swept},
    {"trees_unbuilt", &WorldWork::trees_unbuilt}};

py::dict counters_of(const WorldWork& work) {
  py::dict counters;
  for (const auto& [name, counter] : kCounters)
    counters[name] = work.*counter;
  return counters;
}

std::vector<std::uint64_t> tracked_ids(SharedWorld& shared, const WorldUpdate& update) {
  std::vector<std::uint64_t> all;
  if (!shared.tracker) return all;
  shared.tracker->take(shared.world, update);
  for (std::size_t i = 0; i < update.contacts.size(); ++i) {
    const std::span<const std::uint64_t> ids = shared.tracker->ids(i);
    all.insert(all.end(), ids.begin(), ids.end());
  }
  return all;
}

py::object update(SharedWorld& shared) {
  static const ResultType kType("WorldUpdate");
  KeptUpdate found = shared.ask([&](World& world) {
    const WorldUpdate update = world.update();
    return KeptUpdate{kept(update.begun),          kept(update.ended),
                      kept(update.moved),          kept(update.begun_near),
                      kept(update.ended_near),     kept(update.contacts),
                      kept(update.first_contacts), update.work,
                      tracked_ids(shared, update)};
  });
  return kType(array_of_pairs(found.begun), array_of_pairs(found.ended),
               array_of_pairs(found.moved), result_of(found.contacts, std::move(found.contact_ids)),
               array_of_pairs(found.begun_near), array_of_pairs(found.ended_near),
               first_contacts_of(found.first_contacts), found.work.shapes, counters_of(found.work));
}

py::list islands_of(SharedWorld& shared) {
  py::list lists;
  for (const auto& island : shared.ask([](World& world) { return world.islands(); }))
    lists.append(array_of_ids(island));
  return lists;
}

py::object shape_of(SharedWorld& shared, py::handle argument) {
  const Ids<BodyId> ids(argument);
  if (ids.is_many) throw InputError("id: is one body");
  // What a body has may be taken from it as soon as the lock is released.
  std::unique_lock<std::recursive_mutex> lock(shared.mutex, std::defer_lock);
  {
    const py::gil_scoped_release released;
    lock.lock();
  }
  return object_of(shared.world.shape(ids.all[0]));
}

std::unique_ptr<SharedWorld> make_world(py::handle threads, bool contacts, bool islands,
                                        py::handle number, py::handle sliding_depth,
                                        bool tracks_contacts) {
  const std::size_t which = count_from(number, "number");
  if (which > kLargestWorldNumber) throw InputError("number: is from 0 to 255");
  if (tracks_contacts && !contacts)
    throw InputError("tracks_contacts: there are none, as contacts is False");
  auto shared = std::make_unique<SharedWorld>(
      WorldSettings{.threads = Batch(threads, py::none()).threads,
                    .contacts = contacts,
                    .number = static_cast<std::uint32_t>(which),
                    .islands = islands,
                    .sliding_depth = number_from(sliding_depth, "sliding_depth")});
  if (tracks_contacts) shared->tracker.emplace();
  return shared;
}

void add_bodies_to(py::class_<SharedWorld>& type) {
  type.def(
      "add", &add_bodies,
      R"(add(self, shape, *, kind='dynamic', filter=None, role='solid', margin=0.0, detection='discrete', sides=None, user_data=0)
--

Adds a body, and returns its id: a whole number. `shape` is a Mesh, a Shape, a Compound or a VoxelMap, or a tuple of one
and its pose; with poses of the shape (n, 4, 4) n bodies are added, and their ids are an array of n.

`kind` is "static", "kinematic" or "dynamic"; `role` "solid" or "sensor"; `detection` "discrete", or "continuous" for
a body that is swept from update to update. `filter` is (category, mask, group). Contacts of two bodies begin when
they are apart by no more than the sum of both margins, metres. `sides` say what of a mesh counts beside its surface:
"surface", "solid" for what is inside a closed one, too, or ("one_sided", thickness in metres) for what is behind it.
`user_data` is a whole number that the world keeps.

Raises PoseError, with its index, InputError, and MeshError for sides that the mesh cannot have, as find_contacts() does.
)",
      py::arg("shape"), py::kw_only(), py::arg("kind") = "dynamic", py::arg("filter") = py::none(),
      py::arg("role") = "solid", py::arg("margin") = 0.0, py::arg("detection") = "discrete",
      py::arg("sides") = py::none(), py::arg("user_data") = 0);
  type.def(
      "remove",
      [](SharedWorld& shared, py::handle ids) {
        for_each_id(shared, ids, [](World& world, BodyId id) { world.remove(id); });
      },
      "remove(self, ids)\n--\n\nTakes one body or many out of the world. Raises StaleIdError for a "
      "body that is gone.",
      py::arg("ids"));
  type.def("move", &move_bodies,
           "move(self, ids, poses)\n--\n\nTakes a body to a pose, or along a RigidMotion to its "
           "end; or many bodies to as many "
           "poses, of the shape (n, 4, 4), all or none. Raises StaleIdError and PoseError, with "
           "the index.",
           py::arg("ids"), py::arg("poses"));
  type.def("poses", &poses_of,
           "poses(self, ids)\n--\n\nWhere bodies were put last: (4, 4) for one, (n, 4, 4) for n.",
           py::arg("ids"));
  type.def("shape", &shape_of,
           "shape(self, id)\n--\n\nThe Mesh, Shape, Compound or VoxelMap of a body.",
           py::arg("id"));
  type.def(
      "set_shape",
      [](SharedWorld& shared, std::uint64_t id, py::handle shape) {
        const PlacedBody placed(shape);
        shared.ask([&](World& world) { world.set_shape(id_of<BodyId>(id), placed.shape()); });
      },
      "set_shape(self, id, shape)\n--\n\nGives a body another shape where it is.", py::arg("id"),
      py::arg("shape"));
  type.def("update", &update, R"(update(self)
--

Brings all pairs up to date: a WorldUpdate of what changed, in arrays. Looks only at what moved. It goes to its end,
however long that takes: Ctrl-C waits for it.
)");
}

}  // namespace

py::object result_of(const std::vector<BodyContact>& contacts, std::vector<std::uint64_t> ids) {
  static const ResultType kType("WorldContacts");
  std::vector<BodyPair> pairs;
  std::vector<ShapeContact> all;
  std::vector<std::int64_t> offsets{0};
  std::vector<std::array<std::uint32_t, 2>> parts;
  pairs.reserve(contacts.size());
  parts.reserve(contacts.size());
  offsets.reserve(contacts.size() + 1);
  for (const BodyContact& contact : contacts) {
    pairs.push_back(contact.pair);
    parts.push_back({contact.manifold.part_a(), contact.manifold.part_b()});
    all.insert(all.end(), contact.manifold.begin(), contact.manifold.end());
    offsets.push_back(static_cast<std::int64_t>(all.size()));
  }
  return kType(array_of_pairs(pairs), array_over<std::uint32_t>(std::move(parts), 2),
               array_over<std::int64_t>(std::move(offsets)), result_of(all),
               array_over<std::uint64_t>(std::move(ids)));
}

void add_worlds(py::module_& module) {
  py::class_<SharedWorld> type(
      module, "World",
      R"(Bodies that move, and which of them touch. An update looks only at what moved.

    World(*, threads=1, contacts=True, islands=False, number=0, sliding_depth=0.001, tracks_contacts=False)

`threads` share each stage of an update; 0: all that there are. No result depends on it. Without `contacts` updates
find none. `islands` are kept for islands(). A world with a `number`, 1 to 255, refuses the ids of others. A convex body
that is swept slides along a mesh that it gets no deeper behind than `sliding_depth`, metres. Where it
`tracks_contacts`, each contact of an update has a number, the same as long as the contact goes on: what a solver keeps
impulses by.

>>> world = graze.World()
>>> balls = world.add((graze.Sphere([0, 0, 0], 0.6), np.stack([np.eye(4), raised])))
>>> len(world.update().begun)
0
>>> world.move(balls[1], np.eye(4))
>>> np.array_equal(world.update().begun, [balls])
True
)");
  type.def(py::init(&make_world),
           "__init__(self, *, threads=1, contacts=True, islands=False, number=0, "
           "sliding_depth=0.001, tracks_contacts=False)\n--\n\nWithout bodies.",
           py::kw_only(), py::arg("threads") = 1, py::arg("contacts") = true,
           py::arg("islands") = false, py::arg("number") = 0, py::arg("sliding_depth") = 1e-3,
           py::arg("tracks_contacts") = false);
  type.def("__len__", [](SharedWorld& shared) {
    return shared.ask([](World& world) { return world.size(); });
  });
  type.def("__contains__", [](SharedWorld& shared, std::uint64_t id) {
    return shared.ask([&](World& world) { return world.contains(id_of<BodyId>(id)); });
  });
  add_bodies_to(type);
  add_world_settings(module);
  type.def("islands", &islands_of,
           "islands(self)\n--\n\nSets of bodies that touch, as arrays of ids. Raises InputError "
           "unless the world keeps them.");
  add_snapshots(module);
  add_world_states(module);
  add_world_queries(module);
  add_world_casts(module);
  add_world_pairs(module);
  add_world_drawing(module);
}

}  // namespace graze::python
