// SPDX-License-Identifier: GPL-3.0-or-later
// Where the parts of a page stand: the dial over what is wrong with the device, or its sticks; beside it what
// belongs there, then further lamps, then facts
// in columns; all under one another where it is narrow. Used by DevicePage inside its scroll area.
//
// By hand, not by nested layouts: half of the parts have a height that depends on their width, and Qt's box
// layouts, nested, take that from one part to give it to another.
#pragma once

#include <QRect>
#include <QWidget>
#include <functional>
#include <vector>

namespace deckpipe {

class PageContent : public QWidget {
  Q_OBJECT

 public:
  struct Parts {
    QWidget* dial = nullptr;       // grows with the room there is
    QWidget* reasons = nullptr;    // right under the dial; without one, before all else
    std::vector<QWidget*> sticks;  // of their own width; beside one another where there is room
    std::vector<QWidget*> beside, below, facts;
    friend bool operator==(const Parts&, const Parts&) = default;
  };

  explicit PageContent(QWidget* parent = nullptr);

  // Only these are visible.
  void setParts(const Parts& parts);
  // The height that can be seen at once: what the others leave of it is the dial's.
  void setRoom(int height);

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {240, 160}; }

 protected:
  bool event(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Place {
    QWidget* part;
    QRect rect;
  };
  using Take = std::function<void(QWidget*, const QRect&)>;
  // The sticks from `top`; `width` and `height` become what they take.
  void placeSticks(int inner, int top, int& width, int& height, const Take& take) const;
  // All parts at a width; `height` becomes that of the whole.
  std::vector<Place> places(int width, int& height) const;
  void arrange();

  Parts m_parts;
  int m_room = 0;
};

}  // namespace deckpipe
