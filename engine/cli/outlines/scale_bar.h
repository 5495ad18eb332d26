#pragma once

#include <string>

namespace graze::cli {

/// Holds a round length, and what it is called.
struct ScaleBar {
  double length = 0;  ///< metres
  std::string label;  ///< "2 mm"
};

/// Returns the longest of 1, 2 and 5 times a power of ten metres that is at most `most`, and a
/// length of 0 unless that is positive and finite.
ScaleBar scale_bar(double most);

}  // namespace graze::cli
