// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/link/reviewed_attempt.hpp"

#include <algorithm>

#include <QCoreApplication>
#include <cmath>

#include "console/models/metric_limits.hpp"
#include "console/models/said.hpp"

namespace swage::console {
namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(ReviewedAttempt)
};

}  // namespace

// the player refers to the recording
ReviewedAttempt::~ReviewedAttempt() { player_.reset(); }

void ReviewedAttempt::set_file_services(FileOpener open, FileReader read) {
  open_file_ = std::move(open);
  read_file_ = std::move(read);
}

bool ReviewedAttempt::has_knot() const {
  const auto& signals = recording_.info.script.signals;
  return std::any_of(signals.begin(), signals.end(), [](const judge::Name& name) { return name.id == "knot.throws"; });
}

void ReviewedAttempt::close() {
  player_.reset();
  recording_ = {};
  review_ = {};
  worst_.clear();
  no_player_.clear();
}

QString ReviewedAttempt::open(std::shared_ptr<record::Store> store, const QString& id) {
  store_ = std::move(store);
  from_store_ = true;
  file_.clear();
  return show(id, reader_);
}

QString ReviewedAttempt::open_file(const QString& file) {
  const std::string path = file.toStdString();
  std::string error;
  close();
  store_.reset();
  from_store_ = false;
  file_ = path;
  if (open_file_) store_ = open_file_(path, error);
  const std::vector<record::AttemptRow> attempts = store_ ? store_->attempts("") : std::vector<record::AttemptRow>();
  if (attempts.size() != 1) {
    if (store_ && error.empty()) error = store_->trouble();
    if (error.empty())
      return (attempts.empty() ? Words::tr("%1 holds no attempt.") : Words::tr("%1 is a store of several attempts: start with --store to see them.")).arg(file);
    return said_message(error);
  }
  return show(QString::fromStdString(attempts.front().id),
              [this, path](const std::string& id, record::Recording& out, std::string& why) { return read_file_(path, id, out, why); });
}

// by its id, or by a unique prefix of it
bool ReviewedAttempt::find(const std::string& id, record::AttemptRow& out) const {
  if (store_->attempt(id, out)) return true;
  std::string found;
  for (const record::AttemptRow& a : store_->attempt_heads()) {
    if (id.empty() || !a.id.starts_with(id)) continue;
    if (!found.empty()) return false;
    found = a.id;
  }
  return !found.empty() && store_->attempt(found, out);
}

QString ReviewedAttempt::show(const QString& id, const RecordingReader& reader) {
  close();
  record::AttemptRow row;
  std::string error;
  if (!find(id.toStdString(), row))
    return store_->trouble().empty() ? Words::tr("This attempt is no longer in the store.") : said_message(store_->trouble());
  if (!reader || !reader(row.id, recording_, error)) {
    recording_ = {};
    return Words::tr("The attempt cannot be read: %1").arg(said_message(error));
  }
  base::Problems problems;
  if (opener_) player_ = opener_(recording_, problems);
  if (!player_ && !problems.empty()) no_player_ = said_message(problems.front().message);
  review_.attempt = row;
  read_moments();
  return {};
}

// the attempt's own events, and notes added later
void ReviewedAttempt::read_moments() {
  const record::AttemptRow row = review_.attempt;
  std::vector<record::EventRow> events = store_->events(row.id);
  record::School* school = desk_ ? desk_->school() : nullptr;
  if (school)
    for (const record::Note& n : school->notes(row.id)) events.push_back({n.step, n.time_s, "note", n.text, 0});
  std::vector<std::pair<std::string, double>> given;
  if (school && from_store_) given = desk_->given(row.id);
  review_ = make_review(row, recording_, events, player_ ? &player_->card() : nullptr, given);
  const QString lesson = QString::fromStdString(row.lesson_id);
  const auto target = [&](const std::string& metric) { return finder_ ? finder_(lesson, metric).target : MetricTarget{}; };
  set_limits(review_, target);
  worst_ = worst_moments(review_, recording_, target);
}

QString ReviewedAttempt::read_other(const std::string& id, record::AttemptRow& row, record::Recording& recording) const {
  std::string error;
  if (store_->attempt(id, row) && reader_ && reader_(id, recording, error)) return {};
  return Words::tr("The other attempt cannot be read: %1").arg(said_message(error.empty() ? store_->trouble() : error));
}

bool ReviewedAttempt::add_note(const QString& text, double time_s) {
  if (!desk_ || !desk_->school() || !is_open() || text.trimmed().isEmpty()) return false;
  record::Note note;
  note.attempt_id = review_.attempt.id;
  note.time_s = time_s;
  note.step = static_cast<uint64_t>(std::llround(time_s / review_.dt_s));
  note.text = text.trimmed().toStdString();
  return desk_->add_note(note);
}

bool ReviewedAttempt::rate(const QString& item_id, std::optional<double> points) {
  return !desk_ || !is_open() || desk_->rate(review_.attempt.id, item_id.toStdString(), points);
}

std::vector<record::Note> ReviewedAttempt::notes() const {
  return can_note() ? desk_->school()->notes(review_.attempt.id) : std::vector<record::Note>();
}

std::vector<record::Exported> ReviewedAttempt::exported() const {
  std::vector<record::Exported> out;
  std::string unread;
  if (!exported_ || !exported_(file_, {{}, {}, review_.attempt.id}, out, unread)) out.clear();
  return out;
}

}  // namespace swage::console
