#include <graze/engine/view/writing/frame_places.h>

#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace graze::view {
namespace {

using Eigen::Vector3d;

/// Holds a box that begins empty.
class Around {
 public:
  void add(const Vector3d& point) {
    box_ = box_ ? Aabb{box_->min.cwiseMin(point), box_->max.cwiseMax(point)} : Aabb{point, point};
  }

  void add(const Aabb& box, const Pose& pose) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      Vector3d point;
      for (int i = 0; i < 3; ++i)
        point[i] = (corner >> i & 1u) != 0 ? box.max[i] : box.min[i];
      add(place(pose, point));
    }
  }

  const std::optional<Aabb>& box() const { return box_; }

 private:
  std::optional<Aabb> box_;
};

/// Adds the bodies that stand in the frame, without those that have no end.
void add_bodies(const ShownView& view, const ShownFrame& frame, Around& around) {
  for (const auto& [body, pose] : frame.poses) {
    const ShownShape& shape = view.shapes[view.bodies[body].shape];
    if (!shape.surface.is_boundless) around.add(shape.bounds, pose);
  }
}

/// Adds the marks, for a frame without bodies.
void add_marks(const ShownFrame& frame, Around& around) {
  for (const auto* points : {&frame.curves, &frame.lines, &frame.points})
    for (const Vector3d& point : *points)
      around.add(point);
  for (const ShownContact& contact : frame.contacts)
    around.add(contact.point);
  for (const ShownGap& gap : frame.gaps)
    around.add(gap.point_a), around.add(gap.point_b);
  for (const ShownLabel& label : frame.labels)
    around.add(label.at);
}

float float_of(double number) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(number, -kMost, kMost));
}

}  // namespace

Eigen::Vector3f NumberFrame::numbers(const Vector3d& point) const {
  Eigen::Vector3f out;
  // It takes halves, for the difference of two doubles may be beyond double.
  for (int i = 0; i < 3; ++i)
    out[i] = float_of((point[i] / 2 - center[i] / 2) / scale * 2);
  return out;
}

float NumberFrame::length(double metres) const {
  return float_of(metres / scale);
}

NumberFrame number_frame(const Aabb& box) {
  const Vector3d half = box.max / 2 - box.min / 2;
  int exponent = 0;
  std::frexp(half.maxCoeff(), &exponent);
  if (half.maxCoeff() == 0) exponent = 1;
  // From 2^-1022 on 1 / scale is finite, too.
  return {box.min / 2 + box.max / 2, std::ldexp(1.0, std::clamp(exponent, -1021, 1023))};
}

FramePlaces frame_places(const ShownView& view) {
  FramePlaces found;
  const auto close = [&](std::size_t first, std::size_t end) {
    Around around;
    for (std::size_t f = first; f < end; ++f)
      add_bodies(view, view.frames[f], around);
    for (std::size_t f = first; f < end && !around.box(); ++f)
      add_marks(view.frames[f], around);
    found.places.push_back(around.box() ? number_frame(*around.box())
                                        : NumberFrame{Vector3d::Zero(), 1});
    found.of_frame.resize(end, found.places.size() - 1);
  };
  std::size_t first = 0;
  for (std::size_t f = 1; f < view.frames.size(); ++f) {
    if (!view.frames[f].said.is_apart) continue;
    close(first, f);
    first = f;
  }
  close(first, view.frames.size());
  return found;
}

}  // namespace graze::view
