#include <graze/engine/python/binding/arguments/rays.h>

#include <graze/bvh/error.h>
#include <graze/bvh/value/element_error.h>

#include <string>

namespace graze::python {

Rays::Rays(py::handle origins, py::handle directions, py::handle max_distance)
    : origins_(origins, "origins"),
      directions_(directions, "directions"),
      lengths_(doubles(max_distance, "max_distance")) {
  if (lengths_.ndim() > 1)
    throw InputError("max_distance: is neither a number nor of the shape (n,)");
  const bool are_lengths_many = lengths_.ndim() == 1;
  is_many_ = origins_.is_many() || directions_.is_many() || are_lengths_many;
  const std::size_t lengths = are_lengths_many ? static_cast<std::size_t>(lengths_.shape(0)) : 1;
  size_ = origins_.is_many()      ? origins_.size()
          : directions_.is_many() ? directions_.size()
                                  : lengths;
  check_count(directions_.is_many(), directions_.size(), "directions");
  check_count(are_lengths_many, lengths, "max_distance");
  length_ = static_cast<const char*>(lengths_.data());
  length_stride_ = are_lengths_many ? lengths_.strides(0) : 0;
}

void Rays::blame() const {
  for (std::size_t i = 0; is_many_ && i < size_; ++i)
    bvh::at_element("ray", i, [&] { check_ray((*this)[i], ("ray " + std::to_string(i)).c_str()); });
}

void Rays::check_count(bool are_many, std::size_t count, const char* name) const {
  if (!are_many || count == size_) return;
  throw InputError(std::string(name) + ": are " + std::to_string(count) + ", and there are " +
                   std::to_string(size_) + " rays");
}

}  // namespace graze::python
