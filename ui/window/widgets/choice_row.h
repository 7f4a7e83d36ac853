#pragma once
// A few choices side by side, one of which holds.

#include <QStringList>
#include <QWidget>

class QButtonGroup;

namespace handlebody::ui {

//! Buttons joined in a row; `tips` has one text for each. The group's ids count from 0.
QWidget* choiceRow(const QString& name, const QStringList& texts, const QStringList& tips,
                   QButtonGroup*& group, QWidget* parent);

}  // namespace handlebody::ui
