#pragma once

#include <string>

namespace graze::cli {

// These functions return the files of that name beside this one. Their sources are written by the
// build.
std::string report_css();
std::string report_js();

}  // namespace graze::cli
