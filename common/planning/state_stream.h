#pragma once

#include <cstdint>
#include <iosfwd>
#include <type_traits>
#include <vector>

namespace cell::planning {

/// Writes numbers and vectors of plain values as they lie in memory, for the
/// same program on the same kind of machine, with a checksum at the end.
class StateWriter {
 public:
  explicit StateWriter(std::ostream* out) : out_(*out) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void Put(const T& value) { PutBytes(&value, sizeof(T)); }

  /// Its capacity, too, so that memory is counted in the same way later.
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void Put(const std::vector<T>& values) {
    Put(uint64_t{values.size()});
    Put(uint64_t{values.capacity()});
    PutBytes(values.data(), values.size() * sizeof(T));
  }

  void PutChecksum();

 private:
  void PutBytes(const void* bytes, size_t size);

  std::ostream& out_;
  uint64_t checksum_ = 0;
};

/// Reads what StateWriter has written.
/// All @throws std::runtime_error for an end that comes too early and for sizes
/// that no file could hold.
class StateReader {
 public:
  /// @param num_bytes  of all that is to be read
  StateReader(std::istream* in, uint64_t num_bytes)
      : in_(*in), num_left_(num_bytes) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void Get(T* value) { GetBytes(value, sizeof(T)); }

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void Get(std::vector<T>* values) {
    uint64_t size = 0;
    uint64_t capacity = 0;
    Get(&size);
    Get(&capacity);
    RequireSize(size, capacity, sizeof(T));
    values->clear();
    values->reserve(capacity);
    values->resize(size);
    GetBytes(values->data(), size * sizeof(T));
  }

  /// @throws std::runtime_error unless so many elements may follow
  void RequireSize(uint64_t size, uint64_t capacity, size_t element) const;
  /// @throws std::runtime_error if what was read is not what was written
  void CheckChecksum();

 private:
  void GetBytes(void* bytes, size_t size);

  std::istream& in_;
  uint64_t num_left_;
  uint64_t checksum_ = 0;
};

}  // namespace cell::planning
