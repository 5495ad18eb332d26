#include <graze/engine/cases/answer_case.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/peers/known_peers.h>
#include <graze/engine/compare/peers/process/process_engine.h>

#include <array>
#include <exception>

namespace graze::compare {
namespace {

std::optional<CaseMesh> as_mesh(const CaseShape& shape) {
  if (const auto* mesh = std::get_if<CaseMesh>(&shape)) return *mesh;
  const auto* t = std::get_if<Triangle>(&shape);
  if (t == nullptr) return std::nullopt;
  const std::array<Eigen::Vector3d, 3> corners = {t->a, t->b, t->c};
  const std::array<TriangleIndices, 1> triangle = {{{0, 1, 2}}};
  return CaseMesh(Mesh(corners, triangle), Pose::Identity());
}

/// True for a case of triangles alone: as meshes of one triangle they would be asked another query
/// of the library, whose answer names them.
bool is_of_triangles_alone(const Case& query) {
  const bool are_triangles = std::holds_alternative<Triangle>(query.a) && query.b &&
                             std::holds_alternative<Triangle>(*query.b);
  return are_triangles && (query.ask == Ask::Distance || query.ask == Ask::Intersection);
}

/// Returns the answer, and how long it took to come by.
template <typename Ask>
TimedAnswer timed(const Ask& ask) {
  const auto start = std::chrono::steady_clock::now();
  std::optional<CaseAnswer> answer = ask();
  return {std::move(answer), std::chrono::steady_clock::now() - start};
}

/// Loads another question than whether they meet, about two bodies, into an engine that holds them.
LoadedQuestion load_bodies(const Engine& engine, const Case& query, const BodyCase& bodies) {
  const std::array<Shape, 2> shapes = {bodies.a.shape, bodies.b.shape};
  const std::shared_ptr<LoadedShapes> loaded = engine.load_shapes(shapes);
  if (!loaded) return [] { return TimedAnswer(); };
  return [loaded, question = Question{query.ask, query.settings, bodies.a.course, bodies.b.course},
          pose_a = bodies.a.pose, pose_b = bodies.b.pose] {
    return timed([&] { return loaded->answer(question, {0, pose_a}, {1, pose_b}); });
  };
}

void add_peers(std::span<const KnownPeer> peers, const PeerSettings& settings,
               std::vector<EngineEntry>& engines) {
  for (const KnownPeer& peer : peers) {
    engines.push_back({peer.name, nullptr});
    if (peer.is_here)
      engines.back().engine = make_process_engine(built_in_peer(peer.name, settings));
  }
}

}  // namespace

TimedAnswer LoadedPair::timed_answer(const Question& question, const Pose& pose_a,
                                     const Pose& pose_b) const {
  return timed([&] { return answer(question, pose_a, pose_b); });
}

ShapesAnswer LoadedShapes::intersect_all(
    std::span<const PlacedShape> bodies,
    std::span<const std::pair<std::size_t, std::size_t>> pairs) const {
  ShapesAnswer all;
  const auto start = std::chrono::steady_clock::now();
  for (const auto& [a, b] : pairs) {
    ShapesAnswer::Pair& pair = all.pairs.emplace_back();
    try {
      pair.says = intersects(bodies[a].shape, bodies[a].pose, bodies[b].shape, bodies[b].pose);
    } catch (const Error&) {  // the engine is not there, or graze refuses what it is asked
      throw;
    } catch (const EngineFailure& failure) {
      pair.fault = failure.what();
    } catch (const std::exception& error) {
      pair.fault = std::string("throws ") + error.what();
    }
  }
  all.time = std::chrono::steady_clock::now() - start;
  return all;
}

std::optional<CaseAnswer> LoadedShapes::answer(const Question&, const PlacedShape&,
                                               const PlacedShape&) const {
  return std::nullopt;
}

std::unique_ptr<LoadedShapes> Engine::load_shapes(std::span<const Shape>) const {
  return nullptr;
}

std::unique_ptr<Engine> Engine::alone() const {
  return nullptr;
}

std::optional<MeshCase> as_meshes(const Case& query) {
  std::optional<CaseMesh> a = as_mesh(query.a);
  std::optional<CaseMesh> b = query.b ? as_mesh(*query.b) : std::nullopt;
  if (!a || !b) return std::nullopt;
  return MeshCase{*std::move(a), *std::move(b)};
}

std::optional<BodyCase> as_bodies(const Case& query) {
  const auto* a = std::get_if<CaseBody>(&query.a);
  const auto* b = query.b ? std::get_if<CaseBody>(&*query.b) : nullptr;
  if (a == nullptr || b == nullptr) return std::nullopt;
  return BodyCase{*a, *b};
}

LoadedQuestion load_question(const Engine& engine, const Case& query) {
  if (engine.name().engine == "graze" && is_of_triangles_alone(query)) {
    return [&query] { return timed([&] { return std::optional(answer_case(query)); }); };
  }
  if (const std::optional<MeshCase> meshes = as_meshes(query)) {
    const std::shared_ptr<LoadedPair> pair = engine.load(meshes->a.mesh, meshes->b.mesh);
    return
        [pair, question = Question{query.ask, query.settings, meshes->a.course, meshes->b.course},
         pose_a = meshes->a.pose,
         pose_b = meshes->b.pose] { return pair->timed_answer(question, pose_a, pose_b); };
  }
  const std::optional<BodyCase> bodies = as_bodies(query);
  if (bodies && query.ask == Ask::Any) {
    const std::array<Shape, 2> shapes = {bodies->a.shape, bodies->b.shape};
    const std::shared_ptr<LoadedShapes> loaded = engine.load_shapes(shapes);
    return [loaded, pose_a = bodies->a.pose, pose_b = bodies->b.pose] {
      return timed([&] {
        std::optional<CaseAnswer> answer;
        if (!loaded) return answer;
        const std::optional<bool> says = loaded->intersects(0, pose_a, 1, pose_b);
        if (says) answer.emplace().says = says;
        return answer;
      });
    };
  }
  if (engine.name().engine == "graze")
    return [&query] { return timed([&] { return std::optional(answer_case(query)); }); };
  if (bodies) return load_bodies(engine, query, *bodies);
  return [] { return TimedAnswer(); };
}

std::optional<CaseAnswer> ask(const Engine& engine, const Case& query) {
  return load_question(engine, query)().answer;
}

std::vector<EngineEntry> all_engines(const PeerSettings& settings) {
  std::vector<EngineEntry> engines;
  engines.push_back({"graze", make_graze_engine()});
  add_peers(kKnownPeers, settings, engines);
  return engines;
}

std::vector<EngineEntry> scene_engines(const PeerSettings& settings) {
  std::vector<EngineEntry> engines;
  add_peers(kScenePeers, settings, engines);
  return engines;
}

std::vector<EngineEntry> motion_engines(const PeerSettings& settings) {
  std::vector<EngineEntry> engines;
  add_peers(kMotionPeers, settings, engines);
  for (EngineEntry& entry : engines)
    entry.is_only_if_named = true;
  return engines;
}

EngineEntry start_engine(const std::string& command, const PeerSettings& settings) {
  PeerProgram program = program_of_command(command, settings);
  try {
    program.name = PeerSession(program).hello().witness.engine;
  } catch (const EngineFailure& failure) {
    throw EngineMissingError(failure.what());
  }
  return {program.name, make_process_engine(program), true};
}

}  // namespace graze::compare
