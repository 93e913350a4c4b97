// SPDX-License-Identifier: Apache-2.0
//
// People with their names, groups, courses, published lessons, and instructors' notes and decisions on attempts: the part of the store
// that people edit. Attempts themselves are in store.hpp; pass rules in judge/pass_rule.hpp.
// Threads: a School belongs to the thread that opened it. Every call that returns bool gives one sentence in error() on failure,
// and then nothing has changed.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "record/course.hpp"
#include "record/store.hpp"

namespace swage::record {

struct Group {
  std::string id, name, created_utc, archived_utc;
};

/// A course for a group, or for one person.
struct Assignment {
  std::string id, course_id;
  std::string who_id;     // group or person
  bool to_group = false;
  std::string made_utc, due_utc;  // due: "" for no date
};

/// A lesson as published.
struct LessonVersion {
  std::string id, digest, lesson_id, title, text;
  std::string frozen_utc, retired_utc;  // retired: "" while it can be chosen
  uint32_t number = 0;                  // 1, 2, ... of this lesson in this store
};

/// A person's note on a moment of an attempt.
struct Note {
  std::string id, attempt_id;
  uint64_t step = 0;
  double time_s = 0;
  std::string made_utc, made_by, text;
};

/// Points that a person gives an attempt on an item of a rating scale, as "smart.efficiency". One for each person and item.
struct ObserverRating {
  std::string attempt_id, item;
  double points = 0;
  std::string made_utc, made_by;
};

/// A person's decision about an attempt; the last one is valid, earlier ones are kept.
struct Ruling {
  enum class Kind : int { kCounts = 0, kVoid = 1, kNamed = 2 };
  std::string id, attempt_id, made_utc, made_by, reason;
  Kind kind = Kind::kVoid;
};

/// A file written from this store that has data of a person.
struct ExportedFile {
  std::string file, station, kind, made_utc;
  bool whole = false;  // without data of anybody else
};

class School {
 public:
  /// As Store::open: a file or a server, "" for the user's own store. nullptr and `error` on failure.
  static std::unique_ptr<School> open(const std::string& where, std::string& error);
  virtual ~School() = default;
  virtual const std::string& error() const = 0;

  // People. Names are unique among active trainees: two people called Anna Li need a distinguishing addition.
  /// All people of the store, archived ones too; sorted by name.
  virtual std::vector<Person> people() = 0;
  /// Adds a person with name, handedness, group_id and code ("": a new one such as "4F2AK"); fills in id, code and created_utc. An
  /// erased person can be restored by the same call with its id: undo, as long as no attempts were erased.
  virtual bool add_person(Person& person) = 0;
  /// Sets name, handedness, group and archived_utc of the person with this id. The code does not change.
  virtual bool change_person(const Person& person) = 0;
  /// Removes a person without attempts, without a trace. With attempts: false.
  virtual bool remove_person(const std::string& id) = 0;
  /// A person with this name or code; false when there is none.
  virtual bool find_person(const std::string& name_or_code, Person& out) = 0;
  /// Erases the person, all attempts with their recordings, notes and names permanently; no backup restores them.
  virtual bool erase_person(const std::string& id) = 0;
  /// Files that still have data of a person. Query them before erasing.
  virtual std::vector<ExportedFile> exported_files(const std::string& person_id) = 0;
  virtual bool log_export(const std::vector<std::string>& person_ids, const std::string& kind, const std::string& file) = 0;

  virtual std::vector<Group> groups() = 0;  // sorted by position
  virtual bool add_group(Group& group) = 0;
  virtual bool change_group(const Group& group) = 0;
  virtual bool remove_group(const std::string& id) = 0;  // its people are kept, without a group

  // Lessons and courses.
  /// Publishes a lesson's text; publishing the same text twice gives one version. The digest is that of AttemptRow.
  virtual bool publish_lesson(const std::string& lesson_id, const std::string& title, const std::string& text,
                              LessonVersion& out) = 0;
  virtual std::vector<LessonVersion> lessons(bool with_text = false) = 0;  // newest first; every version
  virtual bool lesson(const std::string& digest, LessonVersion& out) = 0;
  virtual bool retire_lesson(const std::string& digest, bool retired) = 0;

  virtual std::vector<Course> courses() = 0;  // sorted by title, archived ones too
  /// Adds a course when course.id is "", else replaces the one with that id; a removed course can be restored.
  virtual bool save_course(Course& course) = 0;
  virtual bool remove_course(const std::string& id) = 0;
  virtual std::vector<Assignment> assignments() = 0;
  virtual bool assign(Assignment& assignment) = 0;
  virtual bool unassign(const std::string& assignment_id) = 0;

  // Attempts.
  virtual std::vector<Note> notes(const std::string& attempt_id) = 0;  // sorted by time in the attempt
  virtual bool save_note(Note& note) = 0;                              // id "": a new note; else changed, or restored
  virtual bool remove_note(const std::string& id) = 0;
  virtual std::vector<ObserverRating> ratings(const std::string& attempt_id) = 0;  // by item
  /// Takes the place of what the same person gave the item before; made_utc is filled in where it is "".
  virtual bool save_rating(ObserverRating& rating) = 0;
  virtual bool remove_rating(const std::string& attempt_id, const std::string& item, const std::string& by) = 0;
  virtual std::vector<Ruling> rulings(const std::string& attempt_id) = 0;  // newest first
  /// Excludes the attempt from rules and curves, without deleting it or its recording; or includes it again.
  virtual bool set_void(const std::string& attempt_id, bool is_void, const std::string& reason, const std::string& by) = 0;
  /// Assigns a guest's attempt to a person; `even_if_named`: also an attempt that has a person already.
  virtual bool name_attempt(const std::string& attempt_id, const std::string& person_id, const std::string& by,
                            bool even_if_named = false) = 0;
};

/// Digest of a lesson's text: SHA-256 of its values, independent of their order, of spaces and of the seed. 64 hexadecimal digits.
std::string lesson_digest(const std::string& lesson_text);

}  // namespace swage::record
