#include <graze/bvh/error.h>

#include <utility>

namespace graze {

Error::Error(const std::string& what, ErrorPlace place) : std::runtime_error(what) {
  if (place != ErrorPlace{}) place_ = std::make_shared<const ErrorPlace>(std::move(place));
}

const ErrorPlace& Error::place() const noexcept {
  static const ErrorPlace kNowhere;
  return place_ == nullptr ? kNowhere : *place_;
}

}  // namespace graze
