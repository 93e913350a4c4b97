// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QComboBox>
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

/// An instructor's own lesson: derived from another, with its own title, parts and values, and a picture of its scene at rest. Every
/// change can be undone and is stored at once in a draft; the lesson itself is written only after its scene could be built.
class VariantDialog : public QDialog {
  Q_OBJECT
 public:
  struct Services {
    /// Builds the lesson of a file without running it; nullptr and the problems on failure.
    std::function<std::unique_ptr<snapshot::SceneCard>(const QString& path, base::Problems& problems)> build;
    host::Catalogue catalogue;
    QString drafts;                               // folder
    std::function<void(SceneView&)> dress = {};   // sets the colours of the picture
  };

  /// A new lesson in `folder`, derived from `lesson`; without a folder `lesson` itself, one of the user's own, is edited.
  VariantDialog(const LessonEntry& lesson, Services services, const QString& folder, QWidget* parent);
  ~VariantDialog() override;
  /// Sets values that were adjusted during an attempt.
  void preset(const QVector<LiveForm::Change>& values);
  /// After Save: path of the file, and whether it is to be run at once.
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
  void build();  // builds the scene of the present draft
  QString fault_words(const base::Problem& problem) const;
  void update_state();
  void save();
  void done(int result) override;
  void reject() override;
  QString write();  // "" or the error

  LessonEntry lesson_;
  Services services_;
  QString folder_, saved_;  // no folder: the lesson itself is edited
  LessonDraft draft_;
  QString fault_;  // why the present draft cannot be built; "" when it can
  QString told_;
  QString refused_;  // a number that the form did not take, until the next edit
  int preset_ = 0;
  bool to_try_ = false;
  QTimer build_timer_;
  QLineEdit *title_ = nullptr, *summary_ = nullptr, *find_ = nullptr;
  QPlainTextEdit* goal_ = nullptr;
  QComboBox* look_ = nullptr;  // from where the trainee looks first
  LiveForm* form_ = nullptr;
  PartsPanel* parts_ = nullptr;
  SceneView* view_ = nullptr;
  QLabel *problem_ = nullptr, *none_ = nullptr;
  QPushButton *save_ = nullptr, *try_ = nullptr;
};

}  // namespace swage::console
