#include <graze/engine/cli/view/shown_pages.h>

#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/recordings/recorded_pieces.h>
#include <graze/engine/files/source.h>
#include <graze/engine/world/compound.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace graze::cli {
namespace {

/// Holds a piece of a body on the page.
struct ShownPiece {
  ViewBody body;
  Pose pose;
  std::optional<std::uint32_t> part;  ///< the part of a compound
};

/// Holds the page, and what of the recording is on it.
class RecordingPage {
 public:
  RecordingPage(RecordingReplay& replay, const ViewOptions& options, ShownPage& page)
      : replay_(replay), options_(options), page_(page), bodies_(replay.reader().start()) {}

  void show_all(std::size_t total) {
    Progress progress("updates:", total, {.is_forced = options_.has_progress, .has_rows = false});
    for (const BodyPair& pair : replay_.reader().start().touching)
      touching_.insert(pair);
    while (replay_.advance()) {
      note(replay_.step());
      progress.update(replay_.step().number + 1);
      if (is_shown(replay_.step())) show(replay_.step());
    }
  }

 private:
  void note(const RecordedStep& step) {
    bodies_.note(step.changes);
    names_.note(step.changes);
    for (const RecordedChange& change : step.changes) {
      const auto* restored = std::get_if<WorldRestored>(&change);
      if (restored == nullptr) continue;
      touching_.clear();
      touching_.insert(restored->state->touching.begin(), restored->state->touching.end());
      are_contacts_known_ = false;
    }
    for (const BodyPair& pair : step.answers.ended)
      touching_.erase(pair);
    touching_.insert(step.answers.begun.begin(), step.answers.begun.end());
    note_contacts();
  }

  /// Takes contacts of bodies that moved, which keep them until they move again: to ask for those
  /// of all bodies in each update would cost what lies still, too.
  void note_contacts() {
    if (!are_contacts_known_) return take_all_contacts();
    const WorldUpdate& update = replay_.update();
    for (const auto& gone : {update.ended, update.ended_near, update.moved})
      for (const BodyPair& pair : gone)
        contacts_.erase(pair);
    for (const BodyContact& contact : update.contacts)
      contacts_.erase(contact.pair);
    for (const BodyContact& contact : update.contacts)
      contacts_.emplace(contact.pair, contact.manifold);
  }

  void take_all_contacts() {
    contacts_.clear();
    for (const BodyContact& contact : replay_.world().contacts())
      contacts_.emplace(contact.pair, contact.manifold);
    are_contacts_known_ = replay_.reader().head().world.contacts;
  }

  /// True for a step that is shown: one where something begins or ends, or where this graze says
  /// otherwise, is never left out.
  bool is_shown(const RecordedStep& step) const {
    return step.number % options_.every == 0 || !step.answers.begun.empty() ||
           !step.answers.ended.empty() || replay_.difference();
  }

  const std::vector<ShownPiece>& pieces(const RecordedLook& look) {
    const auto [known, is_new] = pieces_.try_emplace(look);
    if (!is_new) return known->second;
    for (const RecordedPiece& piece : pieces_of(*replay_.reader().shape(look.shape))) {
      std::string name = names_.of(look.id);
      if (piece.part) name += fmt::format(", part {}", *piece.part);
      known->second.push_back(
          {page_.view.add(piece.shape, {.name = name}), piece.pose, piece.part});
    }
    return known->second;
  }

  ViewFrame frame_of(const RecordedStep& step) const {
    const RecordingHead& head = replay_.reader().head();
    ViewFrame frame = {.label = fmt::format("update {}", step.number),
                       .state = touching_.empty() ? ViewState::Clear : ViewState::Touching,
                       .facts = {{"pairs that touch", static_cast<double>(touching_.size())}}};
    if (head.seconds_per_update > 0) {
      frame.label =
          fmt::format("t = {:.6g} s, {}",
                      static_cast<double>(step.number) * head.seconds_per_update, frame.label);
    }
    // Before the first update there was nothing.
    frame.is_change =
        step.number > 0 && (!step.answers.begun.empty() || !step.answers.ended.empty());
    if (frame.is_change)
      frame.facts.insert(frame.facts.end(),
                         {{"begun", static_cast<double>(step.answers.begun.size())},
                          {"ended", static_cast<double>(step.answers.ended.size())}});
    if (const auto& difference = replay_.difference()) {
      frame.note = fmt::format("This graze says otherwise: {}: recorded {}, now {}.",
                               difference->what, difference->first, difference->second);
    }
    return frame;
  }

  void show(const RecordedStep& step) {
    page_.view.begin_frame(frame_of(step));
    ++page_.frames;
    if (!touching_.empty()) ++page_.touching;
    const World& world = replay_.world();
    for (const auto& [id, shape] : bodies_.shapes()) {
      const Pose& pose = world.pose(id);
      for (const ShownPiece& piece : pieces({id, shape}))
        page_.view.place(piece.body, placed_part(pose, piece.pose));
    }
    std::set<BodyPair> without = touching_;  // pairs without contacts
    for (const auto& [pair, manifold] : contacts_) {
      for (const ShapeContact& point : manifold)
        page_.view.add_contact(point.point, point.normal, std::max(0.0, point.depth));
      // Some are near, and do not touch.
      if (!touching_.contains(pair)) continue;
      add_pair(pair, manifold.part_a(), manifold.part_b());
      without.erase(pair);
    }
    for (const BodyPair& pair : without)
      add_pair(pair, 0, 0);
  }

  /// Returns the piece of a body that is this part of it, else its first; none where there is
  /// nothing.
  std::optional<ViewBody> piece_of(BodyId id, std::uint32_t part) {
    const auto shape = bodies_.shapes().find(id);
    if (shape == bodies_.shapes().end()) return std::nullopt;
    const std::vector<ShownPiece>& all = pieces({id, shape->second});
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const ShownPiece& piece) { return piece.part == part; });
    if (all.empty()) return std::nullopt;
    return found == all.end() ? all.front().body : found->body;
  }

  void add_pair(const BodyPair& pair, std::uint32_t part_a, std::uint32_t part_b) {
    const auto a = piece_of(pair.a, part_a), b = piece_of(pair.b, part_b);
    if (a && b) page_.view.add_pair(*a, *b);
  }

  RecordingReplay& replay_;
  const ViewOptions& options_;
  ShownPage& page_;
  RecordedBodies bodies_;
  RecordedNames names_;
  std::set<BodyPair> touching_;
  std::multimap<BodyPair, Manifold> contacts_;  ///< a pair of bodies with parts may have several
  bool are_contacts_known_ = false;             ///< true if those of before this update are known
  std::map<RecordedLook, std::vector<ShownPiece>> pieces_;
};

/// Says what reading a recording to its end tells.
struct RecordingLength {
  std::size_t updates = 0;
  bool is_complete = false;
};

RecordingLength length_of(const std::string& file) {
  RecordingReader reader{std::filesystem::path(file)};
  RecordingLength length;
  while (reader.next() != nullptr)
    ++length.updates;
  length.is_complete = reader.end() == RecordingEnd::Complete;
  return length;
}

}  // namespace

ShownPage show_recording(const ViewOptions& options) {
  const std::string& file = options.files.front();
  const RecordingLength length = length_of(file);
  if (length.updates == 0)
    throw RecordingError(mesh_io::printable(file) + ": has no update to show");
  RecordingReplay replay(RecordingReader{std::filesystem::path(file)});
  const RecordingHead& head = replay.reader().head();
  ViewSettings settings = {.title = options.title.empty()
                                        ? std::filesystem::path(file).filename().string()
                                        : options.title};
  if (!head.note.empty()) settings.notes.push_back(head.note);
  settings.notes.push_back(fmt::format(
      "A run that graze {} recorded. Where pairs begin and end is what it said; contacts are asked "
      "anew, where bodies then stood.",
      head.engine_version));
  if (options.every > 1) {
    settings.notes.push_back(fmt::format(
        "Shown are one update of {} and each in which something begins or ends; the others of all "
        "{} are left out.",
        options.every, length.updates));
  }
  if (!length.is_complete)
    settings.notes.emplace_back(
        "The recording is cut off at its end: its writer was stopped, or writes still.");
  ShownPage page(settings);
  RecordingPage shown(replay, options, page);
  shown.show_all(length.updates);
  return page;
}

}  // namespace graze::cli
