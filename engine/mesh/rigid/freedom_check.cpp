// This checks certificates, and depends on nothing else: it proves what is claimed in interval
// arithmetic.
//
// A vertex x starts at p = R x + o and is at c + t s + Q(t) (p - c), with Q(t) the rotation by t
// angle about the axis a. Along a normal n that is n . (c + t s) + m . (p - c), m = Q(t)^T n. While
// a body turns by w, a vertex r from the axis leaves the line between its heights at both ends
// downward by at most w^2 / 8 times the largest -h on its way, h = (m - (a . n) a) . (p - c) being
// its second derivative but for the sign; and that is at most what it is at both ends and w^2 / 8 r
// |n|, or r |n| at all. So the heights of B's vertices at both ends, less that, bound B from below,
// and A's likewise from above.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/rigid/interval.h>
#include <graze/engine/mesh/rigid_certificate.h>

#include <array>
#include <optional>
#include <span>

namespace graze {
namespace {

using Vector = std::array<Interval, 3>;

Vector exact(const double* v) {
  return {v[0], v[1], v[2]};
}

Interval dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector sum(const Vector& a, const Interval& scale, const Vector& b) {
  return {a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Returns sine and 1 - cosine, by Taylor's series about 0 of an angle less whole turns; what is
/// left of these, below 3.2^31 / 31! and 3.2^32 / 32!, is less than 2^-60.
std::array<Interval, 2> sine_and_versine(const Interval& angle) {
  const Interval whole_turn(0x1.921fb54442d18p+2, 0x1.921fb54442d19p+2);
  const Interval x = angle - whole_turn * std::round(angle.low / whole_turn.low);
  if (!(x.low > -3.2 && x.high < 3.2)) return {Interval(-1, 1), Interval(0, 2)};
  const Interval square = x * x, rest(-0x1p-60, 0x1p-60);
  Interval sine(1), versine(1);
  for (int n = 29; n > 1; n -= 2)
    sine = 1 - square * sine * reciprocal(Interval(n) * (n - 1.0));
  for (int n = 30; n > 2; n -= 2)
    versine = 1 - square * versine * reciprocal(Interval(n) * (n - 1.0));
  return {x * sine + rest, square * versine * 0.5 + rest};
}

/// The heights of triangles along a normal, at least: those at both ends of a stretch of time, and
/// by how much triangles may be lower in between than the line between these.
struct Heights {
  double least[2];
  double bulge;
};

struct Body {
  const Mesh& mesh;
  const RigidMotion& motion;
  std::span<const std::uint32_t> order;
  Vector axis;
  std::vector<Vector> from_centre;  ///< each vertex at t = 0, p - c
  std::vector<double> from_axis;    ///< how far each is from the axis, at most
  double rounding;  ///< metres: what law 1 and at() round, below 2^-40 of all lengths

  Body(const Mesh& of_mesh, const RigidMotion& in_motion, std::span<const std::uint32_t> in_order)
      : mesh(of_mesh), motion(in_motion), order(in_order), axis(exact(in_motion.axis().data())) {
    const Interval scale = reciprocal(root(dot(axis, axis)));
    axis = {axis[0] * scale, axis[1] * scale, axis[2] * scale};
    const double* r = motion.start().data();  // column-major 4x4
    const Vector arm = sum(exact(r + 12), -1.0, exact(motion.centre().data()));
    for (const Eigen::Vector3d& vertex : mesh.vertices()) {
      const double* x = vertex.data();
      from_centre.push_back(
          sum(sum(sum(arm, x[0], exact(r)), x[1], exact(r + 4)), x[2], exact(r + 8)));
      const Vector off = cross(from_centre.back(), axis);
      from_axis.push_back(root(dot(off, off)).high);
    }
    double sizes = 0;
    for (int i = 0; i < 3; ++i) {
      sizes += std::abs(mesh.bounds().min.data()[i]) + std::abs(mesh.bounds().max.data()[i]);
      sizes += std::abs(motion.shift().data()[i]) + 4 * std::abs(r[12 + i]) +
               4 * std::abs(motion.centre().data()[i]);
    }
    rounding = 0x1p-40 * (1 + std::abs(motion.angle()) * 0x1p-8) * sizes;
  }

  /// Returns the heights of the triangles order[first] to order[last - 1] from t0 to t1.
  Heights heights(const Vector& n, double t0, double t1, std::uint32_t first,
                  std::uint32_t last) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Heights found{{kInfinity, kInfinity}, 0};
    double inward = 0, radius = 0;
    for (int end = 0; end < 2; ++end) {
      const Interval t(end == 0 ? t0 : t1);
      const auto [sine, versine] = sine_and_versine(t * motion.angle());
      const Vector across = cross(axis, n);
      const Vector m = sum(sum(n, -sine, across), versine, cross(axis, across));
      const Vector h = sum(m, -dot(axis, n), axis);
      const Interval centre =
          dot(n, sum(exact(motion.centre().data()), t, exact(motion.shift().data())));
      for (std::uint32_t i = first; i < last; ++i) {
        for (const std::uint32_t corner : mesh.triangles()[order[i]]) {
          const Vector& q = from_centre[corner];
          found.least[end] = std::min(found.least[end], (centre + dot(m, q)).low);
          inward = std::max(inward, (-dot(h, q)).high);
          radius = std::max(radius, from_axis[corner]);
        }
      }
    }
    const Interval turned = (Interval(t1) - t0) * motion.angle();
    const Interval share = turned * turned * 0.125;
    const Interval length = root(dot(n, n));
    const Interval most = share * Interval(radius) * length;
    found.bulge =
        (share * std::min((Interval(radius) * length).high, (Interval(inward) + most).high) +
         Interval(rounding) * length)
            .high;
    return found;
  }
};

/// The times and the triangles for which something is still to be proved.
struct Open {
  double t0, t1;
  std::uint32_t first_a, last_a, first_b, last_b;
};

bool keeps_apart(const Body& a, const Body& b, const Open& open, const Eigen::Vector3d& normal,
                 double clearance) {
  // In this range nothing overflows, so that no interval becomes one of no numbers.
  const double size = normal.lpNorm<Eigen::Infinity>();
  if (!(size > 0x1p-100 && size < 0x1p100) || normal.hasNaN()) return false;
  const Vector n = exact(normal.data());
  const Vector back{-n[0], -n[1], -n[2]};
  const Heights of_a = a.heights(back, open.t0, open.t1, open.first_a, open.last_a);
  const Heights of_b = b.heights(n, open.t0, open.t1, open.first_b, open.last_b);
  const double least =
      (Interval(clearance) * root(dot(n, n)) + Interval(of_a.bulge) + of_b.bulge).high;
  return (Interval(of_a.least[0]) + of_b.least[0]).low > least &&
         (Interval(of_a.least[1]) + of_b.least[1]).low > least;
}

/// True if each of 0 to size - 1 is there once.
bool is_permutation(std::span<const std::uint32_t> order, std::size_t size) {
  std::vector<bool> is_there(size);
  for (const std::uint32_t index : order) {
    if (index >= size || is_there[index]) return false;
    is_there[index] = true;
  }
  return order.size() == size;
}

/// Puts both halves on the stack, of which the first is looked at first. Returns false if there is
/// nothing to divide.
bool divide(std::vector<Open>& stack, const Open& open, const FreedomStep& step) {
  Open one = open, other = open;
  switch (step.kind) {
    case FreedomStep::Kind::HalveTime:
      one.t1 = other.t0 = open.t0 + (open.t1 - open.t0) / 2;
      if (!(open.t0 < one.t1 && one.t1 < open.t1)) return false;
      break;
    case FreedomStep::Kind::DivideA:
      if (step.count == 0 || step.count >= open.last_a - open.first_a) return false;
      one.last_a = other.first_a = open.first_a + step.count;
      break;
    case FreedomStep::Kind::DivideB:
      if (step.count == 0 || step.count >= open.last_b - open.first_b) return false;
      one.last_b = other.first_b = open.first_b + step.count;
      break;
    default:
      return false;
  }
  stack.push_back(other);
  stack.push_back(one);
  return true;
}

bool is_proved(const FreedomCertificate& certificate, const Body& a, const Body& b) {
  const std::size_t size_a = a.mesh.triangles().size(), size_b = b.mesh.triangles().size();
  constexpr double kLargest = 0x1p400;  // in metres, likewise
  if (!(certificate.clearance >= 0 && certificate.clearance < kLargest)) return false;
  if (!(a.rounding < kLargest && b.rounding < kLargest)) return false;
  if (!is_permutation(a.order, size_a) || !is_permutation(b.order, size_b)) return false;
  std::vector<Open> stack{
      {0, 1, 0, static_cast<std::uint32_t>(size_a), 0, static_cast<std::uint32_t>(size_b)}};
  for (const FreedomStep& step : certificate.steps) {
    if (stack.empty()) return false;
    const Open open = stack.back();
    stack.pop_back();
    const bool is_sound = step.kind == FreedomStep::Kind::Plane
                              ? keeps_apart(a, b, open, step.normal, certificate.clearance)
                              : divide(stack, open, step);
    if (!is_sound) return false;
  }
  return stack.empty();
}

}  // namespace

bool proves_freedom(const FreedomCertificate& certificate, const MeshInMotion& mesh_a,
                    const MeshInMotion& mesh_b) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    return is_proved(certificate, Body(mesh_a.mesh, mesh_a.motion, certificate.order_a),
                     Body(mesh_b.mesh, mesh_b.motion, certificate.order_b));
  });
}

}  // namespace graze
