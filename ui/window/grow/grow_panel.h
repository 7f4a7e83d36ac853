#pragma once
// Step 4: run, step, and the numbers of what has grown.

#include <QWidget>

class QFormLayout;
class QLabel;

namespace handlebody::ui {

class Commands;
class Document;
class EventInspector;
class SurfaceView;
class TopologySection;

class GrowPanel : public QWidget {
  Q_OBJECT

 public:
  GrowPanel(Document& document, SurfaceView& surface, const Commands& commands, QWidget* parent = nullptr);

  EventInspector& inspector() const { return *inspector_; }
  TopologySection& topology() const { return *topology_; }

 private:
  QWidget* buildButtons(const Commands& commands);
  QWidget* buildNumbers();
  void addNumber(QFormLayout* form, const QString& name, const QString& tip, QLabel*& field);
  void showState();
  void showNumbers();
  void showCertificate();

  Document& document_;
  QLabel *hint_, *state_, *error_, *warnings_, *badge_;
  QWidget* numbers_;
  QLabel *components_, *genus_, *euler_, *vertices_, *area_, *volume_;
  EventInspector* inspector_;
  TopologySection* topology_;
};

//! "Running", "Finished: converged" … with the iteration.
QString stateText(const Document& document, const QString& between = QStringLiteral(" · "));

}  // namespace handlebody::ui
