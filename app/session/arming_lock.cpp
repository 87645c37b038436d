// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arming_lock.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <string_view>

namespace deckpipe {

// A name in Linux's abstract space has one owner, and no file that could stay behind.
bool ArmingLock::take() {
  constexpr std::string_view kName("\0deckpipe-moves-monitors", 24);
  if (m_socket >= 0) return true;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, kName.data(), kName.size());
  m_socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + kName.size());
  if (m_socket >= 0 && ::bind(m_socket, reinterpret_cast<const sockaddr*>(&address), length) == 0)
    return true;
  free();
  return false;
}

void ArmingLock::free() {
  if (m_socket >= 0) ::close(m_socket);
  m_socket = -1;
}

}  // namespace deckpipe
