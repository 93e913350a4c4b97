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

/// The form of a lesson's parameters, made from the plugins' tables: one line per number with its unit, its limits and a way back
/// to the lesson's own value. Of what may change while a lesson runs: a change goes out at once; what is refused is said below
/// and put back. Or of all, for a lesson that is to be based on this one.
class LiveForm : public QFrame {
  Q_OBJECT
 public:
  enum class Of { kRunning, kVariant };
  explicit LiveForm(QWidget* parent = nullptr, Of of = Of::kRunning);
  void set_params(const QVector<LiveParam>& params);
  /// While false the fields are shown but cannot be changed: there is nothing to change before the start.
  void set_running(bool running);
  /// After a change: `problem` "" when it was taken over.
  void answer(const QString& problem);
  int count() const { return static_cast<int>(fields_.size()); }
  /// What differs from the lesson: "needle.arc" and JSON.
  QVector<std::pair<std::string, std::string>> changes() const;
  /// The same with SI values, for another form of the same lesson.
  struct Change {
    std::string instance, id;
    std::array<double, 4> value;
  };
  QVector<Change> changed_values() const;
  /// Puts values in as if they had been typed; those of parameters that this form has not are left out. Returns how many it took.
  int preset(const QVector<Change>& values);
  /// What the value of this id is called; "" where the form has none, or two parts have one.
  QString title_of(const std::string& id) const;
  /// Shows the lines in whose name, or whose part's name, the text is; all for "". Returns whether there are any.
  bool find(const QString& text);

 Q_SIGNALS:
  void changed(const QString& instance, const QString& json, const QString& words);

 private:
  struct Field {
    LiveParam param;
    std::array<double, 4> value{}, before{};
    QVector<QWidget*> editors;
    QToolButton* back = nullptr;
    QLabel *label = nullptr, *heading = nullptr;
    bool means = true;  // under what is chosen where it follows a choice
  };
  void add_field(const LiveParam& param, QLabel* heading, QGridLayout* grid);
  QWidget* make_editor(int field, int component);
  void edit(int field, int component, double shown);
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
