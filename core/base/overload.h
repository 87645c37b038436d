// SPDX-License-Identifier: GPL-3.0-or-later
// One visitor made of several lambdas, for std::visit: Overload{[](const A&) {…}, [](const B&) {…}}. Without
// a lambda for `auto` the compiler names every place where a new alternative is not handled yet.
#pragma once

namespace deckpipe {

template <typename... F>
struct Overload : F... {
  using F::operator()...;
};
template <typename... F>
Overload(F...) -> Overload<F...>;

}  // namespace deckpipe
