// SPDX-License-Identifier: GPL-3.0-or-later
// All enumerators of an enum of bytes, for tests that go through every one: no list that a new one could be
// forgotten in. An enumerator named Count is none.
#pragma once

#include <utility>
#include <vector>

#include "base/enum_table.h"

namespace deckpipe::test {

template <auto Value>
constexpr bool isOne() {
  if constexpr (requires { decltype(Value)::Count; }) {
    if (Value == decltype(Value)::Count) return false;
  }
  return isEnumerator<Value>();
}

template <typename E, std::size_t... N>
std::vector<E> enumerators(std::index_sequence<N...>) {
  std::vector<E> all;
  (void)((isOne<static_cast<E>(N)>() && (all.push_back(static_cast<E>(N)), true)), ...);
  return all;
}

// In order of their numbers, 0 to 127.
template <typename E>
std::vector<E> allOf() {
  return enumerators<E>(std::make_index_sequence<128>());
}
template <typename E>
std::vector<E> allBut(E left) {
  std::vector<E> all = allOf<E>();
  std::erase(all, left);
  return all;
}

}  // namespace deckpipe::test
