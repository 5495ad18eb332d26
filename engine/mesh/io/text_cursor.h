#pragma once

#include <graze/engine/files/source.h>
#include <cstdint>
#include <string_view>

namespace graze::mesh_io {

/// The rules of a text format beyond tokens, blanks and lines.
struct TextRules {
  char comment = '\0';  ///< the character that begins, at the start of a token, a comment to the
                        ///< line's end
  bool has_continued_lines = false;  ///< whether a backslash before a line's end stands for a blank
};

/// Reads a text in one pass. A line ends with LF, CR LF or CR. Every failure is a MeshError that
/// names the line. Tokens are views of the source.
class TextCursor {
 public:
  /// Skips a byte order mark. The source must outlive the cursor.
  TextCursor(const Source& source, TextRules rules);

  /// Skips blanks and a comment. Returns true if a token follows on this line.
  bool has_token();

  /// Returns the next token of this line, empty where has_token() is false, and goes past it.
  std::string_view token();

  /// Returns the same token without going past it.
  std::string_view peek();

  /// Returns the next token of this line, or its beginning up to and including the first `last`.
  std::string_view token_through(std::string_view last);

  /// Return the next token as a finite number, rounded once to double, and as a whole number.
  double number();
  std::int64_t integer();

  /// Goes to the beginning of the next line, whatever is left of this one.
  void skip_line();

  /// Does as skip_line() does, but whatever is left must be blank or a comment.
  void end_line();

  /// Does as end_line() does, where a lone CR ends a line and what follows may be binary data that
  /// begin with LF.
  void end_line_with_return();

  /// Goes to the next token of this line or of a later one. Returns false at the end of the file.
  bool find_token();

  /// Does as find_token() does, but fails at the end of the file. `wanted` is for the message.
  void require_token(std::string_view wanted);

  bool is_at_end() const { return next_ == end_; }
  std::size_t offset() const { return static_cast<std::size_t>(next_ - source_.bytes.data()); }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - next_); }

  /// Returns the current line; at the end of the file, the last line that has any characters.
  Place place() const;

  [[noreturn]] void fail(std::string_view why) const;

 private:
  const char* token_end() const;
  bool skip_line_end();
  bool skip_continuation();
  bool is_continuation(const char* at) const;
  void require_no_token();
  void require_token_here(std::string_view wanted);
  bool ends_token(const char* at) const;

  Source source_;
  TextRules rules_;
  const char* next_;
  const char* end_;
  std::uint64_t line_ = 1;
};

/// True if the token is the keyword, in upper or lower case. The keyword is in lower case.
bool is_keyword(std::string_view token, std::string_view keyword);

}  // namespace graze::mesh_io
