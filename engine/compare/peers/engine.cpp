#include <graze/engine/cases/answer_case.h>
#include <graze/engine/compare/peers/engine.h>

#include <array>

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

}  // namespace

std::unique_ptr<LoadedShapes> Engine::load_shapes(std::span<const Shape>) const {
  return nullptr;
}

std::optional<MeshCase> as_meshes(const Case& query) {
  std::optional<CaseMesh> a = as_mesh(query.a);
  std::optional<CaseMesh> b = query.b ? as_mesh(*query.b) : std::nullopt;
  if (!a || !b) return std::nullopt;
  return MeshCase{*std::move(a), *std::move(b)};
}

std::optional<CaseAnswer> ask(const Engine& engine, const Case& query) {
  if (engine.name().engine == "graze" && !as_meshes(query)) return answer_case(query);
  const std::optional<MeshCase> meshes = as_meshes(query);
  if (!meshes) return std::nullopt;
  return engine.load(meshes->a.mesh, meshes->b.mesh)
      ->answer({query.ask, query.settings}, meshes->a.pose, meshes->b.pose);
}

std::vector<EngineEntry> all_engines() {
  std::vector<EngineEntry> engines;
  engines.push_back({"graze", make_graze_engine()});
#if GRAZE_HAS_FCL
  engines.push_back({"fcl", make_fcl_engine()});
#else
  engines.push_back({"fcl", nullptr});
#endif
#if GRAZE_HAS_BULLET
  engines.push_back({"bullet", make_bullet_engine()});
#else
  engines.push_back({"bullet", nullptr});
#endif
#if GRAZE_HAS_ODE
  engines.push_back({"ode", make_ode_engine()});
#else
  engines.push_back({"ode", nullptr});
#endif
#if GRAZE_HAS_COAL
  engines.push_back({"coal", make_coal_engine()});
#else
  engines.push_back({"coal", nullptr});
#endif
  return engines;
}

}  // namespace graze::compare
