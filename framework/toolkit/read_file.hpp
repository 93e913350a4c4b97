// SPDX-License-Identifier: Apache-2.0
//
// Reads files from outside; refuses pipes, devices and files beyond a limit. [main]
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string>

#include "toolkit/sentences.hpp"

namespace swage::toolkit {

/// A lesson, a needle or a table has kilobytes, a hand recording of five minutes at 1 kHz 30 megabytes. A larger file is a mistake,
/// and parsing it would exhaust the memory of the machine.
inline constexpr std::size_t kMostFileBytes = std::size_t{32} << 20;

namespace detail {

inline std::string bytes_text(std::size_t bytes) {
  const bool whole = bytes >= (std::size_t{1} << 20) && bytes % (std::size_t{1} << 20) == 0;
  return whole ? std::to_string(bytes >> 20) + " MiB" : std::to_string(bytes) + " bytes";
}

inline int open_file(const std::string& path) {
  return open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
}

/// Reason not to read an open file; "" when it may be read.
inline std::string file_refusal(int file, std::size_t most) {
  struct stat status {};
  if (fstat(file, &status) != 0) return say::kUnreadable(std::strerror(errno));
  if (S_ISDIR(status.st_mode)) return say::kFolder();
  if (!S_ISREG(status.st_mode)) return say::kPipe();
  return static_cast<std::size_t>(status.st_size) > most ? say::kTooLarge(bytes_text(most)) : std::string();
}

}  // namespace detail

/// Reason not to read a file, as a sentence without the path; "" when it may be read.
inline std::string file_refusal(const std::string& path, std::size_t most) {
  const int file = detail::open_file(path);
  if (file < 0)
    return errno == ENOENT ? say::kNoFile() : say::kUnreadable(std::strerror(errno));
  std::string why = detail::file_refusal(file, most);
  close(file);
  return why;
}

/// Calls take(data, size) for one block after another. "" when all was read, else a sentence without the path. Opening a
/// pipe does not block, and a file that grows while it is read is refused beyond `most` bytes as well.
template <class Take>
std::string read_blocks(const std::string& path, std::size_t most, Take take) {
  std::string why = file_refusal(path, most);
  if (!why.empty()) return why;
  const int file = detail::open_file(path);
  if (file < 0) return say::kUnreadable(std::strerror(errno));
  why = detail::file_refusal(file, most);  // asked of the open file: the path may have been replaced since
  char block[1 << 16];
  std::size_t total = 0;
  while (why.empty()) {
    const ssize_t n = read(file, block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) why = say::kUnreadable(std::strerror(errno));
    if (n <= 0) break;
    total += static_cast<std::size_t>(n);
    if (total > most)
      why = say::kTooLarge(detail::bytes_text(most));
    else
      take(static_cast<const char*>(block), static_cast<std::size_t>(n));
  }
  close(file);
  return why;
}

/// Reads the whole file. False: `why` has a sentence, and `bytes` what was read until then.
inline bool read_file(const std::string& path, std::size_t most, std::string& bytes, std::string& why) {
  bytes.clear();
  why = read_blocks(path, most, [&](const char* data, std::size_t size) { bytes.append(data, size); });
  return why.empty();
}

}  // namespace swage::toolkit
