// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QHash>
#include <QLabel>
#include <QVBoxLayout>
#include <functional>

#include "console/models/live_params.hpp"

class QGridLayout;
class QToolButton;

namespace swage::console {

/// The form of a lesson's parameters, made from the plugins' tables: one line per number with its unit, its limits and a reset
/// to the lesson's value. Either of LIVE parameters during an attempt: each change is sent at once, and a rejected one is reported below
/// and reverted. Or of all parameters, for a lesson that is derived from this one.
class LiveForm : public QFrame {
  Q_OBJECT
 public:
  enum class Of { kRunning, kVariant };
  explicit LiveForm(QWidget* parent = nullptr, Of of = Of::kRunning);
  void set_params(const QVector<LiveParam>& params);
  /// False: the fields are shown but cannot be edited, as before the start.
  void set_running(bool running);
  /// The answer to a change: `problem` is "" when it was accepted.
  void answer(const QString& problem);
  int count() const { return static_cast<int>(fields_.size()); }
  /// The differences from the lesson: "needle.arc" and JSON.
  QVector<std::pair<std::string, std::string>> changes() const;
  /// The same differences with SI values, for another form of the same lesson.
  struct Change {
    std::string instance, id;
    std::array<double, 4> value;
  };
  QVector<Change> changed_values() const;
  /// Sets values as if they had been typed; parameters that this form lacks are skipped. Returns the number of values set.
  int preset(const QVector<Change>& values);
  /// The title of the parameter with this id, of this part of the lesson or of any; "" where the form has none, or several.
  QString title_of(const std::string& id, const std::string& instance = {}) const;
  /// Shows only the lines whose title, section or part's name contains the text, or where none does, whose explanation does; all for "",
  /// but for hidden parameters that are as the lesson has them.
  /// Returns whether any match.
  bool find(const QString& text);

 Q_SIGNALS:
  void changed(const QString& instance, const QString& json, const QString& words);
  /// A number was typed that the field does not take, or not as it is; told at the field, too.
  void refused(const QString& words);

 private:
  struct Field {
    LiveParam param;
    std::array<double, 4> value{}, before{};
    QVector<QWidget*> editors;
    QToolButton* back = nullptr;
    QLabel *label = nullptr, *heading = nullptr;
    bool means = true;  // whether it has a meaning under the choice that it follows
  };
  void add_field(const LiveParam& param, QLabel* heading, QGridLayout* grid);
  QWidget* make_editor(int field, int component);
  void edit(int field, int component, double shown);
  void refuse(int field, QWidget* editor, const QString& words);
  void put(int field, const std::array<double, 4>& value);
  void take_start(const Field& choice);
  void enable(const Field& field);
  QString words(const Field& field) const;

  QVector<Field> fields_;
  QVBoxLayout* column_;
  QWidget* body_ = nullptr;
  QLabel *explain_, *problem_;
  Of of_;
  int last_ = -1;
  bool running_ = false, filling_ = false;
};

}  // namespace swage::console
