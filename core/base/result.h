// SPDX-License-Identifier: GPL-3.0-or-later
// A value or the reason why there is none. No exception crosses a room.
#pragma once

#include <utility>
#include <variant>

namespace deckpipe {

template <typename E>
struct Failure {
  E error;
};
template <typename E>
Failure(E) -> Failure<E>;

template <typename T, typename E>
class Result {
 public:
  Result(T value) : m_content(std::in_place_index<0>, std::move(value)) {}
  template <typename F>
  Result(Failure<F> failure) : m_content(std::in_place_index<1>, std::move(failure.error)) {}

  explicit operator bool() const { return m_content.index() == 0; }
  const T& value() const { return std::get<0>(m_content); }
  T& value() { return std::get<0>(m_content); }
  const E& error() const { return std::get<1>(m_content); }

 private:
  std::variant<T, E> m_content;
};

}  // namespace deckpipe
