#include "widgets/begin/recovery_offer.hpp"

#include <QLocale>
#include <QVBoxLayout>

#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int offer_width = 560;

QString placeOf(const Draft& draft) {
  return draft.file.empty() ? RecoveryOffer::tr("never saved") : text(draft.file.string());
}

}  // namespace

RecoveryOffer::RecoveryOffer(std::vector<Leftover> leftovers, QWidget* parent)
    : QDialog(parent), left_(static_cast<int>(leftovers.size())) {
  setWindowTitle(tr("Unsaved work"));
  setMinimumWidth(offer_width);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 18, 20, 14);
  column->setSpacing(10);
  column->addWidget(makeLabel(tr("Talus ended before this was saved"), "large"));
  column->addWidget(makeWrappedLabel(
      tr("Recovering opens it as it was kept; nothing is written to its file before you save."), "muted"));
  rows_ = new QVBoxLayout;
  setMargins(rows_, 0, 8);
  column->addLayout(rows_);
  for (const Leftover& leftover : leftovers) addRow(leftover);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  auto* later = makeButton(tr("Later"));
  later->setAutoDefault(false);
  later->setToolTip(tr("Offered again at the next start"));
  connect(later, &QPushButton::clicked, this, &QDialog::reject);
  buttons->addWidget(later);
  column->addLayout(buttons);
}

void RecoveryOffer::addRow(const Leftover& leftover) {
  auto* card = makePlane("card");
  auto* line = new QHBoxLayout(card);
  line->setContentsMargins(12, 8, 8, 8);
  line->setSpacing(8);
  auto* words = new QVBoxLayout;
  setMargins(words, 0, 1);
  words->addWidget(new ElidedLabel(leftover.name, "strong"));
  const QString when = QLocale::c().toString(leftover.when, QStringLiteral("d MMM yyyy, HH:mm"));
  words->addWidget(new ElidedLabel(tr("%1; %2").arg(when, placeOf(leftover.draft)), "small"));
  line->addLayout(words, 1);
  auto* discard = makeButton(tr("Discard"));
  auto* recover = makeButton(tr("Recover"), rows_->isEmpty() ? "primary" : nullptr);
  discard->setAutoDefault(false);
  connect(recover, &QPushButton::clicked, this, [this, leftover] {
    emit recovered(leftover);
    accept();
  });
  connect(discard, &QPushButton::clicked, this, [this, leftover, card] {
    leftover.discard();
    card->setVisible(false);
    if (--left_ == 0) accept();
  });
  line->addWidget(discard);
  line->addWidget(recover);
  const bool newest = rows_->isEmpty();
  rows_->addWidget(card);
  if (!newest) return;
  recover->setDefault(true);
  recover->setFocus();  // what Enter does loses nothing
}

}  // namespace talus
