#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/cases/case.h>
#include <graze/engine/world/shape.h>

namespace graze::compare {

/// What is asked about two meshes.
struct Question {
  Ask ask = Ask::Any;
  CaseSettings settings = {};

  /// Surfaces, touching counts, lists are complete: what engines other than graze can be asked.
  bool is_plain() const {
    return settings.touch == Touch::Include && settings.interior == Interior::Surface &&
           !settings.limit;
  }
};

/// Two meshes as an engine holds them. Safe to ask from many threads at once.
class LoadedPair {
 public:
  virtual ~LoadedPair() = default;

  /// The engine's answer in these poses; nothing if it does not know such questions.
  virtual std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                           const Pose& pose_b) const = 0;
};

/// Shapes of bodies as an engine holds them, asked about by their indices.
class LoadedShapes {
 public:
  virtual ~LoadedShapes() = default;

  /// Whether two of them intersect in these poses; nothing if the engine does not know such shapes.
  virtual std::optional<bool> intersects(std::size_t shape_a, const Pose& pose_a,
                                         std::size_t shape_b, const Pose& pose_b) const = 0;
};

/// A collision engine behind one page. No type of the engine's own appears here.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual CaseWitness name() const = 0;

  /// Builds what the engine needs for queries: its trees, for example. Throws Error if it refuses.
  virtual std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const = 0;

  /// The same for shapes of all kinds; null if the engine's adaptor knows meshes only.
  virtual std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const;
};

/// An engine, or the word why it is not here.
struct EngineEntry {
  std::string name;
  std::unique_ptr<Engine> engine;  ///< null if it was not found when this was built
};

/// graze first, then every other engine that this program knows of.
std::vector<EngineEntry> all_engines();

std::unique_ptr<Engine> make_graze_engine();
std::unique_ptr<Engine> make_fcl_engine();
std::unique_ptr<Engine> make_bullet_engine();
std::unique_ptr<Engine> make_ode_engine();
std::unique_ptr<Engine> make_coal_engine();

/// What an engine answers to a case that it holds; nothing if it knows no such question.
using LoadedQuestion = std::function<std::optional<CaseAnswer>()>;

/// Only graze is asked about shapes other than bodies, meshes and triangles, which become meshes of
/// one triangle. Engine and case must outlive the result. Throws Error if the engine refuses.
LoadedQuestion load_question(const Engine& engine, const Case& query);

/// Loads it and asks.
std::optional<CaseAnswer> ask(const Engine& engine, const Case& query);

/// The meshes of a case, a triangle as a mesh of one; nothing for other shapes.
struct MeshCase {
  CaseMesh a;
  CaseMesh b;
};
std::optional<MeshCase> as_meshes(const Case& query);

/// The two bodies of a case, which must outlive this; nothing for other shapes.
struct BodyCase {
  const CaseBody& a;
  const CaseBody& b;
};
std::optional<BodyCase> as_bodies(const Case& query);

}  // namespace graze::compare
