// SPDX-License-Identifier: Apache-2.0
#include "spnav.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "sentences.hpp"

namespace swage::spacemouse {

static_assert(sizeof(SpnavEvent) == 32, "an event is eight numbers");

std::string SpnavSocket::open(const std::string& wanted) {
  close();
  const char* given = std::getenv("SPNAV_SOCKET");
  const std::string path = !wanted.empty() ? wanted : given != nullptr ? given : "/var/run/spnav.sock";
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return say::kLongName(path);
  std::memcpy(address.sun_path, path.c_str(), path.size());
  const int file = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (file < 0) return say::kNoSocket(std::strerror(errno));
  if (connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    file_ = file;
    have_ = 0;
    return "";
  }
  const int error = errno;
  ::close(file);
  if (error == EACCES) return say::kMayNotOpen(path);
  return say::kNoDaemon(path);
}

void SpnavSocket::close() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

bool SpnavSocket::next(SpnavEvent& out) {
  while (file_ >= 0) {
    const ssize_t n = ::read(file_, buffer_ + have_, sizeof buffer_ - have_);
    if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return false;
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      close();
      return false;
    }
    have_ += static_cast<std::size_t>(n);
    if (have_ < sizeof buffer_) continue;
    have_ = 0;
    std::memcpy(&out, buffer_, sizeof out);
    return true;
  }
  return false;
}

}  // namespace swage::spacemouse
