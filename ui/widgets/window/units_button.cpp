#include "widgets/window/units_button.hpp"

#include <QActionGroup>
#include <QMenu>

#include "session/display.hpp"
#include "widgets/kit/display_units.hpp"

namespace talus {

UnitsButton::UnitsButton(Display& display) : display_(display) {
  setObjectName(QStringLiteral("units"));
  setAutoRaise(true);
  setToolTip(tr("In which units numbers are shown. Any other can be typed: 50 kPa, 2.7 t/m³, 0.5 rad"));
  setAccessibleName(tr("Units"));
  setText(units::summary());
  auto* menu = new QMenu(this);
  fill(*menu);
  setMenu(menu);
  setPopupMode(QToolButton::InstantPopup);
  connect(&display_, &Display::unitsChanged, this, [this] { setText(units::summary()); });
}

void UnitsButton::fill(QMenu& menu) {
  for (const auto& [quantity, title, names] : units::choices()) {
    auto* entries = menu.addMenu(title);
    auto* group = new QActionGroup(entries);
    for (const QString& name : names) {
      auto* entry = entries->addAction(name.isEmpty() ? tr("as usual for each") : name);
      entry->setCheckable(true);
      entry->setChecked(units::chosen(quantity) == name);
      group->addAction(entry);
      connect(entry, &QAction::triggered, this, [this, quantity = quantity, name] {
        units::choose(quantity, name);
        emit display_.unitsChanged();
      });
    }
  }
}

}  // namespace talus
