#pragma once

// Ids of bodies and boxes are whole numbers to Python: the index, and above it the generation.

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/engine/world/ids.h>

#include <span>
#include <vector>

namespace graze::python {

template <typename Id>
std::uint64_t number_of(const Id& id) {
  return static_cast<std::uint64_t>(id.generation) << 32 | id.index;
}

template <typename Id>
Id id_of(std::uint64_t number) {
  return {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32)};
}

/// Holds one id, or an array of the shape (n,).
template <typename Id>
struct Ids {
  explicit Ids(py::handle argument, const char* name = "ids") {
    const auto array = py::module_::import("graze._arrays")
                           .attr("ids")(argument, name)
                           .template cast<py::array_t<std::uint64_t>>();
    is_many = array.ndim() == 1;
    all.reserve(static_cast<std::size_t>(array.size()));
    for (py::ssize_t i = 0; i < array.size(); ++i)
      all.push_back(id_of<Id>(array.data()[i]));
  }

  bool is_many;
  std::vector<Id> all;
};

template <typename Id>
py::array_t<std::uint64_t> array_of_ids(const std::vector<Id>& ids) {
  auto array = new_array<std::uint64_t>({static_cast<py::ssize_t>(ids.size())});
  std::uint64_t* at = array.mutable_data();
  for (const Id& id : ids)
    *at++ = number_of(id);
  return array;
}

/// Makes an array of the shape (n, 2).
inline py::array_t<std::uint64_t> array_of_pairs(std::span<const BodyPair> pairs) {
  auto array = new_array<std::uint64_t>({static_cast<py::ssize_t>(pairs.size()), 2});
  std::uint64_t* at = array.mutable_data();
  for (const BodyPair& pair : pairs) {
    *at++ = number_of(pair.a);
    *at++ = number_of(pair.b);
  }
  return array;
}

}  // namespace graze::python
