// One volume against many, and many pairs at once, on whatever SIMD the machine has.

#include "samples/examples/example.h"

using examples::expect;

namespace {

using Hits = std::vector<std::uint8_t>;

graze::Aabb box_at(double x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

}  // namespace

int main() {
  graze::AabbList boxes;
  graze::ObbList turned;
  graze::KDopList kdops;
  for (double x = 0; x < 4; ++x) {
    const graze::Aabb box = box_at(x);
    boxes.add(box);
    turned.add({examples::at(x + 0.5, 0.5, 0.5), {0.5, 0.5, 0.5}});
    kdops.add(graze::bounding_kdop(std::array{box.min, box.max}));
  }
  expect(boxes.size() == 4 && boxes[2] == box_at(2), "lists of volumes");
  expect(turned.size() == 4 && kdops.size() == 4, "the others likewise");

  // hits[i] is what intersects() says of element i alone.
  Hits hits(4);
  graze::intersects(box_at(1), boxes, hits);
  expect(hits == Hits{1, 1, 1, 0}, "one box against many");
  graze::intersects(boxes, boxes, hits);
  expect(hits == Hits{1, 1, 1, 1}, "pairs: each box and itself");
  graze::intersects(turned[3], turned, hits);
  expect(hits[0] == 0 && hits[3] == 1, "oriented boxes");
  graze::intersects(kdops[0], kdops, hits);
  expect(hits[0] == 1 && hits[3] == 0, "and k-DOPs");

  // Spheres in arrays of the caller's.
  const std::vector<double> x{0, 2, 4, 6};
  const std::vector<double> zeros(4, 0.0);
  const std::vector<double> radius(4, 0.5);
  const graze::SphereArray balls{x, zeros, zeros, radius};
  graze::intersects(graze::Sphere{{1, 0, 0}, 0.5}, balls, hits);
  expect(hits == Hits{1, 1, 0, 0}, "one ball against many");
  graze::intersects(balls, boxes.view(), hits);
  expect(hits[0] == 1 && hits[3] == 0, "and balls against boxes, pair by pair");

  boxes.clear();
  expect(boxes.size() == 0, "a list to be filled again");
}
