// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/link/station_link.hpp"

#include <QBuffer>
#include <utility>

#include "console/models/said.hpp"
#include "record/identity.hpp"

namespace swage::console {
namespace {

using record::Stations;

constexpr int kBeat_ms = static_cast<int>(1000 * record::kBeat_s);
constexpr int kList_ms = 250;       // shortest interval between reads of the list, however many stations report
constexpr qint64 kStale_ms = 1000;  // longest interval while the list is watched: lost stations send no notice
constexpr qint64 kRetry_ms = 2000;  // after a failed connection
constexpr int kPicture_px = 480;    // width: 20 to 60 kB, enough to see where needle and jaws are

std::string png_of(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.scaledToWidth(kPicture_px, Qt::SmoothTransformation).save(&buffer, "PNG");
  return bytes.toStdString();
}

}  // namespace

/// Lives in StationLink::thread_; the link is touched through posted calls only.
class StationWorker : public QObject {
 public:
  StationWorker(StationLink* link, StationsOpener opener, std::string wanted)
      : link_(link), opener_(std::move(opener)), wanted_(std::move(wanted)), beat_(this), list_(this) {
    beat_.setInterval(kBeat_ms);
    connect(&beat_, &QTimer::timeout, this, &StationWorker::beat);
    list_.setInterval(kList_ms);
    connect(&list_, &QTimer::timeout, this, &StationWorker::look);
    tried_.invalidate();
  }

  void begin() {
    beat_.start();
    beat();
  }
  void end() {
    if (there_) there_->leave();
    there_.reset();
    deleteLater();
    thread()->quit();
  }
  void beat() {
    if (!reach()) return;
    record::StationNow now;
    {
      const std::lock_guard lock(link_->mutex_);
      now = link_->said_;
    }
    good(there_->say(now));
  }
  void watch(bool on) {
    on ? list_.start() : list_.stop();
    list_read_.invalidate();
    if (on && reach()) read_list(), read_sent();
  }
  void send(record::StationMessage message) {
    if (!reach()) return tell_refused();
    if (message.kind == StationLink::Kind::kPicture) wanted_picture_ = message.to;
    if (!good(there_->send(message))) return tell_refused();
    read_sent();
  }
  void mark(const std::string& station, const std::string& words) {
    double time_s = 0;
    if (!reach() || !good(there_->mark(station, words, name_, time_s))) return tell_refused();
    post([station, time_s](StationLink& l) { Q_EMIT l.marked(QString::fromStdString(station), time_s); });
  }
  void forget(const std::string& station) {
    if (!reach() || !good(there_->forget(station))) return tell_refused();
    read_list();
  }
  void answer(const std::string& id, const std::string& words) {
    if (reach() && good(there_->tell_answer(id, words))) read_inbox();
  }
  void show_picture(const std::string& id, const QImage& image) {
    if (reach() && good(image.isNull() || there_->show_picture(png_of(image)))) good(there_->tell_answer(id, "taken"));
  }

 private:
  template <class Call>
  void post(Call call) {
    QMetaObject::invokeMethod(link_, [link = link_, call] { call(*link); }, Qt::QueuedConnection);
  }

  // Posts a call, so that it does not run inside a driver callback: the call may close the driver's connection.
  template <class Call>
  void later(Call call) {
    QMetaObject::invokeMethod(this, call, Qt::QueuedConnection);
  }

  // True with an open connection; after a failure the next attempt is kRetry_ms later.
  bool reach() {
    if (there_) return true;
    if (tried_.isValid() && tried_.elapsed() < kRetry_ms) return false;
    std::string error;
    there_ = opener_(error);
    if (!there_) {
      tried_.start();
      tell_problem(error);
      return false;
    }
    const bool in = good(there_->listen(Stations::Channel::kMessage, [this] { later([this] { hear_message(); }); })) &&
                    good(there_->listen(Stations::Channel::kNow, [this] { list_stale_ = true; })) &&
                    good(there_->listen(Stations::Channel::kPicture, [this] { later([this] { read_picture(); }); })) &&
                    good(there_->enter(name_.empty() ? wanted_ : name_, program_, name_));
    if (!in) return false;
    tell_problem("");
    post([name = name_](StationLink& l) {
      l.name_ = QString::fromStdString(name);
      Q_EMIT l.named();
    });
    read_inbox();
    return there_ != nullptr;
  }

  // Returns `done`; when the connection is lost, reports the problem once and closes the connection.
  bool good(bool done) {
    if (done || !there_) return done;
    error_ = there_->error();
    if (!there_->lost()) return false;
    there_.reset();
    tried_.start();
    tell_problem(error_);
    return false;
  }
  void tell_problem(const std::string& sentence) {
    error_ = sentence;
    post([sentence](StationLink& l) {
      const QString now = said_message(sentence);
      if (std::exchange(l.problem_, now) != now) Q_EMIT l.problem_changed();
    });
  }
  void tell_refused() {
    post([why = error_](StationLink& l) { Q_EMIT l.refused(said_message(why)); });
  }

  void look() {
    const bool due = list_stale_ || !list_read_.isValid() || list_read_.elapsed() >= kStale_ms;
    if (due && reach()) read_list();
  }
  void read_list() {
    std::vector<record::StationNow> all;
    if (!good(there_->all(all))) return;
    list_stale_ = false;
    list_read_.start();
    post([all = std::move(all)](StationLink& l) {
      l.stations_ = all;
      l.read_.start();
      Q_EMIT l.stations_changed();
    });
  }
  void hear_message() {
    if (!there_) return;
    read_inbox();
    if (there_ && list_.isActive()) read_sent();
  }
  void read_sent() {
    std::vector<record::StationMessage> sent;
    if (!there_ || !good(there_->sent(sent))) return;
    post([sent = std::move(sent)](StationLink& l) {
      l.sent_ = sent;
      Q_EMIT l.sent_changed();
    });
  }
  void read_inbox() {
    std::vector<record::StationMessage> all, words;
    if (!good(there_->inbox(all))) return;
    for (const record::StationMessage& m : all) {
      if (m.kind == StationLink::Kind::kPicture) {
        if (m.id != photographed_) post([id = m.id](StationLink& l) { l.photograph(id); });
        photographed_ = m.id;
        continue;
      }
      if (!m.shown && !good(there_->tell_shown(m.id))) return;
      words.push_back(m);
    }
    post([words = std::move(words)](StationLink& l) {
      l.inbox_ = words;
      Q_EMIT l.inbox_changed();
    });
  }
  void read_picture() {
    std::string png;
    double age_s = 0;
    if (wanted_picture_.empty() || !there_ || !good(there_->picture(wanted_picture_, png, age_s)) || png.empty()) return;
    const QImage image = QImage::fromData(QByteArray::fromStdString(png), "PNG");
    post([station = wanted_picture_, image, age_s](StationLink& l) {
      Q_EMIT l.pictured(QString::fromStdString(station), image, age_s);
    });
  }

  StationLink* link_;
  const StationsOpener opener_;
  const std::string wanted_, program_ = record::make_id();
  std::unique_ptr<Stations> there_;
  QTimer beat_, list_;
  QElapsedTimer tried_, list_read_;
  std::string name_, error_, wanted_picture_, photographed_;
  bool list_stale_ = false;
};

StationLink::~StationLink() {
  if (!worker_) return;
  beat_.stop();
  QMetaObject::invokeMethod(worker_, [worker = worker_] { worker->end(); }, Qt::QueuedConnection);
  thread_.wait();
}

template <class Call>
void StationLink::ask(Call call) {
  if (worker_) QMetaObject::invokeMethod(worker_, [worker = worker_, call] { call(*worker); }, Qt::QueuedConnection);
}

void StationLink::start(StationsOpener opener, const QString& wanted_name) {
  if (!opener || worker_) return;
  worker_ = new StationWorker(this, std::move(opener), wanted_name.toStdString());
  worker_->moveToThread(&thread_);
  hear_voice();
  thread_.setObjectName(QStringLiteral("swage-stations"));
  thread_.start();
  ask([](StationWorker& w) { w.begin(); });
  beat_.setInterval(kBeat_ms);
  connect(&beat_, &QTimer::timeout, this, &StationLink::hear_voice);
  beat_.start();
}

void StationLink::hear_voice() {
  if (!voice_) return;
  record::StationNow now = voice_();
  const std::lock_guard lock(mutex_);
  said_ = std::move(now);
}

void StationLink::tell_now() {
  hear_voice();
  ask([](StationWorker& w) { w.beat(); });
}

void StationLink::watch(bool on) {
  ask([on](StationWorker& w) { w.watch(on); });
}

void StationLink::send(const QString& to, Kind kind, const QString& body, const QString& title) {
  record::StationMessage m;
  m.to = to.toStdString();
  m.kind = kind;
  m.body = body.toStdString();
  m.title = title.toStdString();
  ask([m](StationWorker& w) { w.send(m); });
}

void StationLink::mark(const QString& station, const QString& words) {
  ask([s = station.toStdString(), t = words.toStdString()](StationWorker& w) { w.mark(s, t); });
}

void StationLink::forget(const QString& station) {
  ask([s = station.toStdString()](StationWorker& w) { w.forget(s); });
}

// The message is removed from the screen at once; its receipt is written when the server answers.
void StationLink::answer(const std::string& message_id, const QString& answer) {
  std::erase_if(inbox_, [&](const record::StationMessage& m) { return m.id == message_id; });
  Q_EMIT inbox_changed();
  ask([message_id, a = answer.toStdString()](StationWorker& w) { w.answer(message_id, a); });
}

void StationLink::photograph(const std::string& message_id) {
  const QImage image = camera_ ? camera_() : QImage();
  ask([message_id, image](StationWorker& w) { w.show_picture(message_id, image); });
}

}  // namespace swage::console
