// A broad phase alone: which of many moving boxes overlap, exactly, and which pairs began and
// ended.

#include "samples/examples/example.h"

using examples::expect;

namespace {

graze::Aabb box_at(double x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

}  // namespace

int main() {
  graze::BroadPhase boxes({.threads = 1});
  const graze::BoxId left = boxes.add(box_at(0));
  const graze::BoxId right = boxes.add(box_at(1));  // touches the left one
  const graze::BoxId far = boxes.add(box_at(9));
  boxes.update();
  expect(boxes.pairs().size() == 1 && boxes.begun().size() == 1, "touching counts");

  // Lists are in ascending order, or as they come, which costs less.
  boxes.move(far, box_at(2));
  boxes.update();
  expect(boxes.sorted_pairs()[1] == graze::BoxPair{right.index, far.index}, "a second pair");
  boxes.move(std::vector{left, right}, std::vector{box_at(-9), box_at(2.5)});
  boxes.update();
  expect(boxes.ended().size() == 1 && boxes.begun().empty(), "one pair has ended, none has begun");

  // Queries see changes at once.
  boxes.move(left, box_at(20));
  std::vector<std::uint32_t> found;
  boxes.find_overlapping(box_at(20.5), found);
  expect(found == std::vector{left.index}, "what shares a point with a box");
  std::vector<std::uint32_t> met;
  boxes.visit_along({{-1, 0.5, 0.5}, {1, 0, 0}}, [&](std::uint32_t index) {
    met.push_back(index);
    return 100.0;  // nothing further away than that is of interest
  });
  expect(met.size() == 3, "a ray along x meets all three");

  expect(boxes.box(left) == box_at(20) && boxes.id(left.index) == left,
         "where a box is, and its id");
  boxes.remove(left);
  expect(!boxes.contains(left) && boxes.size() == 2, "it is gone");

  expect(boxes.work().updates == 3, "what updates did");
  expect(boxes.bytes_for_boxes() > 0 && boxes.bytes_for_pairs() > 0, "and what memory it takes");
}
