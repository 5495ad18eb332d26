#include <graze/bvh/error.h>
#include <graze/engine/compare/judge/shrink/shape_numbers.h>
#include <graze/engine/compare/judge/shrink/shrink.h>
#include <graze/engine/compare/peers/engine.h>

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace graze::compare {
namespace {

/// In longer lists each number would cost a question or five.
constexpr std::size_t kMostNumbers = 60;

/// Returns the shape as it is when a file has held it: its rounding comes to rest at once, or
/// nearly so.
std::optional<Shape> as_read_back(Shape shape) {
  for (int i = 0; i < 8; ++i) {
    const std::vector<double> numbers = numbers_of(shape);
    Shape next = with_numbers(shape, numbers);
    if (numbers_of(next) == numbers) return next;
    shape = std::move(next);
  }
  return std::nullopt;
}

class BodyShrinking {
 public:
  BodyShrinking(const Case& query, const StillWrong& is_still_wrong)
      : best_(query), is_still_wrong_(is_still_wrong) {
    best_.answer.reset();
  }

  /// Makes both bodies what a file would give back.
  bool round_trip() {
    Case candidate = best_;
    for (const Side side : kSides) {
      CaseBody& body = body_of(candidate, side);
      std::optional<Shape> shape = as_read_back(body.shape);
      if (!shape) return false;
      body.shape = *std::move(shape);
    }
    return try_case(std::move(candidate));
  }

  void shrink() {
    for (bool is_smaller = true; is_smaller;) {
      is_smaller = false;
      for (const Side side : kSides)
        is_smaller |= take_parts(side);
    }
    for (const Side side : kSides)
      simplify_pose(side);
    for (const Side side : kSides)
      simplify_numbers(side);
  }

  Case take() { return best_; }

 private:
  enum class Side { A, B };
  static constexpr std::array kSides = {Side::A, Side::B};

  static CaseBody& body_of(Case& query, Side side) {
    return std::get<CaseBody>(side == Side::A ? query.a : *query.b);
  }

  bool try_case(Case candidate) {
    if (!is_still_wrong_(candidate)) return false;
    best_ = std::move(candidate);
    return true;
  }

  /// Tries another body. A shape that its constructor refuses is not tried.
  bool try_body(Side side, const std::function<void(CaseBody&)>& change) {
    try {
      Case candidate = best_;
      CaseBody& body = body_of(candidate, side);
      change(body);
      std::optional<Shape> shape = as_read_back(body.shape);
      if (!shape) return false;
      body.shape = *std::move(shape);
      return try_case(std::move(candidate));
    } catch (const Error&) {
      return false;
    }
  }

  bool take_parts(Side side) {
    const Shape whole = body_of(best_, side).shape;
    Indices parts = all_indices(part_count(whole));
    return take_away(parts, [&](const Indices& some) {
      return try_body(side, [&](CaseBody& body) { body.shape = with_parts(whole, some); });
    });
  }

  void simplify_pose(Side side) {
    const CaseBody before = body_of(best_, side);
    const bool is_unplaced = try_body(side, [&](CaseBody& body) {
      if (const std::optional<Shape> shape = unplaced(before.shape, before.pose)) {
        body.shape = *shape;
      }
      body.pose = Pose::Identity();
    });
    if (is_unplaced) return;
    try_body(side, [](CaseBody& body) { body.pose.linear() = Eigen::Matrix3d::Identity(); });
    for (int axis = 0; axis < 3; ++axis) {
      shorten(body_of(best_, side).pose.translation()[axis], [&](double coarse) {
        return try_body(side, [&](CaseBody& body) { body.pose.translation()[axis] = coarse; });
      });
    }
  }

  void simplify_numbers(Side side) {
    const std::size_t count = numbers_of(body_of(best_, side).shape).size();
    if (count > kMostNumbers) return;
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<double> numbers = numbers_of(body_of(best_, side).shape);
      if (i >= numbers.size()) return;
      shorten(numbers[i], [&](double coarse) {
        return try_body(side, [&](CaseBody& body) {
          std::vector<double> shorter = numbers;
          shorter[i] = coarse;
          body.shape = with_numbers(body.shape, shorter);
        });
      });
    }
  }

  Case best_;
  const StillWrong& is_still_wrong_;
};

}  // namespace

Case shrink_bodies(const Case& query, const StillWrong& is_still_wrong) {
  BodyShrinking shrinking(query, is_still_wrong);
  try {
    if (shrinking.round_trip()) shrinking.shrink();
  } catch (const ShrinkingStopped&) {  // the best so far is true
  }
  return shrinking.take();
}

}  // namespace graze::compare
