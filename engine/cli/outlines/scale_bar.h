#pragma once

#include <string>

namespace graze::cli {

/// A round length, and what it is called.
struct ScaleBar {
  double length = 0;  ///< metres
  std::string label;  ///< "2 mm"
};

/// The longest of 1, 2 and 5 times a power of ten metres that is at most `most`; nothing (a length
/// of 0) unless that is positive and finite.
ScaleBar scale_bar(double most);

}  // namespace graze::cli
