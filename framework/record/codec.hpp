// SPDX-License-Identifier: Apache-2.0
//
// Lossless packing of tables of equal words: each word xor the one above it (slow signals leave mostly zeros),
// bytes of equal significance together, zstd level 1. A hand at 1 kHz is compressed about 5:1, at 0.15 ms
// per quarter of a second.
#pragma once

#include <cstddef>
#include <cstdint>

#include "record/sql.hpp"

namespace swage::record {

enum class Codec : int64_t { kRaw = 0, kZstd = 1, kZstdShuffleXor = 2 };

/// `table` is row-major, rows x columns words of 4 or 8 bytes. Incompressible tables stay raw.
struct Packed {
  Codec codec = Codec::kRaw;
  uint32_t crc = 0;  // CRC-32C of `data`
  Blob data;
};
Packed pack(const uint64_t* table, std::size_t rows, std::size_t columns);
Packed pack(const float* table, std::size_t rows, std::size_t columns);

/// The inverse. False when the data does not match its checksum or the size; `table` is then
/// unspecified.
bool unpack(int64_t codec, uint32_t crc, const Blob& data, uint64_t* table, std::size_t rows,
            std::size_t columns);
bool unpack(int64_t codec, uint32_t crc, const Blob& data, float* table, std::size_t rows,
            std::size_t columns);

/// CRC-32C (Castagnoli), as in iSCSI: polynomial 0x1EDC6F41 reflected, start and end inverted.
uint32_t crc32c(const void* data, std::size_t size);

}  // namespace swage::record
