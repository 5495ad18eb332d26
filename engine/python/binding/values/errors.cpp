#include <graze/engine/python/binding/module.h>

#include <graze/bvh/error.h>

namespace graze::python {
namespace {

namespace py = pybind11;

py::object or_none(const std::optional<std::size_t>& number) {
  if (!number) return py::none();
  return py::int_(*number);
}

/// Raises the exception `name` of graze._errors, which carries the place.
void raise(const char* name, const Error& error) {
  const py::module_ errors = py::module_::import("graze._errors");
  const ErrorPlace& place = error.place();
  // A file's name may be any bytes.
  const auto text_of = [](const std::string& text) {
    PyObject* made =
        PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "surrogateescape");
    if (made == nullptr) throw py::error_already_set();
    return py::reinterpret_steal<py::object>(made);
  };
  const auto text_or_none = [&](const std::string& text) -> py::object {
    if (text.empty()) return py::none();
    return text_of(text);
  };
  const py::object type = errors.attr(name);
  const py::object made = type(text_of(error.what()));
  made.attr("place") =
      errors.attr("ErrorPlace")(text_or_none(place.file), or_none(place.line), or_none(place.byte),
                                text_or_none(place.element), or_none(place.index));
  PyErr_SetObject(type.ptr(), made.ptr());
}

}  // namespace

void add_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      raise("InputError", error);
    } catch (const PoseError& error) {
      raise("PoseError", error);
    } catch (const MeshError& error) {
      raise("MeshError", error);
    } catch (const StaleIdError& error) {
      raise("StaleIdError", error);
    } catch (const UnsupportedPairError& error) {
      raise("UnsupportedPairError", error);
    } catch (const CaseError& error) {
      raise("CaseError", error);
    } catch (const Error& error) {
      raise("Error", error);
    }
  });
}

}  // namespace graze::python
