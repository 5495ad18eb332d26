#include <graze/bvh/error.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/compare/run/case_comparison.h>
#include <graze/engine/files/source.h>

#include <fmt/format.h>
#include <algorithm>

namespace graze::cli {
namespace {

using compare::EngineEntry;

std::vector<bool> chosen(std::string_view names, std::span<const EngineEntry> engines) {
  std::vector<bool> is_chosen(engines.size());
  for (std::size_t i = 0; i < engines.size(); ++i)
    is_chosen[i] = names.empty() && !engines[i].is_only_if_named;
  while (!names.empty()) {
    const std::size_t end = std::min(names.find(','), names.size());
    const std::string_view name = names.substr(0, end);
    names.remove_prefix(std::min(end + 1, names.size()));
    const auto at = std::find_if(engines.begin(), engines.end(),
                                 [&](const EngineEntry& entry) { return entry.name == name; });
    if (at == engines.end()) {
      std::string known;
      for (const EngineEntry& entry : engines)
        known += (known.empty() ? "" : ", ") + entry.name;
      throw UsageError("--engines: there is no engine " + mesh_io::quoted(name) + ", but " + known);
    }
    if (at->engine == nullptr) {
      throw UsageError(
          fmt::format("--engines: {} was not found when this command was built", name));
    }
    is_chosen[static_cast<std::size_t>(at - engines.begin())] = true;
  }
  for (std::size_t i = 0; i < engines.size(); ++i)
    if (engines[i].name == "graze" || engines[i].is_users_own) is_chosen[i] = true;
  return is_chosen;
}

class Borrowed : public compare::Engine {
 public:
  explicit Borrowed(const compare::Engine& engine) : engine_(engine) {}
  CaseWitness name() const override { return engine_.name(); }
  std::optional<double> tolerance() const override { return engine_.tolerance(); }
  std::optional<std::vector<Ask>> questions() const override { return engine_.questions(); }
  std::unique_ptr<compare::LoadedPair> load(const Mesh& a, const Mesh& b) const override {
    return engine_.load(a, b);
  }
  std::unique_ptr<compare::LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return engine_.load_shapes(shapes);
  }
  bool answers_scenes() const override { return engine_.answers_scenes(); }
  std::unique_ptr<compare::Engine> alone() const override { return engine_.alone(); }

 private:
  const compare::Engine& engine_;
};

/// Names who gave recorded answers: nothing can be asked of it.
class RecordedEngine : public compare::Engine {
 public:
  explicit RecordedEngine(const compare::AnswerFile& file)
      : witness_(file.witness), tolerance_(file.tolerance) {}
  CaseWitness name() const override { return witness_; }
  std::optional<double> tolerance() const override { return tolerance_; }
  std::unique_ptr<compare::LoadedPair> load(const Mesh&, const Mesh&) const override {
    throw InputError("recorded answers are heard, not asked for");
  }

 private:
  CaseWitness witness_;
  std::optional<double> tolerance_;
};

/// True for a name that no engine may give itself.
bool is_reserved(const std::string& name) {
  return name == compare::kRecorded || name == "world";
}

}  // namespace

std::vector<EngineEntry> engines_with(const compare::PeerSettings& settings,
                                      std::span<const std::string> commands) {
  std::vector<EngineEntry> engines = compare::all_engines(settings);
  for (const std::string& command : commands) {
    const auto refuse = [&](const std::string& why) {
      throw UsageError("--engine-command " + mesh_io::quoted(command) + ": " + why);
    };
    try {
      engines.push_back(compare::start_engine(command, settings));
    } catch (const compare::EngineMissingError& error) {
      refuse(error.what());
    }
    const std::string& name = engines.back().name;
    const bool is_taken = is_reserved(name) ||
                          std::any_of(engines.begin(), engines.end() - 1,
                                      [&](const EngineEntry& entry) { return entry.name == name; });
    if (is_taken) refuse("calls itself " + mesh_io::quoted(name) + ", as another engine does");
    if (name.empty() || name.find(',') != name.npos)
      refuse("calls itself " + mesh_io::quoted(name) + ", which --engines could not name");
  }
  return engines;
}

std::vector<EngineEntry> with_more_engines(std::span<const EngineEntry> engines,
                                           std::vector<EngineEntry> more) {
  std::vector<EngineEntry> all;
  all.reserve(engines.size() + more.size());
  for (const EngineEntry& entry : engines) {
    all.push_back(
        {entry.name, nullptr, entry.is_users_own, entry.recorded, entry.is_only_if_named});
    if (entry.engine) all.back().engine = std::make_unique<Borrowed>(*entry.engine);
  }
  for (EngineEntry& entry : more) {
    const bool is_taken = std::any_of(
        all.begin(), all.end(), [&](const EngineEntry& each) { return each.name == entry.name; });
    if (is_taken) {
      throw UsageError("--engine-command: an engine calls itself " + mesh_io::quoted(entry.name) +
                       ", as another engine does");
    }
    all.push_back(std::move(entry));
  }
  return all;
}

Field::Field(std::span<const EngineEntry> engines, std::string_view names) {
  const std::vector<bool> is_chosen = chosen(names, engines);
  for (std::size_t i = 0; i < engines.size(); ++i) {
    if (!is_chosen[i] || engines[i].engine == nullptr) continue;
    engines_.push_back({engines[i].name, std::make_unique<Borrowed>(*engines[i].engine)});
  }
}

void Field::add_answers(std::span<const std::string> files, const compare::AnswersWanted& wanted) {
  for (const std::string& path : files) {
    const compare::AnswerFile file = compare::read_answer_file(path, wanted);
    const auto is_taken = [&](const std::string& name) {
      return is_reserved(name) || std::any_of(engines_.begin(), engines_.end(),
                                              [&](const EngineEntry& e) { return e.name == name; });
    };
    std::string name = file.witness.engine;
    if (is_taken(name)) name += "@" + file.witness.version;
    const std::string place = "--answers: " + mesh_io::printable(path) + ": ";
    if (is_taken(name)) {
      throw UsageError(place + "is of " + mesh_io::quoted(name) + ", as another engine is");
    }
    if (name.empty() || name.find(',') != name.npos) {
      throw UsageError(place + "is of " + mesh_io::quoted(name) + ", which is no name");
    }
    engines_.push_back({name, std::make_unique<RecordedEngine>(file), true, file.answers});
  }
}

}  // namespace graze::cli
