#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <tests/oracle/shapes.h>

// The text form of a hard case, the same in the folder of regressions and in failure messages, so
// that a failure can be pasted into a file:
//
//   # why it is hard
//   triangle_triangle intersects
//   <nine coordinates of A> <nine coordinates of B>
//   triangle_box apart
//   <nine coordinates> <box minimum> <box maximum>
//
// Numbers are separated by any white space; the texts written here use hexadecimal floats, which
// lose nothing. A '#' starts a comment that ends with the line.

namespace graze::oracle {

struct KnownCase {
  std::variant<TrianglePair, TriangleAndBox> shapes;
  bool intersects = false;
  int line = 0;  ///< where the case begins in its file
};

/// what() reads `file:line: why`.
class CaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws CaseError for a word that is neither a keyword in its place nor a finite number, and for
/// a file that ends within a case or holds none.
std::vector<KnownCase> read_cases(const std::filesystem::path& path);

std::string to_text(const TrianglePair& pair, bool intersects);
std::string to_text(const TriangleAndBox& pair, bool intersects);

}  // namespace graze::oracle
