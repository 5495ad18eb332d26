#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace graze::contacts {

/// Gives a number to each of some vertices of a mesh: few of many, known by their indices. It is a
/// table with open places, at most half of them taken, so that a search is one look and seldom a
/// second.
class VertexNumbers {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  explicit VertexNumbers(std::size_t expected = 8) {
    std::size_t places = 16;
    while (places < 2 * expected)
      places *= 2;
    places_.resize(places);
  }

  /// Returns a vertex's number; kNone for a vertex without one.
  std::uint32_t find(std::uint32_t vertex) const { return places_[place_of(vertex)].number; }

  /// Gives the vertex this number unless it has one. Returns whether it had none.
  bool add(std::uint32_t vertex, std::uint32_t number) {
    Entry& place = places_[place_of(vertex)];
    if (place.number != kNone) return false;
    place = {vertex, number};
    if (2 * ++count_ > places_.size()) grow();
    return true;
  }

 private:
  struct Entry {
    std::uint32_t vertex = 0;
    std::uint32_t number = kNone;
  };

  /// Returns the place where the vertex is, or could be.
  std::size_t place_of(std::uint32_t vertex) const {
    constexpr std::uint64_t kScatter = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio
    const std::size_t mask = places_.size() - 1;
    std::size_t at = static_cast<std::size_t>((vertex * kScatter) >> 32) & mask;
    while (places_[at].number != kNone && places_[at].vertex != vertex)
      at = (at + 1) & mask;
    return at;
  }

  void grow() {
    std::vector<Entry> old(2 * places_.size());
    old.swap(places_);
    for (const Entry& place : old) {
      if (place.number != kNone) places_[place_of(place.vertex)] = place;
    }
  }

  std::vector<Entry> places_;
  std::size_t count_ = 0;
};

}  // namespace graze::contacts
