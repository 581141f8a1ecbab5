#include "widgets/begin/start_page.hpp"

#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QPixmapCache>
#include <QTimer>
#include <QVBoxLayout>
#include <optional>

#include "templates/templates.hpp"
#include "widgets/begin/new_dialog.hpp"
#include "widgets/begin/recent_files.hpp"
#include "widgets/begin/samples.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int cards_in_a_row = 4, left_width = 296;
constexpr double height_of_width = 0.56;  // of a card's picture
constexpr int card_width = 216, widest = 480;

/// Of a picture "wedge.png" the one that was drawn for the dark, "wedge-dark.png", where it is dark and there is one.
QString inTheme(const QString& file, bool dark) {
  const QFileInfo light(file);
  const QString other = light.path() + u'/' + light.completeBaseName() + QStringLiteral("-dark.") + light.suffix();
  return dark && QFileInfo::exists(other) ? other : file;
}

/// The sample's picture, filling its place; the program's sign where it has none. It is read when it comes into view,
/// anew where the theme has changed, and kept as large as cards become.
class Preview : public QWidget {
 public:
  explicit Preview(const QString& file) : file_(file) {
    QSizePolicy grows(QSizePolicy::Expanding, QSizePolicy::Preferred);
    grows.setHeightForWidth(true);
    setSizePolicy(grows);
  }
  int heightForWidth(int width) const override { return static_cast<int>(height_of_width * width); }
  QSize sizeHint() const override { return {card_width, heightForWidth(card_width)}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    if (isOfDark_ != theme::now().dark) readPicture();
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
  void readPicture() {
    isOfDark_ = theme::now().dark;
    shown_ = {};
    const QString kept = QStringLiteral("%1 %2").arg(inTheme(file_, *isOfDark_)).arg(devicePixelRatioF());
    if (QPixmapCache::find(kept, &picture_)) return;
    picture_ = QPixmap(inTheme(file_, *isOfDark_));
    const QSize most = QSize(widest, heightForWidth(widest)) * devicePixelRatioF();
    if (picture_.width() > most.width() && picture_.height() > most.height())
      picture_ = picture_.scaled(most, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    QPixmapCache::insert(kept, picture_);
  }

  QString file_;
  std::optional<bool> isOfDark_;  ///< the theme that it was read for; none: it was not read yet
  QPixmap picture_, shown_;       ///< of all cards' sizes; in the size of this one
};

QString inHome(const std::filesystem::path& folder) {
  QString name = text(folder.string());
  const QString home = qEnvironmentVariable("HOME");
  if (!home.isEmpty() && name.startsWith(home)) name.replace(0, home.size(), u'~');
  return name;
}

constexpr int thumb_width = 62, row_height = 48;

/// A recent file as a button: its last picture, its name, where it is and of when; faint where it is gone.
class RecentButton : public QToolButton {
 public:
  explicit RecentButton(const RecentFile& file) : file_(file) {
    setFixedHeight(row_height);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    const QString name = talus::text(file.path.string());
    setToolTip(file.isThere ? name : tr("%1\nThere is no such file any more").arg(name));
    setAccessibleName(talus::text(file.path.filename().string()));
    setEnabled(file.isThere);
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QToolButton::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QRect thumb(4, 4, thumb_width, height() - 8);
    painter.fillRect(thumb, theme::colours().sunken);
    if (isOfDark_ != theme::now().dark) readPicture();
    if (file_.isThere && !picture_.isNull())
      painter.drawPixmap(thumb, picture_, cut(thumb.size()));
    else
      theme::icon(QStringLiteral("file")).paint(&painter, thumb);
    const int left = thumb.right() + 10, room = width() - left - 4;
    const QString changed = file_.isThere ? QLocale::c().toString(lastChange(), "d MMM") : tr("gone");
    painter.setFont(theme::font(theme::now().type.small));
    painter.setPen(theme::colours().textMuted);
    painter.drawText(QRect(left, 25, room, 16), Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(inHome(file_.path.parent_path()), Qt::ElideMiddle, room));
    painter.drawText(QRect(left, 7, room, 16), Qt::AlignRight | Qt::AlignVCenter, changed);
    const int words = room - painter.fontMetrics().horizontalAdvance(changed) - 8;
    painter.setFont(theme::font(theme::now().type.body, QFont::Medium));
    painter.setPen(file_.isThere ? theme::colours().text : theme::colours().textMuted);
    painter.drawText(QRect(left, 7, words, 16), Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(talus::text(file_.path.stem().string()), Qt::ElideRight, words));
  }

 private:
  void readPicture() {
    isOfDark_ = theme::now().dark;
    picture_ = pictureOf(file_.path, *isOfDark_);
  }
  QDateTime lastChange() const { return QFileInfo(talus::text(file_.path.string())).lastModified(); }
  /// The middle of the picture in the shape of its place.
  QRect cut(QSize place) const {
    const QSize size = place.scaled(picture_.size(), Qt::KeepAspectRatio);
    return {QPoint((picture_.width() - size.width()) / 2, (picture_.height() - size.height()) / 2), size};
  }

  RecentFile file_;
  std::optional<bool> isOfDark_;  ///< the theme that the picture was read for; none: it was not read yet
  QPixmap picture_;
};

}  // namespace

StartCard::StartCard(const QString& name, const QString& description, const QString& picture) {
  setProperty("plane", "card");
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
  setAccessibleName(name);
  setAccessibleDescription(description);
  setToolTip(description);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(1, 1, 1, 10);
  column->setSpacing(0);
  column->addWidget(new Preview(picture), 1);
  auto* words = new QVBoxLayout;
  words->setContentsMargins(12, 8, 12, 0);
  words->setSpacing(2);
  words->addWidget(new ElidedLabel(name, "strong"));
  auto* sentence = makeWrappedLabel(description, "small");
  sentence->setFixedHeight(44);
  sentence->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  words->addWidget(sentence);
  column->addLayout(words);
}

void StartCard::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && rect().contains(event->pos())) emit chosen();
}

void StartCard::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Space)
    emit chosen();
  else
    QFrame::keyPressEvent(event);
}

StartPage::StartPage() {
  auto* row = new QHBoxLayout(this);
  setMargins(row, 0, 0);
  row->addWidget(makeLeft());
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(32, 26, 32, 20);
  column->setSpacing(10);
  addTemplates(*column);
  column->addSpacing(14);
  addSamples(*column);
  column->addStretch();
  row->addWidget(makeScrolled(page), 1);
  refresh(false);
}

QPushButton* StartPage::addButton(QVBoxLayout& column, const QString& words, const QString& icon, const char* kind) {
  auto* button = makeButton(words, kind);
  button->setIcon(theme::icon(icon, kind ? theme::Tone::onAccent : theme::Tone::muted));
  column.addWidget(button);
  return button;
}

QWidget* StartPage::makeLeft() {
  auto* left = makePlane("rail");
  left->setFixedWidth(left_width);
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
  return_ = addButton(*column, tr("Return to the project"), QStringLiteral("arrow-right"), nullptr);
  return_->setToolTip(tr("Esc"));
  connect(return_, &QPushButton::clicked, this, &StartPage::returnRequested);
  auto* begin = addButton(*column, tr("New…"), QStringLiteral("plus"), "primary");
  connect(begin, &QPushButton::clicked, this, [this] { emit templateChosen({}); });
  auto* open = addButton(*column, tr("Open…"), QStringLiteral("folder"), nullptr);
  connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
  auto* results = addButton(*column, tr("Open results…"), QStringLiteral("results"), nullptr);
  connect(results, &QPushButton::clicked, this, &StartPage::openResultsRequested);
  column->addSpacing(16);
  column->addWidget(makeLabel(tr("Recent"), "section"));
  auto* list = new QWidget;
  auto* rows = new QVBoxLayout(list);
  setMargins(rows, 0, 0);
  recent_ = new QVBoxLayout;
  setMargins(recent_, 0, 0);
  rows->addLayout(recent_);
  rows->addStretch();
  column->addWidget(makeScrolled(list), 1);
  column->addWidget(makeWrappedLabel(
      tr("Projects, results, files of geometry and tables of joints can be dropped anywhere."), "small"));
  return left;
}

QGridLayout* StartPage::addHeading(QVBoxLayout& column, const QString& title, const QString& note) {
  auto* heading = new QHBoxLayout;
  heading->setSpacing(10);
  heading->addWidget(makeLabel(title, "large"));
  heading->addWidget(makeLabel(note, "muted"), 0, Qt::AlignBottom);
  heading->addStretch();
  column.addLayout(heading);
  auto* grid = new QGridLayout;
  grid->setSpacing(12);
  for (int i = 0; i < cards_in_a_row; ++i) grid->setColumnStretch(i, 1);
  column.addLayout(grid);
  return grid;
}

void StartPage::addTemplates(QVBoxLayout& column) {
  auto* grid = addHeading(column, tr("New from a template"), tr("five numbers, a picture, a project"));
  int place = 0;
  auto add = [&](const QString& key, const QString& name, const QString& description) {
    auto* card = new StartCard(name, description, QStringLiteral(":/templates/%1.png").arg(key));
    connect(card, &StartCard::chosen, this, [this, key] { emit templateChosen(key); });
    grid->addWidget(card, place / cards_in_a_row, place % cards_in_a_row);
    ++place;
  };
  for (const ProjectTemplate& candidate : project_templates())
    add(text(candidate.key), text(candidate.name), text(candidate.description).section(QStringLiteral(". "), 0, 0));
  add(QLatin1String(empty_key), tr("Empty project"), tr("Nothing but gravity: everything else is yours to add"));
}

void StartPage::addSamples(QVBoxLayout& column) {
  auto* grid = addHeading(column, tr("Samples with a known answer"), tr("opened as a copy: solve, compare, change"));
  int place = 0;
  for (const Sample& sample : samplesIn(samplesFolder())) {
    auto* card = new StartCard(sample.name, sample.description, text(sample.picture.string()));
    connect(card, &StartCard::chosen, this, [this, file = sample.project] { emit sampleChosen(file); });
    grid->addWidget(card, place / cards_in_a_row, place % cards_in_a_row);
    ++place;
  }
  if (place == 0) column.addWidget(makeLabel(tr("No samples were installed with the program."), "muted"));
}

void StartPage::refresh(bool mayReturn) {
  return_->setVisible(mayReturn);
  clearLayout(*recent_);
  const auto files = recentFiles();
  for (const RecentFile& file : files) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    setMargins(line, 0, 0);
    auto* button = new RecentButton(file);
    connect(button, &QToolButton::clicked, this, [this, path = file.path] { emit fileChosen(path); });
    line->addWidget(button, 1);
    if (!file.isThere) {
      auto* forget = makeTool(QStringLiteral("close"), tr("Forget %1").arg(text(file.path.string())));
      connect(forget, &QToolButton::clicked, this, [this, path = file.path, mayReturn] {
        forgetRecent(path);
        QTimer::singleShot(0, this, [this, mayReturn] { refresh(mayReturn); });  // the button must end its click first
      });
      line->addWidget(forget);
    }
    recent_->addWidget(row);
  }
  if (files.empty()) recent_->addWidget(makeLabel(tr("Files you open are listed here."), "small"));
}

}  // namespace talus
