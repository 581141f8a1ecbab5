#include "values/line_values.hpp"

#include <cstdio>

#include "base/error.hpp"
#include "measures/line_probe.hpp"
#include "model/number_text.hpp"
#include "output_file.hpp"
#include "render/charts/line_plot.hpp"

namespace talus::cli {

namespace {

struct Line {
  Vec3 from, to;
};

Line line_of(const std::string& text) {
  double n[6];
  int read = 0;
  const int numbers =
      std::sscanf(text.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf%n", n, n + 1, n + 2, n + 3, n + 4, n + 5, &read);
  if (numbers != 6 || static_cast<std::size_t>(read) != text.size())
    throw InputError("--line " + text, "this is no line", "write its two ends as x,y,z,x,y,z in m");
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

std::string place_text(const Vec3& place) {
  return "(" + significant(place.x(), 4) + ", " + significant(place.y(), 4) + ", " + significant(place.z(), 4) + ")";
}

}  // namespace

void add_line_choice(CLI::App& command, LineChoice& choice) {
  auto* line = command
                   .add_option("--line", choice.ends,
                               "A field along the straight line between two points, m, in one frame, in place of "
                               "histories")
                   ->type_name("x,y,z,x,y,z")
                   ->excludes(command.get_option("--monitor"))
                   ->excludes(command.get_option("--block"));
  command.add_option("--field", choice.field, "Which field along the line (default: displacement)")
      ->type_name("NAME")
      ->needs(line);
  add_frame_choice(command, choice.frame);
  for (const char* moment : {"--time", "--frame"}) command.get_option(moment)->needs(line);
}

std::vector<std::string> write_line(const LineChoice& choice, const ResultReader& results, const ChartFiles& files) {
  const Line line = line_of(choice.ends);
  const Field& field = field_named(choice.field.empty() ? "displacement" : choice.field);
  const Frame frame = results.frame(frame_index(results, choice.frame));
  const LineProbe probe = probe_line(results.system(), frame, field, line.from, line.to);
  if (probe.pieces.empty())
    throw InputError("--line " + choice.ends, "it meets no rock at " + number_text(frame.time) + " s",
                     "info and mesh tell where blocks are");
  if (files.out.extension() == ".csv") {
    write_output(files.out, probe_csv(probe, results.system(), field, line.from, line.to));
    return {files.out.string()};
  }
  HistoryPlot plot = line_plot(probe, field,
                               std::string(field.title) + " from " + place_text(line.from) + " to " +
                                   place_text(line.to) + " at " + significant(frame.time, 4) + " s");
  plot.theme = files.theme;
  return write_charts(files, {{{"line-" + std::string(field.name), std::move(plot)}}}, results.project_name());
}

}  // namespace talus::cli
