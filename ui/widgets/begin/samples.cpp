#include "widgets/begin/samples.hpp"

#include <QFile>
#include <QRegularExpression>
#include <algorithm>

#include "base/error.hpp"
#include "base/installed.hpp"
#include "io/project_file.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

/// Markdown's words without its marks.
QString plainWords(QString text) {
  static const QRegularExpression link(QStringLiteral("\\[([^\\]]*)\\]\\([^)]*\\)")), marks(QStringLiteral("[*`]"));
  return text.replace(link, QStringLiteral("\\1")).remove(marks);
}

/// The first sentence of a README that is neither heading nor picture nor table.
QString firstSentence(const std::filesystem::path& readme) {
  QFile file(text(readme.string()));
  if (!file.open(QIODevice::ReadOnly | QIODevice::Text)) return {};
  QString paragraph;
  while (!file.atEnd()) {
    const QString line = QString::fromUtf8(file.readLine()).trimmed();
    if (line.isEmpty() && !paragraph.isEmpty()) break;
    if (line.isEmpty() || line.startsWith(u'#') || line.startsWith(u'!') || line.startsWith(u'|')) continue;
    paragraph += (paragraph.isEmpty() ? QString() : QStringLiteral(" ")) + line;
  }
  paragraph = plainWords(paragraph);
  const qsizetype stop = paragraph.indexOf(QStringLiteral(". "));
  return stop < 0 ? paragraph : paragraph.left(stop + 1);
}

}  // namespace

std::vector<Sample> samplesIn(const std::filesystem::path& folder) {
  std::vector<Sample> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const auto project = entry.path() / (entry.path().filename().string() + ".talus");
    if (!std::filesystem::exists(project, ignored)) continue;
    try {
      Sample sample;
      sample.project = project;
      sample.name = text(read_project(project).name);
      sample.description = firstSentence(entry.path() / "README.md");
      sample.picture = entry.path() / "preview.png";
      found.push_back(std::move(sample));
    } catch (const InputError&) {
      continue;  // it is listed nowhere rather than offered and refused
    }
  }
  std::sort(found.begin(), found.end(), [](const Sample& a, const Sample& b) { return a.name < b.name; });
  return found;
}

std::filesystem::path samplesFolder() { return installed_or("share/talus/samples", TALUS_SAMPLES); }

}  // namespace talus
