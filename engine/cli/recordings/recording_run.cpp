#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/recordings/recording_file.h>
#include <graze/engine/cli/recordings/recording_run.h>
#include <graze/engine/files/source.h>
#include <graze/engine/record/replay_recording.h>
#include <graze/engine/version.h>

#include <fmt/format.h>

namespace graze::cli {
namespace {

using cases::json_string;

/// Holds what came of the comparison.
struct Comparison {
  std::size_t updates = 0;
  std::size_t differing = 0;
  std::optional<RecordingDifference> first = {};
  std::string pair = {};  ///< the names of its pair
  std::string json_pair = {};
  bool is_complete = true;
  bool is_input = false;  ///< true if what was done differs, not what was said
};

void note(const RecordingDifference& difference, const RecordedNames& names, Comparison& so_far) {
  ++so_far.differing;
  if (so_far.first) return;
  so_far.first = difference;
  if (!difference.pair) return;
  const std::string a = names.of(difference.pair->a), b = names.of(difference.pair->b);
  so_far.pair = fmt::format(" of {} and {}", mesh_io::quoted(a), mesh_io::quoted(b));
  so_far.json_pair = fmt::format("[{},{}]", json_string(a), json_string(b));
}

Comparison repeat(RecordingReader reader, const RecordingOptions& options) {
  Comparison so_far;
  RecordedNames names;
  Progress progress("updates:", 0, {.is_forced = options.has_progress, .has_rows = false});
  RecordingReplay replay(std::move(reader),
                         {.threads = options.threads, .has_work = options.has_work});
  while (replay.advance()) {
    names.note(replay.step().changes);
    ++so_far.updates;
    if (replay.difference()) note(*replay.difference(), names, so_far);
    progress.update(so_far.updates);
  }
  so_far.is_complete = replay.reader().end() == RecordingEnd::Complete;
  return so_far;
}

std::optional<RecordingDifference> difference_of_starts(const RecordingReader& s,
                                                        const RecordingReader& t) {
  const std::vector<RecordedChange> first{
      WorldRestored{std::make_shared<const RecordedState>(s.start())}};
  const std::vector<RecordedChange> second{
      WorldRestored{std::make_shared<const RecordedState>(t.start())}};
  std::optional<RecordingDifference> found = first_difference(0, first, second);
  if (found) found->what = "worlds at the beginning", found->first = found->second = "other bodies";
  return found;
}

/// Keeps the contacts that both have.
void keep_common(const RecordingHead& s, const RecordingHead& t, RecordedAnswers& first,
                 RecordedAnswers& second) {
  if (s.contacts != t.contacts) first.contacts.clear(), second.contacts.clear();
  if (s.world.contacts != t.world.contacts) first.all_contacts = second.all_contacts = 0;
}

Comparison hold_against(RecordingReader reader, const RecordingOptions& options) {
  Comparison so_far;
  RecordedNames names;
  RecordingReader other(*options.against);
  Progress progress("updates:", 0, {.is_forced = options.has_progress, .has_rows = false});
  if (const auto start = difference_of_starts(reader, other)) {
    note(*start, names, so_far);
    so_far.is_input = true;
    return so_far;
  }
  while (true) {
    const RecordedStep* first = reader.next();
    const RecordedStep* second = other.next();
    so_far.is_complete =
        reader.end() != RecordingEnd::CutOff && other.end() != RecordingEnd::CutOff;
    if (first == nullptr || second == nullptr) {
      if ((first == nullptr) == (second == nullptr) || !so_far.is_complete) return so_far;
      const auto word = [](const RecordedStep* step) {
        return std::string(step == nullptr ? "ended" : "goes on");
      };
      note({so_far.updates, "updates", std::nullopt, word(first), word(second)}, names, so_far);
      so_far.is_input = true;
      return so_far;
    }
    names.note(first->changes);
    if (const auto changed = first_difference(so_far.updates, first->changes, second->changes)) {
      note(*changed, names, so_far);
      so_far.is_input = so_far.differing == 1;
      return so_far;
    }
    RecordedAnswers said = first->answers, other_said = second->answers;
    keep_common(reader.head(), other.head(), said, other_said);
    if (!options.has_work) said.work.reset();
    const auto answered = first_difference(so_far.updates, said, other_said);
    ++so_far.updates;
    if (answered) note(*answered, names, so_far);
    progress.update(so_far.updates);
  }
}

std::string time_of(const RecordingHead& head, std::size_t update) {
  if (head.seconds_per_update == 0) return "";
  return fmt::format(", t = {:.6g} s", static_cast<double>(update) * head.seconds_per_update);
}

std::string text_of(const RecordingOptions& options, const RecordingHead& head,
                    const Comparison& found) {
  const std::string second = options.against ? mesh_io::printable(*options.against)
                                             : fmt::format("now, graze {}, threads {}",
                                                           library_version(), options.threads);
  std::string text = fmt::format("{}: by graze {}, {} {}{}\n", mesh_io::printable(options.file),
                                 mesh_io::printable(head.engine_version), found.updates,
                                 found.updates == 1 ? "update" : "updates",
                                 found.is_complete ? "" : ", then cut off");
  if (!found.first) return text + "no difference: " + second + "\n";
  const RecordingDifference& first = *found.first;
  return text + fmt::format("update {}{}: {}{}\n  {}: {}\n  {}: {}\n{}", first.update,
                            time_of(head, first.update), first.what, found.pair, "recorded",
                            first.first, second, first.second,
                            found.is_input ? "what was done differs: there the two runs part\n"
                                           : fmt::format("{} updates differ\n", found.differing));
}

std::string json_of(const RecordingOptions& options, const RecordingHead& head,
                    const Comparison& found) {
  std::string line = fmt::format(
      "{{\"file\":{},\"engine\":{},\"against\":{},\"updates\":{},\"complete\":{},\"differing\":{}",
      json_string(options.file), json_string(head.engine_version),
      options.against ? json_string(*options.against) : "null", found.updates, found.is_complete,
      found.differing);
  if (!found.first) return line + "}\n";
  const RecordingDifference& first = *found.first;
  line += fmt::format(",\"difference\":{{\"update\":{},\"what\":{}", first.update,
                      json_string(first.what));
  if (head.seconds_per_update != 0) {
    line += fmt::format(",\"time\":{}", cases::json_plain_number(static_cast<double>(first.update) *
                                                                 head.seconds_per_update));
  }
  if (!found.json_pair.empty()) line += ",\"pair\":" + found.json_pair;
  return line + fmt::format(",\"is_input\":{},\"first\":{},\"second\":{}}}}}\n", found.is_input,
                            json_string(first.first), json_string(first.second));
}

}  // namespace

ExitCode run_recording(const RecordingOptions& options, Output& output) {
  RecordingReader reader(options.file);
  const RecordingHead head = reader.head();
  const Comparison found = options.against ? hold_against(std::move(reader), options)
                                           : repeat(std::move(reader), options);
  output.write(options.is_json ? json_of(options, head, found) : text_of(options, head, found));
  return found.first ? ExitCode::GrazeWrong : ExitCode::Answered;
}

}  // namespace graze::cli
