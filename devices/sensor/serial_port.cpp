// SPDX-License-Identifier: Apache-2.0
#include "sensor/serial_port.hpp"

#include <fcntl.h>
#include <linux/serial.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "nodes/nodes.hpp"
#include "sensor/sentences.hpp"

namespace swage::sensor {

namespace {

struct Rate {
  int bits_per_s;
  speed_t code;
};
constexpr Rate kRates[] = {{9600, B9600},     {19200, B19200},   {38400, B38400},   {57600, B57600},  {115200, B115200},
                           {230400, B230400}, {460800, B460800}, {921600, B921600}, {1000000, B1000000}};

std::string why_not(const std::string& path, int error) {
  if (error == ENOENT) return say::kNotThere(path);
  if (error == EACCES) return say::kMayNotOpen(path);
  if (error == EBUSY) return say::kBusy(path);
  return say::kNotOpened(path, std::strerror(error));
}

// FTDI adapters buffer bytes for 16 ms unless low latency is requested. Others do not support the request.
void make_quick(int file) {
  serial_struct serial{};
  if (ioctl(file, TIOCGSERIAL, &serial) != 0) return;
  serial.flags |= ASYNC_LOW_LATENCY;
  ioctl(file, TIOCSSERIAL, &serial);
}

}  // namespace

const std::vector<int>& SerialPort::rates() {
  static const std::vector<int> all = [] {
    std::vector<int> out;
    for (const Rate& rate : kRates) out.push_back(rate.bits_per_s);
    return out;
  }();
  return all;
}

std::string SerialPort::open(const std::string& path, int bits_per_s) {
  close();
  const auto* rate = std::find_if(std::begin(kRates), std::end(kRates),
                                  [&](const Rate& r) { return r.bits_per_s == bits_per_s; });
  if (rate == std::end(kRates)) return say::kNoSuchRate(bits_per_s);
  const int file = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return why_not(path, errno);
  termios settings{};
  if (tcgetattr(file, &settings) != 0) {
    ::close(file);
    return say::kNoSerialPort(path);
  }
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~tcflag_t{HUPCL};  // a board that restarts when its port is closed would lose its clock
  settings.c_cc[VMIN] = settings.c_cc[VTIME] = 0;
  cfsetspeed(&settings, rate->code);
  if (tcsetattr(file, TCSANOW, &settings) != 0) {
    const std::string why = why_not(path, errno);
    ::close(file);
    return why;
  }
  ioctl(file, TIOCEXCL);  // with a second reader each would get a part of the bytes
  make_quick(file);
  tcflush(file, TCIFLUSH);  // discards old bytes
  file_ = file;
  return "";
}

void SerialPort::close() {
  if (file_ < 0) return;
  ioctl(file_, TIOCNXCL);
  ::close(file_);
  file_ = -1;
}

int SerialPort::read(char* buffer, std::size_t size) {
  if (file_ < 0) return -1;
  const ssize_t n = ::read(file_, buffer, size);
  if (n > 0) return static_cast<int>(n);
  if (n < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
  // with VMIN 0, read() returns 0 both when there are no bytes and when the port was hung up
  pollfd state{file_, POLLIN, 0};
  if (n == 0 && poll(&state, 1, 0) >= 0 && (state.revents & (POLLHUP | POLLERR | POLLNVAL)) == 0) return 0;
  close();
  return -1;
}

bool SerialPort::write(std::string_view bytes) {
  if (file_ < 0) return false;
  const ssize_t n = ::write(file_, bytes.data(), bytes.size());
  if (n >= 0 || errno == EAGAIN || errno == EINTR) return true;
  close();
  return false;
}

std::vector<std::string> serial_adapters() {
  std::vector<std::string> out;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(nodes::place("/dev/serial/by-id"), ignored)) out.push_back(entry.path().string());
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace swage::sensor
