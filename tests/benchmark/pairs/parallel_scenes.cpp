#include <Eigen/Geometry>

#include "data/generator/parts/geodesic.h"
#include "tests/benchmark/pairs/scene.h"
#include "tests/shapes/random_meshes.h"

namespace graze::benchmark {
namespace {

using Eigen::Vector3d;
using generator::Surface;

constexpr double kGap = 0.001;  // metres; radii and half sides are one metre

Mesh to_mesh(const Surface& surface) {
  return Mesh(surface.vertices(), surface.triangles());
}

/// A tube along z without ends: `around` quadrangles around, `along` along, two metres long. The
/// points of the circle are those of a square's sides moved out to it.
Surface make_tube(double radius, int around, int along) {
  const auto point = [&](int i, int k) {
    const int side = around / 4;
    const double t = 2.0 * (i % side) / side - 1;
    const int turns = (i / side) % 4;
    Vector3d p = turns == 0   ? Vector3d(1, t, 0)
                 : turns == 1 ? Vector3d(-t, 1, 0)
                 : turns == 2 ? Vector3d(-1, -t, 0)
                              : Vector3d(t, -1, 0);
    p *= radius / p.norm();
    p.z() = 2.0 * k / along - 1;
    return p;
  };
  Surface surface;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < along; ++k) {
      const auto corner = [&](int di, int dk) { return surface.vertex(point(i + di, k + dk)); };
      surface.quadrangle(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
    }
  }
  return surface;
}

/// A wavy square of two metres, three tenths of a metre high.
Surface make_sheet(int cells) {
  const auto bump = [](double x) { return x * x * (3 - 2 * x * x); };
  const auto point = [&](int i, int k) {
    const double x = 2.0 * i / cells - 1;
    const double y = 2.0 * k / cells - 1;
    return Vector3d(x, y, 0.3 * bump(x) * (1 - bump(y)));
  };
  Surface surface;
  for (int i = 0; i < cells; ++i) {
    for (int k = 0; k < cells; ++k) {
      const auto corner = [&](int di, int dk) { return surface.vertex(point(i + di, k + dk)); };
      surface.quadrangle(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
    }
  }
  return surface;
}

/// `at(shift, source)` is a pose moved by `shift` gaps towards a touch.
template <typename At>
Scene scene_of(const char* name, const Mesh& mesh_a, const Mesh& mesh_b, std::size_t poses,
               const At& at) {
  RandomSource source(1);
  Scene scene{"parallel", name, mesh_a, mesh_b, {}};
  scene.regimes = {{"clear", "generated", {}}, {"touch", "generated", {}}};
  for (std::size_t i = 0; i < poses; ++i) {
    scene.regimes[0].poses.push_back(at(source.uniform(0, 0.4), source));
    scene.regimes[1].poses.push_back(at(source.uniform(1.5, 2), source));
  }
  return scene;
}

Vector3d direction(RandomSource& source) {
  Vector3d d = source.vector(-1, 1);
  while (d.norm() > 1 || d.norm() < 0.1)
    d = source.vector(-1, 1);
  return d.normalized();
}

Scene spheres(std::size_t poses) {
  constexpr int kFrequency = 50;  // triangles sag by less than a tenth of the gap
  const Surface sphere = generator::make_geodesic_sphere(kFrequency);
  return scene_of("sphere in sphere", to_mesh(sphere.scaled(1 + kGap)), to_mesh(sphere), poses,
                  [](double shift, RandomSource& source) {
                    Pose pose = tests::random_pose(0, source);
                    pose.translation() = shift * kGap * direction(source);
                    return pose;
                  });
}

Scene shaft(std::size_t poses) {
  constexpr int kAround = 240;  // chords sag by less than a seventh of the gap
  constexpr int kAlong = 80;
  return scene_of("shaft in bore", to_mesh(make_tube(1 + kGap, kAround, kAlong)),
                  to_mesh(make_tube(1, kAround, kAlong)), poses,
                  [](double shift, RandomSource& source) {
                    Vector3d across = direction(source);
                    across.z() = 0;
                    Pose pose = Pose::Identity();
                    const Vector3d turn = direction(source);
                    const Vector3d x(Vector3d(turn.x(), turn.y(), 0).normalized());
                    pose.linear().col(0) = x;
                    pose.linear().col(1) = Vector3d::UnitZ().cross(x);
                    pose.translation() = shift * kGap * across.normalized();
                    pose.translation().z() = source.uniform(-0.2, 0.2);
                    return pose;
                  });
}

Scene sheets(std::size_t poses) {
  constexpr int kCells = 130;
  const Mesh sheet = to_mesh(make_sheet(kCells));
  return scene_of("two sheets", sheet, sheet, poses, [](double shift, RandomSource& source) {
    Pose pose = Pose::Identity();
    pose.translation() =
        kGap * Vector3d{source.uniform(-0.2, 0.2), source.uniform(-0.2, 0.2), 1 - shift};
    if (shift > 1) {  // through each other along a line, not sheet beyond sheet
      const double tilt = 2 * kGap;
      pose.linear() = Eigen::AngleAxisd(tilt, direction(source)).toRotationMatrix();
    }
    return pose;
  });
}

}  // namespace

std::vector<SceneMaker> parallel_scenes(const SceneSettings& settings) {
  const std::size_t poses = settings.poses;
  return {[poses] { return spheres(poses); }, [poses] { return shaft(poses); },
          [poses] { return sheets(poses); }};
}

}  // namespace graze::benchmark
