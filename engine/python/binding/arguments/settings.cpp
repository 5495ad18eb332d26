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

std::size_t limit_from(py::handle argument) {
  return argument.is_none() ? kNoLimit : count_from(argument, "limit");
}

}  // namespace graze::python
