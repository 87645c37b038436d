// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays and sets that are indexed by an enum. No other code turns an enumerator into an index.
//
//   EnumArray<E, T>    one T for each enumerator, to be written to
//   EnumTable<E, T>    one constant row for each enumerator, in the enum's order
//   KeyTable<kKeys, T> the same for a list of keys that was worked out at compile time
//   EnumSet<E>         a set of enumerators
//
//   constexpr EnumTable<Gear, int> kTeeth{{{Gear::Low, 40}, {Gear::High, 20}}};
//   kTeeth[Gear::High]
//
// A row that is left out, doubled or out of order does not compile. An enum counts its enumerators by a last one
// called `Count`, or by kLastOf, which is specialised right below it. One that stands behind either does not compile.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace deckpipe {

template <typename E>
inline constexpr E kLastOf = static_cast<E>(static_cast<std::size_t>(E::Count) - 1);

// Whether an enumerator has this value: compilers write "deckpipe::Gear::Low", or "(deckpipe::Gear)3" if none has.
template <auto kValue>
constexpr bool isEnumerator() {
  constexpr std::string_view kText = __PRETTY_FUNCTION__;
  return kText[kText.rfind(" = ") + 3] != '(';
}
// Whether no enumerator stands behind the last one, and behind Count.
template <typename E>
inline constexpr bool kEndsAtLast = !isEnumerator<static_cast<E>(static_cast<std::size_t>(kLastOf<E>) + 1 +
                                                                 (requires { E::Count; } ? 1 : 0))>();

template <typename E>
inline constexpr std::size_t kCountOf = [] {
  static_assert(kEndsAtLast<E>, "an enumerator stands behind the last one");
  return static_cast<std::size_t>(kLastOf<E>) + 1;
}();

// Whether a number that was read is an enumerator. They count from 0 or from 1 without a gap.
template <typename E>
constexpr bool isKnown(E value) {
  static_assert(kEndsAtLast<E>, "an enumerator stands behind the last one");
  return value <= kLastOf<E> && (value != E{} || isEnumerator<E{}>());
}

// Every enumerator in order, to loop over.
template <typename E>
inline constexpr std::array<E, kCountOf<E>> kAllOf = [] {
  std::array<E, kCountOf<E>> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<E>(i);
  return all;
}();

template <typename E, typename T>
class EnumArray {
 public:
  constexpr EnumArray() = default;
  // A row of a matrix: the values in the enum's order.
  template <std::size_t N>
  constexpr EnumArray(const T (&values)[N]) {
    static_assert(N == kCountOf<E>, "one value for each enumerator");
    for (std::size_t i = 0; i < N; ++i) m_values[i] = values[i];
  }

  constexpr T& operator[](E key) { return m_values[static_cast<std::size_t>(key)]; }
  constexpr const T& operator[](E key) const { return m_values[static_cast<std::size_t>(key)]; }
  constexpr auto begin() { return m_values.begin(); }
  constexpr auto end() { return m_values.end(); }
  constexpr auto begin() const { return m_values.begin(); }
  constexpr auto end() const { return m_values.end(); }
  friend constexpr bool operator==(const EnumArray&, const EnumArray&) = default;

 private:
  std::array<T, kCountOf<E>> m_values{};
};

template <const auto& kKeys, typename T>
class KeyTable {
 public:
  using Key = typename std::remove_cvref_t<decltype(kKeys)>::value_type;
  struct Row {
    Key key;
    T value;
  };

  template <std::size_t N>
  consteval KeyTable(const Row (&rows)[N]) {
    static_assert(N == kKeys.size(), "one row for each key: a row is left out or doubled");
    for (std::size_t i = 0; i < N; ++i) {
      if (rows[i].key != kKeys[i]) aRowIsLeftOutDoubledOrOutOfOrder();
      m_values[i] = rows[i].value;
    }
  }

  // Null for a key that is none of the list.
  constexpr const T* find(Key key) const {
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
      if (kKeys[i] == key) return &m_values[i];
    }
    return nullptr;
  }
  constexpr const T& operator[](Key key) const requires(std::is_enum_v<Key>) {
    static_assert(&kKeys == &kAllOf<Key>, "not every enumerator has a row: use find()");
    return m_values[static_cast<std::size_t>(key)];
  }
  // The values in the order of their keys.
  constexpr auto begin() const { return m_values.begin(); }
  constexpr auto end() const { return m_values.end(); }

 private:
  // Not constexpr: the compiler names it where a row is wrong.
  static void aRowIsLeftOutDoubledOrOutOfOrder() {}

  std::array<T, kKeys.size()> m_values{};
};

template <typename E, typename T>
using EnumTable = KeyTable<kAllOf<E>, T>;

template <typename E>
class EnumSet {
 public:
  constexpr EnumSet() = default;
  template <std::same_as<E>... More>
  constexpr explicit EnumSet(E first, More... more) {
    add(first);
    (add(more), ...);
  }

  constexpr bool has(E e) const { return (m_words[wordOf(e)] & bitOf(e)) != 0; }
  constexpr bool isEmpty() const { return *this == EnumSet(); }
  constexpr std::size_t count() const {
    std::size_t count = 0;
    for (const std::uint64_t word : m_words) count += static_cast<std::size_t>(std::popcount(word));
    return count;
  }
  constexpr void add(E e) { m_words[wordOf(e)] |= bitOf(e); }
  constexpr void remove(E e) { m_words[wordOf(e)] &= ~bitOf(e); }
  constexpr EnumSet& operator|=(const EnumSet& other) {
    for (std::size_t i = 0; i < m_words.size(); ++i) m_words[i] |= other.m_words[i];
    return *this;
  }
  friend constexpr EnumSet operator&(EnumSet a, const EnumSet& b) {
    for (std::size_t i = 0; i < a.m_words.size(); ++i) a.m_words[i] &= b.m_words[i];
    return a;
  }
  // Those of `a` that `b` has not.
  friend constexpr EnumSet operator-(EnumSet a, const EnumSet& b) {
    for (std::size_t i = 0; i < a.m_words.size(); ++i) a.m_words[i] &= ~b.m_words[i];
    return a;
  }
  // In the enum's order.
  template <typename F>
  constexpr void forEach(F&& f) const {
    for (const E e : kAllOf<E>) {
      if (has(e)) f(e);
    }
  }
  friend constexpr bool operator==(const EnumSet&, const EnumSet&) = default;

 private:
  static constexpr std::size_t wordOf(E e) { return static_cast<std::size_t>(e) / 64; }
  static constexpr std::uint64_t bitOf(E e) { return 1ull << static_cast<std::size_t>(e) % 64; }

  std::array<std::uint64_t, (kCountOf<E> + 63) / 64> m_words{};
};

}  // namespace deckpipe
