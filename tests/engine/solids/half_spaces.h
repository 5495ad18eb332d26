#pragma once

// Solids of tetrahedra as sets of half-spaces, in whole or rational numbers.

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace graze::tests {

template <typename Number>
struct HalfSpaceOf {
  std::array<Number, 3> normal;
  Number offset;  ///< normal . x < offset within it
};

template <typename Number>
using HalfSpaces = std::vector<HalfSpaceOf<Number>>;

template <typename Number>
using PointOf = std::array<Number, 3>;

template <typename Number>
Number dot(const std::array<Number, 3>& s, const std::array<Number, 3>& t) {
  return Number(s[0] * t[0] + s[1] * t[1] + s[2] * t[2]);
}

template <typename Number>
std::array<Number, 3> cross(const std::array<Number, 3>& s, const std::array<Number, 3>& t) {
  return {Number(s[1] * t[2] - s[2] * t[1]), Number(s[2] * t[0] - s[0] * t[2]),
          Number(s[0] * t[1] - s[1] * t[0])};
}

/// Those that a tetrahedron with volume is the intersection of.
template <typename Number>
HalfSpaces<Number> half_spaces_of(const std::array<PointOf<Number>, 4>& corners) {
  HalfSpaces<Number> all;
  for (std::size_t i = 0; i < 4; ++i) {
    const PointOf<Number>&a = corners[(i + 1) % 4], &b = corners[(i + 2) % 4],
          &c = corners[(i + 3) % 4];
    std::array<Number, 3> ab, ac;
    for (std::size_t k = 0; k < 3; ++k)
      ab[k] = b[k] - a[k], ac[k] = c[k] - a[k];
    HalfSpaceOf<Number> beyond{cross(ab, ac), 0};
    beyond.offset = dot(beyond.normal, a);
    if (!(dot(beyond.normal, corners[i]) < beyond.offset)) {
      for (Number& n : beyond.normal)
        n = -n;
      beyond.offset = -beyond.offset;
    }
    all.push_back(beyond);
  }
  return all;
}

/// Whether some open set lies in all of them, of which four are those of a tetrahedron. Then there
/// are corners, points of three planes that are in all closed half-spaces, and of those not all are
/// on any one plane.
template <typename Number>
bool have_volume(const HalfSpaces<Number>& all) {
  std::vector<bool> is_left(all.size(), false);
  std::size_t count = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const auto along = cross(all[i].normal, all[j].normal);
      for (std::size_t k = j + 1; k < all.size(); ++k) {
        Number weight = dot(along, all[k].normal);
        if (weight == 0) continue;
        const auto jk = cross(all[j].normal, all[k].normal);
        const auto ki = cross(all[k].normal, all[i].normal);
        PointOf<Number> corner;
        for (std::size_t axis = 0; axis < 3; ++axis)
          corner[axis] =
              jk[axis] * all[i].offset + ki[axis] * all[j].offset + along[axis] * all[k].offset;
        if (weight < 0) {
          weight = -weight;
          for (Number& c : corner)
            c = -c;
        }
        bool is_in = true;
        for (const HalfSpaceOf<Number>& each : all)
          is_in = is_in && dot(each.normal, corner) <= each.offset * weight;
        if (!is_in) continue;
        for (std::size_t n = 0; n < all.size(); ++n) {
          if (!is_left[n] && dot(all[n].normal, corner) < all[n].offset * weight)
            is_left[n] = true, ++count;
        }
        if (count == all.size()) return true;
      }
    }
  }
  return false;
}

/// Whether an open set lies in `region` and in none of the closed sets from the one with the number
/// `next` on.
template <typename Number>
bool have_volume_outside(const HalfSpaces<Number>& region,
                         const std::vector<HalfSpaces<Number>>& closed, std::size_t next = 0) {
  if (!have_volume(region)) return false;
  if (next == closed.size()) return true;
  for (const HalfSpaceOf<Number>& each : closed[next]) {
    HalfSpaces<Number> beyond = region;
    beyond.push_back(each);
    for (Number& n : beyond.back().normal)
      n = -n;
    beyond.back().offset = -beyond.back().offset;
    if (have_volume_outside(beyond, closed, next + 1)) return true;
  }
  return false;
}

/// Tetrahedra that are one solid by the even-odd rule: what lies in an odd number of them.
template <typename Number>
using Tetrahedra = std::vector<std::array<PointOf<Number>, 4>>;

/// Whether two such solids have an open set in common.
template <typename Number>
bool have_common_volume(const Tetrahedra<Number>& a, const Tetrahedra<Number>& b) {
  std::vector<HalfSpaces<Number>> all;
  for (const Tetrahedra<Number>* solid : {&a, &b}) {
    for (const auto& corners : *solid)
      all.push_back(half_spaces_of(corners));
  }
  for (unsigned in = 1; in < 1u << all.size(); ++in) {
    std::array<unsigned, 2> counts{};
    HalfSpaces<Number> region;
    std::vector<HalfSpaces<Number>> others;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if ((in >> i & 1) == 0) {
        others.push_back(all[i]);
        continue;
      }
      ++counts[i < a.size() ? 0 : 1];
      region.insert(region.end(), all[i].begin(), all[i].end());
    }
    if (counts[0] % 2 == 1 && counts[1] % 2 == 1 && have_volume_outside(region, others))
      return true;
  }
  return false;
}

}  // namespace graze::tests
