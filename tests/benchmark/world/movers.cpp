#include "tests/benchmark/world/movers.h"

#include <graze/engine/world/world.h>

#include <cmath>
#include <random>
#include <utility>

#include "tests/benchmark/common/thread_clock.h"

namespace graze::benchmark {

std::vector<MoverTime> measure_movers(const Scene& scene, const std::vector<Frame>& path) {
  World world;
  world.add({scene.ground, Pose::Identity()}, {.kind = BodyKind::Static});
  std::vector<std::shared_ptr<const BodyShape>> shapes;
  for (const Kind& kind : scene.kinds)
    shapes.push_back(share(kind.shape));
  std::vector<BodyId> ids;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    ids.push_back(world.add({shapes[scene.bodies[i]], path.front()[i]}));
  world.update();
  std::vector<MoverTime> times;
  for (std::size_t movers = 0; movers <= ids.size(); movers = movers == 0 ? 1 : 10 * movers) {
    std::vector<double> steps;
    for (std::size_t repetition = 0; repetition < 3 * path.size(); ++repetition) {
      const Frame& frame = path[repetition % path.size()];
      const ThreadClock clock;
      // Spread over the scene, so that movers are not each other's neighbours.
      for (std::size_t i = 0; i < movers; ++i) {
        const std::size_t body = i * ids.size() / movers;
        world.move(ids[body], frame[body]);
      }
      world.update();
      steps.push_back(clock.nanoseconds() * 1e-3);
    }
    times.push_back({movers, median(steps)});
  }
  return times;
}

namespace {

/// Bodies about the points of a lattice, each at a place of its own that it leaves and comes back
/// to.
class Crowd {
 public:
  explicit Crowd(std::size_t bodies)
      : side_(static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(bodies))))) {
    const std::shared_ptr<const BodyShape> shapes[] = {share(Sphere{Eigen::Vector3d::Zero(), 0.5}),
                                                       share(Box{{0.4, 0.3, 0.5}})};
    for (std::size_t i = 0; i < bodies; ++i)
      ids_.push_back(world_.add({shapes[i % 2], somewhere(i)}));
    world_.update();
  }

  std::size_t size() const { return ids_.size(); }

  void step(const std::vector<std::size_t>& movers, const std::vector<Pose>& poses) {
    for (std::size_t i = 0; i < movers.size(); ++i)
      world_.move(ids_[movers[i]], poses[i]);
    tests_ += static_cast<double>(world_.update().work.shape_tests);
  }

  std::size_t anyone() { return random_() % ids_.size(); }

  Pose somewhere(std::size_t body) {
    Pose pose = Pose::Identity();
    const std::size_t place[] = {body % side_, body / side_ % side_, body / side_ / side_};
    for (int k = 0; k < 3; ++k) {
      const double jitter = static_cast<double>(random_() % 1001) * 1e-3 - 0.5;
      pose.translation()[k] = kSpacing * (static_cast<double>(place[k]) + 0.2 * jitter);
    }
    return pose;
  }

  double take_tests() { return std::exchange(tests_, 0); }

 private:
  static constexpr double kSpacing = 1;

  World world_;
  std::size_t side_;
  std::mt19937_64 random_{7};
  std::vector<BodyId> ids_;
  double tests_ = 0;
};

}  // namespace

std::vector<CrowdTime> measure_crowd(std::size_t bodies, const std::vector<std::size_t>& movers,
                                     std::size_t steps) {
  Crowd crowd(bodies);
  std::vector<CrowdTime> times;
  for (const std::size_t count : movers) {
    if (count > crowd.size()) continue;
    std::vector<double> each;
    crowd.take_tests();
    for (std::size_t step = 0; step < steps; ++step) {
      std::vector<std::size_t> who;
      std::vector<Pose> poses;
      for (std::size_t i = 0; i < count; ++i) {
        who.push_back(crowd.anyone());
        poses.push_back(crowd.somewhere(who.back()));
      }
      const ThreadClock clock;
      crowd.step(who, poses);
      each.push_back(clock.nanoseconds() * 1e-3);
    }
    times.push_back({count, median(each), crowd.take_tests() / static_cast<double>(steps)});
  }
  return times;
}

}  // namespace graze::benchmark
