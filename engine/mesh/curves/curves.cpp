#include <graze/engine/mesh/curves/curves.h>

#include <algorithm>
#include <utility>

namespace graze::contacts {
namespace {

/// The segments of curves that meet at each node, neighbours ascending.
class Star {
 public:
  explicit Star(const CellComplex& complex)
      : at_(complex.nodes.size()), is_stop_(corners_of_polygons(complex)) {
    const std::vector<bool> is_edge = edges_of_polygons(complex);
    for (std::uint32_t i = 0; i < complex.segments.size(); ++i) {
      if (is_edge[i]) continue;
      const Cell& cell = complex.segments[i];
      at_[cell.corner[0]].push_back({i, cell.corner[0], cell.corner[1]});
      at_[cell.corner[1]].push_back({i, cell.corner[1], cell.corner[0]});
    }
    for (std::vector<CurveStep>& steps : at_) {
      std::sort(steps.begin(), steps.end(),
                [](const CurveStep& s, const CurveStep& t) { return s.to < t.to; });
    }
    for (std::size_t node = 0; node < at_.size(); ++node)
      is_stop_[node] = is_stop_[node] || at_[node].size() != 2;
  }

  const std::vector<CurveStep>& at(std::uint32_t node) const { return at_[node]; }
  bool is_stop(std::uint32_t node) const { return is_stop_[node]; }

  /// Returns the step that goes on after this one, at a node that is no stop.
  const CurveStep& after(const CurveStep& step) const {
    const std::vector<CurveStep>& steps = at_[step.to];
    return steps[0].segment == step.segment ? steps[1] : steps[0];
  }

 private:
  std::vector<std::vector<CurveStep>> at_;
  std::vector<bool> is_stop_;
};

}  // namespace

std::vector<bool> corners_of_polygons(const CellComplex& complex) {
  std::vector<bool> is_corner(complex.nodes.size());
  for (const Cell& polygon : complex.polygons) {
    for (std::uint32_t i = 0; i < polygon.count; ++i)
      is_corner[polygon.corner[i]] = true;
  }
  return is_corner;
}

std::vector<bool> edges_of_polygons(const CellComplex& complex) {
  using Ends = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Ends> edges;
  for (const Cell& polygon : complex.polygons) {
    for (std::uint32_t i = 0; i < polygon.count; ++i)
      edges.push_back(std::minmax(polygon.corner[i], polygon.corner[(i + 1) % polygon.count]));
  }
  std::sort(edges.begin(), edges.end());
  std::vector<bool> is_edge;
  for (const Cell& segment : complex.segments) {
    is_edge.push_back(
        std::binary_search(edges.begin(), edges.end(), Ends{segment.corner[0], segment.corner[1]}));
  }
  return is_edge;
}

std::vector<CurveSteps> chain_curves(const CellComplex& complex) {
  const Star star(complex);
  std::vector<bool> is_chained(complex.segments.size());
  std::vector<CurveSteps> curves;
  const auto follow = [&](const CurveStep& first) {
    if (is_chained[first.segment]) return;
    CurveSteps curve = {first};
    is_chained[first.segment] = true;
    while (!star.is_stop(curve.back().to) && curve.back().to != first.from) {
      curve.push_back(star.after(curve.back()));
      is_chained[curve.back().segment] = true;
    }
    curves.push_back(std::move(curve));
  };
  // Curves from stops are chained first: what is left then has no ends.
  for (const bool is_from_stops : {true, false}) {
    for (std::uint32_t node = 0; node < complex.nodes.size(); ++node) {
      if (star.is_stop(node) != is_from_stops) continue;
      for (const CurveStep& step : star.at(node))
        follow(step);
    }
  }
  std::sort(curves.begin(), curves.end(), [](const CurveSteps& s, const CurveSteps& t) {
    return std::lexicographical_compare(s.begin(), s.end(), t.begin(), t.end(),
                                        [](const CurveStep& u, const CurveStep& v) {
                                          return std::pair(u.from, u.to) < std::pair(v.from, v.to);
                                        });
  });
  return curves;
}

}  // namespace graze::contacts
