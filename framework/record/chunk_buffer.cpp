// SPDX-License-Identifier: Apache-2.0
#include "record/chunk_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "record/codec.hpp"

namespace swage::record {
namespace {

using nlohmann::json;

json column(const std::string& name, const char* unit, const char* type) {
  return {{"name", name}, {"unit", unit}, {"type", type}};
}

// the layout of swage_sample, word by word
json sample_columns(const std::string& device) {
  struct Word {
    const char *name, *unit, *type;
  };
  static constexpr Word kWords[] = {
      {"sequence", "1", "u64"},      {"time_s", "s", "f64"},        {"pose.p.x", "m", "f64"},
      {"pose.p.y", "m", "f64"},      {"pose.p.z", "m", "f64"},      {"pose.q.w", "1", "f64"},
      {"pose.q.x", "1", "f64"},      {"pose.q.y", "1", "f64"},      {"pose.q.z", "1", "f64"},
      {"twist.v.x", "m/s", "f64"},   {"twist.v.y", "m/s", "f64"},   {"twist.v.z", "m/s", "f64"},
      {"twist.w.x", "rad/s", "f64"}, {"twist.w.y", "rad/s", "f64"}, {"twist.w.z", "rad/s", "f64"},
      {"closure", "1", "f64"},       {"grip_force", "N", "f64"},    {"buttons, valid", "1", "2 x u32"},
  };
  static_assert(sizeof kWords / sizeof kWords[0] == kSampleWords);
  json out = json::array();
  for (const Word& w : kWords) out.push_back(column(device + "." + w.name, w.unit, w.type));
  return out;
}

std::string input_dictionary(const AttemptInfo& info) {
  json out = json::array();
  for (const std::string& device : info.devices)
    for (const json& c : sample_columns(device)) out.push_back(c);
  return out.dump();
}

std::string signal_dictionary(const AttemptInfo& info) {
  json out = json::array();
  for (const judge::Name& s : info.script.signals)
    out.push_back(column(s.owner + "." + s.id, s.unit.c_str(), "f32"));
  return out.dump();
}

// the layout of CommandRecord, word by word
std::string command_dictionary() {
  json out = {column("step", "1", "u64"), column("kind, object", "1", "2 x u32"),
              column("parameter", "1", "u32")};
  for (const char* name : {"number.0", "number.1", "number.2", "number.3"})
    out.push_back(column(name, "SI", "f64"));
  return out.dump();
}

const judge::Name& name_of(const std::vector<judge::Name>& names, uint32_t index) {
  static const judge::Name kUnknown;
  return index < names.size() ? names[index] : kUnknown;
}

}  // namespace

uint64_t steps_in(const Batch& batch) {
  uint64_t steps = 0;
  for (const Write& w : batch)
    if (w.kind == Kind::kChunk && text(w.values[1]) == kHashStream)
      steps += static_cast<uint64_t>(integer(w.values[4]));
  return steps;
}

ChunkBuffer::ChunkBuffer(std::string attempt_id, const AttemptInfo& info)
    : attempt_id_(std::move(attempt_id)),
      info_(info),
      hash_stream_{kHashStream, json{column("step", "1", "u64"), column("hash", "1", "u64")}.dump()},
      input_stream_{kInputStream, input_dictionary(info)},
      signal_stream_{kSignalStream, signal_dictionary(info)},
      command_stream_{kCommandStream, command_dictionary()} {}

void ChunkBuffer::add(const StepRecord& record) {
  if (started_ && record.step > next_step_) {
    gap(next_step_, "steps", record.step - next_step_);
    lost_ += record.step - next_step_;
  }
  started_ = true;
  next_step_ = record.step + 1;
  hash_.push_back(record.step);
  hash_.push_back(record.hash);

  // every step has the same columns, even if a record differs
  const std::size_t devices = std::min<std::size_t>(info_.devices.size(), snapshot::kMaxDevices);
  const std::size_t first = input_.size();
  input_.resize(first + devices * kSampleWords);
  if (devices > 0) std::memcpy(&input_[first], record.sample, devices * sizeof(swage_sample));
  const std::size_t signals = std::min<std::size_t>(info_.script.signals.size(), snapshot::kMaxSignals);
  for (std::size_t i = 0; i < signals; ++i) signal_.push_back(static_cast<float>(record.signal[i]));
}

void ChunkBuffer::add(const CommandRecord& command) {
  static_assert(sizeof command == kCommandWords * 8);
  const std::size_t first = command_.size();
  command_.resize(first + kCommandWords);
  std::memcpy(&command_[first], &command, sizeof command);
}

void ChunkBuffer::add(const judge::Event& event) {
  const judge::Name& name = name_of(info_.script.events, event.event);
  add_event(event.step, "script", int64_t{event.event}, name.owner, name.id, event.value);
}

void ChunkBuffer::note(uint64_t step, const std::string& text) {
  add_event(step, "note", -1, "note", text, 0);
}

void ChunkBuffer::gap(uint64_t step, const std::string& what, uint64_t lost) {
  add_event(step, "gap", -1, "gap", what, static_cast<double>(lost));
}

void ChunkBuffer::add_event(uint64_t step, const char* kind, int64_t index, const std::string& owner,
                            const std::string& body, double value) {
  const auto t_us = static_cast<int64_t>(std::llround(static_cast<double>(step) * info_.dt * 1e6));
  events_.push_back({Kind::kEvent,
                     {attempt_id_, event_count_++, static_cast<int64_t>(step), t_us, std::string(kind), index,
                      owner, body, value}});
}

template <class Word>
void ChunkBuffer::emit(Batch& out, Stream& stream, uint64_t first_step, std::vector<Word>& table,
                       std::size_t columns) {
  if (table.empty()) return;
  const std::size_t rows = table.size() / columns;
  Packed packed = pack(table.data(), rows, columns);
  const auto t0_us = static_cast<int64_t>(std::llround(static_cast<double>(first_step) * info_.dt * 1e6));
  const Value dictionary = stream.chunks == 0 ? Value(stream.dictionary) : Value();
  out.push_back(
      {Kind::kChunk,
       {attempt_id_, std::string(stream.name), stream.chunks++, t0_us, static_cast<int64_t>(rows),
        static_cast<int64_t>(packed.codec), int64_t{packed.crc}, std::move(packed.data), dictionary}});
  table.clear();
}

Batch ChunkBuffer::take() {
  Batch out;
  const uint64_t first = hash_.empty() ? next_step_ : hash_.front();
  const std::size_t rows = steps();
  const std::size_t input_columns = rows == 0 ? 0 : input_.size() / rows;
  const std::size_t signal_columns = rows == 0 ? 0 : signal_.size() / rows;
  emit(out, hash_stream_, first, hash_, kHashWords);
  emit(out, input_stream_, first, input_, input_columns);
  emit(out, signal_stream_, first, signal_, signal_columns);
  emit(out, command_stream_, command_.empty() ? 0 : command_.front(), command_, kCommandWords);
  out.insert(out.end(), std::make_move_iterator(events_.begin()), std::make_move_iterator(events_.end()));
  events_.clear();
  return out;
}

}  // namespace swage::record
