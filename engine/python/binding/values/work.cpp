#include <graze/engine/python/binding/module.h>

#include <graze/engine/work.h>

#include <string>
#include <utility>

namespace graze::python {
namespace {

namespace py = pybind11;

using Counter = std::uint64_t Work::*;

constexpr std::pair<const char*, Counter> kCounters[] = {
    {"volume_tests", &Work::volume_tests},
    {"volume_rejections", &Work::volume_rejections},
    {"filter_tests", &Work::filter_tests},
    {"triangle_tests", &Work::triangle_tests},
    {"exact_tests", &Work::exact_tests},
    {"points_tested", &Work::points_tested},
    {"skipped_by_memory", &Work::skipped_by_memory},
    {"trees_built", &Work::trees_built},
    {"treelets_built", &Work::treelets_built},
    {"trees_refitted", &Work::trees_refitted},
    {"treelets_refitted", &Work::treelets_refitted},
    {"triangles_rebuilt", &Work::triangles_rebuilt},
    {"skins_built", &Work::skins_built},
    {"convex_tests", &Work::convex_tests},
    {"convex_failures", &Work::convex_failures},
    {"penetration_tests", &Work::penetration_tests},
    {"penetration_failures", &Work::penetration_failures},
};

py::dict counters_of(const Work& work) {
  py::dict counters;
  for (const auto& [name, counter] : kCounters)
    counters[name] = work.*counter;
  return counters;
}

Work work_of(const py::dict& counters) {
  Work work;
  for (const auto& [name, counter] : kCounters) {
    if (counters.contains(name)) work.*counter = counters[name].cast<std::uint64_t>();
  }
  return work;
}

}  // namespace

void add_work(py::module_& module) {
  py::class_<Work> type(
      module, "Work",
      R"(What queries did and skipped: counters, to which each query adds that is given one.

Two works can be added, compared and pickled; as_dict() has all counters by name.

>>> work = graze.Work()
>>> graze.intersects(bolt, (nut, pose), work=work)
True
>>> work.filter_tests > 0
True
)");
  type.def(py::init<>(), "__init__(self)\n--\n\nAll counters are 0.");
  for (const auto& [name, counter] : kCounters)
    type.def_readwrite(name, counter);
  type.def("as_dict", &counters_of, "as_dict(self)\n--\n\nAll counters by name.");
  type.def("__iadd__", [](Work& work, const Work& other) -> Work& { return work += other; });
  type.def("__add__", [](const Work& work, const Work& other) {
    Work sum = work;
    return sum += other;
  });
  type.def("__eq__", [](const Work& work, py::handle other) {
    return py::isinstance<Work>(other) && work == other.cast<const Work&>();
  });
  type.def("__repr__", [](const Work& work) {
    std::string text;
    for (const auto& [name, counter] : kCounters) {
      if (work.*counter != 0)
        text += std::string(text.empty() ? "" : ", ") + name + "=" + std::to_string(work.*counter);
    }
    return "Work(" + text + ")";
  });
  type.def(py::pickle(&counters_of, &work_of));
}

}  // namespace graze::python
