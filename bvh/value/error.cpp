#include <graze/bvh/error.h>

#include <string>
#include <utility>

namespace graze {

Error::Error(const std::string& what, ErrorPlace place) : std::runtime_error(what) {
  if (place != ErrorPlace{}) place_ = std::make_shared<const ErrorPlace>(std::move(place));
}

const ErrorPlace& Error::place() const noexcept {
  static const ErrorPlace kNowhere;
  return place_ == nullptr ? kNowhere : *place_;
}

StoppedError::StoppedError(std::size_t done, std::size_t total)
    : Error("stopped: " + std::to_string(done) + " of " + std::to_string(total) + " are done"),
      done_(done),
      total_(total) {}

}  // namespace graze
