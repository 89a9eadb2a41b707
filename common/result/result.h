#pragma once

#include <concepts>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace cell {

/// Why there is no result, in plain words; may be empty.
struct Reason {
  std::string text;
};

/// A value, or the reason why there is none: an expected "no".
template <class T>
class [[nodiscard]] Result {
 public:
  template <class U = T>
  requires std::convertible_to<U, T> &&
      (!std::same_as<std::remove_cvref_t<U>, Result>)Result(U&& value)
      : content_(std::in_place_index<0>, std::forward<U>(value)) {}
  Result(Reason reason) : content_(std::move(reason)) {}

  explicit operator bool() const { return content_.index() == 0; }
  /// @throws std::bad_variant_access if there is none, in all three.
  const T& operator*() const& { return std::get<0>(content_); }
  T& operator*() & { return std::get<0>(content_); }
  T&& operator*() && { return std::get<0>(std::move(content_)); }
  const T* operator->() const { return &std::get<0>(content_); }
  /// Empty if there is a value.
  std::string reason() const {
    const auto* reason = std::get_if<1>(&content_);
    return reason == nullptr ? "" : reason->text;
  }

 private:
  std::variant<T, Reason> content_;
};

}  // namespace cell
