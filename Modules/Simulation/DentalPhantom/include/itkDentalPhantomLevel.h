/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#ifndef itkDentalPhantomLevel_h
#define itkDentalPhantomLevel_h

#include "DentalPhantomExport.h"

#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace itk
{
/** \struct DentalPhantomLevel
 * \brief How bad a simulated case may be: every parameter of a cohort, by name, with the tables that have names.
 *
 * A level says how things are distributed; a seed then draws one case. Named() gives the tables: ideal, typical and
 * hard (method.md section 2), real and real-hard (arches as in real-arches.md), standard (typical arches under a
 * standard cephalometric tracing) and practice (real arches under one). Every parameter can be read from JSON:
 *
 * \code{.json}
 * { "level": "real", "traits": { "open_bite_probability": 1 }, "scan": { "frame": "shared" } }
 * \endcode
 *
 * Documentation/Phantom.md says where the numbers are from.
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantom_EXPORT DentalPhantomLevel
{
  /** The table of a name. Throws std::invalid_argument that lists the names. */
  static DentalPhantomLevel
  Named(const std::string & name);
  /** Of the tables, mildest first. */
  static const std::vector<std::string> &
  GetNames();

  using FieldType = std::variant<double       DentalPhantomLevel::*,
                                 bool         DentalPhantomLevel::*,
                                 unsigned int DentalPhantomLevel::*,
                                 std::string  DentalPhantomLevel::*>;
  /** A parameter and its words. */
  struct EntryType
  {
    const char * section; /**< The table of the level's file that it stands in. */
    const char * key;     /**< Its name there. */
    /** In a few words, with the unit. */
    const char * description;
    FieldType    field;
    double       low;
    double       high;
    /** What a word may be. */
    std::vector<std::string> words;
  };
  /** In the order of the struct. */
  static const std::vector<EntryType> &
  GetEntries();

  /** Parameters from a JSON file on top of these; where it names a level, on top of that table. Throws a
   * DentalInputError that names file, field and remedy for an unknown section or field, a wrong type or a value out of
   * range. */
  void
  ReadJson(const std::string & fileName);
  /** The same from a text; the file's name is for messages. */
  void
  ParseJson(const std::string & text, const std::string & fileName);
  /** Every parameter; ParseJson() reads it back to the same values. */
  std::string
  ToJson() const;

  /** Throws std::invalid_argument that names the parameter which is out of its range. */
  void
  Validate() const;

  /** The table it began with. */
  std::string name{ "typical" };

  /** \name head
   * How the head is held.
   * @{ */
  /** Yaw and roll of the head, 1 sd, degrees. */
  double turnDegrees{ 1.5 };
  /** Mean pitch of the occlusal plane, degrees. */
  double pitchDegrees{ 8.0 };
  /** Its standard deviation, degrees. */
  double pitchSigmaDegrees{ 5.0 };
  /** @} */

  /** \name machine
   * The radiographic machine.
   * @{ */
  /** Central ray through the teeth, true distances given, head not shifted. */
  bool knownMachine{ false };
  /** @} */

  /** \name arch
   * The irregularity of any dentition.
   * @{ */
  /** Rotations of the teeth, 1 sd, degrees. */
  double toothRotationDegrees{ 5.0 };
  /** Their mesial tip, 1 sd, degrees. */
  double toothTipDegrees{ 2.0 };
  /** Their torque, 1 sd, degrees. */
  double toothTorqueDegrees{ 3.0 };
  /** Off the arch line, 1 sd, mm. */
  double buccalOffset{ 0.3 };
  /** Off the occlusal surface, 1 sd, mm. */
  double occlusalOffset{ 0.15 };
  /** Of a spaced arch. */
  double spacedProbability{ 0.15 };
  /** Of a scan that shows the palate. */
  double palateProbability{ 0.5 };
  /** Of one tooth lost on the side that is not traced, its place left open. */
  double lostToothProbability{ 0.0 };
  /** @} */

  /** \name traits
   * Traits of real arches; a probability is that of a case, each drawn from a random stream of its own.
   * @{ */
  /** Of premolars extracted for orthodontic reasons, gaps closed. */
  double closedExtractionProbability{ 0.0 };
  /** Largest width that such a gap keeps, mm. */
  double closedExtractionResidual{ 0.4 };
  /** That these are in one quadrant only. */
  double oneSidedExtractionProbability{ 0.25 };
  /** Of a molar or premolar lost long ago, its gap partly closed by tipping and drift. */
  double openExtractionProbability{ 0.0 };
  /** Largest part of the gap that tipping and drift have closed. */
  double openExtractionClosure{ 0.6 };
  /** Of one or two retained milk molars beside premolars. */
  double milkMolarProbability{ 0.0 };
  /** Of third molars in one or both jaws. */
  double thirdMolarProbability{ 0.0 };
  /** That a jaw has one of the two only. */
  double oneSidedThirdMolarProbability{ 0.5 };
  /** Of an infraoccluded molar, a milk molar if there is one. */
  double infraocclusionProbability{ 0.0 };
  /** Largest step below its neighbours, mm; the smallest is 1.5. */
  double infraocclusionDepth{ 4.0 };
  /** Of flat, worn premolars and molars. */
  double wearProbability{ 0.0 };
  /** Most that is worn off, mm; the least is 0.5. */
  double wearDepth{ 1.6 };
  /** Of crowded incisors with a lateral one foremost. */
  double crowdingProbability{ 0.0 };
  /** Largest overlap of two neighbours, mm. */
  double crowdingOverlap{ 1.5 };
  /** Of an anterior open bite. */
  double openBiteProbability{ 0.0 };
  /** Its largest gap, mm; the smallest is 1. */
  double openBiteGap{ 4.0 };
  /** Of a deep bite. */
  double deepBiteProbability{ 0.0 };
  /** Its largest overbite, mm; the smallest is 4.5. */
  double deepBiteOverlap{ 7.0 };
  /** Of premolars and molars in crossbite, on one side in 70 %. */
  double posteriorCrossbiteProbability{ 0.0 };
  /** Of a reverse overjet. */
  double anteriorCrossbiteProbability{ 0.0 };
  /** @} */

  /** \name scan
   * The scanner and its software.
   * @{ */
  /** Of each scan as made. */
  unsigned int numberOfTriangles{ 60000 };
  /** Triangles of each scan after quadric decimation; 0: none. */
  unsigned int decimateTo{ 0 };
  /** Along the normals, 1 sd, mm. */
  double scannerNoise{ 0.01 };
  /** Of brackets and tubes on all teeth from molar to molar. */
  double bracketProbability{ 0.0 };
  /** A jaw, of one to three mucosal flaps. */
  double flapProbability{ 0.0 };
  /** A jaw, of one to three loose pieces of tongue or cheek. */
  double crumbProbability{ 0.0 };
  /** Mean number of loose specks in a jaw. */
  double meanSpecks{ 0.0 };
  /** Mean number of holes in a jaw. */
  double meanHoles{ 0.0 };
  /** Largest radius of a hole, mm. */
  double holeRadius{ 1.5 };
  /** Least factor on the height of gingiva that a jaw's scan shows, which is 4 to 9 mm, and 1 mm at least. */
  double gingivaLeast{ 1.0 };
  /** Greatest such factor; where it is the smaller one it is the only one. */
  double gingivaMost{ 1.0 };
  /** Frame of the files: shared (in occlusion), separate, centred (both occlusal sides alike), upright, or mixed:
   * drawn. */
  std::string frame{ "shared" };
  /** @} */

  /** \name tracing
   * What is drawn and how the hand errs.
   * @{ */
  /** What is drawn: crowns of right, left, mean (bisected) or both; standard: whole teeth U1, L1, U6, L6. */
  std::string tracedSide{ "right" };
  /** Drift of the hand along the line, 1 sd a coordinate, px. */
  double correlatedNoise{ 1.2 };
  /** Jitter of the hand, 1 sd a coordinate, px. */
  double whiteNoise{ 0.5 };
  /** A jaw, that a tooth of the traced side is not drawn. */
  double untracedProbability{ 0.0 };
  /** Each tooth's own shift along the occlusal plane, 1 sd, mm. */
  double toothAlong{ 0.0 };
  /** The same across it. */
  double toothAcross{ 0.0 };
  /** Each tooth's own turn, 1 sd, degrees. */
  double toothTurnDegrees{ 0.0 };
  /** Each tooth's own scale, 1 sd. */
  double toothScale{ 0.0 };
  /** The reader's bias, shared by all outlines and landmarks of a film, 1 sd an axis, mm. */
  double readerBias{ 0.0 };
  /** An outline or a landmark, of a gross error. */
  double grossProbability{ 0.0 };
  /** Largest gross error, mm; the smallest is 5 or this. */
  double grossDistance{ 8.0 };
  /** Further error of palatal and lingual sides, 1 sd, mm. */
  double palatalError{ 0.0 };
  /** Of a stock template instead of the tooth in a standard tracing. */
  double templateProbability{ 0.0 };
  /** Draw tracings at all. */
  bool drawOutlines{ true };
  /** Sigma_px of outlines and landmarks: none; informative: the spread that was drawn from; uninformative: numbers that
   * say nothing. */
  std::string confidence{ "none" };
  /** How much the error spread differs from one outline or landmark to another, sd of its logarithm. */
  double confidenceSpread{ 0.4 };
  /** @} */

  /** \name landmarks
   * Cephalometric landmarks to register with.
   * @{ */
  /** Landmarks of a reader or a detector to register with: tips and mesiobuccal cusps. */
  bool giveLandmarks{ false };
  /** Error of a landmark along the occlusal plane, 1 sd, mm. */
  double landmarkAlong{ 0.45 };
  /** The same across it. */
  double landmarkAcross{ 0.6 };
  /** The incisors' apices, too (U1A, L1A). */
  bool giveApices{ false };
  /** Cusp: mesiobuccal (U6_MB); contact: the mesial contact point (Ms, Mi). */
  std::string molarLandmark{ "cusp" };
  /** Part of the variance that a landmark shares with its tooth's outline. */
  double sharedToothError{ 0.0 };
  /** Of the file: plain {name: [u, v]}, sigma {name: {position, sigma_px}}, detector {landmarks: [{name, x, y, peak,
   * confidence}]}. */
  std::string landmarkForm{ "plain" };
  /** @} */

  /** \name frontal
   * A second radiograph.
   * @{ */
  /** A postero-anterior radiograph with tracing and landmarks. */
  bool frontalView{ false };
  /** Taken at once; else the patient turned in the ear rods. */
  bool sameHeadPosition{ true };
  /** Of the head between the two, where not the same. */
  double frontalPitchDegrees{ 3.0 };
  /** Roll and yaw of it. */
  double frontalTurnDegrees{ 1.5 };
  /** Shifts of it. */
  double frontalShift{ 1.5 };
  /** Error of a frontal landmark an axis, 1 sd, mm. */
  double frontalNoise{ 0.5 };
  /** @} */

  /** \name radiograph
   * The picture.
   * @{ */
  /** Plain: shapes that claim nothing; realistic: roots, bone and soft tissue. */
  std::string radiographStyle{ "plain" };
  /** Grain of a realistic radiograph, 1 sd, grey values. */
  double radiographNoise{ 2.5 };
  /** Its blur, 1 sd, px. */
  double radiographBlur{ 0.7 };
  /** @} */
};

DentalPhantom_EXPORT bool
operator==(const DentalPhantomLevel & a, const DentalPhantomLevel & b);

inline bool
operator!=(const DentalPhantomLevel & a, const DentalPhantomLevel & b)
{
  return !(a == b);
}
} // namespace itk

#endif
