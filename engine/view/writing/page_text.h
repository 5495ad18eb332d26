#pragma once

#include <string>

namespace graze::view {

/// Returns the page without its data, as page/built/page.html has it: {{title}} and {{data}} stand
/// where these go. Its source is written by the build (engine/package/embed_text.cmake).
std::string page_text();

}  // namespace graze::view
