#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/files/output_file.h>
#include <graze/engine/record/write/journal.h>

#include <cmath>
#include <utility>

namespace graze {
namespace {

/// Returns a sink into a file that takes the place of the old one with what comes first, and grows
/// from then on.
std::function<void(std::string_view)> sink_to(const std::filesystem::path& path) {
  return [file = std::make_shared<files::OutputFile>(path)](std::string_view bytes) {
    file->append(bytes);
    file->publish();
  };
}

}  // namespace

WorldRecorder::WorldRecorder(World& world, const std::filesystem::path& file,
                             const WorldRecorderSettings& settings)
    : WorldRecorder(world, sink_to(file), settings) {}

WorldRecorder::WorldRecorder(World& world, std::function<void(std::string_view)> sink,
                             const WorldRecorderSettings& settings) {
  bvh::in_standard_arithmetic([&] {
    if (sink == nullptr) throw InputError("record: nobody takes the bytes");
    if (!(settings.seconds_per_update >= 0) || !std::isfinite(settings.seconds_per_update))
      throw InputError("record: seconds per update are not finite and at least 0");
    auto journal = std::make_shared<Journal>(std::move(sink), settings);
    WorldJournalAccess::attach(world, journal);
    try {
      journal->begin(WorldJournalAccess::contents(world));
    } catch (...) {
      journal->close();
      throw;
    }
    journal_ = std::move(journal);
  });
}

WorldRecorder::~WorldRecorder() {
  try {
    finish();
  } catch (...) {  // the user did not ask
  }
}

WorldRecorder::WorldRecorder(WorldRecorder&& other) noexcept = default;

WorldRecorder& WorldRecorder::operator=(WorldRecorder&& other) noexcept {
  WorldRecorder old(std::move(*this));
  journal_ = std::move(other.journal_);
  return *this;
}

void WorldRecorder::name(BodyId id, std::string_view name) {
  if (journal_ != nullptr) journal_->name(id, name);
}

std::size_t WorldRecorder::updates() const {
  return journal_ == nullptr ? 0 : journal_->updates();
}

std::uint64_t WorldRecorder::bytes() const {
  return journal_ == nullptr ? 0 : journal_->bytes();
}

bool WorldRecorder::has_failed() const noexcept {
  return journal_ != nullptr && journal_->has_failed();
}

void WorldRecorder::finish() {
  if (journal_ != nullptr && journal_->is_open()) journal_->finish();
}

}  // namespace graze
