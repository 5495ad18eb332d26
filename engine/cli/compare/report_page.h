#pragma once

#include <string>

namespace graze::cli {

// The files of that name beside this one. Their sources are written by the build.
std::string report_css();
std::string report_js();

}  // namespace graze::cli
