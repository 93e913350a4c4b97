// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>

#include "record/chunk_buffer.hpp"
#include "record/codec.hpp"
#include "record/recorder.hpp"
#include "record/schema.hpp"
#include "record/sentences.hpp"
#include "record/store.hpp"

namespace swage::record {
namespace {

// Limit of the bytes of columns read into memory, so that a small file cannot exhaust it: an hour of one hand and twenty signals.
constexpr uint64_t kMostBytes = 900'000'000;
// Limits of what Swage writes: texts include the lesson with its scene and the names of the script; blobs are files of up to
// 16 MiB or chunks of some kB.
constexpr int64_t kMostText = 8 << 20, kMostBlob = 32 << 20;

// Unpacks the chunks of one stream in order, and passes each to sink(words, rows).
template <class Word, class Sink>
bool read_stream(Database& db, const std::string& id, const char* stream, std::size_t columns,
                 std::string& error, const Sink& sink) {
  int64_t expected = 0;
  bool ok = true;
  std::vector<Word> table;
  const auto visit = [&](const Row& r) {
    const int64_t n = integer(r[1]);
    ok = integer(r[0]) == expected++ && n > 0 && n <= kMaxChunkRows;
    if (!ok) return false;
    const std::size_t rows = static_cast<std::size_t>(n);
    table.resize(rows * columns);
    ok = unpack(integer(r[2]), static_cast<uint32_t>(integer(r[3])), blob(r[4]), table.data(), rows, columns);
    if (ok) ok = sink(table.data(), rows);
    return ok;
  };
  const bool read =
      columns == 0 || db.each(
                          "SELECT seq, n, codec, crc32c, data FROM chunk WHERE attempt_id = ? AND"
                          " stream = ? ORDER BY seq",
                          {id, std::string(stream)}, visit);
  if (read && ok) return true;
  if (!error.empty()) return false;
  error = "The recording of attempt " + id + " is damaged: chunk " + std::to_string(expected - 1) +
          " of stream \"" + stream + "\" " +
          (read ? "does not fit its checksum." : "cannot be read: " + db.error() + ".");
  return false;
}

// Checks the sizes before a column is read into memory.
bool has_no_giants(Database& db, const std::string& id, std::string& error) {
  if (db.on_postgres()) return true;
  for (const char* table : {"attempt", "metric", "event", "chunk", "hand", "file"}) {
    std::string where;
    for (const Row& column : db.rows("SELECT name FROM pragma_table_info('" + std::string(table) + "')")) {
      const bool is_blob = text(column[0]) == "data";
      where += std::string(where.empty() ? "" : " OR ") + "LENGTH(" + text(column[0]) + ") > " +
               std::to_string(is_blob ? kMostBlob : kMostText);
    }
    if (where.empty()) continue;  // no such table: it belongs to a later version of the schema
    const std::vector<Row> found = db.rows(
        "SELECT 1 FROM " + std::string(table) + " WHERE attempt_id = ? AND (" + where + ") LIMIT 1", {id});
    if (db.trouble() == Trouble::kNone && found.empty()) continue;
    error = db.trouble() != Trouble::kNone
                ? "Attempt " + id + " cannot be read: " + db.error() + "."
                : say::kDamagedTable(id, table);
    return false;
  }
  return true;
}

bool read_info(Database& db, const std::string& id, AttemptInfo& info, std::string& error) {
  const std::vector<Row> rows = db.rows(
      "SELECT p.pseudonym, a.exercise, a.title, a.mode, a.device, a.descriptor, a.descriptor_path, "
      "a.plugins, a.devices,"
      " a.script, a.seed, a.dt_s, a.realtime FROM attempt a JOIN session s ON s.session_id = a.session_id"
      " JOIN person p ON p.person_id = s.person_id WHERE a.attempt_id = ?",
      {id});
  if (rows.empty()) {
    error = db.trouble() == Trouble::kNone ? say::kNoAttemptAtAll(id) : db.error() + ".";
    return false;
  }
  const Row& r = rows[0];
  info.person = text(r[0]);
  info.lesson_id = text(r[1]);
  info.lesson_title = text(r[2]);
  info.mode = text(r[3]);
  info.device = text(r[4]);
  info.descriptor_text = text(r[5]);
  info.descriptor_path = text(r[6]);
  info.seed = static_cast<uint64_t>(integer(r[10]));
  info.dt = real(r[11]);
  info.realtime = integer(r[12]) != 0;
  if (from_json(text(r[7]), info.plugins) && from_json(text(r[8]), info.devices) &&
      from_json(text(r[9]), info.script))
    return true;
  error =
      say::kDamagedHead(id);
  return false;
}

// attachments of attempts since version 2
bool read_attachments(Database& db, const std::string& id, AttemptInfo& info, std::string& error) {
  if (schema_version(db) < 2) return true;
  for (const Row& r : db.rows(
           "SELECT name, choice, plugin, version, params, flags FROM hand WHERE attempt_id = ? ORDER BY seq",
           {id}))
    info.hands.push_back(
        {text(r[0]), text(r[1]), text(r[2]), text(r[3]), text(r[4]), static_cast<uint32_t>(integer(r[5]))});
  for (const Row& r :
       db.rows("SELECT name, crc32c, data FROM file WHERE attempt_id = ? ORDER BY name", {id})) {
    const Blob& data = blob(r[2]);
    if (crc32c(data.data(), data.size()) != static_cast<uint32_t>(integer(r[1]))) {
      error = say::kFileChecksum(text(r[0]), id);
      return false;
    }
    std::string bytes(data.begin(), data.end());
    if (text(r[0]) == kDisplayFile && from_json(bytes, info.display)) continue;
    info.files.push_back({text(r[0]), std::move(bytes)});
  }
  if (db.trouble() == Trouble::kNone) return true;
  error = "The hands and files of attempt " + id + " cannot be read: " + db.error() + ".";
  return false;
}

// Reads the numbers of rows before any chunk is unpacked, and reserves the memory at once: a growing vector needs up to twice
// its size.
bool make_room(Database& db, const std::string& id, Recording& out, std::string& error) {
  const std::size_t devices = out.info.devices.size(), signals = out.info.script.signals.size();
  const auto rows_of = [&](const char* stream) {
    const std::vector<Row> rows = db.rows(
        "SELECT COALESCE(SUM(n), 0) FROM chunk WHERE attempt_id = ? AND stream = ? AND n BETWEEN 1 AND " + std::to_string(kMaxChunkRows),
        {id, std::string(stream)});
    return rows.empty() ? 0.0 : std::max(0.0, real(rows[0][0]));
  };
  const double hashes = rows_of(kHashStream), inputs = rows_of(kInputStream) * static_cast<double>(devices),
               traces = rows_of(kSignalStream) * static_cast<double>(signals), commands = rows_of(kCommandStream);
  const double bytes = hashes * 16 + inputs * sizeof(swage_sample) + traces * sizeof(float) +
                       commands * sizeof(CommandRecord);
  if (!(bytes <= static_cast<double>(kMostBytes))) {
    error = say::kTooLong(id, kMostBytes / 1'000'000);
    return false;
  }
  out.step.reserve(static_cast<std::size_t>(hashes));
  out.hash.reserve(static_cast<std::size_t>(hashes));
  out.sample.reserve(static_cast<std::size_t>(inputs));
  out.signal.reserve(static_cast<std::size_t>(traces));
  out.commands.reserve(static_cast<std::size_t>(commands));
  return true;
}

// Reads the streams of an attempt in parallel. With `keep` they are stored in `out`; else they are only checked.
bool read_streams(Database& db, const std::string& id, Recording& out, bool keep, std::string& error) {
  const std::size_t devices = out.info.devices.size(), signals = out.info.script.signals.size();
  if (devices > snapshot::kMaxDevices || signals > snapshot::kMaxSignals) {
    error = say::kTooManyDevices(id);
    return false;
  }
  uint64_t steps = 0, input_rows = 0, signal_rows = 0;
  if (keep && !make_room(db, id, out, error)) return false;
  const auto hashes = [&](const uint64_t* words, std::size_t rows) {
    steps += rows;
    for (std::size_t i = 0; keep && i < rows; ++i) {
      out.step.push_back(words[kHashWords * i]);
      out.hash.push_back(words[kHashWords * i + 1]);
    }
    return true;
  };
  const auto samples = [&](const uint64_t* words, std::size_t rows) {
    input_rows += rows;
    const std::size_t first = out.sample.size(), size = rows * devices * sizeof(swage_sample);
    if (keep) {
      out.sample.resize(first + rows * devices);
      std::memcpy(&out.sample[first], words, size);
    }
    return true;
  };
  const auto traces = [&](const float* values, std::size_t rows) {
    signal_rows += rows;
    if (keep) out.signal.insert(out.signal.end(), values, values + rows * signals);
    return true;
  };
  const auto commands = [&](const uint64_t* words, std::size_t rows) {
    const std::size_t first = out.commands.size();
    if (!keep) return true;
    out.commands.resize(first + rows);
    std::memcpy(static_cast<void*>(&out.commands[first]), words, rows * sizeof(CommandRecord));
    return true;
  };
  if (!read_stream<uint64_t>(db, id, kHashStream, kHashWords, error, hashes) ||
      !read_stream<uint64_t>(db, id, kInputStream, devices * kSampleWords, error, samples) ||
      !read_stream<float>(db, id, kSignalStream, signals, error, traces) ||
      !read_stream<uint64_t>(db, id, kCommandStream, kCommandWords, error, commands))
    return false;
  if (input_rows == (devices > 0 ? steps : 0) && signal_rows == (signals > 0 ? steps : 0)) return true;
  error = say::kUnlikeStreams(id);
  return false;
}

bool read_events(Database& db, const std::string& id, Recording& out, std::string& error) {
  const auto visit = [&](const Row& r) {
    judge::Event event;
    event.step = static_cast<uint64_t>(integer(r[0]));
    event.event = static_cast<uint32_t>(integer(r[1]));
    event.value = real(r[2]);
    out.events.push_back(event);
    return true;
  };
  if (db.each(
          "SELECT step, script_index, value FROM event WHERE attempt_id = ? AND kind = 'script' ORDER BY seq",
          {id}, visit))
    return true;
  error = "The events of attempt " + id + " cannot be read: " + db.error() + ".";
  return false;
}

bool read(const std::string& store_or_file, const std::string& attempt_id, Recording& out, bool keep,
          std::string& error) {
  const std::string where = store_or_file.empty() ? Store::default_path() : store_or_file;
  const std::unique_ptr<Database> db = open_for_reading(where, error);
  if (!db) return false;
  std::string id = attempt_id;
  if (id.empty()) {
    const std::vector<Row> rows = db->rows("SELECT attempt_id FROM attempt LIMIT 2");
    if (rows.size() != 1) {
      error = db->trouble() != Trouble::kNone
                  ? shown(where) + " cannot be read: " + db->error() + "." + remedy(where, db->trouble())
                  : shown(where) +
                        (rows.empty() ? " holds no attempt." : " holds several attempts: say which one.");
      return false;
    }
    id = text(rows[0][0]);
  }
  out = Recording();
  error.clear();
  return has_no_giants(*db, id, error) && read_info(*db, id, out.info, error) &&
         read_attachments(*db, id, out.info, error) && read_streams(*db, id, out, keep, error) &&
         read_events(*db, id, out, error);
}

}  // namespace

bool read_recording(const std::string& store_or_file, const std::string& attempt_id, Recording& out,
                    std::string& error) {
  return read(store_or_file, attempt_id, out, true, error);
}

bool check_recording(const std::string& store_or_file, const std::string& attempt_id, std::string& error) {
  Recording head;
  return read(store_or_file, attempt_id, head, false, error);
}

}  // namespace swage::record
