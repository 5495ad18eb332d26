#include <graze/engine/cli/output/interruption.h>

#include <atomic>

namespace graze::cli {
namespace {

std::atomic<bool> requested = false;

/// Says what a second signal does; it is written before the handler is there, and read by that
/// alone.
struct sigaction next = {};

static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may use nothing else");

}  // namespace

Interruption::Interruption() : before_() {
  requested = false;
  sigaction(SIGINT, nullptr, &before_);
  if (before_.sa_handler == SIG_IGN) return;
  struct sigaction action = {};
  next = before_;
  action.sa_handler = [](int signal) {
    requested = true;
    sigaction(signal, &next, nullptr);
  };
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
}

Interruption::~Interruption() {
  sigaction(SIGINT, &before_, nullptr);
}

bool Interruption::is_requested() {
  return requested;
}

}  // namespace graze::cli
