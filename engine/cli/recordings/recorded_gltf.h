#pragma once

#include <cstddef>
#include <string>

namespace graze::cli {

/// Holds what came of a recording.
struct RecordedGltf {
  std::string bytes;         ///< the bytes of the file
  std::size_t pictures = 0;  ///< the number of times that it has poses for
  std::size_t touching = 0;  ///< the number of these in which something touches
};

/// Returns a recording as an animated glTF 2.0 file, GLB: each shape once, and a node for each
/// body, which goes through its poses at one update of `every`, and at all in which something
/// begins or ends. Bodies that come or go have the size 0 while they are not there. An update takes
/// a second where the recording does not say how long it is. Throws RecordingError for a recording
/// that cannot be read, or has no update.
RecordedGltf gltf_of_recording(const std::string& file, std::size_t every);

}  // namespace graze::cli
