#pragma once

#include <QObject>
#include <QString>
#include <array>

namespace talus {

class BlockSurvey;
class CurrentProject;
class Display;
struct BlockColours;

/// What the blocks are coloured by while no field of a run is shown.
enum class ColourBy { block, solid, body, material, removability };

inline constexpr std::array all_colourings{ColourBy::block, ColourBy::solid, ColourBy::body, ColourBy::material,
                                           ColourBy::removability};
QString titleOf(ColourBy by);

/// Colours the blocks of the view by what they are made of, or by how they leave their place.
class BlockColouring : public QObject {
  Q_OBJECT
 public:
  BlockColouring(CurrentProject& project, BlockSurvey& survey, Display& display);

  ColourBy by() const { return by_; }
  void colourBy(ColourBy by);

 signals:
  void changed();

 private:
  void refresh();

  CurrentProject& project_;
  BlockSurvey& survey_;
  Display& display_;
  ColourBy by_ = ColourBy::block;
};

}  // namespace talus
