#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tests/oracle/sampler.h>
#include <tests/oracle/shapes.h>

namespace graze::oracle {

/// What the exact answers of a category look like.
enum class Answers {
  Mixed,       ///< both answers, each for at least a twentieth of the elements
  Intersects,  ///< true for all, by construction
};

/// What a category makes of its coordinates when only floats are allowed.
enum class Range {
  Float,   ///< all coordinates are floats then
  Double,  ///< its coordinates are outside of the range of float: there is no such variant
};

/// A kind of hard input: a name and a recipe. Element `index` depends on nothing but the name, the
/// index and the grid, so that a failure can be made again from these three.
template <typename Element>
struct Category {
  const char* name;
  Element (*make)(Sampler& sampler);
  Answers answers = Answers::Mixed;
  Range range = Range::Float;
};

using PairCategory = Category<TrianglePair>;
using BoxCategory = Category<TriangleAndBox>;

/// A category on a grid: what the tests enumerate.
template <typename Element>
struct Corpus {
  Category<Element> category;
  Grid grid;

  std::string name() const;
  Element element(std::uint64_t index) const;
};

/// All of them, the float variants where there are any.
std::vector<Corpus<TrianglePair>> pair_corpora();
std::vector<Corpus<TriangleAndBox>> box_corpora();

/// The families, one for each file.
void add_random_pairs(std::vector<PairCategory>& categories);
void add_bisected_pairs(std::vector<PairCategory>& categories);
void add_near_coplanar_pairs(std::vector<PairCategory>& categories);
void add_coplanar_pairs(std::vector<PairCategory>& categories);
void add_shared_pairs(std::vector<PairCategory>& categories);
void add_touching_pairs(std::vector<PairCategory>& categories);
void add_thin_pairs(std::vector<PairCategory>& categories);
void add_degenerate_pairs(std::vector<PairCategory>& categories);
void add_lattice_pairs(std::vector<PairCategory>& categories);
void add_scale_pairs(std::vector<PairCategory>& categories);
void add_extreme_pairs(std::vector<PairCategory>& categories);

void add_random_boxes(std::vector<BoxCategory>& categories);
void add_bisected_boxes(std::vector<BoxCategory>& categories);
void add_touching_boxes(std::vector<BoxCategory>& categories);
void add_lattice_boxes(std::vector<BoxCategory>& categories);
void add_thin_boxes(std::vector<BoxCategory>& categories);
void add_scale_boxes(std::vector<BoxCategory>& categories);
void add_extreme_boxes(std::vector<BoxCategory>& categories);

}  // namespace graze::oracle
