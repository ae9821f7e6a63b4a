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
#include "itkCephalometricLandmarkSet.h"

#include "itkASCIICharacter.h"
#include "itkLowerCase.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace itk
{
namespace
{
using FeatureEnum = CephalometricLandmarkSet::FeatureEnum;
using MeaningType = CephalometricLandmarkSet::MeaningType;
using JawEnum = ToothCode::JawEnum;

/** Lower case, without blanks, hyphens for underscores. */
std::string
Normalize(const std::string & name)
{
  std::string text;
  for (const char letter : LowerCase(name))
  {
    if (!IsASCIIBlank(letter))
    {
      text += letter == '-' ? '_' : letter;
    }
  }
  return text;
}

/** "incisaledge" of "incisal_edge": whoever writes a name in words parts them with a blank, an underscore or not at
 * all.
 */
std::string
JoinWords(std::string text)
{
  text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
  return text;
}

struct Alias
{
  const char * name;
  JawEnum      jaw;
  unsigned int position;
  FeatureEnum  feature;
};

/** Names that are no tooth with a feature: of analyses (Steiner, Jarabak, Ricketts), data sets (Aariz and CEPHA29, ISBI
 * 2015, Hamedan) and detectors. */
constexpr Alias Aliases[] = {
  { "uit", JawEnum::Upper, 1, FeatureEnum::Tip },
  { "uie", JawEnum::Upper, 1, FeatureEnum::Tip },
  { "is", JawEnum::Upper, 1, FeatureEnum::Tip },
  { "i", JawEnum::Upper, 1, FeatureEnum::Tip },
  { "l12", JawEnum::Upper, 1, FeatureEnum::Tip },
  { "upperincisortip", JawEnum::Upper, 1, FeatureEnum::Tip },
  { "upper_incisor_tip", JawEnum::Upper, 1, FeatureEnum::Tip },
  { "lit", JawEnum::Lower, 1, FeatureEnum::Tip },
  { "lie", JawEnum::Lower, 1, FeatureEnum::Tip },
  { "ii", JawEnum::Lower, 1, FeatureEnum::Tip },
  { "l11", JawEnum::Lower, 1, FeatureEnum::Tip },
  { "lowerincisortip", JawEnum::Lower, 1, FeatureEnum::Tip },
  { "lower_incisor_tip", JawEnum::Lower, 1, FeatureEnum::Tip },
  { "uia", JawEnum::Upper, 1, FeatureEnum::Apex },
  { "upperincisorapex", JawEnum::Upper, 1, FeatureEnum::Apex },
  { "upper_incisor_apex", JawEnum::Upper, 1, FeatureEnum::Apex },
  { "lia", JawEnum::Lower, 1, FeatureEnum::Apex },
  { "lowerincisorapex", JawEnum::Lower, 1, FeatureEnum::Apex },
  { "lower_incisor_apex", JawEnum::Lower, 1, FeatureEnum::Apex },
  { "umt", JawEnum::Upper, 6, FeatureEnum::MesiobuccalCusp },
  { "lmt", JawEnum::Lower, 6, FeatureEnum::MesiobuccalCusp },
  { "uppermolarcusptip", JawEnum::Upper, 6, FeatureEnum::MesiobuccalCusp },
  { "lowermolarcusptip", JawEnum::Lower, 6, FeatureEnum::MesiobuccalCusp },
  { "ms", JawEnum::Upper, 6, FeatureEnum::MesialContact },
  { "mi", JawEnum::Lower, 6, FeatureEnum::MesialContact },
  { "upm", JawEnum::Upper, 5, FeatureEnum::Cusp },
  { "lpm", JawEnum::Lower, 5, FeatureEnum::Cusp },
};

struct Suffix
{
  const char * text;
  FeatureEnum  feature;
};

/** Behind a tooth, with or without "_". The first of a feature is the one that MakeName() writes. */
constexpr Suffix Suffixes[] = {
  { "tip", FeatureEnum::Tip },
  { "t", FeatureEnum::Tip },
  { "incisal_tip", FeatureEnum::Tip },
  { "incisal_edge", FeatureEnum::Tip },
  { "cusp", FeatureEnum::Cusp },
  { "b", FeatureEnum::Cusp },
  { "MB", FeatureEnum::MesiobuccalCusp },
  { "DB", FeatureEnum::DistobuccalCusp },
  { "ML", FeatureEnum::MesiolingualCusp },
  { "DL", FeatureEnum::DistolingualCusp },
  { "mesial", FeatureEnum::MesialContact },
  { "mesial_contact", FeatureEnum::MesialContact },
  { "contact", FeatureEnum::MesialContact },
  { "occlusal", FeatureEnum::OcclusalMiddle },
  { "occl", FeatureEnum::OcclusalMiddle },
  { "apex", FeatureEnum::Apex },
  { "a", FeatureEnum::Apex },
  { "root", FeatureEnum::Apex },
};

/** The feature of a suffix that a tooth of that position may have. */
bool
FindFeature(const std::string & suffix, unsigned int position, FeatureEnum & feature)
{
  if (suffix.empty())
  {
    // An incisor's point is its tip; a molar's may be one of several.
    feature = position <= 2 ? FeatureEnum::Tip : position <= 5 ? FeatureEnum::Cusp : FeatureEnum::Unspecified;
    return true;
  }
  for (const Suffix & known : Suffixes)
  {
    if (JoinWords(suffix) != JoinWords(Normalize(known.text)))
    {
      continue;
    }
    feature = known.feature;
    switch (feature)
    {
      case FeatureEnum::Tip:
        // A canine's tip is its cusp.
        feature = position == 3 ? FeatureEnum::Cusp : feature;
        return position <= 3;
      case FeatureEnum::Cusp:
        return position >= 3 && position <= 5;
      case FeatureEnum::MesiobuccalCusp:
      case FeatureEnum::DistobuccalCusp:
      case FeatureEnum::MesiolingualCusp:
      case FeatureEnum::DistolingualCusp:
        return position >= 6;
      default:
        return true;
    }
  }
  return false;
}
} // namespace

MeaningType
CephalometricLandmarkSet::ParseName(const std::string & name)
{
  const std::string text = Normalize(name);
  for (const Alias & alias : Aliases)
  {
    if (text == alias.name)
    {
      return { alias.jaw, alias.position, ToothCode(), alias.feature };
    }
  }
  if (text.size() < 2 || (text[0] != 'u' && text[0] != 'l'))
  {
    return {};
  }
  MeaningType meaning;
  meaning.jaw = text[0] == 'u' ? JawEnum::Upper : JawEnum::Lower;
  std::size_t place = 1;
  const bool  right = text[place] == 'r';
  const bool  sided = right || text[place] == 'l';
  place += sided ? 1 : 0;
  if (place >= text.size() || text[place] < '1' || text[place] > '8')
  {
    return {};
  }
  const auto  position = static_cast<unsigned int>(text[place] - '0');
  std::string suffix = text.substr(place + 1);
  if (!suffix.empty() && suffix.front() == '_')
  {
    suffix.erase(0, 1);
    if (suffix.empty())
    {
      return {};
    }
  }
  if (!FindFeature(suffix, position, meaning.feature))
  {
    return {};
  }
  meaning.position = position;
  if (sided)
  {
    const unsigned int quadrant = meaning.jaw == JawEnum::Upper ? (right ? 1 : 2) : (right ? 4 : 3);
    meaning.tooth = ToothCode(10 * quadrant + position);
  }
  return meaning;
}

std::string
CephalometricLandmarkSet::MakeName(const MeaningType & meaning)
{
  std::string name = meaning.tooth.IsKnown()
                       ? meaning.tooth.GetName()
                       : (meaning.jaw == JawEnum::Upper ? "U" : "L") + std::to_string(meaning.position);
  for (const Suffix & known : Suffixes)
  {
    if (known.feature == meaning.feature)
    {
      return name + '_' + known.text;
    }
  }
  return name;
}

void
CephalometricLandmarkSet::AddLandmark(const std::string & name,
                                      const PointType &   point,
                                      double              sigma,
                                      double              confidence)
{
  LandmarkType landmark{ name, ParseName(name), point, sigma, confidence };
  if (landmark.meaning.position == 0)
  {
    throw std::invalid_argument("\"" + name +
                                "\" is no dental landmark of a cephalometric analysis, such as U1_tip, "
                                "Is, U6_MB or Ms");
  }
  if (const LandmarkType * other = this->Find(MakeName(landmark.meaning)))
  {
    throw std::invalid_argument(other->name == name
                                  ? "landmark \"" + name + "\" is there twice"
                                  : "landmark \"" + name + "\" is the same point as \"" + other->name + "\"");
  }
  if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
  {
    throw std::invalid_argument("landmark \"" + name + "\" has no finite place");
  }
  if (!(sigma >= 0.0) || !std::isfinite(sigma))
  {
    throw std::invalid_argument("the sigma of landmark \"" + name + "\" is no positive number of pixels");
  }
  m_Landmarks.push_back(landmark);
  this->Modified();
}

auto
CephalometricLandmarkSet::Find(const std::string & name) const -> const LandmarkType *
{
  const auto found = std::find_if(m_Landmarks.begin(), m_Landmarks.end(), [&](const LandmarkType & landmark) {
    return MakeName(landmark.meaning) == name;
  });
  return found == m_Landmarks.end() ? nullptr : &*found;
}

void
CephalometricLandmarkSet::Initialize()
{
  Superclass::Initialize();
  m_Landmarks.clear();
}

void
CephalometricLandmarkSet::Graft(const DataObject * data)
{
  const auto * landmarks = dynamic_cast<const Self *>(data);
  if (landmarks == nullptr)
  {
    itkExceptionMacro("Graft() needs a CephalometricLandmarkSet.");
  }
  m_Landmarks = landmarks->m_Landmarks;
  this->Modified();
}

void
CephalometricLandmarkSet::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  for (const LandmarkType & landmark : m_Landmarks)
  {
    os << indent << landmark.name << " (" << MakeName(landmark.meaning) << "): " << landmark.point << ", sigma "
       << landmark.sigma << ", confidence " << landmark.confidence << std::endl;
  }
}
} // namespace itk
