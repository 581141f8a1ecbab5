#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/quantity.hpp"
#include "render/paint/image.hpp"
#include "render/paint/painter.hpp"
#include "render/paint/picture_words.hpp"
#include "render/paint/theme.hpp"
#include "results/run_report.hpp"

namespace talus {

/// One curve. Points with a value that is not finite break it.
struct Series {
  std::string name;
  std::vector<double> x, y;
};

/// A moment worth a vertical line and a word.
struct EventMark {
  double x = 0;
  std::string label;
  bool reference = false;  ///< from the literature: dashed; computed ones are solid
};

/// Curves over a common axis, as a journal prints them.
struct HistoryPlot {
  std::string title;
  std::string x_title = picture_word("Time"), x_unit = "s";
  std::string y_title, y_unit;
  std::vector<Series> series;    ///< at most 6
  std::vector<EventMark> marks;  ///< labelled above the curves, in as many rows as keep them apart
  Theme theme = Theme::light;
};

/// The curves with all that belongs to them, without paper. Throws std::invalid_argument when series are missing, too
/// many or of unequal lengths.
Painting chart_painting(const HistoryPlot& plot);

/// The same as an image; throws InputError for sizes outside 320…8192.
Image draw_chart(const HistoryPlot& plot, int width = 1600, int height = 1000);

/// The components of a monitor's displacement, velocity or stress over time, from history.csv's rows. A stress that was
/// not recorded leaves curves without points.
HistoryPlot monitor_plot(const std::string& monitor, int monitor_index, std::span<const HistoryRow> history,
                         Quantity::Field field);

}  // namespace talus
