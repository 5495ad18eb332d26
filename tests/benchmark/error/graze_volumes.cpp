#include <graze/bvh/fit/kdop_fit.h>
#include <graze/narrowphase/volumes/kdop_overlap.h>
#include <graze/narrowphase/volumes/obb_list.h>
#include <graze/narrowphase/volumes/obb_overlap.h>

#include <array>
#include <memory>
#include <vector>

#include "tests/benchmark/error/contest.h"
#include "tests/benchmark/error/graze_parts.h"

namespace graze::benchmark {
namespace {

KDop<18> around(const Triangle& t) {
  return bounding_kdop(std::array{t.a, t.b, t.c});
}

struct KDops {
  KDop<18> a;
  KDop<18> b;
};

Label conservative(const char* name) {
  return {name, Origin::Graze, "double", std::nullopt};
}

/// All pairs of a chunk in one call.
class ObbsInLists final : public Contestant<ObbPair> {
 public:
  ObbsInLists() : Contestant(conservative("graze, lists")) {}

  void prepare(std::span<const ObbPair> pairs) override {
    lists_.resize((pairs.size() + kChunk - 1) / kChunk);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      lists_[i / kChunk].a.add(pairs[i].a);
      lists_[i / kChunk].b.add(pairs[i].b);
    }
  }
  void release() override { lists_.clear(); }
  void warm(std::size_t first, std::size_t) const override {
    for (const ObbList* list : {&lists_[first / kChunk].a, &lists_[first / kChunk].b}) {
      double sum = 0;
      for (std::size_t i = 0; i < list->size(); ++i)
        sum += (*list)[i].half_extents.data()[0];  // which reads all of the box
      [[maybe_unused]] volatile double sink = sum;
    }
  }
  void answer(std::size_t first, std::span<Answer> answers) override {
    const Lists& lists = lists_[first / kChunk];
    intersects(lists.a, lists.b, as_hits(answers));
  }

 private:
  struct Lists {
    ObbList a;
    ObbList b;
  };
  std::vector<Lists> lists_;
};

}  // namespace

void add_graze_volumes(Field& field) {
  add(
      field.obb_pairs, conservative("graze"), [](const ObbPair& pair) { return pair; },
      [](const ObbPair& pair) { return intersects(pair.a, pair.b); });
  field.obb_pairs.push_back(std::make_unique<ObbsInLists>());
  add(
      field.kdop_pairs, conservative("graze"),
      [](const KDopPair& pair) {
        return KDops{around(pair.a), around(pair.b)};
      },
      [](const KDops& pair) { return intersects(pair.a, pair.b); });
}

}  // namespace graze::benchmark
