// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/kernel_socket.h"

#ifdef __linux__
#include <linux/sock_diag.h>
#include <linux/sockios.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <array>
#endif

namespace deckpipe {

#ifdef __linux__

std::optional<ReceiveBuffer> readReceiveBuffer(int descriptor) {
  std::array<std::uint32_t, SK_MEMINFO_VARS> info{};
  socklen_t size = sizeof info;
  if (::getsockopt(descriptor, SOL_SOCKET, SO_MEMINFO, info.data(), &size) < 0) return {};
  return ReceiveBuffer{info[SK_MEMINFO_RCVBUF], info[SK_MEMINFO_RMEM_ALLOC], info[SK_MEMINFO_DROPS]};
}

void growReceiveBuffer(int descriptor, int bytes) {
  // The forced variant passes the limit, for those who may; the other is for everybody else.
  if (::setsockopt(descriptor, SOL_SOCKET, SO_RCVBUFFORCE, &bytes, sizeof bytes) < 0) {
    (void)::setsockopt(descriptor, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
  }
}

void startStamping(int descriptor) {
  // Asking for the stamp of the last frame is what switches stamps on; there is none yet.
  timeval none{};
  (void)::ioctl(descriptor, SIOCGSTAMP, &none);
}

#else

std::optional<ReceiveBuffer> readReceiveBuffer(int) { return {}; }
void growReceiveBuffer(int, int) {}
void startStamping(int) {}

#endif

}  // namespace deckpipe
