#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>

#include <memory>

namespace graze::python {
namespace {

std::function<bool(BodyId, BodyId)> pair_filter_from(py::handle argument) {
  if (argument.is_none()) return {};
  return PythonFilter(argument);
}

void add_settings(py::class_<SharedWorld>& type) {
  const auto add = [&](const char* name, const char* text, auto set) {
    type.def(
        name,
        [set](SharedWorld& world, py::handle ids, py::handle value) { set(world, ids, value); },
        text, py::arg("ids"), py::arg("value"));
  };
  add("set_kind",
      "set_kind(self, ids, value)\n--\n\nFrom the next update on: \"static\", \"kinematic\" or "
      "\"dynamic\".",
      [](SharedWorld& shared, py::handle ids, py::handle value) {
        const BodyKind kind = kind_from(value);
        for_each_id(shared, ids, [kind](World& world, BodyId id) { world.set_kind(id, kind); });
      });
  add("set_role",
      "set_role(self, ids, value)\n--\n\nFrom the next update on: \"solid\" or \"sensor\".",
      [](SharedWorld& shared, py::handle ids, py::handle value) {
        const Role role = role_from(value);
        for_each_id(shared, ids, [role](World& world, BodyId id) { world.set_role(id, role); });
      });
  add("set_filter",
      "set_filter(self, ids, value)\n--\n\nFrom the next update on: (category, mask, group).",
      [](SharedWorld& shared, py::handle ids, py::handle value) {
        const Filter filter = filter_from(value);
        for_each_id(shared, ids,
                    [filter](World& world, BodyId id) { world.set_filter(id, filter); });
      });
  add("set_margin", "set_margin(self, ids, value)\n--\n\nFrom the next update on: metres.",
      [](SharedWorld& shared, py::handle ids, py::handle value) {
        const double margin = number_from(value, "margin");
        for_each_id(shared, ids,
                    [margin](World& world, BodyId id) { world.set_margin(id, margin); });
      });
  add("set_user_data",
      "set_user_data(self, ids, value)\n--\n\nA whole number that the world keeps and does not "
      "read; or one for each body.",
      [](SharedWorld& shared, py::handle ids, py::handle value) {
        const Ids<BodyId> bodies(ids);
        const Ids<BodyId> numbers(value, "value");  // whole numbers of 64 bits
        if (numbers.is_many && numbers.all.size() != bodies.all.size())
          throw InputError("value: are not as many as ids");
        std::size_t i = 0;
        for_each_id(shared, ids, [&](World& world, BodyId id) {
          world.set_user_data(id, number_of(numbers.all[numbers.is_many ? i++ : 0]));
        });
      });
  add("set_detection",
      "set_detection(self, ids, value)\n--\n\n\"discrete\", or \"continuous\": swept from here on.",
      [](SharedWorld& shared, py::handle ids, py::handle value) {
        const Detection detection = detection_from(value);
        for_each_id(shared, ids,
                    [detection](World& world, BodyId id) { world.set_detection(id, detection); });
      });
}

void add_states(py::class_<SharedWorld>& type) {
  type.def(
      "sleep",
      [](SharedWorld& shared, py::handle argument) {
        const Ids<BodyId> ids(argument);
        shared.ask([&](World& world) { world.sleep(std::span<const BodyId>(ids.all)); });
      },
      "sleep(self, ids)\n--\n\nPuts bodies to sleep: pairs of which neither body is awake are not "
      "looked at.",
      py::arg("ids"));
  type.def(
      "wake",
      [](SharedWorld& shared, py::handle argument) {
        const Ids<BodyId> ids(argument);
        shared.ask([&](World& world) { world.wake(std::span<const BodyId>(ids.all)); });
      },
      "wake(self, ids)\n--\n\nWakes bodies.", py::arg("ids"));
  const auto add_pair = [&](const char* name, const char* text,
                            void (World::*change)(BodyId, BodyId)) {
    type.def(
        name,
        [change](SharedWorld& shared, std::uint64_t a, std::uint64_t b) {
          shared.ask([&](World& world) { (world.*change)(id_of<BodyId>(a), id_of<BodyId>(b)); });
        },
        text, py::arg("a"), py::arg("b"));
  };
  add_pair("exclude", "exclude(self, a, b)\n--\n\nTwo bodies never meet.", &World::exclude);
  add_pair("include", "include(self, a, b)\n--\n\nThey may meet again.", &World::include);
  type.def(
      "set_pair_filter",
      [](SharedWorld& shared, py::handle argument) {
        auto filter = pair_filter_from(argument);
        shared.ask([&](World& world) { world.set_pair_filter(std::move(filter)); });
      },
      "set_pair_filter(self, filter)\n--\n\nAsked last, filter(a, b), once for each pair whose "
      "boxes begin to overlap; None: no more.",
      py::arg("filter"));
}

}  // namespace

PythonFilter::PythonFilter(py::handle argument) {
  if (PyCallable_Check(argument.ptr()) == 0) throw py::type_error("filter: is not callable");
  function_.reset(new py::object(py::reinterpret_borrow<py::object>(argument)),
                  [](py::object* held) {
                    const py::gil_scoped_acquire acquired;
                    delete held;
                  });
}

bool PythonFilter::operator()(BodyId a, BodyId b) const {
  const py::gil_scoped_acquire acquired;
  return (*function_)(number_of(a), number_of(b)).cast<bool>();
}

BodyKind kind_from(py::handle argument) {
  return word_from<BodyKind>(argument, "kind",
                             {{"static", BodyKind::Static},
                              {"kinematic", BodyKind::Kinematic},
                              {"dynamic", BodyKind::Dynamic}});
}

Detection detection_from(py::handle argument) {
  return word_from<Detection>(
      argument, "detection",
      {{"discrete", Detection::Discrete}, {"continuous", Detection::Continuous}});
}

Filter filter_from(py::handle argument) {
  if (!PySequence_Check(argument.ptr()) || py::len(argument) != 3) {
    throw InputError("filter: is no (category, mask, group)");
  }
  const auto numbers = py::reinterpret_borrow<py::sequence>(argument);
  try {
    return {numbers[0].cast<std::uint32_t>(), numbers[1].cast<std::uint32_t>(),
            numbers[2].cast<std::int32_t>()};
  } catch (const py::cast_error&) {
    throw InputError(
        "filter: category and mask are whole numbers of 32 bits, the group one with a sign");
  }
}

py::tuple tuple_of(const Filter& filter) {
  return py::make_tuple(filter.category, filter.mask, filter.group);
}

Role role_from(py::handle argument) {
  return word_from<Role>(argument, "role", {{"solid", Role::Solid}, {"sensor", Role::Sensor}});
}

void add_world_settings(py::module_& module) {
  py::class_<SharedWorld> type(module.attr("World"));
  add_settings(type);
  add_states(type);
}

}  // namespace graze::python
