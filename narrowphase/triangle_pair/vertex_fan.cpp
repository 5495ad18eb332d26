// A fan is looked at along some direction d, along which all of its triangles surely turn the same
// way: d . (r x s) > 0 for the two rays of each. Let the rays' angles as they are seen, added up
// from the first ray's on, be A_i: each is larger than the one before, by less than half a turn. If
// all add up to one turn of a closed fan, or to less of an open one, then the triangles as they are
// seen are sectors side by side: two have a ray in common if one follows the other, else only the
// vertex. Seen along d, no triangle has two points behind each other, so that what two of them have
// in common is seen in what their sectors have in common: that ray is the edge, and no more.
//
// On which side of the first ray the others are says how far A_i has come. From 0 to a half turn it
// is on the positive side, from there to a whole one on the negative. While no ray that is surely
// positive follows one that is negative, A_i does not pass a whole turn. A ray that is on neither
// side for sure, as two edges along one line are, may be behind half a turn or behind a whole one:
// behind a positive ray, it is less than a whole turn on, and if a negative one follows, this is
// less than a turn and a half on, hence less than one. So one such ray may stand there, and nowhere
// else. In a closed fan the last triangle then leads from less than one turn to a multiple of one.

#include <graze/narrowphase/derived/sign_of_products.h>
#include <graze/narrowphase/triangle_pair/vertex_fan.h>

#include <algorithm>
#include <cmath>

namespace graze::narrowphase {
namespace {

/// Any direction will do. The sum of the normals does for nearly all; where triangles of one side
/// are many or large, their mean is turned towards those that it does not see from their front, as
/// a perceptron is.
constexpr int kMostDirections = 6;

struct Arrow {
  double x, y, z;
};

double size_of(const Arrow& a) {
  return std::max(std::max(std::abs(a.x), std::abs(a.y)), std::abs(a.z));
}

Arrow cross_of(const Arrow& a, const Arrow& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot_of(const Arrow& a, const Arrow& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

void add(Arrow& sum, double factor, const Arrow& a) {
  sum.x += factor * a.x;
  sum.y += factor * a.y;
  sum.z += factor * a.z;
}

class SeenFan {
 public:
  explicit SeenFan(const VertexFan& fan) {
    const Eigen::Vector3d& v = *fan.vertex;
    for (const Eigen::Vector3d* end : fan.rays) {
      const Arrow ray{end->x() - v.x(), end->y() - v.y(), end->z() - v.z()};
      largest_ = std::max(largest_, size_of(ray));
      ray_[rays_++] = ray;
    }
    sectors_ = rays_ - 1;
    for (std::size_t i = 0; i < sectors_; ++i)
      normal_[i] = cross_of(ray_[i], ray_[i + 1]);
    if (fan.kind == VertexFan::Kind::Closed)
      normal_[sectors_++] = cross_of(ray_[rays_ - 1], ray_[0]);
  }

  bool is_surely_simple() {
    Arrow direction{0, 0, 0};
    for (std::size_t i = 0; i < sectors_; ++i)
      add(direction, 1, normal_[i]);
    set_direction(direction);
    if (turn_alike()) return is_within_one_turn();
    make_units();
    for (int n = 0; n < kMostDirections; ++n) {
      if (turn_alike()) return is_within_one_turn();
      turn_to_backs();
    }
    return false;
  }

 private:
  /// Sets the direction, and the bound of all products of it and two rays, in whatever order.
  void set_direction(const Arrow& direction) {
    direction_ = direction;
    const double size = size_of(direction);
    bound_ =
        std::max(triple_bound(largest_, largest_, size), triple_bound(size, largest_, largest_));
  }

  bool turn_alike() const {
    bool are_positive = true;
    for (std::size_t i = 0; i < sectors_; ++i)
      are_positive &= dot_of(normal_[i], direction_) > bound_;
    return are_positive;
  }

  /// The mean of unit normals is the next direction.
  void make_units() {
    Arrow direction{0, 0, 0};
    for (std::size_t i = 0; i < sectors_; ++i) {
      weight_[i] = 1 / std::sqrt(dot_of(normal_[i], normal_[i]));
      add(direction, weight_[i], normal_[i]);
    }
    set_direction(direction);
  }

  void turn_to_backs() {
    Arrow direction = direction_;
    for (std::size_t i = 0; i < sectors_; ++i) {
      if (!(dot_of(normal_[i], direction_) > bound_)) add(direction, weight_[i], normal_[i]);
    }
    set_direction(direction);
  }

  bool is_within_one_turn() const {
    const Arrow across = cross_of(direction_, ray_[0]);
    bool is_negative = false, is_unsure = false;
    for (std::size_t i = 1; i < rays_; ++i) {
      const double side = dot_of(across, ray_[i]);
      if (side < -bound_) {
        is_negative = true;
      } else if (is_negative || is_unsure) {
        return false;
      } else {
        is_unsure = !(side > bound_);
      }
    }
    return true;
  }

  Arrow ray_[VertexFan::kMostRays];
  Arrow normal_[VertexFan::kMostRays];
  double weight_[VertexFan::kMostRays];
  std::size_t rays_ = 0;
  std::size_t sectors_ = 0;
  double largest_ = 0;
  double bound_ = 0;
  Arrow direction_{0, 0, 0};
};

}  // namespace

bool is_surely_simple(const VertexFan& fan) {
  return SeenFan(fan).is_surely_simple();
}

}  // namespace graze::narrowphase
