#include "widgets/results/film_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "base/error.hpp"
#include "session/compared_results.hpp"
#include "session/messages.hpp"
#include "session/playback.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/results/save_table.hpp"
#include "widgets/view/timeline.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

namespace {

constexpr int widths[] = {1280, 1920, 2560, 3840}, rates[] = {25, 30, 50, 60};
constexpr int shown_keys = 5;

QString placeText(const Vec3& place) {
  return QStringLiteral("%1  %2  %3")
      .arg(numbers::figure(place.x(), 3), numbers::figure(place.y(), 3), numbers::figure(place.z(), 3));
}

}  // namespace

FilmDialog::FilmDialog(Playback& playback, ComparedResults& compared, Viewport& viewport, Timeline& timeline,
                       Messages& messages, QWidget* parent)
    : QDialog(parent),
      playback_(playback),
      compared_(compared),
      viewport_(viewport),
      timeline_(timeline),
      messages_(messages),
      width_(makeCombo({}, tr("Width"))),
      rate_(makeCombo({}, tr("Pictures a second"))),
      block_(makeCombo({}, tr("Block that is followed"))),
      others_(makeCombo({tr("beside the view"), tr("over the view, as outlines")}, tr("Compared results"))),
      turns_(new QCheckBox(tr("Turns about the rock by"))),
      follows_(new QCheckBox(tr("Goes along with"))),
      goes_(new QCheckBox(tr("Goes from key to key"))),
      degrees_(new NumberField(turn_, {QStringLiteral("°"), QStringLiteral("°")})),
      begin_(new NumberField({}, {QStringLiteral("s"), QStringLiteral("s")})),
      end_(new NumberField({}, {QStringLiteral("s"), QStringLiteral("s")})),
      save_(makeButton(tr("Save film…"), "primary")),
      speed_(makeLabel({}, "muted")) {
  setWindowTitle(tr("Film"));
  auto* column = new QVBoxLayout(this);
  setMargins(column, 12, 10);
  auto* size = pictures_ = new Section(tr("Pictures"));
  for (const int width : widths) width_->addItem(tr("%1 pixels wide").arg(width), width);
  for (const int rate : rates) rate_->addItem(tr("%1 a second").arg(rate), rate);
  size->addRow(tr("Size"), width_, tr("In the view's shape"));
  size->addRow(tr("Rate"), rate_);
  size->addRow(tr("Speed"), speed_, tr("That of play, which the timeline chooses"));
  size->addRow(tr("Begins at"), begin_);
  size->addRow(tr("Ends at"), end_);
  const auto takeMoment = [this](NumberField* field, std::optional<double>& moment, const QString& none) {
    field->allowNone(none);
    const auto take = [this, &moment](std::optional<double> time) {
      moment = time;
      refresh();
    };
    connect(field, &NumberField::committed, this, take);
    connect(field, &NumberField::cleared, this, [take] { take({}); });
  };
  takeMoment(begin_, from_, tr("first frame"));
  takeMoment(end_, to_, tr("last frame"));
  begin_->setAccessibleName(tr("Moment at which the film begins"));
  begin_->setMeaning(tr("Moment of the model at which the film begins"));
  end_->setAccessibleName(tr("Moment at which the film ends"));
  end_->setMeaning(tr("Moment of the model at which the film ends"));
  others_->setToolTip(tr("Over the view those that were opened first for comparing are drawn"));
  size->addRow(tr("Compared results"), others_);
  connect(&compared_, &ComparedResults::changed, this, &FilmDialog::refresh);
  column->addWidget(size);
  column->addWidget(makeLine(Qt::Horizontal));

  auto* camera = new Section(tr("Camera"));
  turns_->setToolTip(
      tr("Once round from the first picture to the last, or as far as is said, anticlockwise from above"));
  degrees_->setAccessibleName(tr("Degrees that the camera turns by"));
  degrees_->setFixedWidth(80);
  follows_->setToolTip(tr("The block stays in the middle of the picture"));
  goes_->setToolTip(tr("Smoothly through the places of the table; at each key's moment it is there"));
  const auto addRow = [&](QCheckBox* box, QWidget* field) {
    auto* line = new QWidget;
    auto* row = new QHBoxLayout(line);
    setMargins(row, 0, 8);
    row->addWidget(box);
    row->addWidget(field);
    row->addStretch(1);
    camera->addWide(line);
    connect(box, &QCheckBox::toggled, this, &FilmDialog::refresh);
  };
  addRow(turns_, degrees_);
  addRow(follows_, block_);
  camera->addWide(goes_);
  camera->addWide(makeKeys());
  connect(goes_, &QCheckBox::toggled, this, &FilmDialog::refresh);
  connect(degrees_, &NumberField::committed, this, [this](double turn) { turn_ = turn; });
  column->addWidget(camera);
  column->addStretch(1);

  auto* row = new QHBoxLayout;
  setMargins(row, 0, 8);
  row->addStretch(1);
  row->addWidget(save_);
  column->addLayout(row);
  save_->setObjectName(QStringLiteral("saveFilm"));
  save_->setAutoDefault(false);
  connect(save_, &QPushButton::clicked, this, &FilmDialog::filmWanted);
  connect(&playback_, &Playback::framesChanged, this, [this] {
    if (playback_.times().empty()) forgetMoments();
    fillBlocks();
  });
  connect(&timeline_, &Timeline::speedChanged, this, &FilmDialog::refresh);
  fillBlocks();
  setKeys({});
  resizeWithin(*this, {520, 520});
}

/// They were of other results.
void FilmDialog::forgetMoments() {
  from_.reset();
  to_.reset();
  begin_->setValue({});
  end_->setValue({});
  setKeys({});
}

QWidget* FilmDialog::makeKeys() {
  auto* whole = new QWidget;
  auto* column = new QVBoxLayout(whole);
  setMargins(column, 0, 6);
  table_ = new PlainTable;
  table_->setAccessibleName(tr("Camera keys"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  column->addWidget(table_);
  auto* row = new QHBoxLayout;
  setMargins(row, 0, 8);
  add_ = makeButton(tr("Add the view"), "link");
  add_->setToolTip(tr("The camera is at this moment where the view is now"));
  remove_ = makeButton(tr("Remove"), "link");
  read_ = makeButton(tr("Read…"), "link");
  keep_ = makeButton(tr("Save as CSV…"), "link");
  keep_->setToolTip(tr("For talus-cli animate --camera"));
  for (auto* button : {add_, remove_, read_, keep_}) {
    button->setAutoDefault(false);
    row->addWidget(button);
  }
  row->addStretch(1);
  column->addLayout(row);
  connect(add_, &QPushButton::clicked, this, &FilmDialog::addKey);
  connect(remove_, &QPushButton::clicked, this, &FilmDialog::removeKey);
  connect(read_, &QPushButton::clicked, this, &FilmDialog::readKeys);
  connect(keep_, &QPushButton::clicked, this, &FilmDialog::saveKeys);
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { remove_->setEnabled(goes_->isChecked() && table_->currentRow() >= 0); });
  return whole;
}

void FilmDialog::present(const std::vector<int>& selected) {
  fillBlocks();
  const int chosen = selected.empty() ? -1 : block_->findData(selected.front());
  if (chosen >= 0 && !follows_->isChecked()) block_->setCurrentIndex(chosen);
  refresh();
  show();
  raise();
  activateWindow();
}

FilmOptions FilmDialog::options() const {
  FilmOptions film;
  film.width = width_->currentData().toInt();
  film.fps = rate_->currentData().toInt();
  film.speed = timeline_.speed();
  film.from = from_;
  film.to = to_;
  film.over = !compared_.runs().empty() && others_->currentIndex() == 1;
  if (turns_->isChecked()) film.camera.turn = turn_;
  if (follows_->isChecked() && block_->currentIndex() >= 0) film.camera.follow = block_->currentData().toInt();
  if (goes_->isChecked()) film.camera.keys = keys_;
  return film;
}

/// A key at the same moment takes the place of the one that is there.
void FilmDialog::addKey() {
  const auto pose = viewport_.pose();
  if (!pose) return;
  const double time = playback_.time();
  std::vector<CameraKey> keys = keys_;
  std::erase_if(keys, [time](const CameraKey& key) { return key.time == time; });
  keys.push_back({time, pose->position, pose->focal_point});
  std::ranges::sort(keys, {}, &CameraKey::time);
  setKeys(std::move(keys));
}

void FilmDialog::removeKey() {
  const int row = table_->currentRow();
  if (row < 0) return;
  keys_.erase(keys_.begin() + row);
  setKeys(std::move(keys_));
}

void FilmDialog::readKeys() {
  const QString name = QFileDialog::getOpenFileName(this, tr("Read camera keys"), {}, tr("Tables (*.csv)"));
  if (name.isEmpty()) return;
  try {
    setKeys(read_camera_keys(name.toStdString()));
  } catch (const InputError& error) {
    messages_.add(problemOf(error, Problem::Of::picture));
  }
}

void FilmDialog::saveKeys() {
  saveTable(*this, messages_, tr("Save the camera keys"), QStringLiteral("keys.csv"),
            [this] { return camera_keys_csv(keys_); });
}

void FilmDialog::setKeys(std::vector<CameraKey> keys) {
  keys_ = std::move(keys);
  std::vector<QStringList> rows;
  for (const CameraKey& key : keys_)
    rows.push_back({numbers::fixed(key.time, 2), placeText(key.position), placeText(key.focal_point)});
  table_->setContent({tr("Time, s"), tr("Stands at, m"), tr("Looks to, m")}, rows, {false, true, true});
  table_->fitHeight(shown_keys);
  refresh();
}

/// Those of the results, as soon as the view shows them.
void FilmDialog::fillBlocks() {
  const QVariant chosen = block_->currentData();
  block_->clear();
  const auto system = viewport_.showsSolids() ? nullptr : viewport_.shown();
  for (std::size_t b = 0; system && b < system->blocks.size(); ++b)
    if (system->blocks[b].body != BodyKind::fixed) block_->addItem(text(system->blocks[b].name), static_cast<int>(b));
  block_->setCurrentIndex(std::max(0, block_->findData(chosen)));
  refresh();
}

void FilmDialog::refresh() {
  pictures_->setRowVisible(others_, !compared_.runs().empty());
  degrees_->setEnabled(turns_->isChecked());
  follows_->setEnabled(block_->count() > 0);
  block_->setEnabled(follows_->isChecked() && block_->count() > 0);
  for (QWidget* each : {static_cast<QWidget*>(table_), static_cast<QWidget*>(add_), static_cast<QWidget*>(read_)})
    each->setEnabled(goes_->isChecked());
  table_->setVisible(goes_->isChecked() && !keys_.empty());
  keep_->setEnabled(goes_->isChecked() && !keys_.empty());
  remove_->setEnabled(goes_->isChecked() && table_->currentRow() >= 0);
  const std::string speed = speed_text(timeline_.speed());
  speed_->setText(speed.empty() ? tr("real time") : text(speed));
  const std::vector<double>& times = playback_.times();
  const bool lacksKeys = goes_->isChecked() && keys_.empty();
  const bool shows = !times.empty() && std::max(from_.value_or(times.front()), times.front()) <=
                                           std::min(to_.value_or(times.back()), times.back());
  save_->setEnabled(shows && !lacksKeys);
  save_->setToolTip(times.empty() ? tr("There are no frames yet")
                    : !shows      ? tr("No frames lie between its beginning and its end")
                    : lacksKeys   ? tr("Add a key, or let the camera stand still")
                                  : QString());
}

}  // namespace talus
