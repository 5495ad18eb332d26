#include <graze/engine/python/binding/arguments/batch.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>

#include <graze/engine/mesh/mesh_path.h>

#include <memory>
#include <optional>

namespace graze::python {
namespace {

const char* words_of(MeetingFeatures features) {
  switch (features) {
    case MeetingFeatures::VertexFace:
      return "vertex-face";
    case MeetingFeatures::FaceVertex:
      return "face-vertex";
    case MeetingFeatures::EdgeEdge:
      return "edge-edge";
    case MeetingFeatures::AtStart:
      break;
  }
  return "at-start";
}

FirstContactSettings settings_from(py::handle start, py::handle clearance) {
  return {.start = start_from(start), .clearance = number_from(clearance, "clearance")};
}

py::object contact_of(const std::optional<MeshFirstContact>& contact) {
  static const ResultType kType("MeshFirstContact");
  if (!contact) return py::none();
  return kType(contact->time, contact->is_at_start,
               py::make_tuple(contact->pair.a, contact->pair.b), words_of(contact->features),
               py::make_tuple(contact->place_a, contact->place_b));
}

py::object contacts_of(const std::vector<MeshFirstContact>& all) {
  static const ResultType kType("MeshFirstContacts");
  py::list words;
  auto places = new_array<std::uint32_t>({static_cast<py::ssize_t>(all.size()), 2});
  std::uint32_t* place = places.mutable_data();
  for (const MeshFirstContact& contact : all) {
    words.append(words_of(contact.features));
    *place++ = contact.place_a;
    *place++ = contact.place_b;
  }
  return kType(numbers_of<double>(all, [](const auto& contact) { return contact.time; }),
               numbers_of<bool>(all, [](const auto& contact) { return contact.is_at_start; }),
               index_pairs_of(all, [](const auto& contact) { return contact.pair; }),
               py::module_::import("numpy").attr("array")(words, "U11"), std::move(places));
}

/// Asks without the lock of Python.
template <typename Ask>
auto without_lock(const Ask& ask) {
  const py::gil_scoped_release released;
  return ask();
}

constexpr const char* kPathText =
    R"(A mesh in one step of a simulation: its vertices move straight, the triangles between them stay.

    MeshPath(start, end)

`end` is start.deformed(...), or another mesh of the same triangles. Time goes from 0 to 1. Can be pickled.

Raises MeshError for meshes that differ in their number of vertices or in a triangle.

>>> falling = graze.MeshPath(bolt, bolt.deformed(bolt.vertices - [0, 0, 0.1]))
>>> met = graze.first_contact_in_step(graze.MeshPath(nut, nut), falling)
>>> met.time, met.is_at_start
(0.0, True)
)";

constexpr const char* kFirstText =
    R"(first_contact_in_step(path_a, path_b, *, clearance=0.0, start='counts', work=None)
--

When the triangles of two meshes that deform meet first, exactly and never late: a MeshFirstContact, or None if they never
do. What is no further apart than `clearance`, metres, counts as a contact. With `start` "is_left" what merely touches at
t = 0 may leave.

Raises InputError for a clearance that is negative or not finite.
)";

constexpr const char* kAllText =
    R"(find_contacts_in_step(path_a, path_b, *, clearance=0.0, start='counts', work=None)
--

All contacts in a step, of each pair of vertices and faces, or of edges, when it first meets: MeshFirstContacts, by pairs
of triangles. Raises what first_contact_in_step() raises.
)";

void add_pairs(py::module_& module) {
  module.def(
      "first_contact_in_step",
      [](const MeshPath& a, const MeshPath& b, py::handle clearance, py::handle start,
         py::handle work_argument) {
        const FirstContactSettings settings = settings_from(start, clearance);
        Work* work = work_from(work_argument);
        return contact_of(without_lock([&] { return first_contact(a, b, settings, work); }));
      },
      kFirstText, py::arg("path_a"), py::arg("path_b"), py::kw_only(), py::arg("clearance") = 0.0,
      py::arg("start") = "counts", py::arg("work") = py::none());
  module.def(
      "find_contacts_in_step",
      [](const MeshPath& a, const MeshPath& b, py::handle clearance, py::handle start,
         py::handle work_argument) {
        const FirstContactSettings settings = settings_from(start, clearance);
        Work* work = work_from(work_argument);
        return contacts_of(
            without_lock([&] { return find_contacts_in_step(a, b, settings, work); }));
      },
      kAllText, py::arg("path_a"), py::arg("path_b"), py::kw_only(), py::arg("clearance") = 0.0,
      py::arg("start") = "counts", py::arg("work") = py::none());
}

void add_selves(py::module_& module) {
  module.def(
      "first_self_contact",
      [](const MeshPath& path, py::handle clearance, py::handle start, py::handle work_argument) {
        const FirstContactSettings settings = settings_from(start, clearance);
        Work* work = work_from(work_argument);
        return contact_of(without_lock([&] { return first_self_contact(path, settings, work); }));
      },
      R"(first_self_contact(path, *, clearance=0.0, start='counts', work=None)
--

The same of a mesh with itself: what has a vertex in common is a hit only where it crosses at t = 0.

>>> graze.first_self_contact(graze.MeshPath(bolt, bolt)) is None
True
)",
      py::arg("path"), py::kw_only(), py::arg("clearance") = 0.0, py::arg("start") = "counts",
      py::arg("work") = py::none());
  module.def(
      "find_self_contacts_in_step",
      [](const MeshPath& path, py::handle clearance, py::handle start, py::handle work_argument) {
        const FirstContactSettings settings = settings_from(start, clearance);
        Work* work = work_from(work_argument);
        return contacts_of(
            without_lock([&] { return find_self_contacts_in_step(path, settings, work); }));
      },
      R"(find_self_contacts_in_step(path, *, clearance=0.0, start='counts', work=None)
--

All contacts of a mesh with itself in a step: MeshFirstContacts.

>>> len(graze.find_self_contacts_in_step(graze.MeshPath(bolt, bolt)).time)
0
)",
      py::arg("path"), py::kw_only(), py::arg("clearance") = 0.0, py::arg("start") = "counts",
      py::arg("work") = py::none());
}

}  // namespace

void add_mesh_paths(py::module_& module) {
  py::class_<MeshPath> type(module, "MeshPath", kPathText);
  type.def(py::init([](const Mesh& start, const Mesh& end) {
             const py::gil_scoped_release released;
             return std::make_unique<MeshPath>(start, end);
           }),
           "__init__(self, start, end)\n--\n\nSee the class.", py::arg("start"), py::arg("end"));
  type.def_property_readonly(
      "start", [](const MeshPath& path) { return path.start(); }, "The mesh at t = 0.");
  type.def_property_readonly(
      "end", [](const MeshPath& path) { return path.end(); }, "And at t = 1.");
  type.def_property_readonly(
      "bytes", [](const MeshPath& path) { return path.bytes(); },
      "What the path holds beside both meshes.");
  type.def("__reduce__", [](const py::object& self) {
    return py::make_tuple(py::type::of(self), py::make_tuple(self.attr("start"), self.attr("end")));
  });
  add_pairs(module);
  add_selves(module);
}

}  // namespace graze::python
