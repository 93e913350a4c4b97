// SPDX-License-Identifier: Apache-2.0
//
// A quarter of a second of an attempt, between records of the step and rows of the store.
//
// Streams, each a table of words per step (the dictionary of its first chunk names the columns):
//   hash     step, hash                      u64
//   input    each device's swage_sample      18 u64 words: exactly the bits that the step saw
//   signal   each signal of the script       f32: plots, never replayed
//   command  each CommandRecord              7 u64 words, one row per command
#pragma once

#include <string>
#include <vector>

#include "record/attempt_rows.hpp"

namespace swage::record {

inline constexpr const char* kHashStream = "hash";
inline constexpr const char* kInputStream = "input";
inline constexpr const char* kSignalStream = "signal";
inline constexpr const char* kCommandStream = "command";
inline constexpr std::size_t kSampleWords = sizeof(swage_sample) / 8;
inline constexpr std::size_t kHashWords = 2, kCommandWords = sizeof(CommandRecord) / 8;

// 250 steps = 250 ms at 1 kHz: largest loss when the program is killed. Shorter chunks compress worse and commit
// more often.
inline constexpr std::size_t kChunkSteps = 250;
// limit of the rows of a valid chunk: 250 steps, or as many commands as the step's ring holds
inline constexpr int64_t kMaxChunkRows = 4096;

/// Number of steps whose chunks are in a batch.
uint64_t steps_in(const Batch&);

/// Threads: only the writer thread.
class ChunkBuffer {
 public:
  ChunkBuffer(std::string attempt_id, const AttemptInfo& info);

  void add(const StepRecord&);  // a jump in the step number becomes a gap
  void add(const CommandRecord&);
  void add(const judge::Event&);
  void note(uint64_t step, const std::string& text);
  void gap(uint64_t step, const std::string& what, uint64_t lost);

  std::size_t steps() const { return hash_.size() / kHashWords; }
  bool empty() const { return hash_.empty() && command_.empty() && events_.empty(); }
  /// Returns everything added since the last call, packed; the buffer is then empty.
  Batch take();
  uint64_t steps_lost_in_gaps() const { return lost_; }
  uint64_t next_step() const { return next_step_; }

 private:
  struct Stream {
    const char* name;
    std::string dictionary;
    int64_t chunks = 0;
  };
  template <class Word>
  void emit(Batch& out, Stream& stream, uint64_t first_step, std::vector<Word>& table, std::size_t columns);
  void add_event(uint64_t step, const char* kind, int64_t index, const std::string& owner,
                 const std::string& body, double value);

  const std::string attempt_id_;
  const AttemptInfo info_;
  Stream hash_stream_, input_stream_, signal_stream_, command_stream_;
  std::vector<uint64_t> hash_, input_, command_;
  std::vector<float> signal_;
  Batch events_;
  int64_t event_count_ = 0;
  uint64_t next_step_ = 0, lost_ = 0;
  bool started_ = false;
};

}  // namespace swage::record
