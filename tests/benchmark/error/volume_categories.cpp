#include "tests/benchmark/error/volume_categories.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "tests/benchmark/error/baselines/volume_tests.h"
#include "tests/benchmark/error/categories.h"
#include "tests/benchmark/error/distances/rounded_distance.h"
#include "tests/narrowphase/volumes/obb_cases.h"
#include "tests/narrowphase/volumes/rational_boxes.h"

namespace graze::benchmark {
namespace {

/// B at about the distance at which the boxes come apart for the rounded test: off by 1e-17 to 0.1
/// of it, so that many are within rounding of a touch. Of kind Any, which is ordinary input,
/// anywhere.
ObbPair near_touch(Lie lie, RandomSource& random) {
  const ObbCase pair = random_case(lie, random);
  const double reach = 2 * pair.size();
  if (lie == Lie::Any) return {pair.a, pair.b_at(random.uniform(0, 0.5) * reach)};
  const Border border = find_border(0, reach, [&, a = to_plain<double>(pair.a)](double distance) {
    return fifteen_axes(a, to_plain<double>(pair.b_at(distance)), 0.0);
  });
  const double off = std::pow(10, random.uniform(-17, -1));
  return {pair.a, pair.b_at(border.hit * (random.integer(0, 1) == 0 ? 1 - off : 1 + off))};
}

}  // namespace

std::size_t obb_category_count() {
  return kLies;
}

Category<ObbPair> obb_category(std::size_t index, const Sizes& sizes) {
  const Lie lie = kEveryLie[index];
  std::string name = lie == Lie::Any ? "random" : name_of(lie);
  std::replace(name.begin(), name.end(), ' ', '_');
  Category<ObbPair> category{name, lie == Lie::Any, false, {}, {}, sizes.boxes};
  RandomSource random(index);
  for (std::size_t i = 0; i < sizes.boxes; ++i) {
    const ObbPair pair = near_touch(lie, random);
    category.elements.push_back(pair);
    category.truth.push_back(
        !oracle::separation(pair.a, pair.b, oracle::Reading::Image, oracle::Reading::Image)
             .is_apart);
  }
  return category;
}

std::size_t kdop_category_count() {
  return pair_category_count();
}

Category<KDopPair> kdop_category(std::size_t index, const Sizes& sizes) {
  Sizes fewer = sizes;
  fewer.elements = sizes.boxes;
  const Category<TrianglePair> pairs = pair_category(index, fewer);
  Category<KDopPair> category{pairs.name, pairs.is_generic, pairs.has_only_floats, {},
                              {},         pairs.refereed};
  for (std::size_t i = 0; i < pairs.elements.size(); ++i) {
    const TrianglePair& pair = pairs.elements[i];
    if (std::max(largest_coordinate(pair.a), largest_coordinate(pair.b)) > 0x1p1022) continue;
    category.elements.push_back({pair.a, pair.b});
    category.truth.push_back(pairs.truth[i]);
  }
  return category;
}

}  // namespace graze::benchmark
