// graze_planted_engine FILE: a wrapper as users write it, on their client's page, that is honest
// but for what the file plants: in a pose of B it misses a hit, is a picometre off, turns a normal
// round, crashes or hangs. What it does hangs on the pose alone, so that it does the same in every
// process, in every part of a run, and when it is asked again.

#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/peers/engine.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <memory>
#include <thread>

#include "samples/engines/graze_peer.h"

namespace {

using graze_peer::Json;

/// What the file says: {"sleep_us": 0, "planted": [{"pose": [12 numbers], "fault": "crash"}]}.
struct Plan {
  std::chrono::microseconds sleep{0};  ///< before every answer
  std::map<graze_peer::Pose, std::string> faults;
};

Plan read_plan(const char* path) {
  std::ifstream file(path);
  const Json text = Json::parse(file);
  Plan plan{std::chrono::microseconds(text.at("sleep_us").get<int>()), {}};
  for (const Json& each : text.at("planted"))
    plan.faults[each.at("pose").get<graze_peer::Pose>()] = each.at("fault");
  return plan;
}

graze::Pose pose_of(const graze_peer::Pose& numbers) {
  graze::Pose pose;
  for (int i = 0; i < 12; ++i)
    pose(i / 4, i % 4) = numbers[static_cast<std::size_t>(i)];
  return pose;
}

graze::Mesh mesh_of(const graze_peer::Mesh& mesh) {
  std::vector<Eigen::Vector3d> vertices;
  for (const auto& v : mesh.vertices)
    vertices.emplace_back(v[0], v[1], v[2]);
  std::vector<graze::TriangleIndices> triangles;
  for (const auto& t : mesh.triangles)
    triangles.push_back({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
                         static_cast<std::uint32_t>(t[2])});
  return graze::Mesh(vertices, triangles);
}

graze::Ask ask_of(const std::string& question) {
  if (question == "any") return graze::Ask::Any;
  if (question == "distance") return graze::Ask::Distance;
  if (question == "contacts") return graze::Ask::Contacts;
  throw graze_peer::Unsupported("no such question");
}

[[noreturn]] void crash() {
  std::signal(SIGSEGV, SIG_DFL);
  std::raise(SIGSEGV);
  _exit(1);
}

[[noreturn]] void hang() {
  while (true)
    pause();
}

Json with_fault(Json honest, const std::string& fault) {
  if (fault == "crash") crash();
  if (fault == "hang") hang();
  if (fault == "miss") honest["says"] = false;
  if (fault == "picometre") honest["distance"] = honest["distance"].get<double>() + 1e-12;
  if (fault == "reverse") {
    for (Json& contact : honest["contacts"])
      for (Json& x : contact["normal"])
        x = -x.get<double>();
  }
  return honest;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const Plan plan = read_plan(argv[1]);
  const auto load = [&](const graze_peer::Mesh& a, const graze_peer::Mesh& b) {
    const std::shared_ptr<graze::compare::LoadedPair> pair =
        graze::compare::make_graze_engine()->load(mesh_of(a), mesh_of(b));
    return [&plan, pair](const graze_peer::Question& question) -> Json {
      if (plan.sleep.count() > 0) std::this_thread::sleep_for(plan.sleep);
      const graze::CaseAnswer answer = *pair->answer(
          {.ask = ask_of(question.name)}, pose_of(question.pose_a), pose_of(question.pose_b));
      const Json honest = Json::parse(to_plain_json(answer));
      const auto fault = plan.faults.find(question.pose_b);
      return fault == plan.faults.end() ? honest : with_fault(honest, fault->second);
    };
  };
  return graze_peer::serve({"planted", "1", {"any", "distance", "contacts"}, load});
}
