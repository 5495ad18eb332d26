#pragma once

// This is private to engine/mesh.

#include <memory>
#include <mutex>
#include <utility>

namespace graze {

/// Holds what a deformed mesh has from the one before it until it has made its own of it. Meshes
/// that are deformed again and again hand it on, and none holds the one before it.
template <typename Stock>
class Inherited {
 public:
  void set(std::shared_ptr<const Stock> stock) {
    const std::scoped_lock lock(mutex_);
    stock_ = std::move(stock);
  }

  /// Returns the stock; nothing if there is none, or if it has been given up.
  std::shared_ptr<const Stock> get() const {
    const std::scoped_lock lock(mutex_);
    return stock_;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const Stock> stock_;
};

}  // namespace graze
