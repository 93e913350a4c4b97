// SPDX-License-Identifier: Apache-2.0
#include "record/sqlite_pages.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>

#include "record/sentences.hpp"

namespace swage::record {
namespace {

constexpr std::size_t kUsualPage = 4096;  // SQLite's default, and the size of all our stores
constexpr std::size_t kFileHeader = 100, kLogHeader = 32, kFrameHeader = 24, kLeafHeader = 8;
constexpr uint8_t kTableLeaf = 0x0D;
// no row of ours is longer: a file of an attempt has at most 16 MiB
constexpr uint64_t kMostPayload = 32u << 20;

uint64_t big_endian(const uint8_t* at, std::size_t bytes) {
  uint64_t out = 0;
  for (std::size_t i = 0; i < bytes; ++i) out = out << 8 | at[i];
  return out;
}

bool is_page_size(uint64_t n) { return n >= 512 && n <= 65536 && std::has_single_bit(n); }

// 1 to 9 bytes, seven bits each and eight of the ninth; false beyond `end`
bool varint(const std::vector<uint8_t>& bytes, std::size_t& at, std::size_t end, uint64_t& out) {
  out = 0;
  for (int i = 0; i < 9 && at < end; ++i) {
    const uint8_t byte = bytes[at++];
    if (i == 8) return out = out << 8 | byte, true;
    out = out << 7 | (byte & 0x7F);
    if ((byte & 0x80) == 0) return true;
  }
  return false;
}

// one value of a record; `type` as in the record's header
bool take_value(const std::vector<uint8_t>& record, std::size_t& at, uint64_t type, Value& out) {
  static constexpr std::size_t kSize[] = {0, 1, 2, 3, 4, 6, 8, 8, 0, 0};
  const std::size_t left = record.size() - at;
  if (type >= 12) {
    const uint64_t size = (type - 12) / 2;
    if (size > left) return false;
    const auto first = record.begin() + static_cast<std::ptrdiff_t>(at);
    const auto last = first + static_cast<std::ptrdiff_t>(size);
    if (type % 2 == 0)
      out = Blob(first, last);
    else
      out = std::string(first, last);
    at += size;
    return true;
  }
  if (type > 9 || kSize[type] > left) return false;
  const std::size_t size = kSize[type];
  if (type == 0) {
    out = std::monostate{};
  } else if (type >= 8) {
    out = static_cast<int64_t>(type - 8);
  } else {
    uint64_t bits = big_endian(record.data() + at, size);
    if (type == 7) {
      out = std::bit_cast<double>(bits);
    } else {
      const unsigned unused = 64 - 8 * static_cast<unsigned>(size);
      out = static_cast<int64_t>(bits << unused) >> unused;  // sign extension of a short number
    }
  }
  at += size;
  return true;
}

bool take_row(const std::vector<uint8_t>& record, Row& row) {
  constexpr std::size_t kMostColumns = 64;  // twice the number of any table of ours
  std::size_t head = 0;
  uint64_t head_size = 0;
  if (!varint(record, head, record.size(), head_size) || head_size > record.size()) return false;
  std::size_t at = head_size;
  row.clear();
  while (head < head_size) {
    uint64_t type = 0;
    if (row.size() == kMostColumns || !varint(record, head, head_size, type)) return false;
    if (!take_value(record, at, type, row.emplace_back())) return false;
  }
  return at == record.size();
}

bool read_at(int file, uint64_t offset, uint8_t* to, std::size_t size) {
  return pread(file, to, size, static_cast<off_t>(offset)) == static_cast<ssize_t>(size);
}

// the running checksum of a log, over words in the byte order given by its header
struct LogSum {
  bool big = false;
  uint32_t a = 0, b = 0;
  void add(const uint8_t* bytes, std::size_t size) {
    for (std::size_t i = 0; i + 8 <= size; i += 8) {
      a += word(bytes + i) + b;
      b += word(bytes + i + 4) + a;
    }
  }
  uint32_t word(const uint8_t* at) const {
    const auto value = static_cast<uint32_t>(big_endian(at, 4));
    return big ? value : __builtin_bswap32(value);
  }
  bool is(const uint8_t* sums) const { return big_endian(sums, 4) == a && big_endian(sums + 4, 4) == b; }
};

}  // namespace

SqlitePages::~SqlitePages() {
  if (file_ >= 0) close(file_);
  if (log_ >= 0) close(log_);
}

bool SqlitePages::open(const std::string& path, std::string& error) {
  struct stat facts {};
  file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file_ < 0 || fstat(file_, &facts) != 0 || !S_ISREG(facts.st_mode)) {
    error = say::kNoPages(path, (file_ < 0 ? std::strerror(errno) : "it is no file"));
    return false;
  }
  uint8_t head[kFileHeader] = {};
  read_at(file_, 0, head, sizeof head);
  const uint64_t said = big_endian(head + 16, 2);
  const uint64_t size = said == 1 ? 65536 : said;
  size_ = is_page_size(size) ? size : kUsualPage;
  count_ = static_cast<uint64_t>(facts.st_size) / size_;
  read_log(path + "-wal");
  return true;
}

// reads up to the last committed transaction
void SqlitePages::read_log(const std::string& path) {
  log_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  uint8_t head[kLogHeader] = {};
  if (log_ < 0 || !read_at(log_, 0, head, sizeof head)) return;
  const uint64_t magic = big_endian(head, 4);
  if ((magic & ~uint64_t{1}) != 0x377F0682 || !is_page_size(big_endian(head + 8, 4))) return;
  if (count_ == 0) size_ = big_endian(head + 8, 4);
  LogSum sum;
  sum.big = (magic & 1) != 0;
  sum.add(head, 24);
  if (!sum.is(head + 24) || big_endian(head + 8, 4) != size_) return;
  std::vector<uint8_t> frame(kFrameHeader + size_);
  std::map<uint64_t, uint64_t> open_transaction;
  for (uint64_t at = kLogHeader; read_at(log_, at, frame.data(), frame.size()); at += frame.size()) {
    sum.add(frame.data(), 8);
    sum.add(frame.data() + kFrameHeader, size_);
    if (std::memcmp(frame.data() + 8, head + 16, 8) != 0 || !sum.is(frame.data() + 16)) return;
    open_transaction[big_endian(frame.data(), 4)] = at + kFrameHeader;
    const uint64_t pages_after = big_endian(frame.data() + 4, 4);
    if (pages_after == 0) continue;
    for (const auto& [number, place] : open_transaction) newer_[number] = place;
    open_transaction.clear();
    count_ = std::max(count_, pages_after);
  }
}

bool SqlitePages::page(uint64_t number, std::vector<uint8_t>& out) const {
  out.resize(size_);
  const auto found = newer_.find(number);
  if (found != newer_.end()) return read_at(log_, found->second, out.data(), size_);
  return number > 0 && read_at(file_, (number - 1) * size_, out.data(), size_);
}

// Payload of a cell of a leaf, including its overflow pages.
bool SqlitePages::payload(const std::vector<uint8_t>& page, std::size_t at, std::vector<uint8_t>& out) const {
  uint64_t size = 0, rowid = 0;
  if (!varint(page, at, size_, size) || !varint(page, at, size_, rowid) || size > kMostPayload) return false;
  uint64_t here = size;
  if (size > size_ - 35) {
    const uint64_t least = (size_ - 12) * 32 / 255 - 23;
    here = least + (size - least) % (size_ - 4);
    if (here > size_ - 35) here = least;
  }
  if (at + here + (here < size ? 4 : 0) > size_) return false;
  const auto first = page.begin() + static_cast<std::ptrdiff_t>(at);
  out.assign(first, first + static_cast<std::ptrdiff_t>(here));
  uint64_t next = here < size ? big_endian(page.data() + at + here, 4) : 0;
  std::vector<uint8_t> more;
  while (out.size() < size) {
    if (next == 0 || next > count_ || !this->page(next, more)) return false;
    next = big_endian(more.data(), 4);
    const std::size_t take = std::min<std::size_t>(size - out.size(), size_ - 4);
    out.insert(out.end(), more.begin() + 4, more.begin() + 4 + static_cast<std::ptrdiff_t>(take));
  }
  return true;
}

uint64_t SqlitePages::each_row(const std::function<void(const Row&)>& visit) {
  uint64_t lost = 0;
  std::vector<uint8_t> page, record;
  Row row;
  for (uint64_t number = 1; number <= count_; ++number) {
    if (!this->page(number, page)) continue;
    const std::size_t head = number == 1 ? kFileHeader : 0;
    if (page[head] != kTableLeaf) continue;
    const std::size_t cells = big_endian(&page[head + 3], 2), first = head + kLeafHeader;
    for (std::size_t i = 0; i < cells && first + 2 * i + 2 <= size_; ++i) {
      const std::size_t at = big_endian(&page[first + 2 * i], 2);
      if (at >= first && payload(page, at, record) && take_row(record, row))
        visit(row);
      else
        ++lost;
    }
  }
  return lost;
}

}  // namespace swage::record
