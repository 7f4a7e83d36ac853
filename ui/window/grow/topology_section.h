#pragma once
// How many components and tunnels the surface may have, what is done where it would get more, and what is
// to be decided.

#include <QString>
#include <QWidget>

#include "core/evolution/held_changes.h"

class QComboBox;
class QLabel;
class QSpinBox;
class QVBoxLayout;

namespace handlebody::ui {

class Document;

//! "Held at iteration 12: its fronts would meet at 1,2,3 and make a tunnel 84 mm around."
QString questionText(const HeldPlace& held);

class TopologySection : public QWidget {
  Q_OBJECT

 public:
  explicit TopologySection(Document& document, QWidget* parent = nullptr);

 Q_SIGNALS:
  void answered(const handlebody::HeldPlace& held, bool allows);

 private:
  //! What happens at a change that would break the limits.
  enum Rule { kFree, kNeverMore, kAsk };
  Rule rule() const;
  void buildFields(QVBoxLayout* all);
  void buildQuestion(QVBoxLayout* all);
  QSpinBox* countField(const QString& name, const QString& tip, int least);
  void choose(int rule);
  void setCounts();
  void refresh();
  void showQuestion();

  Document& document_;
  QComboBox* rule_ = nullptr;
  QWidget* counts_ = nullptr;
  QSpinBox *components_ = nullptr, *genus_ = nullptr;
  QWidget* question_ = nullptr;
  QLabel* text_ = nullptr;
};

}  // namespace handlebody::ui
