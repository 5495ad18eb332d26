#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/module.h>

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/write_case.h>

#include <memory>

namespace graze::python {
namespace {

CaseShape shape_from(const Placed& placed) {
  if (placed.poses().is_many())
    throw InputError(std::string(placed.name()) + ": a case has one pose");
  if (placed.is_mesh()) return CaseMesh(placed.mesh_at(0));
  return CaseBody(placed.shape(), placed.poses()[0]);
}

Case make_case(py::handle word, py::handle a, py::handle b, py::handle clearance,
               py::handle direction, py::handle note) {
  const Ask ask = word_from<Ask>(word, "ask",
                                 {{"any", Ask::Any},
                                  {"pairs", Ask::Pairs},
                                  {"distance", Ask::Distance},
                                  {"within", Ask::Within},
                                  {"contacts", Ask::Contacts},
                                  {"intersection", Ask::Intersection},
                                  {"separation", Ask::Separation},
                                  {"self_any", Ask::SelfAny},
                                  {"self_pairs", Ask::SelfPairs}});
  Case made{.note = py::str(note).cast<std::string>(),
            .ask = ask,
            .settings = {},
            .a = shape_from(Placed(a, "a")),
            .b = std::nullopt,
            .answer = std::nullopt,
            .answered_by = this_library()};
  if (!b.is_none()) made.b = shape_from(Placed(b, "b"));
  made.settings.clearance = number_from(clearance, "clearance");
  if (!direction.is_none()) made.settings.direction = vector_from(direction, "direction");
  const py::gil_scoped_release released;
  made.answer = answer_case(made);
  return made;
}

/// Returns a case as the file that it would be, read by the JSON module of Python.
py::object dict_of(const std::string& text) {
  return py::module_::import("json").attr("loads")(text);
}

constexpr const char* kToCaseText =
    R"(to_case(ask, a, b=None, *, clearance=0.0, direction=None, note='')
--

A query and its answer as a Case, which can be kept in a file and asked again anywhere, bit for bit.

`ask` is "any" (intersects), "pairs", "distance", "within", "contacts", "intersection", "separation", "self_any" or
"self_pairs"; `a` and `b` are as of intersects(), in one pose.

Raises what the query raises.

>>> case = graze.to_case("distance", bolt, (nut, far), note="far apart")
>>> round(case.answer["distance"], 3), case.is_answered_the_same()
(0.987, True)
)";

}  // namespace

void add_cases(py::module_& module) {
  py::class_<Case>(
      module, "Case",
      "A query that can be asked again, bit for bit, with the answer that somebody gave.")
      .def_property_readonly(
          "ask", [](const Case& query) { return name_of(query.ask); }, "Which query it is.")
      .def_property_readonly(
          "note", [](const Case& query) { return query.note; }, "Why it is kept.")
      .def_property_readonly(
          "answer",
          [](const Case& query) -> py::object {
            if (!query.answer) return py::none();
            return dict_of(to_plain_json(*query.answer));
          },
          "The answer, by the names of data/case.schema.json, or None.")
      .def(
          "ask_again",
          [](const Case& query) {
            CaseAnswer answer;
            {
              const py::gil_scoped_release released;
              answer = answer_case(query);
            }
            return dict_of(to_plain_json(answer));
          },
          "ask_again(self)\n--\n\nWhat this library answers now.")
      .def(
          "is_answered_the_same",
          [](const Case& query) {
            const py::gil_scoped_release released;
            return query.answer && is_same(answer_case(query), *query.answer);
          },
          "is_answered_the_same(self)\n--\n\nWhether this library answers now, to the bit, what "
          "the case says.")
      .def(
          "write", [](const Case& query, py::handle path) { write_case(path_from(path), query); },
          "write(self, path)\n--\n\nWrites it to a file, which appears whole or stays as it was. "
          "Raises CaseError.",
          py::arg("path"))
      .def(
          "to_json", [](const Case& query) { return to_json(query); },
          "to_json(self)\n--\n\nThe text of that file.")
      .def(py::pickle([](const Case& query) { return py::make_tuple(to_json(query)); },
                      [](const py::tuple& state) {
                        return parse_case(state[0].cast<std::string>(), "pickle");
                      }));
  module.def("to_case", &make_case, kToCaseText, py::arg("ask"), py::arg("a"),
             py::arg("b") = py::none(), py::kw_only(), py::arg("clearance") = 0.0,
             py::arg("direction") = py::none(), py::arg("note") = "");
  module.def(
      "read_case", [](py::handle path) { return read_case(path_from(path)); },
      "read_case(path)\n--\n\nReads a case from a file. Raises CaseError, `file:line: /place: "
      "why`.",
      py::arg("path"));
}

}  // namespace graze::python
