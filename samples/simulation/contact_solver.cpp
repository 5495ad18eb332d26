#include "samples/simulation/contact_solver.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace graze::samples {
namespace {

using Eigen::Vector3d;

const RigidBody* body_of(std::uint64_t index, std::span<const RigidBody> bodies) {
  return index < bodies.size() ? &bodies[index] : nullptr;
}

/// True if a body moves. Bodies that sleep stand like walls until they are woken.
bool moves(const RigidBody* body) {
  return body != nullptr && !body->is_asleep;
}

Vector3d velocity_at(const RigidBody* body, const Vector3d& arm) {
  return moves(body) ? Vector3d(body->velocity + body->spin.cross(arm)) : Vector3d::Zero();
}

Vector3d turned_by_inertia(const RigidBody& body, const Vector3d& moment) {
  return body.turn * (body.mass->inverse_inertia * (body.turn.conjugate() * moment));
}

/// Returns by how much an impulse of 1 along a direction at the arm speeds that point up along it.
double mobility(const RigidBody* body, const Vector3d& arm, const Vector3d& along) {
  if (!moves(body)) return 0;
  const Vector3d moment = arm.cross(along);
  return 1 / body->mass->mass + moment.dot(turned_by_inertia(*body, moment));
}

void push(RigidBody& body, const Vector3d& arm, const Vector3d& impulse) {
  body.velocity += impulse / body.mass->mass;
  body.spin += turned_by_inertia(body, arm.cross(impulse));
}

/// Says where a body's mesh is in its own frame, as seen in the world now and from its centre of
/// mass.
struct Place {
  explicit Place(const RigidBody* body)
      : at(body ? body->at : Vector3d::Zero()),
        turn(body ? body->turn : Eigen::Quaterniond::Identity()),
        centre(body ? body->mass->centre : Vector3d::Zero()) {}

  Vector3d arm(const Vector3d& anchor) const { return turn * (anchor - centre); }

  Vector3d at;
  Eigen::Quaterniond turn;
  Vector3d centre;
};

}  // namespace

void ContactSolver::take(const World& world, const WorldUpdate& update,
                         std::span<const RigidBody> bodies, std::vector<std::size_t>& woken) {
  for (const BodyPair& pair : update.ended) {
    const auto found = touches_.find(pair);
    if (found == touches_.end()) continue;
    double load = 0;
    for (const Point& point : found->second.points)
      load += point.impulse[0];
    for (const std::uint64_t index : {found->second.a, found->second.b}) {
      if (index >= bodies.size() || !bodies[index].is_asleep) continue;
      if (load >
          settings_.load_share * bodies[index].mass->mass * settings_.gravity * settings_.step) {
        woken.push_back(index);
      }
    }
    touches_.erase(found);
  }
  tracker_.take(world, update);
  std::vector<Point> before;  // the points of the pair
  for (std::size_t i = 0; i < update.contacts.size(); ++i) {
    const BodyContact& contact = update.contacts[i];
    const std::span<const std::uint64_t> ids = tracker_.ids(i);
    Touch& touch = touches_[contact.pair];
    touch.a = world.user_data(contact.pair.a);
    touch.b = world.user_data(contact.pair.b);
    touch.friction = std::sqrt(friction_of(touch.a, bodies) * friction_of(touch.b, bodies));
    // The contacts of a compound's parts stand one after the other.
    const auto is_of_pair = [&](std::size_t other) {
      return other < update.contacts.size() && update.contacts[other].pair == contact.pair;
    };
    if (i == 0 || !is_of_pair(i - 1)) before = std::exchange(touch.points, {});
    const Pose to_a = world.pose(contact.pair.a).inverse();
    const Pose to_b = world.pose(contact.pair.b).inverse();
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const ShapeContact& c = contact.manifold[k];
      Point point;
      point.id = ids[k];
      point.anchor_a = to_a * c.point;
      point.anchor_b = to_b * c.point;
      point.depth = c.depth;
      point.axis[0] = c.normal;
      point.axis[1] = c.normal.unitOrthogonal();
      point.axis[2] = c.normal.cross(point.axis[1]);
      const auto old = std::ranges::find(before, point.id, &Point::id);
      if (old != before.end()) {
        // Friction is kept as a vector: the axes across the normal turn where the normal does.
        const Vector3d across = old->impulse[1] * old->axis[1] + old->impulse[2] * old->axis[2];
        point.impulse[0] = old->impulse[0];
        for (int axis = 1; axis < 3; ++axis)
          point.impulse[axis] = across.dot(point.axis[axis]);
      }
      touch.points.push_back(point);
    }
    if (settings_.keeps_push && !before.empty() && !is_of_pair(i + 1))
      keep_push(world.pose(contact.pair.a), before, touch.points);
  }
}

// A body that leans a little more to one side touches a little more there: the deepest point of a
// round face moves by millimetres a step, and an impulse that moves with it turns the bodies. So
// the contacts start from impulses that differ the least from their own and push and turn as much
// as those of the step before did.
void ContactSolver::keep_push(const Pose& pose_a, const std::vector<Point>& before,
                              std::vector<Point>& points) {
  using Wrench = Eigen::Matrix<double, 6, 1>;  // a push, and its moment by a length
  const Vector3d middle = pose_a * before.front().anchor_a;
  double width = 0;
  for (const std::vector<Point>* each : {&before, &std::as_const(points)}) {
    for (const Point& point : *each)
      width = std::max(width, (pose_a * point.anchor_a - middle).norm());
  }
  if (width == 0) return;
  const auto wrench_of = [&](const Point& point) {
    Wrench wrench;
    wrench << point.axis[0], (pose_a * point.anchor_a - middle).cross(point.axis[0]) / width;
    return wrench;
  };
  Wrench lacking = Wrench::Zero();
  for (const Point& point : before)
    lacking += point.impulse[0] * wrench_of(point);
  // Directions of wrenches that are alike but for rounding have no inverse: a share of one keeps
  // what is asked along them small.
  constexpr double kAlike = 1e-6;
  Eigen::Matrix<double, 6, 6> squares = kAlike * Eigen::Matrix<double, 6, 6>::Identity();
  for (const Point& point : points) {
    const Wrench wrench = wrench_of(point);
    squares += wrench.lazyProduct(wrench.transpose());
    lacking -= point.impulse[0] * wrench;
  }
  const Wrench weights = squares.llt().solve(lacking);
  for (Point& point : points)
    point.impulse[0] = std::max(point.impulse[0] + wrench_of(point).dot(weights), 0.0);
}

double ContactSolver::friction_of(std::uint64_t index, std::span<const RigidBody> bodies) const {
  const RigidBody* body = body_of(index, bodies);
  return body ? body->friction : settings_.friction;
}

void ContactSolver::prepare(Touch& touch, std::span<const RigidBody> bodies) const {
  const RigidBody* a = body_of(touch.a, bodies);
  const RigidBody* b = body_of(touch.b, bodies);
  const Place place_a(a), place_b(b);
  for (Point& point : touch.points) {
    point.arm_a = place_a.arm(point.anchor_a);
    point.arm_b = place_b.arm(point.anchor_b);
    const Vector3d apart = (place_b.at + point.arm_b) - (place_a.at + point.arm_a);
    point.gap = point.axis[0].dot(apart) - point.depth;
    for (int k = 0; k < 3; ++k) {
      const double yields =
          mobility(a, point.arm_a, point.axis[k]) + mobility(b, point.arm_b, point.axis[k]);
      point.mass[k] = yields > 0 ? 1 / yields : 0;  // zero between two that nothing moves
    }
  }
}

void ContactSolver::apply(const Touch& touch, const Point& point, int axis, double impulse,
                          std::span<RigidBody> bodies) const {
  const Vector3d along = impulse * point.axis[axis];
  if (moves(body_of(touch.a, bodies))) push(bodies[touch.a], point.arm_a, -along);
  if (moves(body_of(touch.b, bodies))) push(bodies[touch.b], point.arm_b, along);
}

void ContactSolver::start_warm(Touch& touch, std::span<RigidBody> bodies) const {
  for (const Point& point : touch.points) {
    for (int k = 0; k < 3; ++k)
      apply(touch, point, k, point.impulse[k], bodies);
  }
}

ContactSolver::Softness ContactSolver::softness() const {
  if (settings_.hertz == 0) return {settings_.push_share / settings_.step, 1, 0};
  const double omega = 2 * std::numbers::pi * settings_.hertz;
  const double a1 = 2 * settings_.damping + settings_.step * omega;
  const double a2 = settings_.step * omega * a1;
  return {omega / a1, a2 / (1 + a2), 1 / (1 + a2)};
}

void ContactSolver::iterate(Touch& touch, std::span<RigidBody> bodies, bool is_pushing) const {
  const Softness soft = softness();
  const auto speed = [&](const Point& point, int k) {
    const Vector3d between = velocity_at(body_of(touch.b, bodies), point.arm_b) -
                             velocity_at(body_of(touch.a, bodies), point.arm_a);
    return between.dot(point.axis[k]);
  };
  const auto change = [&](Point& point, int k, double wanted) {
    const double by = wanted - point.impulse[k];
    point.impulse[k] = wanted;
    apply(touch, point, k, by, bodies);
  };
  for (Point& point : touch.points) {
    const double overlap = -point.gap - settings_.slop;
    double wanted_speed = std::min(-point.gap, 0.0) / settings_.step;  // the gap may close, no more
    double mass_share = 1, impulse_share = 0;
    if (is_pushing && overlap > 0) {
      wanted_speed = std::min(soft.rate * overlap, settings_.push_speed);
      mass_share = soft.mass_share, impulse_share = soft.impulse_share;
    }
    const double by = mass_share * point.mass[0] * (wanted_speed - speed(point, 0)) -
                      impulse_share * point.impulse[0];
    change(point, 0, std::max(point.impulse[0] + by, 0.0));
  }
  for (Point& point : touch.points) {
    double wanted[3];
    for (int k = 1; k < 3; ++k)
      wanted[k] = point.impulse[k] - point.mass[k] * speed(point, k);
    const double most = touch.friction * point.impulse[0];
    const double size = std::hypot(wanted[1], wanted[2]);
    for (int k = 1; k < 3; ++k)
      change(point, k, size > most ? wanted[k] * most / size : wanted[k]);
  }
}

void ContactSolver::solve(std::span<RigidBody> bodies, std::vector<std::size_t>& woken) {
  active_.clear();
  for (auto& [pair, touch] : touches_) {
    const RigidBody* a = body_of(touch.a, bodies);
    const RigidBody* b = body_of(touch.b, bodies);
    if (!moves(a) && !moves(b)) continue;
    active_.push_back(&touch);
    prepare(touch, bodies);
    if (moves(a) && moves(b)) continue;
    for (const Point& point : touch.points) {
      const double nearing =
          point.axis[0].dot(velocity_at(a, point.arm_a) - velocity_at(b, point.arm_b));
      if (nearing < settings_.wake_speed) continue;
      for (const std::uint64_t index : {touch.a, touch.b}) {
        if (index < bodies.size() && bodies[index].is_asleep) woken.push_back(index);
      }
    }
  }
  for (Touch* touch : active_)
    start_warm(*touch, bodies);
  for (int i = 0; i < settings_.iterations; ++i) {
    for (Touch* touch : active_)
      iterate(*touch, bodies, true);
  }
}

void ContactSolver::relax(std::span<RigidBody> bodies) {
  for (int i = 0; i < settings_.relaxations; ++i) {
    for (Touch* touch : active_)
      iterate(*touch, bodies, false);
  }
}

std::size_t ContactSolver::contact_count() const {
  std::size_t count = 0;
  for (const auto& [pair, touch] : touches_)
    count += touch.points.size();
  return count;
}

}  // namespace graze::samples
