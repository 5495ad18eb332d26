#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/compare/peers/process/peer_load.h>
#include <graze/engine/compare/peers/process/process_engine.h>
#include <graze/engine/compare/peers/process/protocol.h>

#include <algorithm>
#include <limits>
#include <system_error>
#include <utility>

namespace graze::compare {
namespace {

using cases::JsonCursor;
using Clock = std::chrono::steady_clock;

/// Returns the engine's own time, if it tells that, or else what passed here.
TimedAnswer::Time time_of(const JsonCursor& reply, Clock::time_point start) {
  if (reply.has("us")) return TimedAnswer::Time(std::max(reply.member("us").number(), 0.0));
  return Clock::now() - start;
}

class PeerPair : public LoadedPair {
 public:
  PeerPair(std::shared_ptr<PeerPool> pool, PeerHistory history, const Mesh& mesh_a,
           const Mesh& mesh_b)
      : hello_(pool->hello()),
        mesh_a_(mesh_a),
        mesh_b_(mesh_b),
        load_(std::move(pool), load_text(mesh_a, mesh_b), history) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    return timed_answer(question, pose_a, pose_b).answer;
  }

  TimedAnswer timed_answer(const Question& question, const Pose& pose_a,
                           const Pose& pose_b) const override {
    const bool is_asked = question.ask == Ask::Any || question.ask == Ask::Pairs ||
                          question.ask == Ask::Distance || question.ask == Ask::Within ||
                          question.ask == Ask::Contacts || question.ask == Ask::Separation ||
                          question.ask == Ask::FirstContact || question.ask == Ask::Free;
    if (!question.is_plain() || !is_asked || !hello_.may_know(question.ask)) return {};
    const Case query{.note = "",
                     .ask = question.ask,
                     .settings = question.settings,
                     .a = CaseMesh(mesh_a_, pose_a),
                     .b = CaseMesh(mesh_b_, pose_b),
                     .answer = std::nullopt,
                     .answered_by = {}};
    TimedAnswer result;
    const auto start = Clock::now();
    load_.request(question_text(question, pose_a, pose_b), [&](const JsonCursor& reply) {
      reply.require_keys({"id", "answer", "us"});
      result.answer = cases::read_answer(reply.member("answer"), query);
      result.time = time_of(reply, start);
    });
    return result;
  }

 private:
  PeerHello hello_;
  Mesh mesh_a_;
  Mesh mesh_b_;
  mutable PeerLoad load_;
};

/// Keeps the texts of shapes. Shapes that no text gives back bit for bit are not asked about: the
/// engine would be blamed for another shape.
class ShapeTexts {
 public:
  explicit ShapeTexts(std::span<const Shape> shapes) {
    for (const Shape& shape : shapes) {
      std::optional<std::string> text = shape_text(shape);
      places_.push_back(text ? std::optional(texts_.size()) : std::nullopt);
      if (text) texts_.push_back(*std::move(text));
    }
  }
  const std::vector<std::string>& texts() const { return texts_; }
  const std::optional<std::size_t>& place(std::size_t shape) const { return places_[shape]; }

 private:
  std::vector<std::string> texts_;
  std::vector<std::optional<std::size_t>> places_;
};

class PeerShapes : public LoadedShapes {
 public:
  PeerShapes(std::shared_ptr<PeerPool> pool, PeerHistory history, std::span<const Shape> shapes)
      : hello_(pool->hello()),
        texts_(shapes),
        load_(std::move(pool), load_text(texts_.texts()), history) {}

  std::optional<bool> intersects(std::size_t shape_a, const Pose& pose_a, std::size_t shape_b,
                                 const Pose& pose_b) const override {
    const std::array<PlacedShape, 2> bodies = {{{shape_a, pose_a}, {shape_b, pose_b}}};
    const std::array<std::pair<std::size_t, std::size_t>, 1> pairs = {{{0, 1}}};
    const ShapesAnswer answer = intersect_all(bodies, pairs);
    if (!answer.pairs.front().fault.empty()) throw EngineFailure(answer.pairs.front().fault);
    return answer.pairs.front().says;
  }

  /// Asks in lots, so that each has its time limit to itself, unless the engine wants to see all.
  ShapesAnswer intersect_all(std::span<const PlacedShape> bodies, BodyPairs pairs) const override {
    constexpr std::size_t kLot = 64;
    const std::size_t lot = hello_.answers_scenes ? std::max(pairs.size(), kLot) : kLot;
    ShapesAnswer all;
    if (!hello_.may_know(Ask::Any)) {
      all.pairs.resize(pairs.size());
      return all;
    }
    all.pairs.reserve(pairs.size());
    for (std::size_t at = 0; at < pairs.size(); at += lot)
      add_lot(bodies, pairs.subspan(at, std::min(lot, pairs.size() - at)), all);
    return all;
  }

  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                   const PlacedShape& b) const override {
    const std::optional<std::size_t>& place_a = texts_.place(a.shape);
    const std::optional<std::size_t>& place_b = texts_.place(b.shape);
    if (!place_a || !place_b || !question.is_plain() || !hello_.may_know(question.ask))
      return std::nullopt;
    const CaseBody any_body(Sphere{{0, 0, 0}, 1}, Pose::Identity());  // how an answer is read
    const Case query{.note = "",
                     .ask = question.ask,
                     .settings = question.settings,
                     .a = any_body,
                     .b = any_body,
                     .answer = std::nullopt,
                     .answered_by = {}};
    std::optional<CaseAnswer> answer;
    load_.request(question_text(question, {*place_a, a.pose}, {*place_b, b.pose}),
                  [&](const JsonCursor& reply) {
                    reply.require_keys({"id", "answer", "us"});
                    answer = cases::read_answer(reply.member("answer"), query);
                  });
    return answer;
  }

 private:
  /// Asks about a lot, and one by one if the engine fails on all of them together.
  void add_lot(std::span<const PlacedShape> bodies, BodyPairs pairs, ShapesAnswer& all) const {
    try {
      add_answers(bodies, pairs, all);
      return;
    } catch (const EngineFailure& failure) {
      if (pairs.size() == 1) {
        all.pairs.push_back({std::nullopt, failure.what()});
        return;
      }
    }
    for (std::size_t i = 0; i < pairs.size(); ++i)
      add_lot(bodies, pairs.subspan(i, 1), all);
  }

  /// Adds all answers, or none.
  void add_answers(std::span<const PlacedShape> bodies, BodyPairs pairs, ShapesAnswer& all) const {
    std::vector<PlacedShape> named;
    std::vector<std::pair<std::size_t, std::size_t>> asked;
    std::vector<std::optional<std::size_t>> places(bodies.size());
    const auto name = [&](std::size_t body) {
      if (!places[body]) {
        places[body] = named.size();
        named.push_back({*texts_.place(bodies[body].shape), bodies[body].pose});
      }
      return *places[body];
    };
    std::vector<ShapesAnswer::Pair> answers(pairs.size());
    std::vector<std::size_t> owners;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [a, b] = pairs[i];
      if (!texts_.place(bodies[a].shape) || !texts_.place(bodies[b].shape)) continue;
      asked.emplace_back(name(a), name(b));
      owners.push_back(i);
    }
    TimedAnswer::Time time{0};
    const auto start = Clock::now();
    const auto read = [&](const JsonCursor& reply) {
      reply.require_keys({"id", "answers", "us"});
      const JsonCursor list = reply.member("answers");
      list.require_size(owners.size());
      for (std::size_t i = 0; i < owners.size(); ++i) {
        const JsonCursor item = list.item(i);
        if (!item.is_null()) answers[owners[i]].says = item.boolean();
      }
      time = time_of(reply, start);
    };
    if (!asked.empty()) load_.request(question_text(named, asked), read);
    all.pairs.insert(all.pairs.end(), answers.begin(), answers.end());
    all.time += time;
  }

  PeerHello hello_;
  ShapeTexts texts_;
  mutable PeerLoad load_;
};

class ProcessEngine : public Engine {
 public:
  ProcessEngine(std::shared_ptr<PeerPool> pool, PeerHistory history)
      : pool_(std::move(pool)), history_(history) {}

  CaseWitness name() const override { return pool_->hello().witness; }
  std::optional<double> tolerance() const override { return pool_->hello().tolerance; }
  bool answers_scenes() const override { return pool_->hello().answers_scenes; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<PeerPair>(pool_, history_, mesh_a, mesh_b);
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<PeerShapes>(pool_, history_, shapes);
  }
  std::unique_ptr<Engine> alone() const override {
    if (history_ == PeerHistory::None) return nullptr;
    return std::make_unique<ProcessEngine>(pool_, PeerHistory::None);
  }

 private:
  std::shared_ptr<PeerPool> pool_;
  PeerHistory history_;
};

/// Returns the program beside the running one, as it is installed, or where it was built: programs
/// of tests lie in folders of their own.
std::filesystem::path peer_program() {
  std::error_code ignored;
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const std::filesystem::path beside = here.parent_path() / "graze-peer";
  const std::filesystem::path built = GRAZE_PEER_PROGRAM;
  return !std::filesystem::exists(beside, ignored) && std::filesystem::exists(built, ignored)
             ? built
             : beside;
}

}  // namespace

std::unique_ptr<Engine> make_process_engine(PeerProgram program) {
  return std::make_unique<ProcessEngine>(std::make_shared<PeerPool>(std::move(program)),
                                         PeerHistory::Shared);
}

PeerProgram built_in_peer(const std::string& name, const PeerSettings& settings) {
  const std::filesystem::path program =
      settings.program.empty() ? peer_program() : settings.program;
  return {.name = name, .command = {program.string(), name}, .timeout = settings.timeout};
}

PeerProgram program_of_command(const std::string& command, const PeerSettings& settings) {
  return {.name = "", .command = {"/bin/sh", "-c", command}, .timeout = settings.timeout};
}

}  // namespace graze::compare
