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
#include "itkDentalPhantomLevel.h"
#include "itkDentalPhantomLevelNames.h"

#include "itkJsonDocument.h"
#include "itkJsonNumber.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace
{
/** Probabilities of level real. Orthodontic patients, not a population: traits are as frequent as keeps each of them
 * measurable in a cohort of some thirty (Documentation/Phantom.md). */
void
SetRealArches(DentalPhantomLevel & level)
{
  level.closedExtractionProbability = 0.2;
  level.openExtractionProbability = 0.15;
  level.milkMolarProbability = 0.15;
  level.thirdMolarProbability = 0.3;
  level.infraocclusionProbability = 0.08;
  level.wearProbability = 0.15;
  level.crowdingProbability = 0.3;
  level.openBiteProbability = 0.08;
  level.deepBiteProbability = 0.15;
  level.posteriorCrossbiteProbability = 0.15;
  level.anteriorCrossbiteProbability = 0.05;
  level.toothRotationDegrees = 6.0;
  level.decimateTo = 16000;
  level.scannerNoise = 0.02;
  level.bracketProbability = 0.1;
  level.flapProbability = 0.25;
  level.crumbProbability = 0.2;
  level.meanSpecks = 2.0;
  level.meanHoles = 2.0;
  level.frame = "mixed";
  level.radiographStyle = "realistic";
}

/** Drawings of practice.md, section 1. */
void
SetStandardTracing(DentalPhantomLevel & level)
{
  level.tracedSide = "standard";
  level.correlatedNoise = 0.6;
  level.whiteNoise = 0.3;
  level.toothAlong = 0.45;
  level.toothAcross = 0.6;
  level.toothTurnDegrees = 2.0;
  level.toothScale = 0.03;
  level.readerBias = 0.15;
  level.grossProbability = 0.01;
  level.palatalError = 0.4;
  level.giveLandmarks = true;
  level.radiographStyle = "realistic";
}

std::string
Join(const std::vector<std::string> & words)
{
  std::string text;
  for (const std::string & word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::string
NumberText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}
} // namespace

const std::vector<std::string> &
DentalPhantomLevel::GetNames()
{
  static const std::vector<std::string> names = GetDentalPhantomLevelNames();
  return names;
}

DentalPhantomLevel
DentalPhantomLevel::Named(const std::string & name)
{
  DentalPhantomLevel level;
  level.name = name;
  if (name == "ideal")
  {
    level.turnDegrees = 0.0;
    level.knownMachine = true;
    level.correlatedNoise = 0.0;
    level.whiteNoise = 0.0;
  }
  else if (name == "hard" || name == "real-hard")
  {
    level.turnDegrees = 3.0;
    level.toothRotationDegrees = 9.0;
    level.correlatedNoise = 2.2;
    level.whiteNoise = 1.0;
    level.lostToothProbability = name == "hard" ? 0.5 : 0.0;
    level.untracedProbability = 0.5;
    if (name == "real-hard")
    {
      SetRealArches(level);
      level.toothRotationDegrees = 9.0;
    }
  }
  else if (name == "real")
  {
    SetRealArches(level);
  }
  else if (name == "standard")
  {
    SetStandardTracing(level);
  }
  else if (name == "practice")
  {
    SetRealArches(level);
    SetStandardTracing(level);
    level.templateProbability = 0.3;
  }
  else if (name != "typical")
  {
    throw std::invalid_argument("\"" + name + "\" is no level of the phantom (" + Join(GetNames()) + ")");
  }
  return level;
}

auto
DentalPhantomLevel::GetEntries() -> const std::vector<EntryType> &
{
  using L = DentalPhantomLevel;
  static const std::vector<EntryType> entries = {
    { "head", "turn_deg", "yaw and roll of the head, 1 sd, degrees", &L::turnDegrees, 0.0, 20.0, {} },
    { "head", "pitch_deg", "mean pitch of the occlusal plane, degrees", &L::pitchDegrees, -30.0, 40.0, {} },
    { "head", "pitch_sd_deg", "its standard deviation, degrees", &L::pitchSigmaDegrees, 0.0, 20.0, {} },
    { "machine",
      "known",
      "central ray through the teeth, true distances given, head not shifted",
      &L::knownMachine,
      0.0,
      0.0,
      {} },
    { "arch", "tooth_rotation_deg", "rotations of the teeth, 1 sd, degrees", &L::toothRotationDegrees, 0.0, 25.0, {} },
    { "arch", "tooth_tip_deg", "their mesial tip, 1 sd, degrees", &L::toothTipDegrees, 0.0, 15.0, {} },
    { "arch", "tooth_torque_deg", "their torque, 1 sd, degrees", &L::toothTorqueDegrees, 0.0, 15.0, {} },
    { "arch", "buccal_offset_mm", "off the arch line, 1 sd, mm", &L::buccalOffset, 0.0, 2.0, {} },
    { "arch", "occlusal_offset_mm", "off the occlusal surface, 1 sd, mm", &L::occlusalOffset, 0.0, 1.0, {} },
    { "arch", "spaced_probability", "of a spaced arch", &L::spacedProbability, 0.0, 1.0, {} },
    { "arch", "palate_probability", "of a scan that shows the palate", &L::palateProbability, 0.0, 1.0, {} },
    { "arch",
      "lost_tooth_probability",
      "of one tooth lost on the side that is not traced, its place left open",
      &L::lostToothProbability,
      0.0,
      1.0,
      {} },
    { "traits",
      "extraction_closed_probability",
      "of premolars extracted for orthodontic reasons, gaps closed",
      &L::closedExtractionProbability,
      0.0,
      1.0,
      {} },
    { "traits",
      "extraction_closed_residual_mm",
      "largest width that such a gap keeps, mm",
      &L::closedExtractionResidual,
      0.0,
      3.0,
      {} },
    { "traits",
      "extraction_one_sided_probability",
      "that these are in one quadrant only",
      &L::oneSidedExtractionProbability,
      0.0,
      1.0,
      {} },
    { "traits",
      "extraction_open_probability",
      "of a molar or premolar lost long ago, its gap partly closed by tipping and drift",
      &L::openExtractionProbability,
      0.0,
      1.0,
      {} },
    { "traits",
      "extraction_open_closure",
      "largest part of the gap that tipping and drift have closed",
      &L::openExtractionClosure,
      0.0,
      0.95,
      {} },
    { "traits",
      "milk_molar_probability",
      "of one or two retained milk molars beside premolars",
      &L::milkMolarProbability,
      0.0,
      1.0,
      {} },
    { "traits",
      "third_molar_probability",
      "of third molars in one or both jaws",
      &L::thirdMolarProbability,
      0.0,
      1.0,
      {} },
    { "traits",
      "third_molar_one_sided_probability",
      "that a jaw has one of the two only",
      &L::oneSidedThirdMolarProbability,
      0.0,
      1.0,
      {} },
    { "traits",
      "infraocclusion_probability",
      "of an infraoccluded molar, a milk molar if there is one",
      &L::infraocclusionProbability,
      0.0,
      1.0,
      {} },
    { "traits",
      "infraocclusion_mm",
      "largest step below its neighbours, mm; the smallest is 1.5",
      &L::infraocclusionDepth,
      1.0,
      6.0,
      {} },
    { "traits", "wear_probability", "of flat, worn premolars and molars", &L::wearProbability, 0.0, 1.0, {} },
    { "traits", "wear_mm", "most that is worn off, mm; the least is 0.5", &L::wearDepth, 0.5, 2.4, {} },
    { "traits",
      "crowding_probability",
      "of crowded incisors with a lateral one foremost",
      &L::crowdingProbability,
      0.0,
      1.0,
      {} },
    { "traits", "crowding_mm", "largest overlap of two neighbours, mm", &L::crowdingOverlap, 0.2, 2.0, {} },
    { "traits", "open_bite_probability", "of an anterior open bite", &L::openBiteProbability, 0.0, 1.0, {} },
    { "traits", "open_bite_mm", "its largest gap, mm; the smallest is 1", &L::openBiteGap, 1.0, 8.0, {} },
    { "traits", "deep_bite_probability", "of a deep bite", &L::deepBiteProbability, 0.0, 1.0, {} },
    { "traits", "deep_bite_mm", "its largest overbite, mm; the smallest is 4.5", &L::deepBiteOverlap, 4.0, 8.0, {} },
    { "traits",
      "crossbite_posterior_probability",
      "of premolars and molars in crossbite, on one side in 70 %",
      &L::posteriorCrossbiteProbability,
      0.0,
      1.0,
      {} },
    { "traits",
      "crossbite_anterior_probability",
      "of a reverse overjet",
      &L::anteriorCrossbiteProbability,
      0.0,
      1.0,
      {} },
    { "scan", "triangles", "of each scan as made", &L::numberOfTriangles, 2000.0, 4000000.0, {} },
    { "scan",
      "decimate_to",
      "triangles of each scan after quadric decimation; 0: none",
      &L::decimateTo,
      0.0,
      4000000.0,
      {} },
    { "scan", "noise_mm", "along the normals, 1 sd, mm", &L::scannerNoise, 0.0, 0.5, {} },
    { "scan",
      "bracket_probability",
      "of brackets and tubes on all teeth from molar to molar",
      &L::bracketProbability,
      0.0,
      1.0,
      {} },
    { "scan", "flap_probability", "a jaw, of one to three mucosal flaps", &L::flapProbability, 0.0, 1.0, {} },
    { "scan",
      "crumb_probability",
      "a jaw, of one to three loose pieces of tongue or cheek",
      &L::crumbProbability,
      0.0,
      1.0,
      {} },
    { "scan", "mean_specks", "mean number of loose specks in a jaw", &L::meanSpecks, 0.0, 100.0, {} },
    { "scan", "mean_holes", "mean number of holes in a jaw", &L::meanHoles, 0.0, 100.0, {} },
    { "scan", "hole_radius_mm", "largest radius of a hole, mm", &L::holeRadius, 0.1, 10.0, {} },
    { "scan",
      "gingiva_least",
      "least factor on the height of gingiva that a jaw's scan shows, which is 4 to 9 mm, and 1 mm at least",
      &L::gingivaLeast,
      0.0,
      1.5,
      {} },
    { "scan",
      "gingiva_most",
      "greatest such factor; where it is the smaller one it is the only one",
      &L::gingivaMost,
      0.0,
      1.5,
      {} },
    { "scan",
      "frame",
      "frame of the files: shared (in occlusion), separate, centred (both occlusal sides alike), upright, or mixed: "
      "drawn",
      &L::frame,
      0.0,
      0.0,
      { "anatomical", "shared", "separate", "centred", "upright", "mixed" } },
    { "tracing",
      "side",
      "what is drawn: crowns of right, left, mean (bisected) or both; standard: whole teeth U1, L1, U6, L6",
      &L::tracedSide,
      0.0,
      0.0,
      { "right", "left", "mean", "both", "standard" } },
    { "tracing",
      "drift_px",
      "drift of the hand along the line, 1 sd a coordinate, px",
      &L::correlatedNoise,
      0.0,
      20.0,
      {} },
    { "tracing", "jitter_px", "jitter of the hand, 1 sd a coordinate, px", &L::whiteNoise, 0.0, 20.0, {} },
    { "tracing",
      "untraced_probability",
      "a jaw, that a tooth of the traced side is not drawn",
      &L::untracedProbability,
      0.0,
      1.0,
      {} },
    { "tracing",
      "tooth_along_mm",
      "each tooth's own shift along the occlusal plane, 1 sd, mm",
      &L::toothAlong,
      0.0,
      5.0,
      {} },
    { "tracing", "tooth_across_mm", "the same across it", &L::toothAcross, 0.0, 5.0, {} },
    { "tracing", "tooth_turn_deg", "each tooth's own turn, 1 sd, degrees", &L::toothTurnDegrees, 0.0, 20.0, {} },
    { "tracing", "tooth_scale", "each tooth's own scale, 1 sd", &L::toothScale, 0.0, 0.3, {} },
    { "tracing",
      "reader_bias_mm",
      "the reader's bias, shared by all outlines and landmarks of a film, 1 sd an axis, mm",
      &L::readerBias,
      0.0,
      3.0,
      {} },
    { "tracing",
      "gross_probability",
      "an outline or a landmark, of a gross error",
      &L::grossProbability,
      0.0,
      1.0,
      {} },
    { "tracing", "gross_mm", "largest gross error, mm; the smallest is 5 or this", &L::grossDistance, 2.0, 60.0, {} },
    { "tracing", "palatal_mm", "further error of palatal and lingual sides, 1 sd, mm", &L::palatalError, 0.0, 3.0, {} },
    { "tracing",
      "template_probability",
      "of a stock template instead of the tooth in a standard tracing",
      &L::templateProbability,
      0.0,
      1.0,
      {} },
    { "tracing", "outlines", "draw tracings at all", &L::drawOutlines, 0.0, 0.0, {} },
    { "tracing",
      "confidence",
      "sigma_px of outlines and landmarks: none; informative: the spread that was drawn from; uninformative: numbers "
      "that say nothing",
      &L::confidence,
      0.0,
      0.0,
      { "none", "informative", "uninformative" } },
    { "tracing",
      "confidence_spread",
      "how much the error spread differs from one outline or landmark to another, sd of its logarithm",
      &L::confidenceSpread,
      0.0,
      1.5,
      {} },
    { "landmarks",
      "given",
      "landmarks of a reader or a detector to register with: tips and mesiobuccal cusps",
      &L::giveLandmarks,
      0.0,
      0.0,
      {} },
    { "landmarks",
      "along_mm",
      "error of a landmark along the occlusal plane, 1 sd, mm",
      &L::landmarkAlong,
      0.0,
      10.0,
      {} },
    { "landmarks", "across_mm", "the same across it", &L::landmarkAcross, 0.0, 10.0, {} },
    { "landmarks", "apices", "the incisors' apices, too (U1A, L1A)", &L::giveApices, 0.0, 0.0, {} },
    { "landmarks",
      "molar",
      "cusp: mesiobuccal (U6_MB); contact: the mesial contact point (Ms, Mi)",
      &L::molarLandmark,
      0.0,
      0.0,
      { "cusp", "contact" } },
    { "landmarks",
      "shared_tooth_error",
      "part of the variance that a landmark shares with its tooth's outline",
      &L::sharedToothError,
      0.0,
      1.0,
      {} },
    { "landmarks",
      "form",
      "of the file: plain {name: [u, v]}, sigma {name: {position, sigma_px}}, detector {landmarks: [{name, x, y, peak, "
      "confidence}]}",
      &L::landmarkForm,
      0.0,
      0.0,
      { "plain", "sigma", "detector" } },
    { "frontal", "given", "a postero-anterior radiograph with tracing and landmarks", &L::frontalView, 0.0, 0.0, {} },
    { "frontal",
      "same_head_position",
      "taken at once; else the patient turned in the ear rods",
      &L::sameHeadPosition,
      0.0,
      0.0,
      {} },
    { "frontal",
      "pitch_sd_deg",
      "of the head between the two, where not the same",
      &L::frontalPitchDegrees,
      0.0,
      20.0,
      {} },
    { "frontal", "turn_sd_deg", "roll and yaw of it", &L::frontalTurnDegrees, 0.0, 20.0, {} },
    { "frontal", "shift_sd_mm", "shifts of it", &L::frontalShift, 0.0, 20.0, {} },
    { "frontal", "landmark_mm", "error of a frontal landmark an axis, 1 sd, mm", &L::frontalNoise, 0.0, 10.0, {} },
    { "radiograph",
      "style",
      "plain: shapes that claim nothing; realistic: roots, bone and soft tissue",
      &L::radiographStyle,
      0.0,
      0.0,
      { "plain", "realistic" } },
    { "radiograph", "noise", "grain of a realistic radiograph, 1 sd, grey values", &L::radiographNoise, 0.0, 30.0, {} },
    { "radiograph", "blur_px", "its blur, 1 sd, px", &L::radiographBlur, 0.0, 5.0, {} },
  };
  return entries;
}

namespace
{
void
ReadValue(const JsonNode & node, const DentalPhantomLevel::EntryType & entry, DentalPhantomLevel & level)
{
  if (const auto number = std::get_if<double DentalPhantomLevel::*>(&entry.field))
  {
    const double value = node.AsNumber();
    if (!(value >= entry.low && value <= entry.high))
    {
      node.Fail(NumberText(value) + " is out of range",
                "write a number from " + NumberText(entry.low) + " to " + NumberText(entry.high) + ": " +
                  entry.description);
    }
    level.** number = value;
  }
  else if (const auto flag = std::get_if<bool DentalPhantomLevel::*>(&entry.field))
  {
    level.** flag = node.AsBoolean();
  }
  else if (const auto count = std::get_if<unsigned int DentalPhantomLevel::*>(&entry.field))
  {
    level.** count =
      static_cast<unsigned int>(node.AsInteger(static_cast<int64_t>(entry.low), static_cast<int64_t>(entry.high)));
  }
  else
  {
    const std::string & word = node.AsString();
    if (std::find(entry.words.begin(), entry.words.end(), word) == entry.words.end())
    {
      node.Fail("\"" + word + "\" is no value of it", "write one of " + Join(entry.words));
    }
    level.*std::get<std::string DentalPhantomLevel::*>(entry.field) = word;
  }
}

void
ReadLevel(const JsonDocument & document, DentalPhantomLevel & level)
{
  const JsonNode root = document.GetRoot();
  if (!root.IsObject())
  {
    root.Fail("is no JSON object", "write { \"level\": \"real\", \"traits\": { ... } }");
  }
  if (const auto name = root.Find("level"))
  {
    try
    {
      level = DentalPhantomLevel::Named(name->AsString());
    }
    catch (const std::invalid_argument & error)
    {
      name->Fail(error.what(), "name one of them");
    }
  }
  std::vector<std::string> sections;
  for (const auto & entry : DentalPhantomLevel::GetEntries())
  {
    if (sections.empty() || sections.back() != entry.section)
    {
      sections.push_back(entry.section);
    }
  }
  for (const auto & section : root.GetMembers())
  {
    if (section.first == "level")
    {
      continue;
    }
    if (std::find(sections.begin(), sections.end(), section.first) == sections.end())
    {
      section.second.Fail("is no section of the phantom's parameters", "the sections are " + Join(sections));
    }
    for (const auto & member : section.second.GetMembers())
    {
      std::vector<std::string>              keys;
      const DentalPhantomLevel::EntryType * found = nullptr;
      for (const auto & entry : DentalPhantomLevel::GetEntries())
      {
        if (section.first == entry.section)
        {
          keys.push_back(entry.key);
          found = member.first == entry.key ? &entry : found;
        }
      }
      if (found == nullptr)
      {
        member.second.Fail("is no parameter of the phantom", "section " + section.first + " has " + Join(keys));
      }
      ReadValue(member.second, *found, level);
    }
  }
}
} // namespace

void
DentalPhantomLevel::ReadJson(const std::string & fileName)
{
  ReadLevel(JsonDocument::ReadFile(fileName), *this);
}

void
DentalPhantomLevel::ParseJson(const std::string & text, const std::string & fileName)
{
  ReadLevel(JsonDocument::Parse(text, fileName), *this);
}

std::string
DentalPhantomLevel::ToJson() const
{
  std::string text = "{\n \"level\": " + JsonString(name);
  std::string section;
  for (const EntryType & entry : GetEntries())
  {
    if (section != entry.section)
    {
      text += std::string(section.empty() ? "" : "\n }") + ",\n " + JsonString(entry.section) + ": {\n";
      section = entry.section;
    }
    else
    {
      text += ",\n";
    }
    text += "  " + JsonString(entry.key) + ": ";
    if (const auto number = std::get_if<double DentalPhantomLevel::*>(&entry.field))
    {
      text += JsonNumber(this->**number);
    }
    else if (const auto flag = std::get_if<bool DentalPhantomLevel::*>(&entry.field))
    {
      text += this->**flag ? "true" : "false";
    }
    else if (const auto count = std::get_if<unsigned int DentalPhantomLevel::*>(&entry.field))
    {
      text += std::to_string(this->**count);
    }
    else
    {
      text += JsonString(this->*std::get<std::string DentalPhantomLevel::*>(entry.field));
    }
  }
  return text + "\n }\n}\n";
}

void
DentalPhantomLevel::Validate() const
{
  Named(name);
  for (const EntryType & entry : GetEntries())
  {
    const std::string field = std::string(entry.section) + "." + entry.key;
    double            value = entry.low;
    if (const auto number = std::get_if<double DentalPhantomLevel::*>(&entry.field))
    {
      value = this->**number;
    }
    else if (const auto count = std::get_if<unsigned int DentalPhantomLevel::*>(&entry.field))
    {
      value = this->**count;
    }
    else if (const auto word = std::get_if<std::string DentalPhantomLevel::*>(&entry.field))
    {
      if (std::find(entry.words.begin(), entry.words.end(), this->**word) == entry.words.end())
      {
        throw std::invalid_argument("Phantom parameter " + field + " is \"" + this->**word + "\", must be one of " +
                                    Join(entry.words) + ".");
      }
    }
    if (!(value >= entry.low && value <= entry.high))
    {
      throw std::invalid_argument("Phantom parameter " + field + " is " + NumberText(value) + ", must be in [" +
                                  NumberText(entry.low) + ", " + NumberText(entry.high) + "].");
    }
  }
}

bool
operator==(const DentalPhantomLevel & a, const DentalPhantomLevel & b)
{
  return a.name == b.name && a.ToJson() == b.ToJson();
}
} // namespace itk
