#include <graze/bvh/error.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/run/job_key.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/files/source.h>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace graze::compare {
namespace {

using cases::json_number;
using files::sha256_of;

/// Returns the SHA-256 of a mesh's vertices and triangles, with `before` in front.
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

/// Returns the same for a body: for its text in a case.
std::string digest_of(const CaseShape& shape, const std::string& before) {
  if (const auto* mesh = std::get_if<CaseMesh>(&shape)) return digest_of(mesh->mesh, before);
  const Case text{.note = "",
                  .ask = Ask::Any,
                  .settings = {},
                  .a = CaseBody(std::get<CaseBody>(shape).shape, Pose::Identity()),
                  .b = std::nullopt,
                  .answer = std::nullopt,
                  .answered_by = {}};
  return sha256_of(before + to_json(text));
}

bool has_clearance(const ComparisonJob& job) {
  return job.question.ask == Ask::Within || job.question.settings.clearance != 0;
}

}  // namespace

JournalHead head_of(const ComparisonJob& job) {
  const CaseSettings& settings = job.question.settings;
  std::string question = name_of(job.question.ask);
  question += settings.hit == Hit::Crossing ? " exclude" : "";
  question += settings.hit == Hit::Solid ? " solid" : "";
  std::string text = question;
  if (has_clearance(job)) {
    text += json_number(settings.clearance);
    question += ' ';
    question += cases::json_plain_number(settings.clearance);
    question += " m";
  }
  text = digest_of(job.b, digest_of(job.a, text));
  text += cases::json_pose(pose_a(job)) + job.poses_b->key();
  return {.kind = "graze_comparison",
          .unit = "poses",
          .key = sha256_of(text),
          .parts = {{"question", question},
                    {"mesh A", digest_of(job.a, "")},
                    {"mesh B", digest_of(job.b, "")},
                    {"pose of A", sha256_of(cases::json_pose(pose_a(job)))},
                    {"poses of B", job.poses_b->key()}},
          .places = job.places()};
}

JournalHead head_of(const std::filesystem::path& path, const Scene& scene,
                    const SceneComparisonSettings& settings) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw SceneError(mesh_io::printable(path.string()) + ": cannot be read");
  const std::string file_sum = sha256_of(text);
  std::string meshes;
  text = file_sum;
  for (const SceneShape& shape : scene.shapes) {
    const Mesh* mesh = shape.shape.as<Mesh>();
    if (mesh == nullptr) continue;
    text = digest_of(*mesh, text);
    meshes = digest_of(*mesh, meshes);
  }
  const double step = settings.step > 0 ? settings.step : scene.step;
  text += json_number(step);
  std::vector<JournalPart> parts = {{"scene", file_sum},
                                    {"set of meshes", sha256_of(meshes)},
                                    {"step of", cases::json_plain_number(step) + " s"}};
  if (settings.ask != Ask::Any) {
    std::string question = name_of(settings.ask);
    if (settings.clearance != 0)
      question += " " + cases::json_plain_number(settings.clearance) + " m";
    text += question;
    parts.insert(parts.begin(), {"question", question});
  }
  return {.kind = "graze_scene_comparison",
          .unit = "steps",
          .key = sha256_of(text),
          .parts = std::move(parts),
          .places = settings.steps + 1};
}

JournalHead head_of(const CaseJob& job) {
  std::string text;
  std::string names;
  for (const NamedCase& each : job.cases) {
    names += cases::json_string(each.name);
    text += cases::json_string(each.name) + sha256_of(to_json(each.query));
  }
  return {.kind = "graze_case_comparison",
          .unit = "cases",
          .key = sha256_of(text),
          .parts = {{"set of file names", sha256_of(names)}, {"content of files", sha256_of(text)}},
          .places = job.cases.size()};
}

}  // namespace graze::compare
