// SPDX-License-Identifier: Apache-2.0
//
// All stations of a school, live: each reports its state twice a second; messages and receipts are exchanged. Over
// the school's PostgreSQL server (LISTEN and NOTIFY): its roles give the rights, its sslmode encrypts, and no other
// port is open on the network. A store that is a file has one station only.
// Threads: those of the thread that opened it. Every call may wait for the server, at most 3 s: not for a thread that must respond.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace swage::record {

/// s between two reports of a station. Half: twice the load of the server; twice: forces in the list are a second old.
inline constexpr double kBeat_s = 0.5;
/// s without a report after which a station counts as lost: ten reports, so that a slow network loses none.
inline constexpr double kLost_s = 5.0;
/// s after which messages are removed. A day: the next lesson does not begin with messages of the day before.
inline constexpr double kMessageLife_s = 86400.0;

enum class StationState : int { kIdle = 0, kRunning = 1, kPaused = 2, kFinished = 3, kClosed = 4 };

/// Present state of a station.
struct StationNow {
  std::string station;                 // its name
  StationState state = StationState::kIdle;
  std::string person;                  // name as in the roster; the row has the identifier only
  std::string lesson_id, lesson_title, mode, phase;
  std::vector<std::string> cues;       // meanings of the cues that are on
  std::string attempt_id;              // of the running or just ended attempt, "" when it is not recorded
  uint64_t step = 0;
  double time_s = 0;                   // of the attempt
  double score = std::numeric_limits<double>::quiet_NaN(), force_N = std::numeric_limits<double>::quiet_NaN();
  uint64_t late = 0, dropped = 0;      // steps
  uint64_t solver = 0;                 // steps in which the solver did not converge
  uint64_t stopped = 0;                // plugin instances in quarantine
  uint64_t silent_devices = 0;
  bool recorded = false;
  std::string app_version = {};
  double silent_s = 0;                 // s since its last report, by the server's clock; set by Stations::all()
  bool lost() const { return state != StationState::kClosed && silent_s > kLost_s; }
};

struct StationMessage {
  enum class Kind : int { kWords = 0, kLesson = 1, kPicture = 2 };
  std::string id, to, from;
  Kind kind = Kind::kWords;
  std::string body;                    // the text, or the id of a lesson
  std::string title;                   // title of the lesson
  std::string answer;                  // "read", "taken", "declined", "missing"; "" before it is answered
  double age_s = 0;                    // s since it was sent, by the server's clock
  bool shown = false;                  // it was displayed
};

class Stations {
 public:
  enum class Channel { kNow, kMessage, kPicture };
  /// Opens the connection. nullptr with a sentence; for a store that is a file, the sentence says what to set.
  static std::unique_ptr<Stations> open(const std::string& where, std::string& error);
  virtual ~Stations() = default;
  virtual const std::string& error() const = 0;  // of the last call that returned false
  /// The server has not responded or the connection is lost: open another.
  virtual bool lost() const = 0;
  /// Calls `heard` from this thread's event loop when the channel is notified; `heard` must not destroy this object.
  virtual bool listen(Channel, std::function<void()> heard) = 0;

  /// Registers this station under a name; where another program has it, under "name 2", "name 3"... `name` is the result.
  /// `program`: make_id() of the running program, so that it gets the same name again on another connection.
  virtual bool enter(const std::string& wanted, const std::string& program, std::string& name) = 0;
  virtual bool say(const StationNow& now) = 0;  // `station` is the name of enter()
  virtual bool leave() = 0;
  /// Messages to this station, not yet answered, oldest first.
  virtual bool inbox(std::vector<StationMessage>& out) = 0;
  virtual bool tell_shown(const std::string& message_id) = 0;
  virtual bool tell_answer(const std::string& message_id, const std::string& answer) = 0;
  virtual bool show_picture(const std::string& png) = 0;

  /// All stations, by name.
  virtual bool all(std::vector<StationNow>& out) = 0;
  /// Sends a message; fills in id and from.
  virtual bool send(StationMessage& message) = 0;
  /// Messages from this station, newest first, with their receipts; without requests for pictures.
  virtual bool sent(std::vector<StationMessage>& out) = 0;
  /// The last picture of a station; "" when there is none.
  virtual bool picture(const std::string& station, std::string& png, double& age_s) = 0;
  /// Adds a note at this moment of the attempt that runs there; `time_s` is its time. The text may be "".
  virtual bool mark(const std::string& station, const std::string& words, const std::string& by, double& time_s) = 0;
  /// Removes a station from the list, until it registers again.
  virtual bool forget(const std::string& station) = 0;
};

}  // namespace swage::record
