// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Lessons page: the list of lessons, the criteria of each, and the user's own lessons.
#pragma once

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <optional>

#include "console/link/school_desk.hpp"
#include "console/models/lesson_facts.hpp"
#include "console/models/lessons_model.hpp"

namespace swage::console {

class LessonsPage : public QWidget {
  Q_OBJECT
 public:
  /// Reads the criteria of a lesson file.
  using CriteriaReader = std::function<Criteria(const QString& path)>;
  LessonsPage(LessonsModel* lessons, CriteriaReader criteria, QWidget* parent = nullptr);
  void select(const QString& path);
  QString lesson() const;  // path; "" for none
  /// Reads the chosen lesson again, as after an edit.
  void show_lesson();
  /// Sets the desk for publishing; without it no lesson can be published. It outlives the page.
  void set_desk(SchoolDesk* desk);
  /// During an attempt no lesson can be made, changed or started.
  void set_running(bool running);
  /// Checks whether the chosen lesson can run, shortly after the last change of selection: "" or the error.
  using Checker = std::function<QString(const QString& path)>;
  void set_checker(Checker checker) { checker_ = std::move(checker); }
  /// Shows a sentence below the lesson, until another is chosen; "" for none.
  void tell(const QString& words);

 public Q_SLOTS:
  /// Freezes the chosen lesson as it is now, so that courses and attempts can refer to this version.
  void publish();
  /// Stops offering the last published version of the chosen lesson, or offers it again.
  void retire();
  /// Asks for the file of a lesson to import, or for a file to export to.
  void ask_import();
  void ask_export();

 Q_SIGNALS:
  /// "practice" or "test".
  void run(const QString& path, const QString& mode);
  void make_variant(const QString& path);
  void edit_lesson(const QString& path);
  void delete_lesson(const QString& path);
  void import_lesson(const QString& file);
  void export_lesson(const QString& path, const QString& file);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void check();
  void tell_fault(const QString& why);
  QWidget* make_list(LessonsModel* lessons);
  QWidget* make_detail();
  void search(const QString& words);
  void show_version(bool can);
  void add_own_buttons(QVBoxLayout* column);
  void add_version_row(QVBoxLayout* column);
  QPushButton* add_button(QHBoxLayout* row, const QString& words, const char* key, const char* name, std::function<void()> call);

  CriteriaReader criteria_;
  Checker checker_;
  QTimer check_timer_;
  QSortFilterProxyModel* found_;
  QLineEdit* words_ = nullptr;
  QListView* list_ = nullptr;
  QWidget* detail_ = nullptr;
  QLabel *none_ = nullptr, *title_ = nullptr, *task_ = nullptr, *asked_ = nullptr;
  QPushButton *practise_ = nullptr, *test_ = nullptr, *variant_ = nullptr, *edit_ = nullptr, *delete_ = nullptr, *publish_ = nullptr,
              *retire_ = nullptr, *import_ = nullptr, *export_ = nullptr;
  QLabel *version_ = nullptr, *note_ = nullptr;
  bool running_ = false;
  SchoolDesk* desk_ = nullptr;
  std::optional<record::LessonVersion> last_;  // last published version of the chosen lesson
};

}  // namespace swage::console
