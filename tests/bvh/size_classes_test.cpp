// Which classes of sizes share a tree: fewer trees where boxes lie far apart, none that a floor
// would stretch. A guess at costs, so that the cases are clear ones.

#include <graze/bvh/box_set/order/size_classes.h>
#include <gtest/gtest.h>

#include <limits>

namespace graze::bvh {
namespace {

/// A lattice of `side` cubed points a metre apart.
std::vector<KdItem> lattice(std::uint32_t side) {
  std::vector<KdItem> items;
  for (std::uint32_t i = 0; i < side * side * side; ++i) {
    items.push_back({{static_cast<float>(i % side), static_cast<float>(i / side % side),
                      static_cast<float>(i / side / side)},
                     i});
  }
  return items;
}

std::vector<std::size_t> groups(const std::vector<SizeClass>& classes) {
  std::vector<KdItem> sample = lattice(8);
  return share_layers(classes, sample);
}

using Numbers = std::vector<std::size_t>;

TEST(SizeGroups, ShareATreeWhereBoxesAreSmallerThanTheSpaceBetweenThem) {
  EXPECT_EQ(groups({{0.001, 100}, {0.004, 200}, {0.016, 100}, {0.0625, 112}}),
            Numbers({0, 0, 0, 0}));
}

TEST(SizeGroups, KeepAFloorApart) {
  EXPECT_EQ(groups({{0.25, 511}, {100, 1}}), Numbers({0, 1}));
  EXPECT_EQ(groups({{0.25, 511}, {std::numeric_limits<double>::infinity(), 1}}), Numbers({0, 1}));
  EXPECT_EQ(groups({{0.004, 255}, {0.016, 256}, {100, 1}}), Numbers({0, 0, 1}));
}

TEST(SizeGroups, KeepApartWhatOverlapsMuch) {
  EXPECT_EQ(groups({{1, 256}, {4, 128}, {16, 128}}), Numbers({0, 1, 2}));
}

TEST(SizeGroups, KeepApartWhatHasNoVolume) {
  std::vector<KdItem> sample(64);
  EXPECT_EQ(share_layers(std::vector<SizeClass>{{1, 32}, {4, 32}}, sample), Numbers({0, 1}));
  EXPECT_EQ(share_layers(std::vector<SizeClass>{{1, 32}, {4, 32}}, {}), Numbers({0, 1}));
  EXPECT_EQ(share_layers(std::vector<SizeClass>{{1, 32}}, sample), Numbers({0}));
  EXPECT_EQ(share_layers({}, {}), Numbers());
}

}  // namespace
}  // namespace graze::bvh
