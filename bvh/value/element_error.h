#pragma once

#include <cstddef>
#include <string>

#include <graze/bvh/error.h>

namespace graze::bvh {

/// Calls `check`; what it throws is told to be about element `index` of those that are called
/// `element`, in ErrorPlace: its words, and its type, stay. It costs nothing where nothing is
/// thrown.
template <typename Check>
void at_element(const char* element, std::size_t index, Check&& check) {
  const auto place = [&] { return ErrorPlace{.element = element, .index = index}; };
  try {
    check();
  } catch (const PoseError& error) {
    throw PoseError(error.what(), place());
  } catch (const InputError& error) {
    throw InputError(error.what(), place());
  } catch (const StaleIdError& error) {
    throw StaleIdError(error.what(), place());
  }
}

/// Calls `check(what)` for element `index` of those that are called `element`; what it throws names
/// it, `what` being "pose 12 of mesh B", say. That text is only written where something is thrown.
template <typename Check>
void check_element(const char* element, std::size_t index, const char* of, Check&& check) {
  try {
    check(element);
  } catch (const Error&) {
    const std::string what = element + (" " + std::to_string(index)) + of;
    at_element(element, index, [&] { check(what.c_str()); });
    throw;
  }
}

}  // namespace graze::bvh
