#pragma once

// Takes settings as Python says them: words for enumerations, None for what is not set.

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/bvh/error.h>
#include <graze/engine/mesh/query_settings.h>
#include <graze/engine/world/sides.h>
#include <graze/narrowphase/first_contact.h>
#include <graze/narrowphase/touch.h>

#include <initializer_list>
#include <string>
#include <utility>

namespace graze::python {

/// Returns the value that goes by the word. Throws InputError, which lists the words.
template <typename T>
T word_from(py::handle argument, const char* name,
            std::initializer_list<std::pair<const char*, T>> words) {
  for (const auto& [word, value] : words) {
    if (PyUnicode_Check(argument.ptr()) &&
        PyUnicode_CompareWithASCIIString(argument.ptr(), word) == 0)
      return value;
  }
  std::string known;
  for (const auto& [word, value] : words)
    known += std::string(known.empty() ? "" : ", ") + '"' + word + '"';
  throw InputError(std::string(name) + ": " + py::repr(argument).cast<std::string>() +
                   " is none of " + known);
}

Hit hit_from(py::handle argument);
Touch touch_from(py::handle argument);
StartContact start_from(py::handle argument);
/// Takes None or "surface" for the surface alone, "solid", or ("one_sided", thickness). Throws
/// InputError for anything else.
MeshSides sides_from(py::handle argument, const char* name);
/// Returns the bytes of a file's name, whatever they are: a str, bytes or a path. Throws TypeError
/// for anything else.
std::string path_from(py::handle argument);
/// Returns a limit; None is no limit.
std::size_t limit_from(py::handle argument);

}  // namespace graze::python
