#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/points/nearest_search.h>
#include <graze/engine/mesh/query/batch.h>
#include <graze/engine/mesh/query/query_results.h>

#include <cmath>
#include <optional>
#include <string>

namespace graze {
namespace {

/// The most points of a part: enough that what is made once for each does not count, few enough to
/// share.
constexpr std::size_t kMostInAPart = 4096;

bool is_finite(const Eigen::Vector3d& point) {
  return std::isfinite(point.x()) && std::isfinite(point.y()) && std::isfinite(point.z());
}

/// Points of a span, or in the rows of a matrix.
class PointRows {
 public:
  explicit PointRows(std::span<const Eigen::Vector3d> points)
      : data_(points.empty() ? nullptr : points.data()->data()),
        size_(points.size()),
        row_stride_(3),
        column_stride_(1) {
    check();
  }

  explicit PointRows(const MatrixView<double>& points)
      : data_(points.data()),
        size_(static_cast<std::size_t>(points.rows())),
        row_stride_(points.rowStride()),
        column_stride_(points.colStride()) {
    if (points.cols() != 3) {
      throw InputError("points: a matrix of " + std::to_string(points.cols()) + " columns, not 3");
    }
    check();
  }

  std::size_t size() const { return size_; }

  Eigen::Vector3d operator[](std::size_t index) const {
    const double* row = data_ + static_cast<std::ptrdiff_t>(index) * row_stride_;
    return {row[0], row[column_stride_], row[2 * column_stride_]};
  }

 private:
  void check() const {
    for (std::size_t i = 0; i < size_; ++i) {
      const Eigen::Vector3d point = (*this)[i];
      if (is_finite(point)) [[likely]]
        continue;
      bvh::at_element("point", i, [&] { check_point(point, "point " + std::to_string(i)); });
    }
  }

  const double* data_;
  std::size_t size_;
  std::ptrdiff_t row_stride_;
  std::ptrdiff_t column_stride_;
};

/// Calls `ask(first, last, work)` for parts of so many points, on any thread.
template <typename Ask>
void ask_all(std::size_t count, const BatchSettings& batch, Work* total, Ask&& ask) {
  for_each_part_of_batch(count, kMostInAPart, batch, total,
                         [&](std::size_t first, std::size_t last, BatchRun& run, Work& work) {
                           ask(first, last, work);
                           run.add(last - first);
                         });
}

/// Checks the pose. Throws PoseError; returns the deviation from a rotation.
double check_pose(const PlacedMeshView& mesh) {
  return check_placement(mesh.pose, mesh.mesh.bounds(), "pose of the mesh");
}

/// Returns a distance with the sign of the side on which its point lies.
double with_side(double distance, const PlacedMeshView& mesh, const Eigen::Vector3d& point,
                 Work& work) {
  if (distance == 0) return 0;
  return is_moved_point_enclosed(mesh, point, work) ? -distance : distance;
}

std::vector<bool> contains_each(const PlacedMeshView& mesh, const PointRows& points,
                                const BatchSettings& batch, Work* work) {
  check_pose(mesh);
  check_closed(mesh.mesh, "the mesh");
  // There is a char for each answer, because many threads cannot write to the bits of one word.
  std::vector<char> answers(points.size());
  ask_all(points.size(), batch, work, [&](std::size_t first, std::size_t last, Work& own) {
    for (std::size_t i = first; i < last; ++i)
      answers[i] = static_cast<char>(contains(mesh, points[i], &own));
  });
  return {answers.begin(), answers.end()};
}

/// Calls `take(i, nearest, work)` for each point, on any thread.
template <typename Take>
void find_each(const PlacedMeshView& mesh, const PointRows& points, const BatchSettings& batch,
               Work* work, Take&& take) {
  const double deviation = check_pose(mesh);
  ask_all(points.size(), batch, work, [&](std::size_t first, std::size_t last, Work& own) {
    NearestSearch search(mesh, deviation, own);
    std::optional<std::uint32_t> hint;
    for (std::size_t i = first; i < last; ++i) {
      const NearestPoint nearest = search.nearest_to(points[i], hint);
      hint = nearest.triangle;
      take(i, nearest, own);
    }
  });
}

std::vector<NearestPoint> nearest_to_each(const PlacedMeshView& mesh, const PointRows& points,
                                          const BatchSettings& batch, Work* work) {
  std::vector<NearestPoint> answers(points.size());
  find_each(mesh, points, batch, work,
            [&](std::size_t i, const NearestPoint& nearest, Work&) { answers[i] = nearest; });
  return answers;
}

std::vector<double> signed_distance_of_each(const PlacedMeshView& mesh, const PointRows& points,
                                            const BatchSettings& batch, Work* work) {
  check_closed(mesh.mesh, "the mesh");
  std::vector<double> answers(points.size());
  find_each(mesh, points, batch, work, [&](std::size_t i, const NearestPoint& nearest, Work& own) {
    answers[i] = with_side(nearest.distance, mesh, points[i], own);
  });
  return answers;
}

}  // namespace

NearestPoint nearest_point(const PlacedMeshView& mesh, const Eigen::Vector3d& point, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> NearestPoint {
    check_point(point, "point");
    const double deviation = check_pose(mesh);
    CountedWork counted(work);
    return NearestSearch(mesh, deviation, counted.work()).nearest_to(point, std::nullopt);
  });
}

double signed_distance(const PlacedMeshView& mesh, const Eigen::Vector3d& point, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> double {
    check_closed(mesh.mesh, "the mesh");
    CountedWork counted(work);
    return with_side(nearest_point(mesh, point, &counted.work()).distance, mesh, point,
                     counted.work());
  });
}

std::vector<bool> contains_points(const PlacedMeshView& mesh,
                                  std::span<const Eigen::Vector3d> points,
                                  const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic(
      [&]() -> std::vector<bool> { return contains_each(mesh, PointRows(points), batch, work); });
}

std::vector<bool> contains_points(const PlacedMeshView& mesh, const MatrixView<double>& points,
                                  const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic(
      [&]() -> std::vector<bool> { return contains_each(mesh, PointRows(points), batch, work); });
}

std::vector<NearestPoint> nearest_points(const PlacedMeshView& mesh,
                                         std::span<const Eigen::Vector3d> points,
                                         const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<NearestPoint> {
    return nearest_to_each(mesh, PointRows(points), batch, work);
  });
}

std::vector<NearestPoint> nearest_points(const PlacedMeshView& mesh,
                                         const MatrixView<double>& points,
                                         const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<NearestPoint> {
    return nearest_to_each(mesh, PointRows(points), batch, work);
  });
}

std::vector<double> signed_distances(const PlacedMeshView& mesh,
                                     std::span<const Eigen::Vector3d> points,
                                     const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<double> {
    return signed_distance_of_each(mesh, PointRows(points), batch, work);
  });
}

std::vector<double> signed_distances(const PlacedMeshView& mesh, const MatrixView<double>& points,
                                     const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<double> {
    return signed_distance_of_each(mesh, PointRows(points), batch, work);
  });
}

}  // namespace graze
