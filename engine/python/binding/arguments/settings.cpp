#include <graze/engine/python/binding/arguments/settings.h>

namespace graze::python {

Hit hit_from(py::handle argument) {
  return word_from<Hit>(
      argument, "hit",
      {{"touching", Hit::Touching}, {"crossing", Hit::Crossing}, {"solid", Hit::Solid}});
}

Touch touch_from(py::handle argument) {
  return word_from<Touch>(argument, "touch",
                          {{"include", Touch::Include}, {"exclude", Touch::Exclude}});
}

StartContact start_from(py::handle argument) {
  return word_from<StartContact>(
      argument, "start", {{"counts", StartContact::Counts}, {"is_left", StartContact::IsLeft}});
}

MeshSides sides_from(py::handle argument, const char* name) {
  if (argument.is_none()) return {};
  if (PyTuple_Check(argument.ptr()) != 0 && py::len(argument) == 2) {
    const auto pair = py::reinterpret_borrow<py::tuple>(argument);
    word_from<Sides>(pair[0], name, {{"one_sided", Sides::OneSided}});
    return MeshSides::one_sided(number_from(pair[1], name));
  }
  const auto kind =
      word_from<Sides>(argument, name, {{"surface", Sides::Surface}, {"solid", Sides::Solid}});
  return kind == Sides::Solid ? MeshSides::solid() : MeshSides::surface();
}

std::string path_from(py::handle argument) {
  return py::module_::import("os").attr("fsencode")(argument).cast<std::string>();
}

std::size_t limit_from(py::handle argument) {
  return argument.is_none() ? kNoLimit : count_from(argument, "limit");
}

}  // namespace graze::python
