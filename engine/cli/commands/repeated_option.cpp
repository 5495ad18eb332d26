#include <graze/engine/cli/commands/commands.h>

#include <CLI/CLI.hpp>

namespace graze::cli {

void add_repeated_option(CLI::App& command, const std::string& name,
                         std::vector<std::string>& values, const std::string& description,
                         const std::string& type) {
  command.add_option(name, values, description + "; may be repeated")
      ->type_name(type)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace graze::cli
