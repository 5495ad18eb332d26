// Results are values: they compare, hash and print.

#include <sstream>
#include <string>
#include <unordered_set>

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

namespace {

template <typename Value>
std::string text_of(const Value& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

}  // namespace

int main() {
  const graze::Mesh cube = examples::cube(1);
  const graze::TrianglePairs pairs = graze::find_triangle_pairs({cube}, {cube, at(0.5, 0.5, 0.5)});
  const graze::TrianglePairs again = graze::find_triangle_pairs({cube}, {cube, at(0.5, 0.5, 0.5)});
  expect(pairs == again, "the same question has the same answer");
  expect(pairs[0] < pairs[1], "pairs are ordered");

  const std::unordered_set<graze::TrianglePair> set(pairs.begin(), pairs.end());
  expect(set.size() == pairs.size() && set.contains(pairs[0]), "and hash");
  expect(graze::hash_of({1, 2}) != graze::hash_of({2, 1}), "as pairs of your own can");

  // For logs and failing tests: numbers in the fewest digits that give the same double.
  expect(!text_of(pairs).empty() && !text_of(pairs[0]).empty(), "lists and their elements");
  expect(text_of(graze::Sphere{{0, 0, 0}, 0.1}).find("0.1") != std::string::npos, "0.1 is 0.1");
  expect(!text_of(graze::distance({cube}, {cube, at(3, 0, 0)})).empty(), "results with all parts");
  expect(text_of(graze::Shape(graze::Capsule{0.1, 2})) == "capsule of radius 0.1 and half length 2",
         "shapes");
  expect(text_of(graze::RigidStatus::Free) == "free", "and names of enumerators");

  graze::Work work;
  graze::intersects({cube}, {cube, at(3, 0, 0)}, &work);
  graze::Work sum = work;
  sum += work;
  expect(sum.volume_tests == 2 * work.volume_tests, "counters add up");

  const std::string version = std::to_string(graze::kVersionMajor) + "." +
                              std::to_string(graze::kVersionMinor) + "." +
                              std::to_string(graze::kVersionPatch);
  expect(graze::library_version() == version, "the library is of the version of its headers");
}
