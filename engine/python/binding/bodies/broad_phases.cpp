#include <graze/engine/python/binding/arguments/batch.h>
#include <graze/engine/python/binding/bodies/body_ids.h>
#include <graze/engine/python/binding/module.h>

#include <graze/bvh/value/element_error.h>
#include <graze/engine/world/broad_phase.h>

#include <memory>
#include <mutex>

namespace graze::python {
namespace {

/// Holds boxes that threads of Python may share: one waits for the other.
struct SharedBoxes {
  explicit SharedBoxes(int threads) : boxes(BroadPhaseSettings{.threads = threads}) {}

  template <typename Ask>
  auto ask(const Ask& question) {
    const py::gil_scoped_release released;
    const std::scoped_lock lock(mutex);
    return question(boxes);
  }

  BroadPhase boxes;
  std::mutex mutex;
};

/// Holds one box of the shape (2, 3), or n of (n, 2, 3).
struct Boxes {
  explicit Boxes(py::handle argument) {
    const py::array array = doubles(argument, "boxes");
    const py::ssize_t dimensions = array.ndim();
    if ((dimensions != 2 && dimensions != 3) || array.shape(dimensions - 1) != 3 ||
        array.shape(dimensions - 2) != 2) {
      throw InputError("boxes: the shape " +
                       py::str(py::tuple(array.attr("shape"))).cast<std::string>() +
                       " is neither (2, 3) nor (n, 2, 3)");
    }
    is_many = dimensions == 3;
    const auto rows = py::array_t<double, py::array::c_style>::ensure(array);
    const double* at = rows.data();
    all.reserve(static_cast<std::size_t>(rows.size() / 6));
    for (py::ssize_t i = 0; i < rows.size() / 6; ++i, at += 6)
      all.push_back({{at[0], at[1], at[2]}, {at[3], at[4], at[5]}});
  }

  bool is_many;
  std::vector<Aabb> all;
};

py::object add_boxes(SharedBoxes& shared, py::handle argument) {
  const Boxes boxes(argument);
  const auto ids = shared.ask([&](BroadPhase& phase) {
    for (std::size_t i = 0; i < boxes.all.size(); ++i)
      bvh::at_element("box", i,
                      [&] { check_box(boxes.all[i], ("box " + std::to_string(i)).c_str()); });
    std::vector<BoxId> added;
    added.reserve(boxes.all.size());
    for (const Aabb& box : boxes.all)
      added.push_back(phase.add(box));
    return added;
  });
  if (boxes.is_many) return array_of_ids(ids);
  return py::int_(number_of(ids[0]));
}

void move_boxes(SharedBoxes& shared, py::handle ids_argument, py::handle boxes_argument) {
  const Ids<BoxId> ids(ids_argument);
  const Boxes boxes(boxes_argument);
  if (ids.is_many != boxes.is_many || ids.all.size() != boxes.all.size()) {
    throw InputError("boxes: are " + std::to_string(boxes.all.size()) + ", and there are " +
                     std::to_string(ids.all.size()) + " ids");
  }
  shared.ask([&](BroadPhase& phase) { phase.move(ids.all, boxes.all); });
}

void remove_boxes(SharedBoxes& shared, py::handle argument) {
  const Ids<BoxId> ids(argument);
  shared.ask([&](BroadPhase& phase) {
    for (const BoxId id : ids.all)
      static_cast<void>(phase.box(id));  // so that all are removed or none
    for (const BoxId id : ids.all)
      phase.remove(id);
  });
}

/// Returns indices of pairs, of the shape (k, 2).
py::object pairs_of(SharedBoxes& shared,
                    const std::function<std::span<const BoxPair>(BroadPhase&)>& which) {
  std::vector<BoxPair> pairs = shared.ask([&](BroadPhase& phase) {
    const auto span = which(phase);
    return std::vector<BoxPair>(span.begin(), span.end());
  });
  return array_over<std::uint32_t>(std::move(pairs), 2);
}

}  // namespace

void add_broad_phases(py::module_& module) {
  py::class_<SharedBoxes> type(
      module, "BroadPhase",
      R"(Which of many moving boxes overlap: exactly, on their own doubles, touching included.

    BroadPhase(*, threads=1)

Boxes are of the shape (2, 3), the least and the greatest corner, or (n, 2, 3); ids are whole numbers, or arrays of n.
The lower 32 bits of an id are the box's index, by which pairs name it.

>>> boxes = graze.BroadPhase()
>>> ids = boxes.add([[[0, 0, 0], [1, 1, 1]], [[1, 1, 1], [2, 2, 2]], [[5, 5, 5], [6, 6, 6]]])
>>> boxes.update()
>>> boxes.pairs()
array([[0, 1]], dtype=uint32)
)");
  type.def(py::init([](py::handle threads) {
             return std::make_unique<SharedBoxes>(Batch(threads, py::none()).threads);
           }),
           "__init__(self, *, threads=1)\n--\n\nWithout boxes.", py::kw_only(),
           py::arg("threads") = 1);
  type.def("add", &add_boxes,
           "add(self, boxes)\n--\n\nAdds a box or many, and returns its id or their ids. Raises "
           "InputError, with the index, for "
           "a box that is not finite or whose least corner exceeds its greatest.",
           py::arg("boxes"));
  type.def("move", &move_boxes,
           "move(self, ids, boxes)\n--\n\nGives boxes new places, all or none. Raises StaleIdError "
           "and InputError.",
           py::arg("ids"), py::arg("boxes"));
  type.def("remove", &remove_boxes, "remove(self, ids)\n--\n\nRemoves boxes. Raises StaleIdError.",
           py::arg("ids"));
  type.def(
      "update", [](SharedBoxes& shared) { shared.ask([](BroadPhase& phase) { phase.update(); }); },
      "update(self)\n--\n\nFinds which pairs overlap now.");
  type.def(
      "pairs",
      [](SharedBoxes& shared) {
        return pairs_of(shared, [](BroadPhase& phase) { return phase.sorted_pairs(); });
      },
      "pairs(self)\n--\n\nAll pairs that overlapped at the last update, by index, ascending: "
      "uint32 of the shape (k, 2).");
  type.def(
      "begun",
      [](SharedBoxes& shared) {
        return pairs_of(shared, [](BroadPhase& phase) { return phase.begun(); });
      },
      "begun(self)\n--\n\nThose that did not before the last update.");
  type.def(
      "ended",
      [](SharedBoxes& shared) {
        return pairs_of(shared, [](BroadPhase& phase) { return phase.ended(); });
      },
      "ended(self)\n--\n\nThose that did before the last update, and do not any more.");
  type.def(
      "find_overlapping",
      [](SharedBoxes& shared, py::handle argument) {
        const Boxes boxes(argument);
        if (boxes.is_many) throw InputError("box: is one box");
        auto indices = shared.ask([&](BroadPhase& phase) {
          std::vector<std::uint32_t> found;
          phase.find_overlapping(boxes.all[0], found);
          std::sort(found.begin(), found.end());
          return found;
        });
        return array_over<std::uint32_t>(std::move(indices));
      },
      "find_overlapping(self, box)\n--\n\nThe indices of all boxes that share a point with one, "
      "ascending.",
      py::arg("box"));
  type.def("__len__", [](SharedBoxes& shared) {
    return shared.ask([](BroadPhase& phase) { return phase.size(); });
  });
  type.def("__contains__", [](SharedBoxes& shared, std::uint64_t id) {
    return shared.ask([&](BroadPhase& phase) { return phase.contains(id_of<BoxId>(id)); });
  });
}

}  // namespace graze::python
