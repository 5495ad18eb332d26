#include <graze/bvh/fit/methods/support_ball.h>

#include <algorithm>

namespace graze::bvh {
namespace {

double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.data()[0] * b.data()[0] + a.data()[1] * b.data()[1] + a.data()[2] * b.data()[2];
}

/// The smallest ball around one point, which lies on its surface, and up to four others. It is the
/// circumscribed ball, with its centre in their affine hull, of the one and some of the others.
/// Of all such balls, each with the radius that covers all five, the smallest is taken: nothing is
/// asked of a tolerance, and a ball from ill-conditioned points only comes out too large.
class Pivot {
 public:
  Pivot(const Eigen::Vector3d& apex, std::span<const Eigen::Vector3d> others)
      : apex_(apex), others_(others) {
    for (const Eigen::Vector3d& other : others)
      edges_[edge_count_++] = other - apex;
    best_squared_ = covering_square(Eigen::Vector3d::Zero());
    extend(0, 0, Eigen::Vector3d::Zero());
  }

  SupportBall ball() const {
    SupportBall ball{apex_ + best_centre_, best_squared_, {}, best_size_ + 1};
    ball.support[0] = apex_;
    for (int i = 0; i < best_size_; ++i)
      ball.support[i + 1] = others_[best_[i]];
    return ball;
  }

 private:
  double covering_square(const Eigen::Vector3d& centre) const {
    double square = dot(centre, centre);
    for (int i = 0; i < edge_count_; ++i) {
      const Eigen::Vector3d to_edge = edges_[i] - centre;
      square = std::max(square, dot(to_edge, to_edge));
    }
    return square;
  }

  /// Adds each edge from `first` on to the `depth` chosen ones, whose circumscribed centre,
  /// relative to the apex, is given. The centre moves along the part z of the new edge e that is
  /// orthogonal to the chosen ones, to where it is as far from e as from the apex: |e|^2 = 2 e.(c +
  /// l z), l = (|e|^2 - 2 e.c) / (2 e.z).
  void extend(int first, int depth, const Eigen::Vector3d& centre) {
    for (int i = first; i < edge_count_; ++i) {
      const Eigen::Vector3d& edge = edges_[i];
      Eigen::Vector3d across = edge;
      for (int twice = 0; twice < 2; ++twice) {  // once leaves what cancellation lost
        for (int k = 0; k < depth; ++k)
          across -= dot(across, axes_[k]) * axes_[k];
      }
      const double length = across.norm();
      if (!(length > 0)) continue;
      axes_[depth] = across / length;
      const double along = dot(edge, axes_[depth]);
      if (!(along > 0)) continue;
      const double step = (dot(edge, edge) - 2 * dot(edge, centre)) / (2 * along);
      const Eigen::Vector3d moved = centre + step * axes_[depth];
      chosen_[depth] = i;
      const double square = covering_square(moved);
      if (square < best_squared_) {
        best_squared_ = square;
        best_centre_ = moved;
        best_size_ = depth + 1;
        best_ = chosen_;
      }
      if (depth < 2) extend(i + 1, depth + 1, moved);
    }
  }

  Eigen::Vector3d apex_;
  std::span<const Eigen::Vector3d> others_;
  std::array<Eigen::Vector3d, 4> edges_;
  int edge_count_ = 0;
  std::array<Eigen::Vector3d, 3> axes_;
  std::array<int, 3> chosen_{};
  std::array<int, 3> best_{};
  int best_size_ = 0;
  Eigen::Vector3d best_centre_ = Eigen::Vector3d::Zero();
  double best_squared_ = 0;
};

/// Returns the index and the square of the distance of the point farthest from `centre`.
std::pair<std::size_t, double> farthest(std::span<const Eigen::Vector3d> points,
                                        const Eigen::Vector3d& centre) {
  std::pair<std::size_t, double> best{0, -1};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d offset = points[i] - centre;
    const double squared = dot(offset, offset);
    if (squared > best.second) best = {i, squared};
  }
  return best;
}

}  // namespace

SupportBall smallest_ball(std::span<const Eigen::Vector3d> points) {
  // Exactly, the radius grows with each step. Rounded, it may stand still although the centre still
  // moves, for it can grow by the square of what the centre moves; hence the patience.
  constexpr int kPatience = 8;
  SupportBall ball{points[0], 0, {points[0]}, 1};
  SupportBall best = ball;
  double best_cover = -1;
  double largest = 0;
  for (int idle = 0; idle < kPatience;) {
    const auto [index, squared] = farthest(points, ball.centre);
    if (best_cover < 0 || squared < best_cover) {
      best_cover = squared;
      best = ball;
    }
    if (squared <= ball.squared_radius * (1 + kBallTolerance)) break;
    ball = Pivot(points[index], {ball.support.data(), std::size_t(ball.support_size)}).ball();
    if (ball.squared_radius > largest * (1 + 0x1p-50)) {
      largest = ball.squared_radius;
      idle = 0;
    } else {
      ++idle;
    }
  }
  return best;
}

}  // namespace graze::bvh
