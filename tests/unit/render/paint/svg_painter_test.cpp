#include "render/paint/svg_painter.hpp"

#include <gmock/gmock.h>

#include "render/paint/pdf_pages.hpp"
#include "support/xml_elements.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

TEST(SvgPainter, WritesWhatIsPaintedWithItsOriginAtTheUpperLeft) {
  SvgPainter painter(200, 100, rgb(0xffffff));
  const PixelPoint curve[] = {{10, 20}, {30.5, 40.126}, {50, 20}};
  painter.line(curve, 1.5, rgb(0x0000ff));
  painter.fill(PixelRect{0, 0, 20, 10}, rgb(0x00ff00), 0.5);
  painter.disc({100, 90}, 3, rgb(0xff0000));
  painter.text({10, 30}, "φ < 30° & \"dry\"", {.height = 12, .colour = rgb(0x123456), .x = AlignX::right});
  const std::string svg = svg_document(200, 100, painter.element());
  EXPECT_THAT(test::xml_elements(svg),
              testing::ElementsAre("svg", "svg", "rect", "polyline", "rect", "circle", "text"));
  EXPECT_THAT(svg, HasSubstr("points=\"10,80 30.5,59.87 50,80\""));
  EXPECT_THAT(svg, HasSubstr("<rect x=\"0\" y=\"90\" width=\"20\" height=\"10\" fill=\"#00ff00\" opacity=\"0.5\"/>"));
  EXPECT_THAT(svg, HasSubstr("cx=\"100\" cy=\"10\" r=\"3\""));
  EXPECT_THAT(svg, HasSubstr(">φ &lt; 30° &amp; &quot;dry&quot;</text>"));
  EXPECT_THAT(svg, HasSubstr("text-anchor=\"end\""));
}

TEST(SvgPainter, TurnsTextThatIsReadUpwards) {
  SvgPainter painter(200, 100, rgb(0xffffff));
  painter.text({10, 30}, "Energy", {.height = 10, .colour = {}, .x = AlignX::centre, .upwards = true});
  EXPECT_THAT(painter.element(), HasSubstr("transform=\"rotate(-90 10 70)\""));
}

TEST(PdfPages, HasAPageForEachPaintingWithItsTextInIt) {
  const Painting words = [](Painter& painter, double, double height) {
    painter.text({10, height / 2}, "settled", {.height = 12, .colour = {}});
  };
  const std::string pdf = pdf_of(400, 200, "Histories", std::vector{words, words, words});
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_THAT(pdf, HasSubstr("%%EOF"));
  EXPECT_THAT(pdf, HasSubstr("/Count 3"));
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [ 0 0 300 150 ]"));
  EXPECT_THAT(pdf, HasSubstr("/ToUnicode")) << "letters are text";
}

}  // namespace
}  // namespace talus
