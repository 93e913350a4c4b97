// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/run_memory.hpp"

#include <algorithm>

namespace swage::console {

RunMemory::RunMemory(const WindowPages* pages, LessonsModel* lessons, Settings& settings)
    : pages_(pages), lessons_(lessons), settings_(settings) {}

bool RunMemory::on(const char* key, const char* otherwise) const {
  return settings_.text(key, QString::fromLatin1(otherwise)) == QLatin1String("true");
}

void RunMemory::restore(const Launch& launch) {
  RunPage* run = pages_->run();
  run->set_draws_seed(launch.draws_seed);
  run->set_sound(on("sound", "true"), settings_.text("volume", QStringLiteral("0.7")).toDouble());
  run->set_used_controls(settings_.text("used_controls"));
  run->set_guided(on("guided"));
  SetupPanel* setup = run->setup();
  setup->set_left_handed(on("left_handed"));
  restore_person(launch);
  if (launch.device_given) setup->set_device(QString::fromStdString(launch.options.device));
  if (launch.mode_given) setup->set_mode(QString::fromStdString(launch.options.mode));
  select_lesson(launch);
}

void RunMemory::restore_person(const Launch& launch) {
  SetupPanel* setup = pages_->run()->setup();
  PeoplePage* people = pages_->people();
  people->refresh();
  const QString person = launch.person_given ? QString::fromStdString(launch.options.person) : settings_.text("person");
  setup->set_people(people->people()->names(), person);
  if (launch.person_given) setup->know_person(setup->person());
  people->select_person(setup->person());
}

// The lesson named, else the last one, else the first.
void RunMemory::select_lesson(const Launch& launch) {
  int row = lessons_->row_of(settings_.text("lesson"));
  if (!launch.options.lesson_path.empty()) row = lessons_->add_file(QString::fromStdString(launch.options.lesson_path));
  if (lessons_->rowCount() > 0) pages_->run()->setup()->select_lesson(std::max(row, 0));
}

void RunMemory::remember() const {
  RunPage* run = pages_->run();
  settings_.set("sound", run->sound_on());
  settings_.set("volume", run->speaker().volume());
  settings_.set("left_handed", run->setup()->left_handed());
  settings_.set("person", run->setup()->person());
  settings_.set("lesson", run->setup()->lesson());
  settings_.set("used_controls", run->used_controls());
  settings_.set("guided", run->guided());
}

}  // namespace swage::console
