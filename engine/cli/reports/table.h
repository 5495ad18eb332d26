#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace graze::cli {

struct Column {
  std::string title;
  std::size_t min_width = 0;
};

/// Makes rows with right-aligned columns, which can be written before the next row is known: a
/// column is as wide as its title or its minimum, and a wider value shifts what follows in its row.
class Table {
 public:
  explicit Table(std::vector<Column> columns);

  std::string header() const;

  /// Returns a row of one value per column.
  std::string row(const std::vector<std::string>& values) const;

 private:
  std::vector<Column> columns_;
};

}  // namespace graze::cli
