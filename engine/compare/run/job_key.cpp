#include <graze/engine/cases/json_text.h>
#include <graze/engine/cases/sha256.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/run/job_key.h>
#include <graze/engine/mesh/io/source.h>
#include <graze/engine/scenes/scene_error.h>

#include <fstream>
#include <iterator>
#include <string>

namespace graze::compare {
namespace {

using cases::json_number;
using cases::sha256_of;

/// SHA-256 of a mesh's vertices and triangles, with `before` in front.
std::string digest_of(const Mesh& mesh, const std::string& before) {
  std::string text = before;
  for (const Eigen::Vector3d& vertex : mesh.vertices())
    text += cases::json_point(vertex);
  for (const TriangleIndices& t : mesh.triangles()) {
    for (const std::uint32_t index : t)
      text += std::to_string(index) + " ";
  }
  return sha256_of(text);
}

}  // namespace

JournalHead head_of(const ComparisonJob& job) {
  const CaseSettings& settings = job.question.settings;
  std::string text = name_of(job.question.ask);
  text += settings.touch == Touch::Exclude ? " exclude" : "";
  text += settings.interior == Interior::Solid ? " solid" : "";
  if (job.question.ask == Ask::Within) text += json_number(settings.clearance);
  text = digest_of(job.b.mesh, digest_of(job.a.mesh, text));
  text += cases::json_pose(job.a.pose);
  for (const Pose& pose : job.poses_b)
    text += cases::json_pose(pose);
  return {"graze_comparison", "poses", sha256_of(text), job.poses_b.size()};
}

JournalHead head_of(const std::filesystem::path& path, const Scene& scene,
                    const SceneComparisonSettings& settings) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw SceneError(mesh_io::printable(path.string()) + ": cannot be read");
  text = sha256_of(text);
  for (const SceneShape& shape : scene.shapes)
    if (const Mesh* mesh = shape.shape.as<Mesh>()) text = digest_of(*mesh, text);
  text += json_number(settings.step > 0 ? settings.step : scene.step);
  return {"graze_scene_comparison", "steps", sha256_of(text), settings.steps + 1};
}

JournalHead head_of(const CaseJob& job) {
  std::string text;
  for (const NamedCase& each : job.cases)
    text += cases::json_string(each.name) + sha256_of(to_json(each.query));
  return {"graze_case_comparison", "cases", sha256_of(text), job.cases.size()};
}

}  // namespace graze::compare
