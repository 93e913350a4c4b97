// SPDX-License-Identifier: Apache-2.0
#include "record/codec.hpp"

#include <zstd.h>

#include <array>
#include <bit>
#include <cstring>
#include <vector>

namespace swage::record {
namespace {

static_assert(std::endian::native == std::endian::little,
              "chunks are little-endian; swap bytes here on other machines");

constexpr int kLevel = 1;  // higher levels gain under 3 % on hand traces and cost three times as much

constexpr std::array<uint32_t, 256> crc_table() {
  std::array<uint32_t, 256> table{};
  for (uint32_t i = 0; i < 256; ++i) {
    uint32_t c = i;
    for (int bit = 0; bit < 8; ++bit) c = (c >> 1) ^ ((c & 1) != 0 ? 0x82F63B78u : 0u);
    table[i] = c;
  }
  return table;
}
constexpr std::array<uint32_t, 256> kCrcTable = crc_table();

// byte b of word i of the column-major, differenced table is at b * count + i
template <class Word>
Blob shuffle(const Word* table, std::size_t rows, std::size_t columns) {
  const std::size_t count = rows * columns;
  Blob out(count * sizeof(Word));
  std::size_t i = 0;
  for (std::size_t c = 0; c < columns; ++c) {
    Word above = 0;
    for (std::size_t r = 0; r < rows; ++r, ++i) {
      const Word word = table[r * columns + c];
      const Word delta = word ^ above;
      above = word;
      for (std::size_t b = 0; b < sizeof(Word); ++b)
        out[b * count + i] = static_cast<uint8_t>(delta >> (8 * b));
    }
  }
  return out;
}

template <class Word>
void unshuffle(const Blob& in, Word* table, std::size_t rows, std::size_t columns) {
  const std::size_t count = rows * columns;
  std::size_t i = 0;
  for (std::size_t c = 0; c < columns; ++c) {
    Word above = 0;
    for (std::size_t r = 0; r < rows; ++r, ++i) {
      Word delta = 0;
      for (std::size_t b = 0; b < sizeof(Word); ++b)
        delta |= static_cast<Word>(Word{in[b * count + i]} << (8 * b));
      above ^= delta;
      table[r * columns + c] = above;
    }
  }
}

template <class Word>
Packed pack_words(const Word* table, std::size_t rows, std::size_t columns) {
  Packed out;
  const Blob plain = shuffle(table, rows, columns);
  out.data.resize(ZSTD_compressBound(plain.size()));
  const std::size_t size =
      ZSTD_compress(out.data.data(), out.data.size(), plain.data(), plain.size(), kLevel);
  if (ZSTD_isError(size) == 0 && size < plain.size()) {
    out.codec = Codec::kZstdShuffleXor;
    out.data.resize(size);
  } else {
    out.data.resize(plain.size());
    if (!plain.empty()) std::memcpy(out.data.data(), table, plain.size());
  }
  out.crc = crc32c(out.data.data(), out.data.size());
  return out;
}

template <class Word>
bool unpack_words(int64_t codec, uint32_t crc, const Blob& data, Word* table, std::size_t rows,
                  std::size_t columns) {
  const std::size_t bytes = rows * columns * sizeof(Word);
  if (crc32c(data.data(), data.size()) != crc) return false;
  if (codec == static_cast<int64_t>(Codec::kRaw)) {
    if (data.size() != bytes) return false;
    if (bytes > 0) std::memcpy(table, data.data(), bytes);
    return true;
  }
  if (codec != static_cast<int64_t>(Codec::kZstd) && codec != static_cast<int64_t>(Codec::kZstdShuffleXor))
    return false;
  Blob plain(bytes);
  const std::size_t size = ZSTD_decompress(plain.data(), plain.size(), data.data(), data.size());
  if (ZSTD_isError(size) != 0 || size != bytes) return false;
  if (codec == static_cast<int64_t>(Codec::kZstd)) {
    if (bytes > 0) std::memcpy(table, plain.data(), bytes);
  } else {
    unshuffle(plain, table, rows, columns);
  }
  return true;
}

}  // namespace

uint32_t crc32c(const void* data, std::size_t size) {
  const uint8_t* byte = static_cast<const uint8_t*>(data);
  uint32_t c = ~0u;
  for (std::size_t i = 0; i < size; ++i) c = kCrcTable[(c ^ byte[i]) & 0xff] ^ (c >> 8);
  return ~c;
}

Packed pack(const uint64_t* table, std::size_t rows, std::size_t columns) {
  return pack_words(table, rows, columns);
}

Packed pack(const float* table, std::size_t rows, std::size_t columns) {
  std::vector<uint32_t> words(rows * columns);
  if (!words.empty()) std::memcpy(words.data(), table, words.size() * sizeof(uint32_t));
  return pack_words(words.data(), rows, columns);
}

bool unpack(int64_t codec, uint32_t crc, const Blob& data, uint64_t* table, std::size_t rows,
            std::size_t columns) {
  return unpack_words(codec, crc, data, table, rows, columns);
}

bool unpack(int64_t codec, uint32_t crc, const Blob& data, float* table, std::size_t rows,
            std::size_t columns) {
  std::vector<uint32_t> words(rows * columns);
  if (!unpack_words(codec, crc, data, words.data(), rows, columns)) return false;
  if (!words.empty()) std::memcpy(table, words.data(), words.size() * sizeof(uint32_t));
  return true;
}

}  // namespace swage::record
