// SPDX-License-Identifier: Apache-2.0
#include "record/journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/hash.hpp"
#include "record/codec.hpp"
#include "record/store.hpp"

namespace swage::record {
namespace {

namespace fs = std::filesystem;

constexpr char kMagic[8] = {'S', 'W', 'A', 'G', 'E', 'J', '1', '\n'};
constexpr std::string_view kEnding = ".journal";

// 8 MiB hold the inputs of one hand for about two minutes: time to finish and to free space. At most an
// eighth of the free space, so that the reserve itself does not fill the disk.
constexpr uint64_t kReserve = 8u << 20;

// "/folder/attempts.db-"; a server has no folder, so its journals are beside the user's own store
std::string prefix(const std::string& store) {
  if (is_postgres(store)) {
    char name[32];
    const std::string who = shown(store);
    std::snprintf(name, sizeof name, "server-%016llx-", static_cast<unsigned long long>(base::hash(who)));
    return (fs::path(Store::default_path()).parent_path() / name).string();
  }
  std::error_code code;
  const fs::path whole = fs::weakly_canonical(fs::absolute(store, code), code);
  return (code ? store : whole.string()) + "-";
}

// A frame is a quarter of a second, some ten kB, or the head of an attempt with its files, at most 16 MiB.
constexpr uint32_t kMostFrame = 64u << 20;

void put(Blob& out, const void* data, std::size_t size) {
  const auto* from = static_cast<const uint8_t*>(data);
  out.insert(out.end(), from, from + size);
}

template <class T>
void put(Blob& out, T number) {
  put(out, &number, sizeof number);
}

// a value is its kind (the index in Value) and its bytes
void put(Blob& out, const Value& value) {
  put(out, static_cast<uint8_t>(value.index()));
  if (const auto* i = std::get_if<int64_t>(&value)) put(out, *i);
  if (const auto* d = std::get_if<double>(&value)) put(out, *d);
  if (const auto* s = std::get_if<std::string>(&value)) {
    put(out, static_cast<uint32_t>(s->size()));
    put(out, s->data(), s->size());
  }
  if (const auto* b = std::get_if<Blob>(&value)) {
    put(out, static_cast<uint32_t>(b->size()));
    put(out, b->data(), b->size());
  }
}

// reads forward through untrusted bytes
class Reader {
 public:
  Reader(const uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
  bool take(void* to, std::size_t size) {
    if (static_cast<std::size_t>(end_ - at_) < size) return false;
    if (size > 0) std::memcpy(to, at_, size);
    at_ += size;
    return true;
  }
  template <class T>
  bool take(T& number) {
    return take(&number, sizeof number);
  }
  template <class Bytes>
  bool take_bytes(Bytes& out) {
    uint32_t size = 0;
    if (!take(size) || static_cast<std::size_t>(end_ - at_) < size) return false;
    out.resize(size);
    return take(out.data(), size);
  }
  bool take(Value& value) {
    uint8_t kind = 0;
    if (!take(kind)) return false;
    switch (kind) {
      case 0:
        value = std::monostate{};
        return true;
      case 1:
        return take(value.emplace<int64_t>());
      case 2:
        return take(value.emplace<double>());
      case 3:
        return take_bytes(value.emplace<std::string>());
      case 4:
        return take_bytes(value.emplace<Blob>());
      default:
        return false;
    }
  }
  bool at_end() const { return at_ == end_; }
  const uint8_t* here() const { return at_; }

 private:
  const uint8_t *at_, *end_;
};

bool take(Reader& in, Batch& batch) {
  while (!in.at_end()) {
    uint8_t kind = 0;
    if (!in.take(kind) || kind >= kKinds) return false;
    Write w{static_cast<Kind>(kind), Row(arity(static_cast<Kind>(kind)))};
    for (Value& v : w.values)
      if (!in.take(v)) return false;
    batch.push_back(std::move(w));
  }
  return true;
}

bool write_all(int file, const Blob& data, uint64_t offset) {
  std::size_t done = 0;
  while (done < data.size()) {
    const ssize_t n = pwrite(file, data.data() + done, data.size() - done, static_cast<off_t>(offset + done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

}  // namespace

std::unique_ptr<Journal> Journal::create(const std::string& store, const std::string& attempt_id) {
  const std::string path = prefix(store) + attempt_id + std::string(kEnding);
  // for the first attempt of a user there is no folder yet
  std::error_code code;
  if (fs::create_directories(fs::path(path).parent_path(), code))
    fs::permissions(fs::path(path).parent_path(), fs::perms::owner_all, code);

  // locked before it is renamed, so that no program can take it for that of a dead one
  const std::string unnamed = path + ".new";
  const int file = ::open(unnamed.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (file < 0) return nullptr;
  if (flock(file, LOCK_EX | LOCK_NB) != 0 || rename(unnamed.c_str(), path.c_str()) != 0) {
    close(file);
    unlink(unnamed.c_str());
    return nullptr;
  }
  struct statvfs disk {};
  if (fstatvfs(file, &disk) == 0) {
    const uint64_t room = std::min<uint64_t>(kReserve, uint64_t{disk.f_bavail} * disk.f_frsize / 8);
    // a file system that cannot reserve space leaves the file empty
    if (room > 0 && fallocate(file, 0, 0, static_cast<off_t>(room)) != 0) (void)ftruncate(file, 0);
  }
  return std::unique_ptr<Journal>(new Journal(file, path));
}

Journal::~Journal() {
  if (empty()) remove();
  close(file_);
}

bool Journal::is_whole() const {
  struct stat mine {}, named {};
  return fstat(file_, &mine) == 0 && stat(path_.c_str(), &named) == 0 && mine.st_ino == named.st_ino &&
         mine.st_dev == named.st_dev && static_cast<uint64_t>(mine.st_size) >= size_;
}

void Journal::remove() { unlink(path_.c_str()); }

bool Journal::append(const Batch& batch) {
  if (batch.empty()) return true;  // a frame of length 0 would mean the end
  Blob payload;
  for (const Write& w : batch) {
    put(payload, static_cast<uint8_t>(w.kind));
    for (const Value& v : w.values) put(payload, v);
  }
  Blob frame;
  if (size_ == 0) put(frame, kMagic, sizeof kMagic);
  put(frame, static_cast<uint32_t>(payload.size()));
  put(frame, crc32c(payload.data(), payload.size()));
  put(frame, payload.data(), payload.size());
  if (!write_all(file_, frame, size_)) return false;
  size_ += frame.size();
  return true;
}

bool is_recording(const std::string& store, const std::string& attempt_id) {
  if (attempt_id.find('/') != std::string::npos) return false;  // not one of our names: no other folder is searched
  const std::string path = prefix(store) + attempt_id + std::string(kEnding);
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool locked = flock(file, LOCK_SH | LOCK_NB) != 0;
  close(file);
  return locked;
}

bool merge_journal(Database& db, const std::string& path) {
  std::error_code code;
  if (!fs::is_regular_file(path, code)) return false;
  uint64_t left = fs::file_size(path, code);
  std::ifstream in(path, std::ios::binary);
  const auto take_from = [&](void* to, std::size_t size) {
    if (left < size || !in.read(static_cast<char*>(to), static_cast<std::streamsize>(size))) return false;
    left -= size;
    return true;
  };
  char magic[8] = {};
  if (!take_from(magic, sizeof magic) || std::memcmp(magic, kMagic, sizeof magic) != 0)
    return true;  // nothing was ever written
  for (;;) {
    uint32_t size = 0, crc = 0;
    if (!take_from(&size, sizeof size) || !take_from(&crc, sizeof crc) || size == 0) return true;
    // torn: the frame was not written completely
    if (size > left || size > kMostFrame) return true;
    Blob frame(size);
    if (!take_from(frame.data(), size) || crc32c(frame.data(), size) != crc) return true;
    Batch batch;
    Reader rows(frame.data(), size);
    if (!take(rows, batch)) return true;
    if (!write_batch(db, batch)) return false;
  }
}

int merge_journals(Database& db, const std::string& store) {
  int merged = 0;
  const fs::path first = prefix(store);
  std::error_code code;
  for (const fs::directory_entry& entry : fs::directory_iterator(first.parent_path(), code)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(first.filename().string()) || !name.ends_with(kEnding)) continue;
    if (!entry.is_regular_file(code)) continue;
    const int file = ::open(entry.path().c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) continue;
    // locked by a running program, which will handle it
    if (flock(file, LOCK_EX | LOCK_NB) == 0 && merge_journal(db, entry.path().string())) {
      unlink(entry.path().c_str());
      ++merged;
    }
    close(file);
  }
  return merged;
}

}  // namespace swage::record
