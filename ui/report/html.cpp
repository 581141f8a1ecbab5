#include "report/html.hpp"

#include "base/base64.hpp"
#include "base/xml_text.hpp"
#include "render/paint/svg_painter.hpp"

namespace talus::report {

namespace {

// Slashes close elements that have no end, so that the page is well-formed XML too.
constexpr const char* style = R"(
  @page { size: A4; margin: 18mm 17mm 20mm; }
  * { box-sizing: border-box; }
  html { background: #eef0f2; }
  body { font: 15px/1.5 Inter, "DejaVu Sans", "Segoe UI", Arial, sans-serif; color: #1d2329; background: #fff;
         max-width: 960px; margin: 24px auto; padding: 44px 56px 56px; font-feature-settings: "tnum"; }
  h1 { font-size: 30px; line-height: 1.2; margin: 0 0 6px; }
  h2 { font-size: 20px; margin: 40px 0 10px; padding-top: 14px; border-top: 1px solid #d5dade;
       break-after: avoid; }
  h3 { font-size: 15px; margin: 22px 0 6px; break-after: avoid; }
  p { margin: 6px 0; }
  .byline, .note, figcaption { color: #5d6873; font-size: 13px; }
  .good, .bad { font-size: 19px; font-weight: 600; margin: 16px 0 10px; padding: 10px 16px; border-left: 5px solid; }
  .good { border-color: #2e7d4f; background: #eef7f1; }
  .bad { border-color: #b3372f; background: #fbefee; }
  table { border-collapse: collapse; margin: 8px 0 14px; font-size: 13px; line-height: 1.4; }
  thead { display: table-header-group; }
  tr { break-inside: avoid; }
  th { text-align: left; font-weight: 600; border-bottom: 1.5px solid #1d2329; vertical-align: bottom; }
  th, td { padding: 4px 18px 4px 0; }
  td { border-bottom: 1px solid #e6e9ec; vertical-align: top; }
  th:last-child, td:last-child { padding-right: 0; }
  .r { text-align: right; white-space: nowrap; }
  table.facts td { border: 0; padding: 2px 24px 2px 0; font-size: 14px; }
  table.facts td:first-child { color: #5d6873; white-space: nowrap; }
  figure { margin: 12px 0 18px; break-inside: avoid; }
  figure img, figure svg { display: block; width: 100%; height: auto; }
  figure img { border: 1px solid #d5dade; }
  figcaption { margin-top: 6px; }
  @media (max-width: 700px) { body { padding: 20px; } table { display: block; overflow-x: auto; } }
  @media print { html { background: #fff; } body { margin: 0; padding: 0; max-width: none; font-size: 9.5pt; }
    h1 { font-size: 20pt; } h2 { font-size: 13pt; } h3 { font-size: 10pt; } table { font-size: 8pt; }
    table.facts td, .byline, .note, figcaption { font-size: 8.5pt; } .good, .bad { font-size: 11.5pt; } }
)";

/// `<name class="…">text</name>`
std::string element(const std::string& name, const std::string& text, const std::string& kind = {}) {
  return "<" + name + (kind.empty() ? "" : " class=\"" + kind + "\"") + ">" + xml_text(text) + "</" + name + ">";
}

std::string kind_of(const Paragraph& paragraph) {
  switch (paragraph.kind) {
    case Paragraph::Kind::note:
      return "note";
    case Paragraph::Kind::good:
      return "good";
    case Paragraph::Kind::bad:
      return "bad";
    case Paragraph::Kind::plain:
      break;
  }
  return "";
}

std::string caption_of(const std::string& caption) {
  return caption.empty() ? "" : element("figcaption", caption) + "\n";
}

std::string html(const Paragraph& paragraph) { return element("p", paragraph.text, kind_of(paragraph)) + "\n"; }

std::string html(const Facts& facts) {
  std::string text = "<table class=\"facts\"><tbody>\n";
  for (const auto& [name, value] : facts.rows) text += "<tr>" + element("td", name) + element("td", value) + "</tr>\n";
  return text + "</tbody></table>\n";
}

std::string html(const Table& table) {
  const auto row = [&](const std::vector<std::string>& cells, const char* name) {
    std::string text = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
      text += element(name, cells[i], table.alignment[i] == 'r' ? "r" : "");
    return text + "</tr>\n";
  };
  std::string text = table.title.empty() ? "" : element("h3", table.title) + "\n";
  text += "<table><thead>" + row(table.heads, "th") + "</thead><tbody>\n";
  for (const auto& cells : table.rows) text += row(cells, "td");
  return text + "</tbody></table>\n";
}

std::string html(const Picture& picture) {
  return "<figure><img alt=\"" + xml_text(picture.caption) + "\" src=\"data:image/png;base64," +
         base64(png_of(picture.image)) + "\"/>\n" + caption_of(picture.caption) + "</figure>\n";
}

std::string html(const Chart& chart) {
  SvgPainter painter(chart.width, chart.height, paper);
  chart.painting(painter, chart.width, chart.height);
  return "<figure>" + painter.element() + caption_of(chart.caption) + "</figure>\n";
}

}  // namespace

std::string html_of(const Document& document) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
      "<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n" +
      element("title", document.title) + "\n<style>" + style + "</style>\n</head>\n<body>\n" +
      element("h1", document.title) + "\n";
  for (const std::string& line : document.below_title) text += element("p", line, "byline") + "\n";
  for (const Section& section : document.sections) {
    text += "<section>\n" + element("h2", section.title) + "\n";
    for (const Part& part : section.parts) text += std::visit([](const auto& one) { return html(one); }, part);
    text += "</section>\n";
  }
  return text + "</body>\n</html>\n";
}

}  // namespace talus::report
