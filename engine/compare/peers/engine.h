#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/bvh/error.h>
#include <graze/engine/cases/case.h>
#include <graze/engine/world/shape.h>

namespace graze::compare {

/// Says what is asked about two meshes or shapes.
struct Question {
  Ask ask = Ask::Any;
  CaseSettings settings = {};
  std::optional<RigidCourse> course_a = {};  ///< A's course for Ask::FirstContact and Free; without
                                             ///< one it rests
  std::optional<RigidCourse> course_b = {};

  /// True for a question that engines other than graze can be asked: surfaces, touching counts,
  /// lists are complete.
  bool is_plain() const { return settings.hit == Hit::Touching && !settings.limit; }
};

/// Thrown for what an engine did instead of answering: it died, it hung, it wrote what nobody
/// can read. what() says it in words. It is the engine's error, and no refusal.
class EngineFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown if an engine cannot be asked at all: the program that it runs in is not there.
class EngineMissingError : public Error {
 public:
  using Error::Error;
};

/// Holds an answer, or nothing where the engine knows no such question, and how long the engine
/// itself took for it.
struct TimedAnswer {
  using Time = std::chrono::duration<double, std::micro>;
  TimedAnswer() = default;
  TimedAnswer(std::optional<CaseAnswer> the_answer, Time the_time = Time(0))  // NOLINT: implicit
      : answer(std::move(the_answer)), time(the_time) {}

  std::optional<CaseAnswer> answer;
  Time time{0};
};

/// Holds two meshes as an engine does. One thread may ask at a time, unless its engine says that
/// many may.
class LoadedPair {
 public:
  virtual ~LoadedPair() = default;

  /// Returns the engine's answer in these poses; nothing if it does not know such questions.
  virtual std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                           const Pose& pose_b) const = 0;

  /// Returns the same with the engine's time, which does not count the way to another process and
  /// back.
  virtual TimedAnswer timed_answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const;
};

/// Names one of the shapes that are loaded, by its index, in a pose.
struct PlacedShape {
  std::size_t shape = 0;
  Pose pose = Pose::Identity();
};

/// Holds what an engine says of many pairs of placed shapes.
struct ShapesAnswer {
  /// Says of a pair whether the two intersect; nothing if the engine does not know such shapes.
  struct Pair {
    std::optional<bool> says = {};
    std::string fault = {};  ///< what the engine did instead of answering; empty if it answered
  };
  std::vector<Pair> pairs;
  TimedAnswer::Time time{0};  ///< the time of all pairs together
};

/// Holds shapes of bodies as an engine does, asked about by their indices. What LoadedPair says of
/// threads holds here, too.
class LoadedShapes {
 public:
  virtual ~LoadedShapes() = default;

  /// Returns whether two of them intersect in these poses; nothing if the engine does not know such
  /// shapes.
  virtual std::optional<bool> intersects(std::size_t shape_a, const Pose& pose_a,
                                         std::size_t shape_b, const Pose& pose_b) const = 0;

  /// Asks about many pairs, given by indices into `bodies`. What the engine throws becomes a fault,
  /// but for an Error, which is thrown on.
  virtual ShapesAnswer intersect_all(
      std::span<const PlacedShape> bodies,
      std::span<const std::pair<std::size_t, std::size_t>> pairs) const;

  /// Returns what the engine answers to any other question about two of them: Ask::Distance, Within
  /// and Contacts as they stand, FirstContact and Free as each goes from its pose along the course
  /// in the question; nothing if it does not know such questions.
  virtual std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                           const PlacedShape& b) const;
};

/// This is a collision engine behind one interface. No type of the engine's own appears here.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual CaseWitness name() const = 0;

  /// Returns which questions about two meshes it knows, if it says so.
  virtual std::optional<std::vector<Ask>> questions() const { return std::nullopt; }

  /// True if it is asked about all pairs of a scene in one question, because it looks itself for
  /// those that may meet. A pair by itself is then another question than the pair among others.
  virtual bool answers_scenes() const { return false; }

  /// Returns how far off it may be by its own word, metres, if it says so. No verdict depends on
  /// it, only what is advised.
  virtual std::optional<double> tolerance() const { return std::nullopt; }

  /// Builds what the engine needs for queries: its trees, for example. Throws Error if it refuses.
  virtual std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const = 0;

  /// Builds the same for shapes of all kinds; null if the engine's adaptor knows meshes only.
  virtual std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const;

  /// Returns the same engine, for confirming what it said: every load starts where nothing else was
  /// loaded before, and every question is asked where nothing else was asked. Returns null if this
  /// is such an engine, or if nothing that it is asked changes what it says later.
  virtual std::unique_ptr<Engine> alone() const;
};

/// Holds what an engine once said, for each place: poses of one job, counted from 0. Many threads
/// may read it.
class RecordedAnswers {
 public:
  virtual ~RecordedAnswers() = default;

  /// Returns the answer as LoadedPair::timed_answer() has it. Throws EngineFailure for what was no
  /// answer.
  virtual TimedAnswer at(std::size_t place) const = 0;

  /// Returns the SHA-256 of all of them.
  virtual const std::string& digest() const = 0;
};

/// Holds an engine, or says why it is not here.
struct EngineEntry {
  std::string name;
  std::unique_ptr<Engine> engine;  ///< null if it was not found when this was built
  bool is_users_own = false;       ///< true if start_engine() made it
  /// The recorded answers, if the engine only bears a name, and nothing can be asked of it. Null if
  /// it is asked.
  std::shared_ptr<const RecordedAnswers> recorded = nullptr;
  bool is_only_if_named = false;  ///< true if it takes part only where somebody names it
};

/// Says how engines in processes of their own are asked.
struct PeerSettings {
  std::chrono::duration<double> timeout{60};  ///< the time for loading, and for each question
  /// The program that they run in. If it is empty, it is graze-peer beside the running program, or
  /// else where it was built.
  std::filesystem::path program = {};
};

/// Returns graze first, then every other engine that this program knows of, each in processes of
/// its own (peers/process/README.md), which start when they are first needed. Many threads may ask
/// all of them.
std::vector<EngineEntry> all_engines(const PeerSettings& settings = {});

/// Returns engines that are for scenes alone (Engine::answers_scenes()): FCL's managers.
std::vector<EngineEntry> scene_engines(const PeerSettings& settings = {});

/// Returns engines that know motions alone and take part where they are named: FCL with each of its
/// other settings, and Bullet's other casts.
std::vector<EngineEntry> motion_engines(const PeerSettings& settings = {});

/// Makes graze in this process, which many threads may ask.
std::unique_ptr<Engine> make_graze_engine();

/// Starts an engine of a user's own: a program that speaks the protocol (peers/process/README.md),
/// under the name that it gives itself. `command` is a line for the shell, which is run once for
/// each thread that asks. Throws EngineMissingError, which tells what became of the program, if it
/// does not say who it is.
EngineEntry start_engine(const std::string& command, const PeerSettings& settings = {});

/// Returns what an engine answers to a case that it holds; nothing if it knows no such question.
using LoadedQuestion = std::function<TimedAnswer()>;

/// Loads a case into an engine. Only graze is asked about shapes other than bodies, meshes and
/// triangles, which become meshes of one triangle. Engine and case must outlive the result. Throws
/// Error if the engine refuses.
LoadedQuestion load_question(const Engine& engine, const Case& query);

/// Loads a case and asks.
std::optional<CaseAnswer> ask(const Engine& engine, const Case& query);

/// Holds the meshes of a case, a triangle as a mesh of one.
struct MeshCase {
  CaseMesh a;
  CaseMesh b;
};
/// Returns the meshes of a case; nothing for other shapes.
std::optional<MeshCase> as_meshes(const Case& query);

/// Holds the two bodies of a case, which must outlive it.
struct BodyCase {
  const CaseBody& a;
  const CaseBody& b;
};
/// Returns the bodies of a case; nothing for other shapes.
std::optional<BodyCase> as_bodies(const Case& query);

}  // namespace graze::compare
