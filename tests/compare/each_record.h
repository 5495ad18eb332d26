#pragma once

#include <functional>
#include <utility>
#include <vector>

namespace graze::compare {

/// Calls `on_record` with one record after the other, in their order, to the last of them.
template <typename Record, typename OnRecord>
std::function<bool(std::vector<Record>)> each_record(OnRecord on_record) {
  return [on_record = std::move(on_record)](const std::vector<Record>& records) {
    for (const Record& record : records)
      on_record(record);
    return true;
  };
}

}  // namespace graze::compare
