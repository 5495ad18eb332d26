#include <graze/engine/files/temporary_file.h>

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

namespace graze::files {
namespace {

namespace fs = std::filesystem;

/// Holds a path for a handler, which may read a slot at any time: only while `state` is kNamed is
/// the path whole.
struct Slot {
  static constexpr int kFree = 0;
  static constexpr int kTaken = 1;
  static constexpr int kNamed = 2;

  std::atomic<int> state = kFree;
  std::atomic<pid_t> owner = 0;
  std::array<char, PATH_MAX> path;
};
// A signal handler may use nothing else.
static_assert(decltype(Slot::state)::is_always_lock_free);
static_assert(decltype(Slot::owner)::is_always_lock_free);

/// Files are written one at a time, or a few; one that finds no slot is not removed by a handler.
std::array<Slot, 16> slots;

[[noreturn]] void throw_errno() {
  throw std::system_error(errno, std::generic_category());
}

/// Returns an absolute name: a handler must find the file from wherever the program is then.
std::string absolute_name(const fs::path& path) {
  std::error_code ignored;
  const fs::path whole = fs::absolute(path, ignored);
  return ignored ? path.string() : whole.string();
}

int take_slot(const fs::path& path) {
  const std::string name = absolute_name(path);
  if (name.size() >= PATH_MAX) return -1;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    int expected = Slot::kFree;
    if (!slots[i].state.compare_exchange_strong(expected, Slot::kTaken)) continue;
    std::memcpy(slots[i].path.data(), name.c_str(), name.size() + 1);
    slots[i].owner = getpid();
    slots[i].state = Slot::kNamed;
    return static_cast<int>(i);
  }
  return -1;
}

void free_slot(int slot) {
  if (slot >= 0) slots[static_cast<std::size_t>(slot)].state = Slot::kFree;
}

std::string random_name() {
  std::uint64_t bits = 0;
  if (getrandom(&bits, sizeof bits, 0) != sizeof bits) throw_errno();
  std::array<char, 40> name;
  std::snprintf(name.data(), name.size(), ".graze-%016llx.part",
                static_cast<unsigned long long>(bits));
  return name.data();
}

/// Gives the file the owner and rights of the old one. If it cannot have that owner it keeps ours,
/// and no right to be run as its owner.
void adopt(int descriptor, const struct stat& old) {
  const bool is_adopted = fchown(descriptor, old.st_uid, old.st_gid) == 0;
  const mode_t mode = old.st_mode & (is_adopted ? 07777 : 0777);
  if (fchmod(descriptor, mode) != 0) throw_errno();
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& target, const std::optional<struct stat>& old) {
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
  const fs::path folder = target.parent_path();
  while (descriptor_ < 0) {
    path_ = folder / random_name();
    // The name is listed first: no moment is left in which a signal would find the file and not its
    // name.
    slot_ = take_slot(path_);
    descriptor_ = open(path_.c_str(), kFlags, old ? 0600 : 0666);
    if (descriptor_ >= 0) break;
    const int error = errno;
    free_slot(std::exchange(slot_, -1));
    if (error != EEXIST && error != EINTR) {
      throw std::system_error(error, std::generic_category());
    }
  }
  is_there_ = true;
  try {
    if (old) adopt(descriptor_, *old);
  } catch (...) {
    remove();
    throw;
  }
}

TemporaryFile::~TemporaryFile() {
  remove();
}

void TemporaryFile::remove() {
  if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
  if (std::exchange(is_there_, false)) unlink(path_.c_str());
  free_slot(std::exchange(slot_, -1));
}

int TemporaryFile::take_descriptor() {
  return std::exchange(descriptor_, -1);
}

void TemporaryFile::replace(const fs::path& target) {
  if (rename(path_.c_str(), target.c_str()) != 0) throw_errno();
  is_there_ = false;
  free_slot(std::exchange(slot_, -1));
}

void remove_temporary_files() noexcept {
  const int error = errno;
  const pid_t here = getpid();
  for (Slot& slot : slots) {
    if (slot.state == Slot::kNamed && slot.owner == here) unlink(slot.path.data());
  }
  errno = error;
}

}  // namespace graze::files
