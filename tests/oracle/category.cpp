#include <tests/oracle/category.h>

namespace graze::oracle {
namespace {

Eigen::Vector3d on_grid(const Eigen::Vector3d& p, Grid grid) {
  return {oracle::on_grid(p.x(), grid), oracle::on_grid(p.y(), grid), oracle::on_grid(p.z(), grid)};
}

Triangle on_grid(const Triangle& t, Grid grid) {
  return for_each_vertex(t, [&](const Eigen::Vector3d& p) { return on_grid(p, grid); });
}

TrianglePair on_grid(const TrianglePair& pair, Grid grid) {
  return {on_grid(pair.a, grid), on_grid(pair.b, grid)};
}

// Rounding to the nearest is monotone: min stays below max.
TriangleAndBox on_grid(const TriangleAndBox& pair, Grid grid) {
  return {on_grid(pair.triangle, grid), {on_grid(pair.box.min, grid), on_grid(pair.box.max, grid)}};
}

template <typename Element>
std::vector<Corpus<Element>> on_both_grids(const std::vector<Category<Element>>& categories) {
  std::vector<Corpus<Element>> corpora;
  for (const Category<Element>& category : categories) {
    corpora.push_back({category, Grid::Double});
    if (category.range == Range::Float) corpora.push_back({category, Grid::Float});
  }
  return corpora;
}

}  // namespace

template <typename Element>
std::string Corpus<Element>::name() const {
  return std::string(category.name) + (grid == Grid::Float ? "_float" : "");
}

template <typename Element>
Element Corpus<Element>::element(std::uint64_t index) const {
  Sampler sampler(category.name, index, grid);
  return on_grid(category.make(sampler), grid);
}

template struct Corpus<TrianglePair>;
template struct Corpus<TriangleAndBox>;

std::vector<Corpus<TrianglePair>> pair_corpora() {
  std::vector<PairCategory> categories;
  add_random_pairs(categories);
  add_bisected_pairs(categories);
  add_near_coplanar_pairs(categories);
  add_coplanar_pairs(categories);
  add_shared_pairs(categories);
  add_touching_pairs(categories);
  add_thin_pairs(categories);
  add_degenerate_pairs(categories);
  add_lattice_pairs(categories);
  add_scale_pairs(categories);
  add_extreme_pairs(categories);
  return on_both_grids(categories);
}

std::vector<Corpus<TriangleAndBox>> box_corpora() {
  std::vector<BoxCategory> categories;
  add_random_boxes(categories);
  add_bisected_boxes(categories);
  add_touching_boxes(categories);
  add_lattice_boxes(categories);
  add_thin_boxes(categories);
  add_scale_boxes(categories);
  add_extreme_boxes(categories);
  return on_both_grids(categories);
}

}  // namespace graze::oracle
