// SPDX-License-Identifier: Apache-2.0
#include "record/recorder.hpp"

#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <QtCore/QThread>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>

#include "base/spsc_ring.hpp"
#include "record/chunk_buffer.hpp"
#include "record/identity.hpp"
#include "record/journal.hpp"
#include "record/schema.hpp"
#include "record/seal.hpp"
#include "record/sentences.hpp"
#include "record/store.hpp"

namespace swage::record {
namespace {

using Clock = std::chrono::steady_clock;

// 4 s of steps: the longest measured commit took 0.25 s, a locked store times out after 2 s. Smaller rings
// make gaps.
constexpr std::size_t kStepRing = 4096;
constexpr std::size_t kEventRing = 4096;
constexpr std::size_t kCommandRing = 1024;
// 10 ms between polls of the rings; 250 ms until a chunk is closed before it is full
constexpr std::chrono::milliseconds kWake{10}, kOldest{250};
// the writer must never delay the step (nice, -20..19)
constexpr int kNice = 5;

class FileRecorder final : public Recorder {
 public:
  FileRecorder(std::string store, const AttemptInfo& info)
      : store_(std::move(store)), id_(make_id()), info_(info), buffer_(id_, info_) {}

  ~FileRecorder() override {
    // not finished: the attempt stays "running" and later becomes "recovered", as is right
    if (thread_.joinable()) end_thread();
  }

  bool start(base::Problems& problems) {
    journal_ = Journal::create(store_, id_);
    // Qt takes the first thread that it sees for the main thread, and destroys objects of that thread at exit: it must not be the
    // writer thread, whose data are freed earlier
    QThread::currentThread();
    std::future<bool> opened = opened_.get_future();

    // blocks signals in the writer thread: they are for the program's other threads
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    thread_ = std::thread([this] { write(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);

    const bool ok = opened.get();
    for (base::Problem& p : this->problems()) problems.push_back(std::move(p));
    return ok;
  }

  void step(const StepRecord& record) noexcept override { push(steps_, record); }
  void event(const judge::Event& event) noexcept override { push(events_, event); }
  void command(const CommandRecord& command) noexcept override { push(commands_, command); }

  void note(uint64_t step, const std::string& text) override {
    const std::lock_guard lock(mutex_);
    notes_.emplace_back(step, text);
  }

  void finish(const AttemptEnd& end) override {
    if (!thread_.joinable()) return;
    end_ = end;
    finished_ = true;
    end_thread();
  }

  void discard() override {
    if (!thread_.joinable()) return;
    discarded_ = true;
    end_thread();
  }

  Kept kept() const override { return kept_; }
  std::string attempt_id() const override { return id_; }
  uint64_t dropped() const override { return dropped_.load(std::memory_order_relaxed); }
  bool healthy() const override { return healthy_.load(std::memory_order_relaxed); }

  base::Problems problems() override {
    const std::lock_guard lock(mutex_);
    return std::exchange(problems_, {});
  }

 private:
  template <class T>
  void push(base::SpscRing<T>& ring, const T& record) noexcept {
    while (!ring.try_push(record)) {
      if (info_.realtime) {
        dropped_.fetch_add(1, std::memory_order_relaxed);
        return;
      }
      // not real time: waits for the writer, so that nothing is lost
      const timespec moment{0, 100'000};
      nanosleep(&moment, nullptr);
    }
  }

  void end_thread() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    wake_.notify_one();
    thread_.join();
  }

  void tell(base::Severity severity, const std::string& message) {
    const std::lock_guard lock(mutex_);
    problems_.push_back({severity, std::string(kRecordPlace) + shown(store_), message});
  }

  // causes that may be gone by the end of the attempt; others need a person's decision
  static bool may_go_on_without(Trouble why) {
    return why == Trouble::kLocked || why == Trouble::kFull || why == Trouble::kUnreachable;
  }

  // --- writer thread

  void write() {
    setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), kNice);
    const bool ok = open();
    opened_.set_value(ok);
    if (!ok) return;
    std::unique_lock lock(mutex_);
    while (!stop_) {
      wake_.wait_for(lock, kWake, [this] { return stop_; });
      lock.unlock();
      drain();
      if (!buffer_.empty() && Clock::now() - oldest_ >= kOldest) commit();
      lock.lock();
    }
    lock.unlock();
    close();
  }

  bool open() {
    std::string error;
    Trouble why = Trouble::kNone;
    db_ = open_store(store_, error, &why);
    if (!db_) {
      if (may_go_on_without(why)) return fall_back(why, error);
      tell(base::Severity::kError, error + " With --store :none: the lesson runs all the same, and nothing is kept.");
      return false;
    }
    merge_journals(*db_, store_);
    return write_batch(*db_, attempt_rows(id_, info_)) || fall_back(db_->trouble(), db_->error());
  }

  void drain() {
    const bool was_empty = buffer_.empty();
    CommandRecord command;
    while (commands_.try_pop(command)) buffer_.add(command);
    judge::Event event;
    while (events_.try_pop(event)) buffer_.add(event);
    {
      const std::lock_guard lock(mutex_);
      for (const auto& [step, text] : notes_) buffer_.note(step, text);
      notes_.clear();
    }
    if (was_empty) oldest_ = Clock::now();
    while (steps_.try_pop(record_)) {
      buffer_.add(record_);
      ++taken_;
      if (buffer_.steps() < kChunkSteps) continue;
      commit();
      oldest_ = Clock::now();
    }
  }

  void commit() { keep(buffer_.take(), false); }

  // the end of an attempt is small: it is written even after a chunk found no space
  void keep(const Batch& batch, bool is_end) {
    if (batch.empty() || (db_ && write_batch(*db_, batch))) return;
    if (db_) fall_back(db_->trouble(), db_->error());
    if (journal_ && (is_end || !full_) && journal_->append(batch)) return;
    dropped_.fetch_add(steps_in(batch), std::memory_order_relaxed);
    if (!journal_ || full_) return;
    full_ = true;
    tell(base::Severity::kError,
         say::kFallbackFull(journal_->path()));
  }

  std::string reason(Trouble why, const std::string& error) const {
    switch (why) {
      case Trouble::kLocked:
        return say::kLocked();
      case Trouble::kFull:
        return say::kDiskFull();
      case Trouble::kUnreachable:
        return say::kNoAnswer((error.ends_with('.') ? error.substr(0, error.size() - 1) : error));
      default:
        return say::kNotWritten(error);
    }
  }

  // Writes the rest of the attempt to the journal, with its head repeated so that the file is self-contained. `error` is taken by
  // value: the text of the connection ends with it.
  bool fall_back(Trouble why, const std::string error) {
    db_.reset();
    healthy_.store(false, std::memory_order_relaxed);
    const std::string what = say::kStoreFails(reason(why, error));
    if (!journal_ || !journal_->append(attempt_rows(id_, info_))) {
      tell(base::Severity::kError,
           say::kNothingKept(what));
      journal_.reset();
      return false;
    }
    tell(base::Severity::kWarning,
         say::kGoesOn(what, journal_->path(),
                      why == Trouble::kFull      ? say::kFreeSpaceNow()
                      : why == Trouble::kDamaged ? remedy(store_, why)
                                                 : std::string()));
    return true;
  }

  // dependent rows are deleted with the attempt; the journal has nothing else
  void forget() {
    if (db_) db_->run("DELETE FROM attempt WHERE attempt_id = ?", {id_});
    if (journal_) journal_->remove();
    db_.reset();
    journal_.reset();
  }

  void close() {
    if (discarded_) return forget();
    drain();
    commit();
    const uint64_t lost = dropped() - std::min(dropped(), buffer_.steps_lost_in_gaps());
    if (lost > 0) buffer_.gap(buffer_.next_step(), "records", lost);
    Batch end = buffer_.take();
    // a finished attempt survives a power cut: this one commit is synchronous
    if (finished_) {
      for (Write& w : end_rows(id_, info_, end_, dropped())) end.push_back(std::move(w));
      if (db_ && !db_->on_postgres()) db_->run("PRAGMA synchronous = FULL");
    }
    keep(end, true);
    settle();
    if (finished_) look_back();
    db_.reset();
    journal_.reset();
  }

  void settle() {
    if (db_) {
      if (finished_) seal_attempt(*db_, id_);
      if (!db_->on_postgres()) {
        // a reader may prevent the log from being emptied; nothing is lost then, so the timeout is short
        db_->run("PRAGMA busy_timeout = 200");
        db_->rows("PRAGMA wal_checkpoint(TRUNCATE)");
      }
    } else if (journal_ && finished_) {
      // the other program may have ended meanwhile
      std::string error;
      std::unique_ptr<Database> again = open_store(store_, error);
      if (again && merge_journal(*again, journal_->path())) {
        journal_->remove();
        seal_attempt(*again, id_);
        db_ = std::move(again);
        tell(base::Severity::kNote, say::kMerged());
      }
    }
  }

  // Reads back how the attempt was stored, as another program would find it.
  void look_back() {
    kept_.missing_steps = std::max(dropped(), buffer_.steps_lost_in_gaps());
    // the connection that wrote is closed last: closing it removes the log
    std::string error;
    if (journal_ && !journal_->empty() && journal_->is_whole()) {
      kept_.where = Kept::Where::kBeside;
      kept_.file = journal_->path();
    } else if (const std::unique_ptr<Database> store = open_for_reading(store_, error)) {
      const std::vector<Row> ended =
          store->rows("SELECT state FROM attempt WHERE attempt_id = ? AND state <> 'running'", {id_});
      if (!ended.empty()) kept_.where = Kept::Where::kStore;
      const std::vector<Row> steps = store->rows(
          "SELECT COALESCE(SUM(n), 0) FROM chunk WHERE attempt_id = ? AND stream = ?", {id_, std::string(kHashStream)});
      const auto there = steps.empty() ? 0 : static_cast<uint64_t>(real(steps[0][0]));
      kept_.missing_steps = std::max(kept_.missing_steps, taken_ - std::min(taken_, there));
    }
    if (kept_.where == Kept::Where::kNowhere)
      tell(base::Severity::kError, say::kAttemptNotKept(error));
    else if (kept_.missing_steps > 0)
      tell(base::Severity::kWarning,
           say::kStepsLost(kept_.missing_steps));
  }

  const std::string store_, id_;
  const AttemptInfo info_;
  base::SpscRing<StepRecord> steps_{kStepRing};
  base::SpscRing<judge::Event> events_{kEventRing};
  base::SpscRing<CommandRecord> commands_{kCommandRing};
  std::atomic<uint64_t> dropped_{0};
  std::atomic<bool> healthy_{true};

  std::mutex mutex_;  // protects the members below, between [main] and the writer
  std::condition_variable wake_;
  bool stop_ = false;
  std::vector<std::pair<uint64_t, std::string>> notes_;
  base::Problems problems_;

  std::promise<bool> opened_;
  Kept kept_;
  AttemptEnd end_;                             // passed to the writer thread by joining
  bool finished_ = false, discarded_ = false;  // set before stop_

  // used by the writer thread only
  ChunkBuffer buffer_;
  StepRecord record_{};
  uint64_t taken_ = 0;  // number of steps taken from the ring
  Clock::time_point oldest_{};
  std::unique_ptr<Database> db_;
  std::unique_ptr<Journal> journal_;
  bool full_ = false;  // a chunk did not fit into the journal
  std::thread thread_;
};

}  // namespace

std::unique_ptr<Recorder> Recorder::open(const std::string& store_path, const AttemptInfo& info,
                                         base::Problems& problems) {
  auto recorder =
      std::make_unique<FileRecorder>(store_path.empty() ? Store::default_path() : store_path, info);
  if (!recorder->start(problems)) return nullptr;
  return recorder;
}

}  // namespace swage::record
