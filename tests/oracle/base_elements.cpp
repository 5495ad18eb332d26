#include <tests/oracle/base_elements.h>
#include <tests/oracle/category.h>

namespace graze::oracle {
namespace {

template <typename Element>
Element any_of(const std::vector<Category<Element>>& categories, Sampler& sampler) {
  const int last = static_cast<int>(categories.size()) - 1;
  return categories[static_cast<std::size_t>(sampler.integer(0, last))].make(sampler);
}

}  // namespace

TrianglePair base_pair(Sampler& sampler) {
  static const std::vector<PairCategory> kCategories = [] {
    std::vector<PairCategory> categories;
    add_random_pairs(categories);
    add_near_coplanar_pairs(categories);
    add_coplanar_pairs(categories);
    add_shared_pairs(categories);
    add_touching_pairs(categories);
    add_thin_pairs(categories);
    add_degenerate_pairs(categories);
    add_lattice_pairs(categories);
    return categories;
  }();
  return any_of(kCategories, sampler);
}

TriangleAndBox base_box(Sampler& sampler) {
  static const std::vector<BoxCategory> kCategories = [] {
    std::vector<BoxCategory> categories;
    add_random_boxes(categories);
    add_touching_boxes(categories);
    add_lattice_boxes(categories);
    add_thin_boxes(categories);
    return categories;
  }();
  return any_of(kCategories, sampler);
}

}  // namespace graze::oracle
