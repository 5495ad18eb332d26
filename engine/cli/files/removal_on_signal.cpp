#include <graze/engine/cli/files/removal_on_signal.h>
#include <graze/engine/files/temporary_file.h>

#include <csignal>

namespace graze::cli {
namespace {

/// Removes temporary files and ends the program. The default action is back when this begins
/// (SA_RESETHAND), and the signal is held until it ends: then it comes again, and whoever waits for
/// the program sees what ended it.
void remove_and_end(int signal) {
  files::remove_temporary_files();
  raise(signal);
}

}  // namespace

void remove_temporary_files_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    struct sigaction action = {};
    action.sa_handler = remove_and_end;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace graze::cli
