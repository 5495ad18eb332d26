#pragma once

#include <graze/narrowphase/lanes/triangle_rows.h>

#include <tests/benchmark/triangles/columns.h>

namespace graze::benchmark {

/// The memory behind TriangleRows.
class TriangleColumns {
 public:
  template <typename Elements, typename TriangleOf>
  void assign(const Elements& elements, TriangleOf triangle_of) {
    columns_.assign(elements, 9, [&](const auto& element, double* numbers) {
      const Triangle t = triangle_of(element);
      const Eigen::Vector3d* corners[3] = {&t.a, &t.b, &t.c};
      for (int i = 0; i < 9; ++i)
        numbers[i] = corners[i / 3]->data()[i % 3];
    });
  }

  narrowphase::TriangleRows rows(std::size_t first, std::size_t count) const {
    narrowphase::TriangleRows rows{{}, count};
    for (std::size_t i = 0; i < 9; ++i)
      rows.row[i] = columns_.row(i) + first;
    return rows;
  }

 private:
  Columns columns_;
};

}  // namespace graze::benchmark
