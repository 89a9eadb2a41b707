#include "common/planning/state_stream.h"

#include <algorithm>
#include <cstring>
#include <istream>
#include <ostream>
#include <stdexcept>

namespace cell::planning {
namespace {

/// Most of a vector that is reserved beyond its size: it doubles when it grows,
/// and small ones start with a few.
constexpr uint64_t kSpareFactor = 2;
constexpr uint64_t kSpare = 4096;

uint64_t ChecksumWith(uint64_t checksum, const void* bytes, size_t size) {
  const auto* from = static_cast<const char*>(bytes);
  for (size_t i = 0; i < size; i += sizeof(uint64_t)) {
    uint64_t word = 0;
    std::memcpy(&word, from + i, std::min(sizeof(word), size - i));
    checksum = (checksum ^ word) * 0x9e3779b97f4a7c15;
    checksum ^= checksum >> 29;
  }
  return checksum;
}

}  // namespace

void StateWriter::PutBytes(const void* bytes, size_t size) {
  out_.write(static_cast<const char*>(bytes),
             static_cast<std::streamsize>(size));
  checksum_ = ChecksumWith(checksum_, bytes, size);
}

void StateWriter::PutChecksum() {
  const uint64_t checksum = checksum_;
  Put(checksum);
}

void StateReader::GetBytes(void* bytes, size_t size) {
  if (size > num_left_ || !in_.read(static_cast<char*>(bytes),
                                    static_cast<std::streamsize>(size))) {
    throw std::runtime_error("ends too early");
  }
  num_left_ -= size;
  checksum_ = ChecksumWith(checksum_, bytes, size);
}

void StateReader::RequireSize(uint64_t size, uint64_t capacity,
                              size_t element) const {
  if (size > num_left_ / element || capacity < size ||
      capacity > kSpareFactor * size + kSpare) {
    throw std::runtime_error("is damaged");
  }
}

void StateReader::CheckChecksum() {
  const uint64_t found = checksum_;
  uint64_t written = 0;
  Get(&written);
  if (written != found) throw std::runtime_error("is damaged");
}

}  // namespace cell::planning
