// SPDX-License-Identifier: Apache-2.0
//
// All stations of a school, live: each says twice a second what it does, messages go between them and their receipts come back. Over
// the PostgreSQL server that the school has already (LISTEN and NOTIFY): its roles say who may, its sslmode encrypts, and nothing
// else listens on the network. A store that is a file has one station only.
// Threads: belongs to the thread that opened it. Every call may wait for the server, 3 s at most: never call it where somebody waits.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace swage::record {

/// s between two words of a station. Half: twice the load of the server; twice: forces in the list are a second old.
inline constexpr double kBeat_s = 0.5;
/// s of silence after which a station counts as lost: ten beats, so that a slow network loses none.
inline constexpr double kLost_s = 5.0;
/// s after which messages are removed. A day: the next lesson does not begin with yesterday's words.
inline constexpr double kMessageLife_s = 86400.0;

enum class StationState : int { kIdle = 0, kRunning = 1, kPaused = 2, kFinished = 3, kClosed = 4 };

/// What a station does now.
struct StationNow {
  std::string station;                 // its name
  StationState state = StationState::kIdle;
  std::string person;                  // name as the roster has it; only the identifier is kept in the row
  std::string lesson_id, lesson_title, mode, phase;
  std::vector<std::string> cues;       // meanings that are on
  std::string attempt_id;              // that runs or has just ended, "" when nothing is kept
  uint64_t step = 0;
  double time_s = 0;                   // of the attempt
  double score = std::numeric_limits<double>::quiet_NaN(), force_N = std::numeric_limits<double>::quiet_NaN();
  uint64_t late = 0, dropped = 0;      // steps
  uint64_t solver = 0;                 // steps in which it fell short
  uint64_t stopped = 0;                // parts in quarantine
  uint64_t silent_devices = 0;
  bool recorded = false;
  std::string app_version = {};
  double silent_s = 0;                 // since its last word, by the server's clock; of Stations::all()
  bool lost() const { return state != StationState::kClosed && silent_s > kLost_s; }
};

struct StationMessage {
  enum class Kind : int { kWords = 0, kLesson = 1, kPicture = 2 };
  std::string id, to, from;
  Kind kind = Kind::kWords;
  std::string body;                    // the words, or the id of a lesson
  std::string title;                   // of the lesson
  std::string answer;                  // "read", "taken", "declined", "missing"; "" while nobody has answered
  double age_s = 0;                    // since it was sent, by the server's clock
  bool shown = false;                  // it stood on the screen
};

class Stations {
 public:
  enum class Channel { kNow, kMessage, kPicture };
  /// nullptr with a sentence; for a store that is a file, with what to set.
  static std::unique_ptr<Stations> open(const std::string& where, std::string& error);
  virtual ~Stations() = default;
  virtual const std::string& error() const = 0;  // of the last call that returned false
  /// The server has not answered or the connection is gone: open another.
  virtual bool lost() const = 0;
  /// Calls `heard` from this thread's event loop when somebody has said something there; it must not end this object.
  virtual bool listen(Channel, std::function<void()> heard) = 0;

  /// This station comes in under a name; where another program has it, under "name 2", "name 3"... The name is what came out.
  /// `program`: make_id() of the program that runs, so that it finds its own name again on another connection.
  virtual bool enter(const std::string& wanted, const std::string& program, std::string& name) = 0;
  virtual bool say(const StationNow& now) = 0;  // `station` is the name of enter()
  virtual bool leave() = 0;
  /// To this station, not yet answered, oldest first.
  virtual bool inbox(std::vector<StationMessage>& out) = 0;
  virtual bool tell_shown(const std::string& message_id) = 0;
  virtual bool tell_answer(const std::string& message_id, const std::string& answer) = 0;
  virtual bool show_picture(const std::string& png) = 0;

  /// Everybody, by name.
  virtual bool all(std::vector<StationNow>& out) = 0;
  /// Fills in id and from.
  virtual bool send(StationMessage& message) = 0;
  /// From this station, newest first, with their receipts; requests for pictures are left out.
  virtual bool sent(std::vector<StationMessage>& out) = 0;
  /// "" when there is none.
  virtual bool picture(const std::string& station, std::string& png, double& age_s) = 0;
  /// Pins a note to this moment of the attempt that runs there; `time_s` is where. Words may be "".
  virtual bool mark(const std::string& station, const std::string& words, const std::string& by, double& time_s) = 0;
  /// Out of the list, until it comes in again.
  virtual bool forget(const std::string& station) = 0;
};

}  // namespace swage::record
