// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTimer>
#include <functional>
#include <memory>

#include "base/problem.hpp"
#include "console/models/lesson_draft.hpp"
#include "console/models/lessons_model.hpp"
#include "console/widgets/live_form.hpp"
#include "host/catalogue.hpp"
#include "snapshot/scene_card.hpp"

namespace swage::console {

class PartsPanel;
class SceneView;

/// An instructor's own lesson: another one with a title, parts and values of its own, and its scene at rest as it would be. Every
/// change can be undone and is kept at once in a draft; the lesson itself is not written before its scene could be built.
class VariantDialog : public QDialog {
  Q_OBJECT
 public:
  struct Services {
    /// Builds the lesson of a file without running it; nullptr and why not.
    std::function<std::unique_ptr<snapshot::SceneCard>(const QString& path, base::Problems& problems)> build;
    host::Catalogue catalogue;
    QString drafts;                               // folder
    std::function<void(SceneView&)> dress = {};   // gives the picture its colours
  };

  /// A new lesson below `folder`, based on `lesson`; without a folder `lesson` itself, one of one's own, is edited.
  VariantDialog(const LessonEntry& lesson, Services services, const QString& folder, QWidget* parent);
  ~VariantDialog() override;
  /// Values that an attempt was adjusted to are in the form from the start.
  void preset(const QVector<LiveForm::Change>& values);
  /// After Save: the file, and whether it is to be tried at once.
  QString saved() const { return saved_; }
  bool to_try() const { return to_try_; }
  LessonDraft& draft() { return draft_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* make_words();
  QWidget* make_values();
  QWidget* make_picture();
  QWidget* make_buttons();
  void add_undo();
  void show_edit(bool structure, bool by_undo);
  void show_words();
  void show_values();
  void build();  // the scene of the draft as it is now
  QString fault_words(const base::Problem& problem) const;
  void update_state();
  void save();
  void done(int result) override;
  QString write();  // "" or why not

  LessonEntry lesson_;
  Services services_;
  QString folder_, saved_;  // no folder: the lesson itself is edited
  LessonDraft draft_;
  QString fault_;  // why the lesson cannot be built as it is now; "" when it can
  QString told_;
  int preset_ = 0;
  bool to_try_ = false;
  QTimer build_timer_;
  QLineEdit *title_ = nullptr, *summary_ = nullptr, *find_ = nullptr;
  QPlainTextEdit* goal_ = nullptr;
  LiveForm* form_ = nullptr;
  PartsPanel* parts_ = nullptr;
  SceneView* view_ = nullptr;
  QLabel *problem_ = nullptr, *none_ = nullptr;
  QPushButton *save_ = nullptr, *try_ = nullptr;
};

}  // namespace swage::console
