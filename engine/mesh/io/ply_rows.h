#pragma once

#include <graze/engine/mesh/io/byte_cursor.h>
#include <graze/engine/mesh/io/ply_header.h>
#include <graze/engine/mesh/io/text_cursor.h>
#include <bit>
#include <cstdint>

namespace graze::mesh_io {

/// Reads the data of an ASCII file, a line to a row. Numbers are read as doubles whatever type the
/// header gives them.
class PlyAsciiRows {
 public:
  explicit PlyAsciiRows(const TextCursor& cursor) : cursor_(cursor) {}

  void begin_element(const PlyElement&) {}
  void begin_row(const PlyElement& element, std::uint64_t row);
  void end_row() { cursor_.end_line(); }

  double number(PlyType) { return cursor_.number(); }
  std::int64_t integer(PlyType) { return cursor_.integer(); }
  void skip(PlyType, std::uint64_t count);

  /// Returns a bound of how many rows can follow.
  std::uint64_t max_rows(const PlyElement& element) const;

  /// Fails if anything but comments follows.
  void finish();

  Place place() const { return cursor_.place(); }
  [[noreturn]] void fail(std::string_view why) const { cursor_.fail(why); }

 private:
  TextCursor cursor_;
};

/// Reads the data of a binary file.
class PlyBinaryRows {
 public:
  explicit PlyBinaryRows(const ByteCursor& cursor) : cursor_(cursor) {}

  /// Fails at once if the file is too short for the claimed count of even the shortest rows.
  void begin_element(const PlyElement& element);
  void begin_row(const PlyElement&, std::uint64_t) {}
  void end_row() {}

  double number(PlyType type);
  std::int64_t integer(PlyType type);
  void skip(PlyType type, std::uint64_t count);

  std::uint64_t max_rows(const PlyElement& element) const;

  /// Fails if anything follows.
  void finish();

  Place place() const { return cursor_.place(); }
  [[noreturn]] void fail(std::string_view why) const { cursor_.fail(why); }

 private:
  ByteCursor cursor_;
};

}  // namespace graze::mesh_io
