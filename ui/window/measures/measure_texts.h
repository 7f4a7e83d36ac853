#pragma once
// Measures as the window writes them, in the user's locale and with their units.

#include <QStringList>

#include "core/io/report/measured.h"
#include "core/sensitivity/sensitivity.h"

namespace handlebody::ui {

//! Of the table's columns, with units.
QStringList measureHeaders();
QStringList measureCells(const Measured& measured, const MeasuredObject& object);
//! What the table has no column for, a line each.
QString measureDetails(const Measured& measured, const MeasuredObject& object, const Grid& grid);
//! Length, and the least and the largest section of a centre line.
QString lineSummary(const MeasuredLine& line);
//! Columns of a table (measuredColumns, with tabs) as a spreadsheet of the user's locale reads them: numbers
//! with its decimal point, without groups. Names stay.
QString columnsForSpreadsheet(const QString& columns);
//! Why a perturbed run left no surface. Precondition: it did not.
QString failureText(const PerturbedRun& run);
//! Of a point of a centre line.
QString sectionText(const CentreLinePoint& point);

}  // namespace handlebody::ui
