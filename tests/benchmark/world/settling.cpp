#include "tests/benchmark/world/settling.h"

#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/world/world.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>

#include "samples/simulation/contact_solver.h"

namespace graze::benchmark {
namespace {

using Eigen::Vector3d;
using samples::ContactSolver;
using samples::RigidBody;

constexpr double kTimeToSleep = 0.1;  // seconds

class Settling {
 public:
  explicit Settling(const Scene& scene) : scene_(scene), solver_(settings_) {
    world_.add({scene.ground, Pose::Identity()},
               {.kind = BodyKind::Static, .user_data = ContactSolver::kFixed});
    for (const Kind& kind : scene.kinds) {
      shapes_.push_back(share(kind.shape));
      bounding_radius_ = std::max(bounding_radius_, kind.bounding_radius);
    }
    bodies_.reserve(scene.bodies.size());
  }

  void pour_all() {
    while (bodies_.size() < scene_.bodies.size()) {
      pour_layer();
      run(2 * std::sqrt(2 * 2 * bounding_radius_ / settings_.gravity));
      std::fprintf(stderr, "\r%s: %zu of %zu poured ", scene_.name.c_str(), bodies_.size(),
                   scene_.bodies.size());
    }
    run(scene_.seconds);
    std::fprintf(stderr, "\n");
  }

  std::vector<Frame> record(std::size_t count) {
    may_sleep_ = false;
    for (RigidBody& body : bodies_)
      body.is_asleep = false;
    std::vector<Frame> frames;
    for (std::size_t i = 0; i < count; ++i) {
      step();
      Frame& frame = frames.emplace_back();
      for (const RigidBody& body : bodies_)
        frame.push_back(body.pose());
    }
    return frames;
  }

 private:
  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }

  /// On rings of a disc above all that has been poured, turned at random.
  void pour_layer() {
    double top = 0;
    const bool is_first = bodies_.empty();
    for (const RigidBody& body : bodies_)
      top = std::max(top, body.at.z());
    const std::size_t end = std::min(bodies_.size() + scene_.layer, scene_.bodies.size());
    const double golden = 2.399963229728653;  // radians: a spiral that fills the disc evenly
    for (std::size_t i = 0; bodies_.size() < end; ++i) {
      const double radius = scene_.radius * std::sqrt((static_cast<double>(i) + 0.5) /
                                                      static_cast<double>(scene_.layer));
      const double angle = golden * static_cast<double>(i);
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      const double below = is_first ? ground_at(x, y) : top;
      add({x, y, below + 2.2 * bounding_radius_});
    }
  }

  double ground_at(double x, double y) const {
    const double high = scene_.ground.bounds().max.z() + bounding_radius_;
    const auto hit = graze::cast_ray(PlacedMeshView{scene_.ground}, Ray{{x, y, high}, {0, 0, -1}});
    return hit ? high - hit->distance : 0;
  }

  void add(const Vector3d& at) {
    const std::size_t index = scene_.bodies[bodies_.size()];
    const Kind& kind = scene_.kinds[index];
    Eigen::Quaterniond turn(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1));
    turn.normalize();
    RigidBody body{.id = {},
                   .mass = &kind.mass,
                   .at = at,
                   .turn = turn,
                   .bounding_radius = kind.bounding_radius};
    body.id = world_.add({shapes_[index], body.pose()}, {.user_data = bodies_.size()});
    bodies_.push_back(body);
  }

  void run(double seconds) {
    for (double time = 0; time < seconds; time += settings_.step)
      step();
  }

  void step() {
    const WorldUpdate update = world_.update();
    woken_.clear();
    solver_.take(world_, update, bodies_, woken_);
    for (RigidBody& body : bodies_) {
      if (!body.is_asleep) body.velocity.z() -= settings_.gravity * settings_.step;
    }
    solver_.solve(bodies_, woken_);
    for (RigidBody& body : bodies_) {
      if (!body.is_asleep) advance(body);
    }
    solver_.relax(bodies_);
    for (RigidBody& body : bodies_) {
      if (!body.is_asleep) tell_world(body);
    }
    for (const std::size_t i : woken_) {
      bodies_[i].is_asleep = false, bodies_[i].stillness = 0;
      world_.wake(bodies_[i].id);
    }
  }

  void advance(RigidBody& body) const {
    body.spin *= 1 / (1 + 4 * settings_.step);  // what rolling costs
    body.at += settings_.step * body.velocity;
    const Eigen::Quaterniond rate(0, body.spin.x(), body.spin.y(), body.spin.z());
    body.turn.coeffs() += 0.5 * settings_.step * (rate * body.turn).coeffs();
    body.turn.normalize();
  }

  void tell_world(RigidBody& body) {
    world_.move(body.id, body.pose());
    const double speed = body.velocity.norm() + body.spin.norm() * body.bounding_radius;
    body.stillness = speed < 3 * body.bounding_radius ? body.stillness + settings_.step : 0;
    if (!may_sleep_ || body.stillness < kTimeToSleep) return;
    body.is_asleep = true;
    body.velocity = body.spin = Vector3d::Zero();
    world_.sleep(body.id);
  }

  const Scene& scene_;
  samples::SolverSettings settings_;
  ContactSolver solver_;
  World world_;
  std::vector<std::shared_ptr<const BodyShape>> shapes_;
  std::vector<RigidBody> bodies_;
  std::vector<std::size_t> woken_;
  std::mt19937_64 random_{2};
  double bounding_radius_ = 0;  // the largest
  bool may_sleep_ = true;
};

}  // namespace

std::vector<Frame> settle(const Scene& scene, std::size_t frames) {
  Settling settling(scene);
  settling.pour_all();
  return settling.record(frames);
}

std::vector<Frame> settle_once(const Scene& scene, std::size_t frames, const std::string& file) {
  constexpr std::streamsize kPoseBytes = 12 * sizeof(double);
  std::vector<Frame> path(frames, Frame(scene.bodies.size(), Pose::Identity()));
  const auto for_each = [&](auto&& exchange) {
    for (Frame& frame : path) {
      for (Pose& pose : frame) {
        double rows[12];
        exchange(pose, rows);
      }
    }
  };
  if (std::ifstream in(file, std::ios::binary); !file.empty() && in) {
    for_each([&](Pose& pose, double(&rows)[12]) {
      in.read(reinterpret_cast<char*>(rows), kPoseBytes);
      for (int i = 0; i < 12; ++i)
        pose.matrix()(i % 3, i / 3) = rows[i];
    });
    if (in) return path;
  }
  path = settle(scene, frames);
  if (file.empty()) return path;
  std::ofstream out(file, std::ios::binary);
  for_each([&](const Pose& pose, double(&rows)[12]) {
    for (int i = 0; i < 12; ++i)
      rows[i] = pose.matrix()(i % 3, i / 3);
    out.write(reinterpret_cast<const char*>(rows), kPoseBytes);
  });
  return path;
}

}  // namespace graze::benchmark
