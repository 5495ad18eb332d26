#include "tests/benchmark/motion/measure.h"

#include <graze/bvh/error.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair_memory.h>

#include <optional>

#include "tests/benchmark/common/thread_clock.h"

namespace graze::benchmark {
namespace {

/// The answer to any of the questions.
struct Answer {
  bool is_yes = false;
  std::vector<TrianglePair> pairs;
  std::optional<MeshDistance> distance;

  bool operator==(const Answer& other) const {
    if (distance.has_value() != other.distance.has_value()) return false;
    const bool is_same_distance = !distance || (distance->distance == other.distance->distance &&
                                                distance->pair == other.distance->pair &&
                                                distance->point_a == other.distance->point_a &&
                                                distance->point_b == other.distance->point_b);
    return is_same_distance && is_yes == other.is_yes && pairs == other.pairs;
  }
};

class Asker {
 public:
  Asker(const Scene& scene, Question question, double clearance)
      : scene_(scene), question_(question), clearance_(clearance) {}

  Answer cold(const Pose& pose, Work* work = nullptr) const {
    const PlacedMeshView a{scene_.mesh_a};
    const PlacedMeshView b{scene_.mesh_b, pose};
    Answer answer;
    switch (question_) {
      case Question::Any:
        answer.is_yes = intersects(a, b, work);
        break;
      case Question::Pairs:
        answer.pairs = find_triangle_pairs(a, b, {}, work).pairs;
        break;
      case Question::Distance:
        answer.distance = distance(a, b, {}, work);
        break;
      case Question::Within:
        answer.is_yes = within(a, b, clearance_, {}, work);
        break;
    }
    return answer;
  }

  Answer remembering(const Pose& pose, PairMemory& memory, Work* work = nullptr) const {
    const PlacedMeshView a{scene_.mesh_a};
    const PlacedMeshView b{scene_.mesh_b, pose};
    Answer answer;
    switch (question_) {
      case Question::Any:
        answer.is_yes = intersects(a, b, memory, {}, work);
        break;
      case Question::Pairs:
        answer.pairs = find_triangle_pairs(a, b, memory, {}, work).pairs;
        break;
      case Question::Distance:
        answer.distance = distance(a, b, memory, {}, work);
        break;
      case Question::Within:
        answer.is_yes = within(a, b, clearance_, memory, {}, work);
        break;
    }
    return answer;
  }

  const Scene& scene() const { return scene_; }
  Question question() const { return question_; }
  double clearance() const { return clearance_; }

 private:
  const Scene& scene_;
  Question question_;
  double clearance_;
};

/// What is left of an answer when only its time matters.
double cold_value(const Asker& asker, const Pose& pose) {
  const PlacedMeshView a{asker.scene().mesh_a};
  const PlacedMeshView b{asker.scene().mesh_b, pose};
  switch (asker.question()) {
    case Question::Any:
      return intersects(a, b);
    case Question::Pairs:
      return static_cast<double>(find_triangle_pairs(a, b).size());
    case Question::Distance:
      return distance(a, b).distance;
    case Question::Within:
      return within(a, b, asker.clearance());
  }
  throw InputError("there is no such question");
}

double remembering_value(const Asker& asker, const Pose& pose, PairMemory& memory) {
  const PlacedMeshView a{asker.scene().mesh_a};
  const PlacedMeshView b{asker.scene().mesh_b, pose};
  switch (asker.question()) {
    case Question::Any:
      return intersects(a, b, memory);
    case Question::Pairs:
      return static_cast<double>(find_triangle_pairs(a, b, memory).size());
    case Question::Distance:
      return distance(a, b, memory).distance;
    case Question::Within:
      return within(a, b, asker.clearance(), memory);
  }
  throw InputError("there is no such question");
}

/// Microseconds of a run, the mean of as many as make the clock count for little.
template <typename Run>
double microseconds_of(const Run& run) {
  constexpr double kEnough = 100;
  for (int runs = 1;; runs *= 4) {
    const ThreadClock clock;
    for (int i = 0; i < runs; ++i)
      run();
    const double time = clock.nanoseconds() / 1000;
    if (time >= kEnough) return time / runs;
  }
}

PathTimes times_on(const Asker& asker, const Path& path, int repetitions) {
  volatile double sum = 0;
  std::vector<double> cold;
  std::vector<double> remembering;
  for (int i = 0; i < repetitions; ++i) {
    cold.push_back(microseconds_of([&] {
      for (const Pose& pose : path)
        sum = sum + cold_value(asker, pose);
    }));
    remembering.push_back(microseconds_of([&] {
      PairMemory memory;
      for (const Pose& pose : path)
        sum = sum + remembering_value(asker, pose, memory);
    }));
  }
  const auto queries = static_cast<double>(path.size());
  return {path.size(), median(cold) / queries, median(remembering) / queries};
}

}  // namespace

const char* name_of(Question question) {
  switch (question) {
    case Question::Any:
      return "any";
    case Question::Pairs:
      return "pairs";
    case Question::Distance:
      return "distance";
    case Question::Within:
      return "within";
  }
  throw InputError("there is no such question");
}

MotionResult measure_motion(const Scene& scene, const std::vector<Path>& paths, Question question,
                            const MotionSettings& settings) {
  const Asker asker(scene, question, settings.clearance * scene.size());
  MotionResult result{question, 0, 0, {}, {}, {}};
  for (const Path& path : paths) {
    // What builds the trees and compares answers also warms the caches.
    PairMemory memory;
    for (const Pose& pose : path) {
      const Answer expected = asker.cold(pose, &result.cold);
      result.wrong += !(asker.remembering(pose, memory, &result.remembering) == expected);
    }
    result.queries += path.size();
    result.paths.push_back(times_on(asker, path, settings.repetitions));
  }
  return result;
}

}  // namespace graze::benchmark
