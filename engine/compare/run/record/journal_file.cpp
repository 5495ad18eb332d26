#include <graze/bvh/error.h>
#include <graze/engine/compare/run/record/journal.h>
#include <graze/engine/files/file_error.h>
#include <graze/engine/files/output_target.h>
#include <graze/engine/files/source.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace graze::compare {
namespace {

constexpr mode_t kForAll = 0666;  // the user's mask takes away from this

/// Turns a file error into what it is to the one who keeps a record.
template <typename Write>
void written(const Write& write) {
  try {
    write();
  } catch (const files::FileError& error) {
    throw CaseError(error.what(), error.place());
  }
}

}  // namespace

JournalFile::JournalFile(const std::filesystem::path& path) : path_(path) {
  files::OutputTarget target;
  written([&] { target = files::find_output_target(path); });
  if (target.kind != files::OutputTarget::Kind::Replaced) {
    written([&] { through_ = std::make_unique<files::OutputFile>(path); });
    return;
  }
  descriptor_ = open(target.path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOCTTY, kForAll);
  if (descriptor_ < 0) fail(errno);
  // A file system without locks has none, and then runs that are started twice by mistake are not
  // noticed.
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor_);
  throw CaseError(mesh_io::printable(path_.string()) + ": another run is writing it");
}

JournalFile::~JournalFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

void JournalFile::fail(int error) const {
  written([&] { files::fail_to_write(path_, error); });
  throw CaseError(mesh_io::printable(path_.string()) + ": cannot be written");
}

/// True if there is a whole head: the part of it that a run had written when it was stopped does
/// not count.
bool JournalFile::has_record(const JournalHead& head) const {
  if (through_) return false;
  const std::string first = sealed(to_json(head)) + "\n";
  std::string there(first.size(), '\0');
  const ssize_t count = pread(descriptor_, there.data(), there.size(), 0);
  if (count < 0) fail(errno);
  there.resize(static_cast<std::size_t>(count));
  return !(there.size() < first.size() && first.starts_with(there));
}

void JournalFile::begin(const JournalHead& head) {
  if (!through_ && (ftruncate(descriptor_, 0) != 0 || lseek(descriptor_, 0, SEEK_SET) != 0)) {
    fail(errno);
  }
  add(to_json(head));
}

void JournalFile::go_on(std::uint64_t bytes) {
  const auto end = static_cast<off_t>(bytes);
  if (ftruncate(descriptor_, end) != 0 || lseek(descriptor_, end, SEEK_SET) != end) fail(errno);
}

void JournalFile::add(std::string_view line) {
  write(sealed(line) + "\n");
}

void JournalFile::write(std::string_view bytes) {
  if (through_) {
    written([&] {
      through_->append(bytes);
      through_->flush();
    });
    return;
  }
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) fail(errno);
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

}  // namespace graze::compare
