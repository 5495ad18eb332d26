#include <fast_float/fast_float.h>
#include <graze/engine/mesh/io/text_cursor.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <system_error>

namespace graze::mesh_io {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

TextCursor::TextCursor(const Source& source, TextRules rules)
    : source_(source),
      rules_(rules),
      next_(source.bytes.data()),
      end_(source.bytes.data() + source.bytes.size()) {
  if (source.bytes.starts_with("\xef\xbb\xbf")) next_ += 3;
}

/// True if this is a backslash with a line's end right behind it.
bool TextCursor::is_continuation(const char* at) const {
  return rules_.has_continued_lines && *at == '\\' && at + 1 != end_ && is_line_end(at[1]);
}

bool TextCursor::ends_token(const char* at) const {
  return at == end_ || is_blank(*at) || is_line_end(*at) || is_continuation(at);
}

const char* TextCursor::token_end() const {
  const char* at = next_;
  while (!ends_token(at))
    ++at;
  return at;
}

/// Goes past one line's end, if it is here.
bool TextCursor::skip_line_end() {
  if (next_ == end_ || !is_line_end(*next_)) return false;
  if (*next_ == '\r' && next_ + 1 != end_ && next_[1] == '\n') ++next_;
  ++next_;
  ++line_;
  return true;
}

bool TextCursor::skip_continuation() {
  if (!is_continuation(next_)) return false;
  ++next_;
  return skip_line_end();
}

bool TextCursor::has_token() {
  while (next_ != end_) {
    if (is_blank(*next_)) {
      ++next_;
    } else if (!skip_continuation()) {
      break;
    }
  }
  if (next_ == end_) return false;
  if (*next_ == rules_.comment && rules_.comment != '\0') {
    while (next_ != end_ && !is_line_end(*next_))
      ++next_;
    return false;
  }
  return !is_line_end(*next_);
}

std::string_view TextCursor::peek() {
  if (!has_token()) return {};
  return {next_, static_cast<std::size_t>(token_end() - next_)};
}

std::string_view TextCursor::token() {
  const std::string_view token = peek();
  next_ += token.size();
  return token;
}

std::string_view TextCursor::token_through(std::string_view last) {
  const std::string_view whole = token();
  const std::size_t found = whole.find(last);
  if (found == std::string_view::npos) return whole;
  next_ = whole.data() + found + last.size();
  return whole.substr(0, found + last.size());
}

void TextCursor::require_token_here(std::string_view wanted) {
  if (has_token()) return;
  fail("expected " + std::string(wanted) +
       (next_ == end_ ? ", but the file ends" : ", but the line ends"));
}

double TextCursor::number() {
  require_token_here("a number");
  // The parser takes no plus sign; behind one there must not be a second sign.
  const bool has_plus = *next_ == '+' && next_ + 1 != end_ && next_[1] != '-';
  double value = 0;
  const auto result = fast_float::from_chars(next_ + (has_plus ? 1 : 0), end_, value);
  // Out of range is judged by the value: too small is a rounding to zero, too large is infinite.
  if (result.ec == std::errc::invalid_argument || !ends_token(result.ptr) ||
      !std::isfinite(value)) {
    fail(quoted(token()) + " is not a finite number");
  }
  next_ = result.ptr;
  return value;
}

std::int64_t TextCursor::integer() {
  require_token_here("a whole number");
  const char* at = next_;
  const bool is_negative = *at == '-';
  if (*at == '-' || *at == '+') ++at;
  const char* digits = at;
  constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
  bool is_too_large = false;
  std::int64_t value = 0;
  for (; at != end_ && is_digit(*at); ++at) {
    is_too_large = is_too_large || value > kLargest / 10 - 1;
    if (!is_too_large) value = 10 * value + (*at - '0');
  }
  if (at == digits || !ends_token(at)) fail(quoted(token()) + " is not a whole number");
  if (is_too_large) fail(quoted(token()) + " is too large");
  next_ = at;
  return is_negative ? -value : value;
}

void TextCursor::skip_line() {
  while (next_ != end_) {
    if (skip_continuation()) continue;
    if (skip_line_end()) return;
    ++next_;
  }
}

void TextCursor::end_line() {
  require_no_token();
  skip_line_end();
}

void TextCursor::end_line_with_return() {
  require_no_token();
  if (next_ == end_) return;
  ++next_;
  ++line_;
}

void TextCursor::require_no_token() {
  if (has_token()) fail("unexpected " + quoted(token()) + " at the end of the line");
}

bool TextCursor::find_token() {
  while (!has_token()) {
    if (!skip_line_end()) return false;
  }
  return true;
}

void TextCursor::require_token(std::string_view wanted) {
  if (!find_token()) fail("expected " + std::string(wanted) + ", but the file ends");
}

Place TextCursor::place() const {
  const bool is_behind_last_line =
      next_ == end_ && line_ > 1 && !source_.bytes.empty() && is_line_end(source_.bytes.back());
  return {Place::Unit::Line, is_behind_last_line ? line_ - 1 : line_};
}

void TextCursor::fail(std::string_view why) const {
  mesh_io::fail(source_, place(), why);
}

bool is_keyword(std::string_view token, std::string_view keyword) {
  const auto to_lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::ranges::equal(token, keyword, {}, to_lower);
}

}  // namespace graze::mesh_io
