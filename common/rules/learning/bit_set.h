#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace cell::rules {

/// A set of the numbers below size().
class BitSet {
 public:
  explicit BitSet(int size = 0, bool is_full = false) { Resize(size, is_full); }

  int size() const { return size_; }
  /// New numbers are members if `is_full`.
  void Resize(int size, bool is_full = false) {
    const int old = size_;
    size_ = size;
    words_.resize((static_cast<size_t>(size) + 63) / 64);
    for (int i = old; is_full && i < size; ++i) Add(i);
  }

  bool Has(int i) const {
    return words_[static_cast<size_t>(i) / 64] >> (i % 64) & 1;
  }
  void Add(int i) {
    words_[static_cast<size_t>(i) / 64] |= uint64_t{1} << (i % 64);
  }

  BitSet& operator&=(const BitSet& other) {
    for (size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
    return *this;
  }
  BitSet& operator|=(const BitSet& other) {
    for (size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    return *this;
  }
  /// Takes out the members of `other`.
  BitSet& operator-=(const BitSet& other) {
    for (size_t i = 0; i < words_.size(); ++i) words_[i] &= ~other.words_[i];
    return *this;
  }

  int Count() const {
    int count = 0;
    for (const uint64_t word : words_) count += std::popcount(word);
    return count;
  }
  bool IsEmpty() const {
    for (const uint64_t word : words_) {
      if (word != 0) return false;
    }
    return true;
  }
  /// Number of common members.
  int CountWith(const BitSet& other) const {
    int count = 0;
    for (size_t i = 0; i < words_.size(); ++i) {
      count += std::popcount(words_[i] & other.words_[i]);
    }
    return count;
  }
  bool Meets(const BitSet& other) const {
    for (size_t i = 0; i < words_.size(); ++i) {
      if ((words_[i] & other.words_[i]) != 0) return true;
    }
    return false;
  }

  /// In ascending order.
  template <class Visit>
  void ForEach(Visit visit) const {
    for (size_t i = 0; i < words_.size(); ++i) {
      for (uint64_t word = words_[i]; word != 0; word &= word - 1) {
        visit(static_cast<int>(64 * i) + std::countr_zero(word));
      }
    }
  }

  uint64_t Hash() const {
    uint64_t hash = 0xcbf29ce484222325;
    for (const uint64_t word : words_) {
      hash = (hash ^ word) * 0x9e3779b97f4a7c15;
      hash ^= hash >> 29;
    }
    return hash;
  }
  bool operator==(const BitSet&) const = default;

 private:
  int size_ = 0;
  std::vector<uint64_t> words_;
};

}  // namespace cell::rules
