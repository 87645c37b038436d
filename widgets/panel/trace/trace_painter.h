// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rows of the trace: a gutter with the cursor and the signs of what is out of the ordinary, then the
// cells. Made by the view for each painting, from what holds for all rows.
#pragma once

#include <QFont>
#include <QFontMetrics>
#include <QModelIndex>
#include <QRect>
#include <vector>

#include "model/trace_model.h"
#include "paint/palette.h"

class QPainter;

namespace deckpipe {

struct TraceColumn {
  int column = 0;
  int left = 0;
  int width = 0;
};

// The fonts of the trace: figures and bytes stand under one another, words are easier to read in the person's
// own font.
struct TraceFonts {
  explicit TraceFonts(const QFont& text);
  const QFont& of(int column) const { return isTabular(column) ? figures : text; }
  static bool isTabular(int column);

  QFont text;
  QFont figures;
};

class TracePainter {
 public:
  static constexpr int kGutter = 36;

  TracePainter(QPainter& painter, const Colours& colours, const TraceFonts& fonts,
               std::vector<TraceColumn> columns);

  struct Look {
    bool isSelected = false;
    bool isOdd = false;
    bool hasFocus = false;  // the current row of a view that has the focus
  };
  void row(const QRect& rect, const QModelIndex& index, Look look);

 private:
  void gutter(const QRect& rect, TraceModel::Marks marks, bool isSelected);
  void cells(const QRect& rect, const QModelIndex& index, TraceModel::Marks marks, bool isSelected);
  QColor ink(int column, TraceModel::Marks marks, bool isSelected) const;

  QPainter& m_painter;
  const Colours& m_colours;
  const TraceFonts& m_fonts;
  const QFontMetrics m_textMetrics;
  const QFontMetrics m_figureMetrics;
  const double m_figureWidth;
  const std::vector<TraceColumn> m_columns;
};

}  // namespace deckpipe
