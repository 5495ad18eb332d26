#include <graze/engine/cli/commands/commands.h>

namespace graze::cli {

void add_view_command(CLI::App&, Action&) {}  // built without pages

}  // namespace graze::cli
