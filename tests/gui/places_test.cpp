// All places of the window, looked at: no word is cut off, none lies over another; and pictures of them.
#include <QPainter>
#include <set>

#include "cut_off.hpp"
#include "every_place.hpp"
#include "widgets/kit/language.hpp"

namespace talus {
namespace {

const QSize smallest_screen(1280, 720);

/// A page or dialog of each kind; all of them, light and dark, take some minutes (WindowPicture).
const std::set<std::string> some_places{"start",     "new-wedge", "geometry", "joints-joint", "stereonet-mode-2",
                                        "materials", "stages",    "blocks",   "loads",        "results"};

TEST_F(EveryPlace, CutsNoWordOffOnASmallScreenAndLooksAsItDid) {
  std::set<std::string> cut;
  std::size_t seen = 0, compared = 0;
  visitAll(smallest_screen, [&](const std::string& place) {
    ++seen;
    for (const std::string& word : cutOff(*window)) cut.insert(place + ": " + word);
    if (!some_places.contains(place)) return;
    ++compared;
    expectAsItWas(place);
  });
  EXPECT_EQ(compared, some_places.size());
  for (const std::string& word : cut) ADD_FAILURE() << word;
  EXPECT_GT(seen, 80u);
}

class WindowPicture : public EveryPlace, public testing::WithParamInterface<bool> {};

TEST_P(WindowPicture, OfEveryPlaceIsAsItWas) {
  session->display.setDark(GetParam());
  visitAll(smallest_screen, [&](const std::string& place) { expectAsItWas(place); });
}

INSTANTIATE_TEST_SUITE_P(Light, WindowPicture, testing::Values(false));
INSTANTIATE_TEST_SUITE_P(Dark, WindowPicture, testing::Values(true));

/// Small pictures side by side, each with its name, as many sheets as they need; large enough for their writing to be
/// read.
class ContactSheets {
 public:
  explicit ContactSheets(QString folder) : folder_(std::move(folder)) {}
  ~ContactSheets() { finish(); }
  void add(const QPixmap& picture, const QString& name) {
    QImage small = picture.toImage();
    small.setDevicePixelRatio(1);
    small = small.scaledToWidth(width - 4, Qt::SmoothTransformation);
    const int height = small.height() + line;
    if (sheet_.isNull()) {
      sheet_ = QImage(columns * width, rows * height, QImage::Format_RGB32);
      sheet_.fill(Qt::white);
    }
    QPainter painter(&sheet_);
    const QPoint at(count_ % columns * width, count_ / columns * height);
    painter.drawImage(at, small);
    painter.drawText(at + QPoint(4, height - 4), name);
    painter.end();
    if (++count_ == columns * rows) finish();
  }

 private:
  static constexpr int columns = 3, rows = 3, width = 860, line = 16;  // pixels
  void finish() {
    if (count_ > 0) sheet_.save(QStringLiteral("%1/sheet_%2.png").arg(folder_).arg(++sheets_));
    sheet_ = {};
    count_ = 0;
  }
  QString folder_;
  QImage sheet_;
  int count_ = 0, sheets_ = 0;
};

/// Not a test: draws all of them, and sheets of them, into the folder that TALUS_PICTURES names, in the size of
/// TALUS_SIZE ("1600x1000"), the theme of TALUS_THEME and the language of TALUS_LANGUAGE.
TEST_F(EveryPlace, DISABLED_DrawsPictures) {
  const QString folder = qEnvironmentVariable("TALUS_PICTURES");
  const QStringList sides = qEnvironmentVariable("TALUS_SIZE", QStringLiteral("1280x720")).split(u'x');
  language::install(qEnvironmentVariable("TALUS_LANGUAGE", QStringLiteral("en")));
  openWindow();
  session->display.setDark(qEnvironmentVariable("TALUS_THEME") == QLatin1String("dark"));
  constexpr int until_fine = 700;  // ms: the fine drawing comes when the camera has rested
  ContactSheets sheets(folder);
  visitAll({sides.at(0).toInt(), sides.at(1).toInt()}, [&](const std::string& place) {
    rest(until_fine);
    const QPixmap shown = picture();
    ASSERT_TRUE(shown.save(QStringLiteral("%1/%2.png").arg(folder, place.c_str())));
    sheets.add(shown, QString::fromStdString(place));
  });
}

}  // namespace
}  // namespace talus
