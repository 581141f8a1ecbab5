#include "widgets/project/start_page.hpp"

#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QVBoxLayout>

#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int cards_in_a_row = 4;

/// The sample's picture, filling its place; the program's sign where it has none.
class Preview : public QWidget {
 public:
  explicit Preview(const std::filesystem::path& picture) : picture_(text(picture.string())) {
    setMinimumHeight(128);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    if (picture_.isNull()) {
      painter.fillRect(rect(), theme::colours().window);
      const QRect sign(width() / 2 - 20, height() / 2 - 20, 40, 40);
      theme::icon(QStringLiteral("blocks")).paint(&painter, sign);
      return;
    }
    const double ratio = devicePixelRatioF();
    const QSize wanted = size() * ratio;
    if (shown_.isNull() || shown_.size() != picture_.size().scaled(wanted, Qt::KeepAspectRatioByExpanding))
      shown_ = picture_.scaled(wanted, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    shown_.setDevicePixelRatio(ratio);
    const QSizeF drawn = QSizeF(shown_.size()) / ratio;
    painter.drawPixmap(QPointF((width() - drawn.width()) / 2, (height() - drawn.height()) / 2), shown_);
  }

 private:
  QPixmap picture_, shown_;  ///< as it is on disk; in the size of the card
};

QString inHome(const std::filesystem::path& folder) {
  QString name = text(folder.string());
  const QString home = qEnvironmentVariable("HOME");
  if (!home.isEmpty() && name.startsWith(home)) name.replace(0, home.size(), u'~');
  return name;
}

/// A recent file as a button with two lines.
class RecentFile : public QToolButton {
 public:
  explicit RecentFile(const std::filesystem::path& file) : file_(file) {
    setFixedHeight(44);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(talus::text(file.string()));
    setAccessibleName(talus::text(file.filename().string()));
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QToolButton::paintEvent(event);
    QPainter painter(this);
    theme::icon(QStringLiteral("file")).paint(&painter, QRect(4, 13, 18, 18));
    const QString changed = QLocale::c().toString(QFileInfo(talus::text(file_.string())).lastModified(), "d MMM");
    painter.setFont(theme::font(theme::now().type.small));
    painter.setPen(theme::colours().textMuted);
    painter.drawText(QRect(32, 22, width() - 36, 16), Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(inHome(file_.parent_path()), Qt::ElideMiddle, width() - 36));
    painter.drawText(QRect(0, 5, width() - 4, 16), Qt::AlignRight | Qt::AlignVCenter, changed);
    painter.setFont(theme::font(theme::now().type.body, QFont::Medium));
    painter.setPen(theme::colours().text);
    painter.drawText(
        QRect(32, 5, width() - 90, 16), Qt::AlignVCenter,
        painter.fontMetrics().elidedText(talus::text(file_.stem().string()), Qt::ElideRight, width() - 90));
  }

 private:
  std::filesystem::path file_;
};

}  // namespace

SampleCard::SampleCard(const Sample& sample) {
  setProperty("plane", "card");
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
  setAccessibleName(sample.name);
  setMaximumHeight(280);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(1, 1, 1, 10);
  column->setSpacing(0);
  column->addWidget(new Preview(sample.picture), 1);
  auto* words = new QVBoxLayout;
  words->setContentsMargins(12, 8, 12, 0);
  words->setSpacing(2);
  words->addWidget(new ElidedLabel(sample.name, "strong"));
  auto* description = makeWrappedLabel(sample.description, "small");
  description->setFixedHeight(44);
  description->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  words->addWidget(description);
  column->addLayout(words);
}

void SampleCard::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && rect().contains(event->pos())) emit chosen();
}

void SampleCard::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Space)
    emit chosen();
  else
    QFrame::keyPressEvent(event);
}

StartPage::StartPage() {
  auto* row = new QHBoxLayout(this);
  setMargins(row, 0, 0);
  row->addWidget(makeLeft());
  row->addWidget(makeScrolled(makeSamples()), 1);
  refresh();
}

QWidget* StartPage::makeLeft() {
  auto* left = makePlane("rail");
  left->setFixedWidth(296);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(24, 24, 24, 20);
  column->setSpacing(8);
  auto* brand = new QHBoxLayout;
  brand->setSpacing(10);
  brand->addWidget(new Glyph(QStringLiteral("logo"), theme::Tone::accent, 32));
  brand->addWidget(makeLabel(QStringLiteral("Talus"), "display"));
  brand->addStretch();
  column->addLayout(brand);
  column->addWidget(makeLabel(tr("Rock slopes that come apart along joints"), "muted"));
  column->addSpacing(12);
  auto* open = makeButton(tr("Open…"), "primary");
  open->setIcon(theme::icon(QStringLiteral("folder"), theme::Tone::onAccent));
  connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
  column->addWidget(open);
  auto* results = makeButton(tr("Open results…"));
  results->setIcon(theme::icon(QStringLiteral("results")));
  connect(results, &QPushButton::clicked, this, &StartPage::openResultsRequested);
  column->addWidget(results);
  column->addSpacing(16);
  column->addWidget(makeLabel(tr("Recent"), "section"));
  recent_ = new QVBoxLayout;
  setMargins(recent_, 0, 0);
  column->addLayout(recent_);
  column->addStretch();
  return left;
}

QWidget* StartPage::makeSamples() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(32, 26, 32, 20);
  column->setSpacing(10);
  auto* heading = new QHBoxLayout;
  heading->setSpacing(10);
  heading->addWidget(makeLabel(tr("Samples with a known answer"), "large"));
  heading->addWidget(makeLabel(tr("open, solve, compare"), "muted"), 0, Qt::AlignBottom);
  heading->addStretch();
  column->addLayout(heading);
  auto* grid = new QGridLayout;
  grid->setSpacing(12);
  int place = 0;
  for (const Sample& sample : samplesIn(samplesFolder())) {
    auto* card = new SampleCard(sample);
    connect(card, &SampleCard::chosen, this, [this, file = sample.project] { emit fileChosen(file); });
    grid->addWidget(card, place / cards_in_a_row, place % cards_in_a_row);
    ++place;
  }
  for (int i = 0; i < cards_in_a_row; ++i) grid->setColumnStretch(i, 1);
  column->addLayout(grid);
  if (place == 0) column->addWidget(makeLabel(tr("No samples were installed with the program."), "muted"));
  column->addStretch();
  return page;
}

void StartPage::refresh() {
  clearLayout(*recent_);
  const auto files = recentFiles();
  for (const auto& file : files) {
    auto* button = new RecentFile(file);
    connect(button, &QToolButton::clicked, this, [this, file] { emit fileChosen(file); });
    recent_->addWidget(button);
  }
  if (files.empty()) recent_->addWidget(makeLabel(tr("Files you open are listed here."), "small"));
}

}  // namespace talus
