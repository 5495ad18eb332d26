#include "tests/benchmark/world/movers.h"

#include <graze/engine/world/world.h>

#include "tests/benchmark/common/thread_clock.h"

namespace graze::benchmark {

std::vector<MoverTime> measure_movers(const Scene& scene, const std::vector<Frame>& path) {
  World world;
  world.add(scene.ground, Pose::Identity(), {.motion = Motion::Static});
  std::vector<std::shared_ptr<const BodyShape>> shapes;
  for (const Kind& kind : scene.kinds)
    shapes.push_back(share(kind.shape));
  std::vector<BodyId> ids;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    ids.push_back(world.add(shapes[scene.bodies[i]], path.front()[i]));
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

}  // namespace graze::benchmark
