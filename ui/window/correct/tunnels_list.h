#pragma once
// Tunnels, components and cavities of the shown surface, each with what can be done to it; and the edits that
// were asked for.

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "ui/model/mesh_contents.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace handlebody::ui {

class Document;
class ViewState;

class TunnelsList : public QWidget {
  Q_OBJECT

 public:
  TunnelsList(Document& document, ViewState& state, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  //! A button below the table: shown for the rows that it can do something with.
  struct Action {
    QPushButton* button;
    std::function<std::optional<MeshEdit>()> edit;  // of the chosen row; none: not for it
  };
  //! A row of the table: one of them is meant.
  struct Row {
    const FoundTunnel* tunnel = nullptr;
    const FoundPiece* piece = nullptr;
    std::optional<MeshEdit> edit{};
    QString what{}, size{}, detail{};
  };

  void buildTable();
  QWidget* buildActions();
  void addAction(const QString& text, const QString& tip, std::function<std::optional<MeshEdit>()> edit);
  bool canLook() const;
  void look();
  void take(MeshContents found);
  void follow();
  void forget();
  std::vector<Row> rowsNow() const;
  void addTunnels(std::vector<Row>& rows) const;
  void addPieces(std::vector<Row>& rows, bool cavities) const;
  void addEdits(std::vector<Row>& rows) const;
  void showRows();
  void fitTable();
  void scrollToActions();
  void showState();
  QString summary() const;
  const Row* chosen() const;  // null: none
  void showActions();
  void mark();
  void showChosen();
  int bodies() const;

  Document& document_;
  ViewState& state_;
  QPushButton* find_;
  QLabel *summary_, *detail_;
  QTableWidget* table_;
  std::vector<Action> actions_;
  QPushButton* leaveOut_ = nullptr;
  QWidget* actionRow_ = nullptr;
  std::vector<Row> rows_;
  std::optional<MeshContents> found_;  // of the shown surface
  bool isLooking_ = false;
  bool looksAgain_ = false;  // after an edit that was made from here
  ContentsFinder finder_;    // last: its thread ends before the rest
};

}  // namespace handlebody::ui
