#include <graze/narrowphase/convex/core/contact_faces.h>
#include <graze/narrowphase/predicates/predicates.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace graze::narrowphase {
namespace {

using Index = std::uint32_t;

// Facets that lean further than this from a face do not belong to it, however small they are.
constexpr double kOneFace = 0.99;

/// Returns twice the area, in units in which nothing overflows.
double area_of(const Hull& hull, const Hull::Face& face) {
  const auto at = [&](Index i) {
    return hull.corners[hull.loops[face.first + i]] * (1 / hull.bounding_radius);
  };
  double area = 0;
  for (Index i = 2; i < face.count; ++i)
    area += length(cross(at(i - 1) - at(0), at(i) - at(0)));
  return area;
}

/// Returns the axis along which a normal points most.
int steepest_axis(const Vec3& normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  if (z >= x && z >= y) return 2;
  return y >= x ? 1 : 0;
}

/// Returns the corners of the convex polygon around those given, as seen along the axis:
/// counter-clockwise if the axis comes towards the eye. They are found by Andrew's chains.
std::vector<Index> outline(const Hull& hull, std::vector<Index> inside, int axis) {
  const auto seen = [&](Index i) { return project(&hull.corners[i].x, axis); };
  std::sort(inside.begin(), inside.end(), [&](Index i, Index j) {
    const Point2 a = seen(i), b = seen(j);
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : i < j;
  });
  std::vector<Index> loop;
  const auto chain = [&](auto begin, auto end) {
    const std::size_t first = loop.size();
    for (auto i = begin; i != end; ++i) {
      while (loop.size() >= first + 2 &&
             orientation_2d(seen(loop[loop.size() - 2]), seen(loop.back()), seen(*i)) !=
                 Sign::Positive) {
        loop.pop_back();
      }
      loop.push_back(*i);
    }
    loop.pop_back();
  };
  chain(inside.begin(), inside.end());
  chain(inside.rbegin(), inside.rend());
  return loop;
}

class ContactFaces {
 public:
  explicit ContactFaces(Hull& hull)
      : hull_(hull), is_taken_(hull.faces.size(), false), is_flat_(hull.corners.size(), false) {
    around_.resize(hull.corners.size());
    for (Index i = 0; i < hull.faces.size(); ++i) {
      for (Index k = 0; k < hull.faces[i].count; ++k)
        around_[hull.loops[hull.faces[i].first + k]].push_back(i);
    }
  }

  void run() {
    std::vector<double> areas;
    for (const Hull::Face& facet : hull_.faces)
      areas.push_back(area_of(hull_, facet));
    std::vector<Index> order(hull_.faces.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](Index i, Index j) { return areas[i] > areas[j]; });
    for (const Index seed : order) {
      if (!is_taken_[seed]) add_face(seed);
    }
    if (found_.empty()) keep_facets();
    // They go in the order of the facets, so that numbers of features do not hang on areas.
    std::sort(found_.begin(), found_.end(),
              [](const Found& s, const Found& t) { return s.first < t.first; });
    for (const Found& found : found_) {
      const auto begin = static_cast<Index>(hull_.contact_loops.size());
      hull_.contact_loops.insert(hull_.contact_loops.end(), found.loop.begin(), found.loop.end());
      const Hull::Face& seed = hull_.faces[found.seed];
      hull_.contact_faces.push_back({seed.normal, begin, static_cast<Index>(found.loop.size())});
      hull_.contact_offsets.push_back(hull_.offsets[found.seed]);
    }
  }

 private:
  struct Found {
    Index seed;
    Index first;  ///< the first of the facets that it took
    std::vector<Index> loop;
  };

  void add_face(Index seed) {
    const Hull::Face& facet = hull_.faces[seed];
    const double least = hull_.offsets[seed] - kContactFlatness * hull_.bounding_radius;
    std::vector<Index> flat;
    for (Index i = 0; i < hull_.corners.size(); ++i) {
      if (dot(facet.normal, hull_.corners[i]) >= least) flat.push_back(i);
    }
    const int axis = steepest_axis(facet.normal);
    std::vector<Index> loop = outline(hull_, flat, axis);
    is_taken_[seed] = true;
    // A facet may be so narrow that rounding leaves nothing of it: then its neighbours stand for
    // it.
    if (loop.size() < 3) return;
    const double towards = axis == 0 ? facet.normal.x : axis == 1 ? facet.normal.y : facet.normal.z;
    if (towards < 0) std::reverse(loop.begin(), loop.end());
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    found_.push_back({seed, take(facet, flat, seed), std::move(loop)});
  }

  /// Keeps the facets as they are, for a needle so thin that rounding leaves a line.
  void keep_facets() {
    for (Index i = 0; i < hull_.faces.size(); ++i) {
      const auto begin = hull_.loops.begin() + hull_.faces[i].first;
      found_.push_back({i, i, std::vector<Index>(begin, begin + hull_.faces[i].count)});
    }
  }

  /// Takes the facets that lie in the face, and returns the first of them.
  Index take(const Hull::Face& face, const std::vector<Index>& flat, Index seed) {
    for (const Index corner : flat)
      is_flat_[corner] = true;
    Index first = seed;
    for (const Index corner : flat) {
      for (const Index i : around_[corner]) {
        const Hull::Face& other = hull_.faces[i];
        const auto begin = hull_.loops.begin() + other.first;
        if (is_taken_[i] || dot(other.normal, face.normal) < kOneFace ||
            !std::all_of(begin, begin + other.count, [&](Index c) { return is_flat_[c]; })) {
          continue;
        }
        is_taken_[i] = true;
        first = std::min(first, i);
      }
    }
    for (const Index corner : flat)
      is_flat_[corner] = false;
    return first;
  }

  Hull& hull_;
  std::vector<bool> is_taken_;
  std::vector<bool> is_flat_;
  std::vector<std::vector<Index>> around_;
  std::vector<Found> found_;
};

}  // namespace

void add_contact_faces(Hull& hull) {
  ContactFaces(hull).run();
}

}  // namespace graze::narrowphase
