#include <graze/narrowphase/triangle_triangle.h>

#include <tests/benchmark/triangles/guigue_devillers.h>
#include <tests/benchmark/triangles/one_by_one.h>
#include <tests/benchmark/triangles/pair_contestants.h>

namespace graze::benchmark {
namespace {

using oracle::TrianglePair;
using PairContestant = Contestant<TrianglePair>;

template <typename Answer>
std::unique_ptr<PairContestant> one_by_one(const char* name, Answer answer) {
  return std::make_unique<OneByOne<TrianglePair, Answer>>(name, answer);
}

}  // namespace

std::vector<std::unique_ptr<PairContestant>> pair_contestants() {
  std::vector<std::unique_ptr<PairContestant>> all;
  all.push_back(one_by_one("Guigue-Devillers, plain double", [](const TrianglePair& pair) {
    return guigue_devillers(pair.a, pair.b);
  }));
  all.push_back(
      one_by_one("graze", [](const TrianglePair& pair) { return intersects(pair.a, pair.b); }));
  all.push_back(one_by_one("graze, exact stage alone", [](const TrianglePair& pair) {
    return narrowphase::intersects_exactly(pair.a, pair.b);
  }));
  return all;
}

Truth truth_of(const std::vector<TrianglePair>& pairs) {
  Truth truth;
  for (const TrianglePair& pair : pairs) {
    truth.hits.push_back(narrowphase::intersects_exactly(pair.a, pair.b));
    truth.exact += narrowphase::decide(pair.a, pair.b).stage == narrowphase::Stage::Exact;
  }
  return truth;
}

}  // namespace graze::benchmark
