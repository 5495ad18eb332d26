#pragma once

#include <cstddef>
#include <string>

namespace graze::cli {

/// What came of it.
struct RecordedGltf {
  std::string bytes;         ///< of the file
  std::size_t pictures = 0;  ///< times that it has poses for
  std::size_t touching = 0;  ///< of these, in which something touches
};

/// A recording as an animated glTF 2.0 file, GLB: each shape once, a node for each body, whose
/// poses at one update of `every`, and at all in which something begins or ends, it goes through.
/// Bodies that come or go have the size 0 while they are not there. An update takes a second where
/// the recording does not say how long it is. Throws RecordingError for what cannot be read, or has
/// no update.
RecordedGltf gltf_of_recording(const std::string& file, std::size_t every);

}  // namespace graze::cli
