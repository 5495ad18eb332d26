#include <graze/engine/cli/reports/table.h>

#include <fmt/format.h>
#include <algorithm>
#include <cassert>
#include <utility>

namespace graze::cli {

Table::Table(std::vector<Column> columns) : columns_(std::move(columns)) {
  for (Column& column : columns_)
    column.min_width = std::max(column.min_width, column.title.size());
}

std::string Table::header() const {
  std::vector<std::string> titles;
  for (const Column& column : columns_)
    titles.push_back(column.title);
  return row(titles);
}

std::string Table::row(const std::vector<std::string>& values) const {
  assert(values.size() == columns_.size());
  std::string line;
  for (std::size_t i = 0; i < values.size(); ++i) {
    line += fmt::format("{}{:>{}}", i == 0 ? "" : "  ", values[i], columns_[i].min_width);
  }
  return line + "\n";
}

}  // namespace graze::cli
