#include <graze/bvh/value/ray_slabs.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/fields/field_query.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <cmath>
#include <queue>

namespace graze {

namespace {

using Eigen::Vector3d;

double largest(const Vector3d& v) {
  return std::max(std::abs(v.x()), std::max(std::abs(v.y()), std::abs(v.z())));
}

double sum(const Vector3d& v) {
  return (std::abs(v.x()) + std::abs(v.y())) + std::abs(v.z());
}

double along(const Pose& pose, int k, const Vector3d& v) {
  const double* m = pose.data();  // column-major 4x4
  return (m[4 * k] * v.x() + m[4 * k + 1] * v.y()) + m[4 * k + 2] * v.z();
}

// The slack of MeshDescent is (8 dev + 2^-45) of the same sizes, and that of the plane in
// lowest_vertex() 2^-47: a descent looks at no triangle that this leaves out.
double pad_of(const HeightFieldData& field, const Pose& pose, double others) {
  const Aabb& own = field.bounds;
  const double* m = pose.data();
  const double size = 2 * (sum(own.min) + sum(own.max)) + 2 * others;
  return (16 * rotation_deviation(pose) + 0x1p-40) * size + 0x1p-46 * sum({m[12], m[13], m[14]});
}

}  // namespace

FieldQuery::FieldQuery(const HeightFieldData& field, const Pose& pose, const Aabb& box) {
  const double* m = pose.data();
  const Vector3d half = box.max / 2 - box.min / 2;
  const Vector3d middle = box.min / 2 + box.max / 2 - Vector3d(m[12], m[13], m[14]);
  pad_ = pad_of(field, pose, sum(middle) + sum(half));
  for (int k = 0; k < 3; ++k) {
    const double at = along(pose, k, middle);
    const double radius = (std::abs(m[4 * k]) * half.x() + std::abs(m[4 * k + 1]) * half.y()) +
                          std::abs(m[4 * k + 2]) * half.z() + pad_;
    box_.min.data()[k] = at - radius;
    box_.max.data()[k] = at + radius;
  }
  inner_ = box_;
}

FieldQuery::FieldQuery(const HeightFieldData& field, const Pose& pose,
                       const PlacedShapeView& other) {
  const auto* half_space = other.shape.as<HalfSpace>();
  if (half_space == nullptr) {
    *this = FieldQuery(field, pose, bounding_aabb(other));
    return;
  }
  is_plane_ = true;
  const double* m = pose.data();
  const double* o = other.pose.data();
  const Vector3d& own = half_space->normal;
  Vector3d normal;  // in the world
  for (int i = 0; i < 3; ++i)
    normal.data()[i] = (o[i] * own.x() + o[4 + i] * own.y()) + o[8 + i] * own.z();
  const Vector3d between = Vector3d(o[12], o[13], o[14]) - Vector3d(m[12], m[13], m[14]);
  offset_ = half_space->offset +
            ((normal.x() * between.x() + normal.y() * between.y()) + normal.z() * between.z());
  for (int k = 0; k < 3; ++k)
    normal_.data()[k] = along(pose, k, normal);
  const double sizes = sum(between) + std::abs(half_space->offset);
  pad_ = pad_of(field, pose, sizes) + 16 * rotation_deviation(other.pose) * sizes +
         8 * kTouchTolerance * (largest(field.bounds.min) + largest(field.bounds.max) + sizes);
  offset_ += pad_;
}

void FieldQuery::grow(double room) {
  const double wider = room * (1 + 0x1p-20);
  offset_ += wider;
  room_ += wider;
  const Vector3d each = Vector3d::Constant(wider);
  box_.min -= each;
  box_.max += each;
}

void FieldQuery::grow_aside(double room) {
  const Vector3d aside(room, room, room);
  box_.min -= aside;
  box_.max += aside;
  inner_.min -= aside;
  inner_.max += aside;
}

void FieldQuery::move(const Pose& pose, const Vector3d& displacement) {
  for (int k = 0; k < 3; ++k)
    displacement_.data()[k] = along(pose, k, displacement);
  const Vector3d each =
      Vector3d::Constant((16 * rotation_deviation(pose) + 0x1p-40) * sum(displacement));
  box_.min -= each;
  box_.max += each;
  offset_ +=
      each.x() + std::max(-(normal_.x() * displacement_.x() + normal_.y() * displacement_.y() +
                            normal_.z() * displacement_.z()),
                          0.0);
}

/// Returns the height of the lowest corner above the half-space's plane.
double FieldQuery::height_above(const Aabb& box) const {
  double low = -offset_;
  for (int k = 0; k < 3; ++k) {
    low += std::min(normal_.data()[k] * box.min.data()[k], normal_.data()[k] * box.max.data()[k]);
  }
  return low;
}

// A box that moves meets another if the path of its corner enters the other, grown by its sides.
bool FieldQuery::meets(const Aabb& box) const {
  if (is_plane_) return !(height_above(box) > 0);
  double enter = 0, exit = 1;
  for (int k = 0; k < 3; ++k) {
    const double low = box.min.data()[k] - box_.max.data()[k];
    const double high = box.max.data()[k] - box_.min.data()[k];
    const double component = displacement_.data()[k];
    if (low > std::max(component, 0.0) || high < std::min(component, 0.0)) return false;
    // Products and quotients are off by 2^-50 of numbers below 1. If the component is so short that
    // they overflow, its ends have decided.
    if (!(std::abs(component) > 0x1p-900)) continue;
    const double at_low = low / component, at_high = high / component;
    enter = std::max(enter, std::min(at_low, at_high));
    exit = std::min(exit, std::max(at_low, at_high));
  }
  const bool goes = displacement_.x() != 0 || displacement_.y() != 0 || displacement_.z() != 0;
  if (!goes && room_ > 0 && gap_to(box) > room_) return false;
  return enter <= exit + 0x1p-40;
}

double FieldQuery::distance(const Aabb& box) const {
  return is_plane_ ? std::max(height_above(box), 0.0) : std::max(gap_to(box) - room_, 0.0);
}

double FieldQuery::gap_to(const Aabb& box) const {
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double gap = std::max(box.min.data()[k] - inner_.max.data()[k],
                                inner_.min.data()[k] - box.max.data()[k]);
    if (gap > 0) square += gap * gap;
  }
  return std::sqrt(square) * (1 - 0x1p-40);
}

namespace {

/// Cuts the cells from `first` to `last` along an axis to those between low and high, rounded
/// outward.
void cut(double low, double high, double spacing, std::uint32_t& first, std::uint32_t& last) {
  const double most = last;
  const double from = std::floor(low / spacing * (1 - 0x1p-50)) - 1;
  const double to = std::ceil(high / spacing * (1 + 0x1p-50)) + 1;
  first = static_cast<std::uint32_t>(std::clamp(from, 0.0, most));
  last = static_cast<std::uint32_t>(std::clamp(to, 0.0, most));
}

}  // namespace

CellRect FieldQuery::columns_of_cells(const HeightFieldData& field) const {
  CellRect cells = field.cells();
  if (is_plane_) return cells;
  const double x = displacement_.x(), y = displacement_.y();
  cut(box_.min.x() + std::min(x, 0.0), box_.max.x() + std::max(x, 0.0), field.spacing_x,
      cells.first_column, cells.last_column);
  cut(box_.min.y() + std::min(y, 0.0), box_.max.y() + std::max(y, 0.0), field.spacing_y,
      cells.first_row, cells.last_row);
  return cells;
}

namespace {

/// Walks the squares whose cells are within a rectangle and that are met, down to level 0, until
/// `visit(square)` returns false.
class SquareWalk {
 public:
  SquareWalk(const HeightFieldData& field, const FieldQuery& query)
      : field_(field), query_(query), within_(query.columns_of_cells(field)) {}

  template <typename Visit>
  bool down(const CellSquare& square, const Visit& visit) const {
    const CellRect cells = field_.cells_of(square);
    if (cells.first_column >= within_.last_column || cells.last_column <= within_.first_column ||
        cells.first_row >= within_.last_row || cells.last_row <= within_.first_row)
      return true;
    const HeightRange range = field_.range_of(square);
    if (range.is_empty() || !query_.meets(field_.box_of(cells, range))) return true;
    if (square.level == 0) return visit(square);
    bool goes_on = true;
    field_.for_children(square,
                        [&](const CellSquare& child) { goes_on = goes_on && down(child, visit); });
    return goes_on;
  }

  /// Walks down from the smallest square of the hierarchy that holds the rectangle.
  template <typename Visit>
  bool all(const Visit& visit) const {
    if (within_.is_empty()) return true;
    CellSquare top = field_.root();
    while (top.level > 0) {
      const auto width = static_cast<std::uint32_t>(top.width() >> CellSquare::kShift);
      const std::uint32_t column = within_.first_column / width, row = within_.first_row / width;
      if ((within_.last_column - 1) / width != column || (within_.last_row - 1) / width != row)
        break;
      top = {top.level - 1, column, row};
    }
    return down(top, visit);
  }

 private:
  const HeightFieldData& field_;
  const FieldQuery& query_;
  CellRect within_;
};

}  // namespace

bool is_any_met(const HeightFieldData& field, const FieldQuery& query) {
  return !SquareWalk(field, query).all([](const CellSquare&) { return false; });
}

std::vector<CellSquare> squares_met(const HeightFieldData& field, const FieldQuery& query) {
  std::vector<CellSquare> found;
  SquareWalk(field, query).all([&](const CellSquare& square) {
    found.push_back(square);
    return true;
  });
  std::sort(found.begin(), found.end(), [](const CellSquare& s, const CellSquare& t) {
    return s.row != t.row ? s.row < t.row : s.column < t.column;
  });
  return found;
}

CellSquare nearest_square(const HeightFieldData& field, const FieldQuery& query) {
  struct Waiting {
    double distance;
    CellSquare square;
    bool operator<(const Waiting& other) const { return distance > other.distance; }
  };
  std::priority_queue<Waiting> waiting;
  waiting.push({0, field.root()});
  while (waiting.top().square.level > 0) {
    const CellSquare square = waiting.top().square;
    waiting.pop();
    field.for_children(square, [&](const CellSquare& child) {
      const HeightRange range = field.range_of(child);
      if (range.is_empty()) return;
      waiting.push({query.distance(field.box_of(field.cells_of(child), range)), child});
    });
  }
  return waiting.top().square;
}

}  // namespace graze
