#include "data/generator/parts/rock.h"

#include <algorithm>
#include <vector>

#include "data/generator/dice.h"
#include "data/generator/noise.h"
#include "data/generator/parts/geodesic.h"

namespace graze::generator {
namespace {

using Eigen::Vector3d;

constexpr int kFrequency = 28;
constexpr double kLongestSide = 0.3;
constexpr std::int64_t kSeed = 3;
constexpr int kFlats = 9;
constexpr double kRoughness = 0.22;
constexpr Fractal kWeather{kSeed, 5, 0.45};

/// The half-space below it is kept.
struct Flat {
  Vector3d normal;
  double height;
};

std::vector<Flat> draw_flats() {
  Dice dice(kSeed);
  std::vector<Flat> flats;
  for (int i = 0; i < kFlats; ++i) {
    const Vector3d normal = dice.direction();
    flats.push_back({normal, dice.uniform(0.72, 0.92)});
  }
  return flats;
}

// How far the rock reaches in this direction, a unit vector.
double radius(const Vector3d& u, const std::vector<Flat>& flats) {
  double result = 1;
  for (const Flat& flat : flats) {
    const Vector3d& n = flat.normal;
    const double rise = n.x() * u.x() + n.y() * u.y() + n.z() * u.z();
    if (rise > 0) result = std::min(result, flat.height / rise);
  }
  return result * (1 + kRoughness * fractal_noise(1.7 * u, kWeather));
}

double longest_side(const Surface& surface) {
  Vector3d low = surface.vertices().front();
  Vector3d high = low;
  for (const Vector3d& p : surface.vertices()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

}  // namespace

Surface make_rock() {
  const Surface sphere = make_geodesic_sphere(kFrequency);
  const std::vector<Flat> flats = draw_flats();
  Surface rock;
  std::vector<std::uint32_t> moved;
  for (const Vector3d& u : sphere.vertices()) {
    const Vector3d p = u * radius(u, flats);
    moved.push_back(rock.vertex({p.x(), 0.85 * p.y(), 0.7 * p.z()}));
  }
  for (const auto& [a, b, c] : sphere.triangles())
    rock.triangle(moved[a], moved[b], moved[c]);
  return rock.scaled(kLongestSide / longest_side(rock));
}

}  // namespace graze::generator
