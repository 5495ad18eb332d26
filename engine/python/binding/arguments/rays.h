#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/bvh/ray.h>

namespace graze::python {

/// Holds origins, directions and lengths, each of which may stand for all rays.
class Rays {
 public:
  /// Throws InputError for arrays of other shapes, and for different numbers of them.
  Rays(py::handle origins, py::handle directions, py::handle max_distance);

  bool is_many() const { return is_many_; }
  std::size_t size() const { return size_; }
  Ray operator[](std::size_t i) const {
    return {
        origins_[origins_.is_many() ? i : 0], directions_[directions_.is_many() ? i : 0],
        *reinterpret_cast<const double*>(length_ + static_cast<py::ssize_t>(i) * length_stride_)};
  }

  /// Throws for the first invalid ray.
  void blame() const;

 private:
  void check_count(bool are_many, std::size_t count, const char* name) const;

  Points origins_;
  Points directions_;
  py::array lengths_;
  const char* length_;
  py::ssize_t length_stride_;
  bool is_many_;
  std::size_t size_;
};

}  // namespace graze::python
