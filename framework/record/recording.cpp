// SPDX-License-Identifier: Apache-2.0
#include <cstring>

#include "record/chunk_buffer.hpp"
#include "record/codec.hpp"
#include "record/recorder.hpp"
#include "record/schema.hpp"
#include "record/store.hpp"

namespace swage::record {
namespace {

// the chunks of one stream, unpacked one behind the other
template <class Word>
bool read_stream(Database& db, const std::string& id, const char* stream, std::size_t columns,
                 std::vector<Word>& table, std::string& error) {
  int64_t expected = 0;
  bool ok = true;
  const auto visit = [&](const Row& r) {
    const int64_t n = integer(r[1]);
    ok = integer(r[0]) == expected++ && n > 0 && n <= kMaxChunkRows;
    if (!ok) return false;
    const std::size_t first = table.size(), rows = static_cast<std::size_t>(n);
    table.resize(first + rows * columns);
    ok = unpack(integer(r[2]), static_cast<uint32_t>(integer(r[3])), blob(r[4]), table.data() + first, rows,
                columns);
    return ok;
  };
  const bool read =
      columns == 0 || db.each(
                          "SELECT seq, n, codec, crc32c, data FROM chunk WHERE attempt_id = ? AND"
                          " stream = ? ORDER BY seq",
                          {id, std::string(stream)}, visit);
  if (read && ok) return true;
  error = "The recording of attempt " + id + " is damaged: chunk " + std::to_string(expected - 1) +
          " of stream \"" + stream + "\" " +
          (read ? "does not fit its checksum." : "cannot be read: " + db.error() + ".");
  return false;
}

bool read_info(Database& db, const std::string& id, AttemptInfo& info, std::string& error) {
  const std::vector<Row> rows = db.rows(
      "SELECT p.pseudonym, a.exercise, a.title, a.mode, a.device, a.descriptor, a.descriptor_path, "
      "a.plugins, a.devices,"
      " a.script, a.seed, a.dt_s, a.realtime FROM attempt a JOIN session s ON s.session_id = a.session_id"
      " JOIN person p ON p.person_id = s.person_id WHERE a.attempt_id = ?",
      {id});
  if (rows.empty()) {
    error = db.trouble() == Trouble::kNone ? "There is no attempt " + id + "." : db.error() + ".";
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
      "The head of attempt " + id + " is damaged: its plugins, devices or names are not what Swage writes.";
  return false;
}

// what attempts carry since version 2
bool read_luggage(Database& db, const std::string& id, AttemptInfo& info, std::string& error) {
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
      error = "The file \"" + text(r[0]) + "\" of attempt " + id + " does not fit its checksum.";
      return false;
    }
    info.files.push_back({text(r[0]), std::string(data.begin(), data.end())});
  }
  if (db.trouble() == Trouble::kNone) return true;
  error = "The hands and files of attempt " + id + " cannot be read: " + db.error() + ".";
  return false;
}

bool read_streams(Database& db, const std::string& id, Recording& out, std::string& error) {
  const std::size_t devices = out.info.devices.size(), signals = out.info.script.signals.size();
  if (devices > snapshot::kMaxDevices || signals > snapshot::kMaxSignals) {
    error = "Attempt " + id + " claims more devices or signals than a scene can have.";
    return false;
  }
  std::vector<uint64_t> hash, input, command;
  if (!read_stream(db, id, kHashStream, kHashWords, hash, error) ||
      !read_stream(db, id, kInputStream, devices * kSampleWords, input, error) ||
      !read_stream(db, id, kSignalStream, signals, out.signal, error) ||
      !read_stream(db, id, kCommandStream, kCommandWords, command, error))
    return false;
  const std::size_t steps = hash.size() / kHashWords;
  if (input.size() != steps * devices * kSampleWords || out.signal.size() != steps * signals) {
    error = "The recording of attempt " + id + " is damaged: its streams are not equally long.";
    return false;
  }
  for (std::size_t i = 0; i < steps; ++i) {
    out.step.push_back(hash[kHashWords * i]);
    out.hash.push_back(hash[kHashWords * i + 1]);
  }
  out.sample.resize(steps * devices);
  if (!input.empty()) std::memcpy(out.sample.data(), input.data(), input.size() * sizeof(uint64_t));
  out.commands.resize(command.size() / kCommandWords);
  if (!command.empty())
    std::memcpy(static_cast<void*>(out.commands.data()), command.data(), command.size() * sizeof(uint64_t));
  return true;
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

}  // namespace

bool read_recording(const std::string& store_or_file, const std::string& attempt_id, Recording& out,
                    std::string& error) {
  const std::string where = store_or_file.empty() ? Store::default_path() : store_or_file;
  const std::unique_ptr<Database> db = open_for_reading(where, error);
  if (!db) return false;
  std::string id = attempt_id;
  if (id.empty()) {
    const std::vector<Row> rows = db->rows("SELECT attempt_id FROM attempt LIMIT 2");
    if (rows.size() != 1) {
      error = where + (rows.empty() ? " holds no attempt." : " holds several attempts: say which one.");
      return false;
    }
    id = text(rows[0][0]);
  }
  out = Recording();
  if (read_info(*db, id, out.info, error) && read_luggage(*db, id, out.info, error) &&
      read_streams(*db, id, out, error) && read_events(*db, id, out, error))
    return true;
  return false;
}

}  // namespace swage::record
