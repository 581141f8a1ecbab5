#include "report/document.hpp"

#include <gmock/gmock.h>

#include "report/html.hpp"
#include "report/pdf.hpp"
#include "support/xml_elements.hpp"

namespace talus::report {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// One of each part, and a table that is longer than a page.
Document example_document() {
  Table table{"Blocks", {"Block", "Volume (m³)"}, "lr", {}};
  for (int i = 0; i < 120; ++i) table.rows.push_back({"B" + std::to_string(i), std::to_string(i) + ".5"});
  const Painting line = [](Painter& painter, double width, double height) {
    painter.line({0, 0}, {width, height}, 2, rgb(0x336699));
    painter.text({10, 10}, "Energy (J)", {.height = 12, .colour = {}});
  };
  return {"Slope <A> & B",
          {"Solved by a test"},
          {{"What came out", {Paragraph{"All is well.", Paragraph::Kind::good}, Facts{{{"Blocks", "120"}}}}},
           {"Pictures", {Picture{Image(20, 10), "The \"last\" frame"}, Chart{line, 700, 300, "A chart"}}},
           {"The model", {table, Paragraph{"It did not converge.", Paragraph::Kind::bad}}}}};
}

TEST(HtmlReport, IsOneWellFormedPageThatNeedsNoOtherFile) {
  const std::string html = html_of(example_document());
  const std::vector<std::string> elements = test::xml_elements(html);
  EXPECT_EQ(elements.front(), "html");
  EXPECT_EQ(std::ranges::count(elements, "tr"), 1 + 1 + 120);
  for (const char* element : {"h1", "h2", "h3", "img", "svg", "figcaption"}) EXPECT_THAT(elements, Contains(element));
  EXPECT_THAT(html, HasSubstr("<title>Slope &lt;A&gt; &amp; B</title>"));
  EXPECT_THAT(html, HasSubstr("src=\"data:image/png;base64,iVBORw0KGgo"));
  for (const char* link : {"href=", "src=\"http", "url(", "@import"}) EXPECT_THAT(html, Not(HasSubstr(link)));
}

TEST(PdfReport, GoesOnFromPageToPage) {
  const std::string pdf = pdf_of(example_document());
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_THAT(pdf, HasSubstr("%%EOF"));
  EXPECT_THAT(pdf, HasSubstr("/Count 4")) << "120 rows take three pages and a bit";
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [ 0 0 595.28 841.89 ]")) << "A4";
  EXPECT_THAT(pdf, HasSubstr("/Image"));
  EXPECT_THAT(pdf, HasSubstr("/ToUnicode")) << "letters are text";
}

}  // namespace
}  // namespace talus::report
