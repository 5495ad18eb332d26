#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace graze::benchmark {

/// Poses of B in A's frame that have something in common.
struct RegimePoses {
  std::string name;    ///< far, near, touch, deep, or clear
  std::string source;  ///< the file that they were read from, or "generated"
  std::vector<Pose> poses;
};

/// Two meshes and how they are placed.
struct Scene {
  std::string kind;  ///< "meshes", "parallel" or "scaling"
  std::string name;
  Mesh mesh_a;
  Mesh mesh_b;
  std::vector<RegimePoses> regimes;

  /// Half the diagonal of the smaller bounds, metres.
  double size() const;
};

/// A scene is made when its turn comes and forgotten afterwards.
using SceneMaker = std::function<Scene()>;

struct SceneSettings {
  std::string data;  ///< folder of the bundled geometry
  std::vector<std::pair<std::string, std::string>> pairs;
  std::size_t poses = 60;                ///< of each regime
  std::size_t most_triangles = 4000000;  ///< of the refined mesh, about
};

/// The bundled meshes and `pairs`. Poses are those of the files A-B.REGIME.txt beside A, or in
/// ../poses from there, spread evenly; where there is no such file, they are made by poses_in().
std::vector<SceneMaker> mesh_scenes(const SceneSettings& settings);

/// Surfaces that are nearly parallel, a gap of a thousandth of their size apart, clear of each
/// other and moved until they touch: a sphere in a sphere, a shaft in its bore, two sheets.
std::vector<SceneMaker> parallel_scenes(const SceneSettings& settings);

/// A rock and another, both refined step by step, fourfold each, from a thousand triangles on.
std::vector<SceneMaker> scaling_scenes(const SceneSettings& settings);

}  // namespace graze::benchmark
